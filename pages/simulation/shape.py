"""The shape of a movement after the fact, to hold simulated people against recorded ones.

Onset, arrival and sub-movements are the scorer's; only the speed profile is smoothed here.
"""

from __future__ import annotations

import msgspec
import numpy as np

from pointpred.recording import Recording
from pointpred.records import EventColumns, FloatArray
from pointpred.scoring import Prepared, prepare
from pointpred.scoring.trials import resolution

GRID_S = 0.005
SMOOTHING_S = 0.02


class Shape(msgspec.Struct, frozen=True):
    """One movement from onset to arrival, as the scorer cuts it, looked at as a whole."""

    distance_px: float
    movement_s: float
    before_s: float
    """From the first event to the onset."""
    after_s: float
    """From arrival to the last event."""
    peak_share: float
    """Time of the highest speed as a share of the movement time."""
    path_ratio: float
    """Length of the path over the distance."""
    one_piece: bool
    """Whether the scorer finds no sub-movement."""
    sharpness: float
    """Highest speed times movement time over distance: 1.57 for half a cosine, 1.88 for minimum jerk."""
    end_x: float
    end_y: float


def speeds(events: EventColumns) -> tuple[FloatArray, FloatArray]:
    """Time (s) and speed of the cursor (px/s) on a grid of 5 ms, smoothed by a Gaussian of 20 ms.

    Looks ahead: for judging whole movements only.
    """
    grid = np.arange(events.t[0] - 0.1, events.t[-1] + 0.1, GRID_S)
    reach = np.arange(-12, 13) * GRID_S / SMOOTHING_S
    kernel = np.exp(-0.5 * reach**2)
    kernel /= kernel.sum()
    axes = (np.gradient(np.interp(grid, events.t, axis), GRID_S) for axis in (events.x, events.y))
    smooth = [np.convolve(axis, kernel, "same") for axis in axes]
    return grid, np.hypot(*smooth)


def shapes(recording: Recording) -> list[Shape | None]:
    """The shape of every trial, in the recording's order; ``None`` for one that the scorer skips."""
    prepared = prepare(recording, **resolution(recording, None, None))
    by_number = {
        (scored.trial.user, scored.trial.trial): shape(prepared, k)
        for k, scored in enumerate(prepared.trials)
    }
    return [by_number.get((trial.user, trial.trial)) for trial in recording.trials]


def shape(prepared: Prepared, k: int) -> Shape:
    """The shape of one trial that the scorer prepared."""
    scored, events = prepared.trials[k], prepared.rows(k)
    t, x, y = events.t, events.x, events.y
    arrival = int(prepared.arrivals[k] - prepared.offsets[k])
    grid, speed = speeds(events)
    steps = np.hypot(np.diff(x[: arrival + 1]), np.diff(y[: arrival + 1]))
    return Shape(
        distance_px=scored.distance_px,
        movement_s=scored.arrival_s,
        before_s=scored.onset_s,
        after_s=float(t[-1] - t[arrival]),
        peak_share=float((grid[speed.argmax()] - t[0]) / scored.arrival_s),
        path_ratio=float(steps.sum() / scored.distance_px),
        one_piece=not scored.submovements,
        sharpness=float(speed.max() * scored.arrival_s / scored.distance_px),
        end_x=float(x[-1]),
        end_y=float(y[-1]),
    )
