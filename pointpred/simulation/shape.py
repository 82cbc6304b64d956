"""The shape of a movement after the fact, to hold simulated people against recorded ones."""

from __future__ import annotations

import msgspec
import numpy as np

from pointpred.columns import EventColumns, FloatArray
from pointpred.recording import Recording

GRID_S = 0.005
SMOOTHING_S = 0.02
ONSET_PX = 3.0
ARRIVED_PX, ARRIVED_SHARE = 8.0, 0.03
ONE_PIECE_RATIO = 5.0
"""Thesis, remark 2.3.1 and section 2.6.3: no sub-movement where the highest peak is 5 times the next."""


class Shape(msgspec.Struct, frozen=True):
    """One movement from onset to arrival (as the scorer cuts them), looked at as a whole."""

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
    peak_ratio: float
    """Highest peak of the speed over the next; infinite where there is only one."""
    sharpness: float
    """Highest speed times movement time over distance: 1.57 for half a cosine, 1.88 for minimum jerk."""
    end_x: float
    end_y: float

    @property
    def one_piece(self) -> bool:
        """Whether the movement has no sub-movement by the thesis's rule."""
        return self.peak_ratio >= ONE_PIECE_RATIO


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


def shape(events: EventColumns) -> Shape | None:
    """The shape of one trial, ``None`` where it has no movement of at least four events."""
    if len(events) == 0:
        return None
    t, x, y = events.t, events.x, events.y
    away = np.nonzero(np.hypot(x - x[0], y - y[0]) > ONSET_PX)[0]
    if len(away) == 0:
        return None
    onset = int(away[0]) - 1
    distance = float(np.hypot(x[-1] - x[onset], y[-1] - y[onset]))
    off = np.hypot(x - x[-1], y - y[-1]) > max(ARRIVED_PX, ARRIVED_SHARE * distance)
    if distance == 0.0 or not off.any():
        return None
    arrival = int(np.nonzero(off)[0][-1]) + 1
    if arrival < onset + 4:
        return None
    grid, speed = speeds(events)
    inner = speed[1:-1]
    peaks = np.sort(inner[(inner > speed[:-2]) & (inner >= speed[2:])])[::-1]
    movement = float(t[arrival] - t[onset])
    steps = np.hypot(np.diff(x[onset : arrival + 1]), np.diff(y[onset : arrival + 1]))
    return Shape(
        distance_px=distance,
        movement_s=movement,
        before_s=float(t[onset] - t[0]),
        after_s=float(t[-1] - t[arrival]),
        peak_share=float((grid[speed.argmax()] - t[onset]) / movement),
        path_ratio=float(steps.sum() / distance),
        peak_ratio=float(peaks[0] / peaks[1]) if len(peaks) > 1 else float("inf"),
        sharpness=float(speed.max() * movement / distance),
        end_x=float(x[-1]),
        end_y=float(y[-1]),
    )


def shapes(recording: Recording) -> list[Shape | None]:
    """The shape of every trial, in the recording's order."""
    return [shape(recording.rows(i)) for i in range(len(recording.trials))]
