"""KEP as one would write it first: keep every sample, refit with numpy.polyfit at every event.

It grows with the movement in time and memory. It is the independent second
implementation of the ungated KEP predictors.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from math import hypot

import numpy as np

from pointpred import EventColumns, Motion
from pointpred.differentiators import HomogeneousDifferentiator

SPREAD_LEAST = 1e-5
"""The recursive fit refuses distances that determine the polynomial worse than this; so does this one."""


class NaiveKep:
    """Endpoint where a polynomial of speed over distance travelled returns to zero; ``None`` without one."""

    def __init__(self, degree: int = 4, reach: float = 10.0) -> None:
        self.degree = degree
        self.reach = reach
        self.reset()

    def reset(self) -> None:
        """Forget the movement."""
        self.last: Motion | None = None
        self.start = (0.0, 0.0)
        self.travelled = 0.0
        self.distances: list[float] = []
        self.speeds: list[float] = []

    def update(self, motion: Motion) -> tuple[float, float] | None:
        """Add a motion, refit, and return the endpoint."""
        if motion.start or self.last is None:
            self.reset()
            self.start = (motion.x, motion.y)
        else:
            self.travelled += hypot(motion.x - self.last.x, motion.y - self.last.y)
        if self.last is None or motion.t > self.last.t:
            self.distances.append(self.travelled)
            self.speeds.append(hypot(motion.vx, motion.vy))
        self.last = motion
        away = hypot(motion.x - self.start[0], motion.y - self.start[1])
        length = self.length()
        if length is None or away == 0.0:
            return None
        ahead = (length - self.travelled) / away
        return (motion.x + ahead * (motion.x - self.start[0]), motion.y + ahead * (motion.y - self.start[1]))

    def length(self) -> float | None:
        """The length of the whole movement as the fit sees it."""
        if self.travelled <= 0.0 or not self.determined():
            return None
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", np.exceptions.RankWarning)
            polynomial = np.polyfit(self.distances, self.speeds, self.degree)
        if np.polyval(polynomial, self.travelled) <= 0.0:
            return None
        roots = np.roots(polynomial)
        real = roots.real[np.abs(roots.imag) <= 1e-9 * np.abs(roots)]
        ahead = real[(real > self.travelled) & (real <= (1.0 + self.reach) * self.travelled)]
        return float(ahead.min()) if len(ahead) else None

    def determined(self) -> bool:
        """Whether no power of the distance is, in the samples, a combination of the lower powers."""
        if len(self.distances) <= self.degree:
            return False
        powers = np.vander(np.array(self.distances) / self.travelled, self.degree + 1, increasing=True)
        own = np.abs(np.diag(np.linalg.qr(powers, mode="r")))
        return bool((own > SPREAD_LEAST * np.linalg.norm(powers, axis=0)).all())

    def walk(self, events: EventColumns) -> Callable[[], object]:
        """An action that feeds events one by one through a differentiator and refits after each."""
        records = list(events.events())
        differentiator = HomogeneousDifferentiator()

        def action() -> None:
            self.reset()
            differentiator.reset()
            for record in records:
                self.update(differentiator.update(record))

        return action
