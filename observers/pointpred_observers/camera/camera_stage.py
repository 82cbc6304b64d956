"""The stages on camera samples: which samples are refused, and why."""

from __future__ import annotations

from collections.abc import Callable
from math import nan
from operator import attrgetter
from typing import Any, ClassVar

import numpy as np

from pointpred.compiled import law
from pointpred.errors import EventError, EventOrderError
from pointpred.parameter import is_number
from pointpred.records import LATEST_S, FloatArray, FloatTable
from pointpred.stage import CompiledStage
from pointpred_observers.camera.samples import CameraColumns, CameraSample, SampleRow

LARGEST_PX, LARGEST_W, LARGEST_A = 1e6, 1e3, 1e4
"""Bounds on positions px, angular velocities rad/s and accelerations m/s^2."""
SUBSTEP_S = 0.05
"""Longest step of an integration."""
READ = attrgetter(*CameraColumns.names)
PLAIN = frozenset({float, type(None)})
"""Types of a sample's fields that need no conversion."""


@law
def sample_at(
    rows: FloatTable, i: int
) -> tuple[float, float, float, float, float, float, float, float, float]:
    """A row of a table of samples as a tuple."""
    r = rows[i]
    return r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]


@law
def usable(sample: SampleRow, started: float, last_t: float, gap_s: float) -> bool:
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

    A subclass names its ``layout``, with ``started`` and ``t`` in the state and ``gap_s`` in the settings.
    """

    step: ClassVar[Callable[..., Any]]
    layout: ClassVar[Any]

    def advance(self, sample: CameraSample) -> Any:
        """The row of answers to one sample; raises EventError or EventOrderError and then changes nothing."""
        values = _numbers(sample)
        row = type(self).step(self._memory, values)
        if row[0] != row[0]:
            raise self._reason(values, self._last())
        return row

    def table(self, columns: CameraColumns) -> FloatArray:
        """The rows of answers to a table; a refused row raises its error and nothing is consumed."""
        before = self.remembered()
        out = self.walk(np.zeros(len(columns), np.bool_), columns.table)
        refused = out[:, 0] != out[:, 0]
        if refused.any():
            row = int(refused.argmax())
            self.recall(before)
            last_t = float(columns.t[row - 1]) if row else self._last()
            reason = self._reason(tuple(columns.table[row].tolist()), last_t)
            raise type(reason)(f"row {row}: {reason}", field=reason.field, value=reason.value)
        return out

    def _last(self) -> float | None:
        state = self.layout(self._memory).state
        return float(state.t) if state.started == 1.0 else None

    def _reason(self, values: tuple[float, ...], last_t: float | None) -> EventError:
        bounds = (LATEST_S, LARGEST_PX, LARGEST_PX, *[LARGEST_W] * 3, *[LARGEST_A] * 3)
        missing = values[1] != values[1] and values[2] != values[2]
        for name, value, most in zip(CameraColumns.names, values, bounds, strict=True):
            if not abs(value) <= most and not (name in "xy" and missing):
                return EventError(
                    f"{name} must lie in [{-most:g}, {most:g}], received {value!r}", field=name, value=value
                )
        t = values[0]
        if last_t is not None and t <= last_t:
            return EventOrderError(
                f"t must increase: received {t!r} s after {last_t!r} s", field="t", value=t
            )
        gap_s = float(self.layout(self._memory).settings.gap_s)
        return EventError(
            f"the inertial sensor was silent from {last_t!r} s to {t!r} s, at most {gap_s:g} s are "
            "bridged: reset and begin anew",
            field="t",
            value=t,
        )


def _numbers(sample: CameraSample) -> tuple[float, ...]:
    """A sample as plain numbers, NaN for a missing image."""
    try:
        raw = READ(sample)
    except AttributeError as missing:
        raise EventError(f"a sample must be a CameraSample, received {sample!r:.80}") from missing
    paired = (raw[1] is None) == (raw[2] is None) and raw[1] == raw[1] and raw[2] == raw[2]
    if paired and set(map(type, raw)) <= PLAIN:
        return raw if raw[1] is not None else (raw[0], nan, nan, *raw[3:])
    for name, value in zip(CameraColumns.names, raw, strict=True):
        if not (is_number(value) and value == value) and not (value is None and name in "xy"):
            raise EventError(f"{name} must be a number, received {value!r}", field=name, value=value)
    if (raw[1] is None) != (raw[2] is None):
        raise EventError(f"x and y come together or not at all, received {raw[1]!r} and {raw[2]!r}")
    return tuple(nan if value is None else float(value) for value in raw)
