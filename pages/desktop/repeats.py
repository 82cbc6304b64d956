"""How often a simulated person's movements end where an earlier one ended: what there is to learn."""

from __future__ import annotations

import numpy as np

from pointpred.records import FloatArray
from pointpred.scoring import Prepared

NEAR_PX = 40.0
SCREEN, WINDOW = "on the screen", "in the window"


def repeated(prepared: Prepared) -> dict[str, FloatArray]:
    """1 for each trial that ends within 40 px of an earlier end of the same person, else 0.

    On the screen; and relative to the corner of the window in front at the movement's start, among the
    earlier ends with that window.
    """
    screen: list[float] = []
    window: list[float] = []
    earlier: dict[tuple[str, ...], list[FloatArray]] = {}
    for k, scored in enumerate(prepared.trials):
        user, known = scored.trial.user, scored.trial.condition
        end = prepared.rows(k).table[-1, 1:3]
        corner = np.array([float(known["window_x"]), float(known["window_y"])])
        screen.append(_near(end, earlier.setdefault((user,), [])))
        window.append(_near(end - corner, earlier.setdefault((user, str(known["window"])), [])))
    return {SCREEN: np.array(screen), WINDOW: np.array(window)}


def _near(end: FloatArray, earlier: list[FloatArray]) -> float:
    """Whether an end lies near one of the earlier ones, to which it is then added."""
    near = bool(earlier) and float(np.hypot(*(np.array(earlier) - end).T).min()) < NEAR_PX
    earlier.append(end)
    return float(near)
