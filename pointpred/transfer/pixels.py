"""Counts to whole pixels through a transfer function, with the fraction of a pixel carried over."""

from __future__ import annotations

from math import hypot, nan, trunc
from typing import Annotated, NamedTuple

import numpy as np

from pointpred.compiled import law
from pointpred.errors import EventError
from pointpred.layout import Layout
from pointpred.parameter import option, parameter
from pointpred.records import CPI, DPI, LARGEST, LATEST_S, METRES_PER_INCH, FloatArray, FloatTable
from pointpred.stage import CompiledStage, loop_of
from pointpred.transfer import functions

USUAL_TIMES_S = (0.001, 0.1)
"""``period_s`` and ``gap_s`` unless they are set."""


class CountsRow(NamedTuple):
    """What moves the cursor: at ``t`` s, ``dx dy`` counts of the device."""

    t: float
    dx: float
    dy: float


class Settings(Layout):
    """The device and the screen; the time of the first report and the longest time, s; the function."""

    px_per_count: float
    metres_per_count: float
    period_s: float
    gap_s: float
    function: functions.Function


class Carried(Layout):
    """The fractions of a pixel of x and of y that have not been moved yet, px."""

    px: Annotated[FloatArray, 2]


class State(Layout):
    """What is remembered of the reports."""

    started: float
    t: float
    gain: float
    carried: Carried


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


@law
def carry(carried: Carried, axis: int, moved_px: float) -> float:
    """Whole pixels of one axis, 0 or 1; the remainder is carried until the direction reverses.

    Truncation leaves a remainder with the sign of the motion, so it also holds the direction.
    """
    rest = carried.px[axis] if carried.px[axis] * moved_px >= 0.0 else 0.0
    whole = float(trunc(rest + moved_px))
    carried.px[axis] = rest + moved_px - whole
    return whole


@law
def accept(memory: Memory, t: float, dx: float, dy: float) -> tuple[bool, float]:
    """Whether a report is valid, and the time in s of its counts."""
    settings, s = memory.settings, memory.state
    fine = abs(t) <= LATEST_S and abs(dx) <= LARGEST and abs(dy) <= LARGEST
    if s.started == 0.0:
        return fine, float(settings.period_s)
    return fine and t >= s.t, float(min(t - s.t, settings.gap_s))


@law
def turn(memory: Memory, t: float, dt: float, dx: float, dy: float) -> float:
    """Process an accepted report and return the pixels per count; without elapsed time, by the last gain."""
    settings, s = memory.settings, memory.state
    if dt > 0.0:
        speed = hypot(dx, dy) * settings.metres_per_count / dt
        s.gain = functions.gain(settings.function, speed)
    s.started = 1.0
    s.t = t
    return float(s.gain * settings.px_per_count)


@law
def step(memory: Memory, report: tuple[float, float, float]) -> tuple[float, float, float]:
    """One ``CountsRow``: (t, dx in px, dy in px); NaN for a report that is refused."""
    t, dx, dy = CountsRow(*report)
    usable, dt = accept(memory, t, dx, dy)
    if not usable:
        return nan, nan, nan
    scale, carried = turn(memory, t, dt, dx, dy), memory.state.carried
    return t, carry(carried, 0, scale * dx), carry(carried, 1, scale * dy)


@law
def lay_out(
    memory: FloatArray,
    own: FloatArray,
    device: tuple[float, float, float, float],
    function: functions.Function,
) -> None:
    """Write the beginning of a memory: a stage's ``own`` parameters, then its ``Settings``.

    ``device``: counts per inch, px per inch, the time of the first report and the longest time in s.
    """
    cpi, dpi, period_s, gap_s = device
    for i in range(len(own)):
        memory[i] = own[i]
    settings = Settings(memory, len(own))
    settings.px_per_count, settings.metres_per_count = dpi / cpi, METRES_PER_INCH / cpi
    settings.period_s, settings.gap_s = period_s, gap_s
    settings.function.kind = function.kind
    for i in range(len(function.numbers)):
        settings.function.numbers[i] = function.numbers[i]


@law
def report_at(rows: FloatTable, i: int) -> tuple[float, float, float]:
    """A row of a table of reports."""
    return rows[i, 0], rows[i, 1], rows[i, 2]


class ReportStage(CompiledStage):
    """The parameters of all stages that turn reports into pixels: the device, the screen, the function."""

    function: functions.TransferFunction = option("the transfer function", kw_only=False)
    cpi: float = parameter("counts per inch", *CPI, "resolution of the device")
    dpi: float = parameter("px per inch", *DPI, "resolution of the screen", default=96.0)
    period_s: float = parameter("s", 1e-5, 1.0, "time taken for the first report", default=USUAL_TIMES_S[0])
    gap_s: float = parameter(
        "s", 1e-3, 1e3, "longest time between two reports that is believed", default=USUAL_TIMES_S[1]
    )

    def settings(self) -> list[float] | FloatArray:
        """The beginning of the memory: the subclass's own parameters, then those of the device."""
        declared = type(self).parameters[len(ReportStage.parameters) :]
        own = np.array([one.number(getattr(self, one.name)) for one in declared])
        out = np.empty(len(own) + Settings.length)
        lay_out(out, own, (self.cpi, self.dpi, self.period_s, self.gap_s), self.function.slots)
        return out


class PixelTransfer(ReportStage):
    """Counts of a device to whole pixels of the cursor, through a transfer function.

    px = gain(V) dpi / cpi counts, V = 0.0254 |counts| / (cpi h), both axes with the gain of the common
    speed, each axis truncated to whole pixels with its remainder carried until the axis reverses. The cursor
    is not bounded by the screen's edge.

    Parameters: ``function`` a transfer function; ``cpi`` counts per inch and ``dpi`` px per inch;
    ``period_s`` the time assumed for the first report; ``gap_s`` the longest valid time between two reports.
    A report with the time of the one before moves with the same gain.
    Memory: 17 floats. Raises ParameterError, and EventError from ``update``.
    Reference: Khalin 2022, sections 2.3 and 2.6.1; Casiez and Roussel 2011.

    >>> stage = PixelTransfer(functions.ConstantGain(4.0), cpi=2000.0, dpi=96.0)
    >>> [stage.update((i / 1000, 2.0, -3.0)) for i in range(3)]  # 0.384 and -0.576 px a report
    [(0.0, 0.0), (0.0, -1.0), (1.0, 0.0)]
    """

    states = State.length
    width = 3
    loop = staticmethod(loop_of(step, report_at))

    def update(self, report: tuple[float, float, float], /) -> tuple[float, float]:
        """Consume one report (t in s, dx and dy in counts) and return the whole pixels moved.

        Raises EventError when time runs backwards or a value is not finite; the stage is then unchanged.
        """
        t, dx, dy = step(self._memory, report if type(report) is tuple else tuple(report))
        if t != t:
            last = float(Memory(self._memory).state.t)
            raise EventError(
                f"report must be finite and not before t = {last!r} s, received {report!r}", value=report
            )
        return dx, dy

    def run(self, t: FloatArray, dx: FloatArray, dy: FloatArray) -> FloatArray:
        """Consume many reports; a row of whole pixels for each. Raises EventError naming the row."""
        rows = np.column_stack([t, dx, dy]).astype(np.float64)
        before = self.remembered()
        out = self.walk(np.zeros(len(rows), np.bool_), rows)
        refused = np.isnan(out[:, 0])
        if refused.any():
            self.recall(before)
            row = int(refused.argmax())
            raise EventError(f"row {row}: report must be finite and not before the last one")
        return out[:, 1:]
