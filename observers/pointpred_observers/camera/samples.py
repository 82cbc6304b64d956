"""Samples of a camera with an inertial sensor: records, columns, and the stages on them."""

from __future__ import annotations

from math import nan
from typing import Any, ClassVar, NamedTuple

import numpy as np

from pointpred.columns import Columns
from pointpred.compiled import law
from pointpred.errors import EventError, EventOrderError
from pointpred.parameter import is_number
from pointpred.records import LATEST_S, FloatArray
from pointpred.stage import CompiledStage

FOCAL_PX = (1.0, 1e6)
LARGEST_PX, LARGEST_W, LARGEST_A = 1e6, 1e3, 1e4
"""Bounds on positions px, angular velocities rad/s and accelerations m/s^2."""
SUBSTEP_S = 0.05
"""Longest step of an integration."""


class CameraSample(NamedTuple):
    """A reading of the inertial sensor, with the tracked point if an image was taken at that time.

    ``t`` s; ``x y`` px from the principal point, x right, y down, both NaN without an image; ``wx wy wz``
    rad/s; ``ax ay az`` m/s^2 of the motion in the camera's frame, gravity already removed (10): ``Gravity``.
    """

    t: float
    x: float
    y: float
    wx: float
    wy: float
    wz: float
    ax: float
    ay: float
    az: float


class CameraColumns(Columns[CameraSample]):
    """Camera samples as columns; x and y are NaN where there is no image."""

    names = CameraSample._fields

    def _record(self, row: list[float]) -> CameraSample:
        return CameraSample(*row)


@law
def usable(sample: CameraSample, started: float, last_t: float, gap_s: float) -> bool:
    """Whether a sample can be used: within the bounds, after the last one and within the longest gap."""
    t, x, y, wx, wy, wz, ax, ay, az = sample
    if not (abs(t) <= LATEST_S and abs(wx) <= LARGEST_W and abs(wy) <= LARGEST_W and abs(wz) <= LARGEST_W):
        return False
    if not (abs(ax) <= LARGEST_A and abs(ay) <= LARGEST_A and abs(az) <= LARGEST_A):
        return False
    if not ((x != x and y != y) or (abs(x) <= LARGEST_PX and abs(y) <= LARGEST_PX)):
        return False
    return started != 1.0 or (last_t < t <= last_t + gap_s)


class CameraStage(CompiledStage):
    """A stage whose rows are camera samples.

    A subclass names its law ``step(memory, row, out)``, which leaves out[0] NaN where it refuses a row, and
    its ``layout``, with ``started`` and ``t`` in the state and ``gap_s`` in the settings.
    """

    layout: ClassVar[Any]

    def advance(self, sample: CameraSample, more: tuple[float, ...] = ()) -> Any:
        """The row of answers to one sample; raises EventError or EventOrderError and then changes nothing."""
        values = _numbers(sample) + more
        out = np.full(self.width, nan)
        type(self).step(self._memory, np.array(values), out)
        if out[0] != out[0]:
            raise self._reason(values, self._last())
        return out

    def table(self, rows: FloatArray) -> FloatArray:
        """The rows of answers to a table; a refused row raises its error and nothing is consumed."""
        before = self.remembered()
        out = self.walk(np.zeros(len(rows), np.bool_), rows)
        refused = out[:, 0] != out[:, 0]
        if refused.any():
            row = int(refused.argmax())
            self.recall(before)
            last_t = float(rows[row - 1, 0]) if row else self._last()
            reason = self._reason(tuple(rows[row].tolist()), last_t)
            raise type(reason)(f"row {row}: {reason}", field=reason.field, value=reason.value)
        return out

    def _last(self) -> float | None:
        state = self.layout(self._memory).state
        return float(state.t) if state.started == 1.0 else None

    def _reason(self, values: tuple[float, ...], last_t: float | None) -> EventError:
        bounds = (LATEST_S, LARGEST_PX, LARGEST_PX, *[LARGEST_W] * 3, *[LARGEST_A] * 3)
        missing = [one != one for one in values[1:3]]
        if any(missing) and not all(missing):
            return EventError(f"x and y come together or not at all, received {values[1:3]}")
        for name, value, most in zip(CameraColumns.names, values, bounds, strict=False):
            if not abs(value) <= most and not (name in "xy" and all(missing)):
                words = f"{name} must lie in [{-most:g}, {most:g}], received {value!r}"
                return EventError(words, field=name, value=value)
        t = values[0]
        if last_t is not None and t <= last_t:
            words = f"t must increase: received {t!r} s after {last_t!r} s"
            return EventOrderError(words, field="t", value=t)
        most = float(self.layout(self._memory).settings.gap_s)
        words = f"the inertial sensor was silent from {last_t!r} s to {t!r} s, at most {most:g} s are bridged"
        return EventError(words, field="t", value=t)


def _numbers(sample: CameraSample) -> CameraSample:
    """A sample as plain numbers."""
    if not isinstance(sample, CameraSample):
        raise EventError(f"a sample must be a CameraSample, received {sample!r:.80}")
    for name, value in zip(CameraColumns.names, sample, strict=True):
        if not is_number(value):
            raise EventError(f"{name} must be a number, received {value!r}", field=name, value=value)
    return CameraSample(*map(float, sample))
