"""From counts to whole pixels: a transfer function at work, the fraction of a pixel carried on."""

from __future__ import annotations

from math import hypot, trunc
from typing import Any

import numpy as np

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.errors import EventError
from pointpred.events import LARGEST, LATEST_S, METRES_PER_INCH
from pointpred.parameter import Parameter, check
from pointpred.stage import CompiledStage
from pointpred.transfer import known

NONE = float("nan")

# Remainders of x and y in px, relative to `at`: all that carrying needs.
CARRIED = 2

# Memory of the stage, relative to `at`: parameters with the transfer function behind them, then the state.
PX_PER_COUNT, METRES_PER_COUNT, PERIOD_S, GAP_S, FUNCTION = 0, 1, 2, 3, 4
SETTINGS = FUNCTION + known.SLOTS
KNOWN, T, GAIN, CARRY = SETTINGS, SETTINGS + 1, SETTINGS + 2, SETTINGS + 3
STATES = 3 + CARRIED
AT = 0


@law
def carry(memory: FloatArray, at: int, moved_px: float) -> float:
    """Whole pixels of one axis; the rest waits in ``memory[at]`` and is dropped when the direction reverses.

    Truncation leaves a rest with the sign of the motion, so the rest also remembers the direction.
    """
    rest = memory[at] if memory[at] * moved_px >= 0.0 else 0.0
    whole = float(trunc(rest + moved_px))
    memory[at] = rest + moved_px - whole
    return whole


@law
def accept(memory: FloatArray, at: int, t: float, dx: float, dy: float) -> tuple[bool, float]:
    """Whether a report can be used, and the time in s that its counts took."""
    fine = abs(t) <= LATEST_S and abs(dx) <= LARGEST and abs(dy) <= LARGEST
    if memory[at + KNOWN] == 0.0:
        return fine, float(memory[at + PERIOD_S])
    return fine and t >= memory[at + T], float(min(t - memory[at + T], memory[at + GAP_S]))


@law
def turn(memory: FloatArray, at: int, t: float, dt: float, dx: float, dy: float) -> float:
    """Take in an accepted report and return the pixels of one count; no time, the gain of the one before."""
    if dt > 0.0:
        speed = hypot(dx, dy) * memory[at + METRES_PER_COUNT] / dt
        memory[at + GAIN] = known.gain(memory, at + FUNCTION, speed)
    memory[at + KNOWN] = 1.0
    memory[at + T] = t
    return float(memory[at + GAIN] * memory[at + PX_PER_COUNT])


@law
def step(memory: FloatArray, t: float, dx: float, dy: float) -> tuple[float, float, float]:
    """One report: (t, dx in px, dy in px); NaN for a report that is refused."""
    ok, dt = accept(memory, AT, t, dx, dy)
    if not ok:
        return NONE, NONE, NONE
    scale = turn(memory, AT, t, dt, dx, dy)
    return t, carry(memory, AT + CARRY, scale * dx), carry(memory, AT + CARRY + 1, scale * dy)


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table of (t, dx, dy)."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        out[i, 0], out[i, 1], out[i, 2] = step(memory, rows[i, 0], rows[i, 1], rows[i, 2])


def settings(
    function: known.TransferFunction, cpi: float, dpi: float, period_s: float, gap_s: float
) -> list[float]:
    """The parameters as they stand first in the memory."""
    return [dpi / cpi, METRES_PER_INCH / cpi, period_s, gap_s, *map(float, function.slots)]


class PixelTransfer(CompiledStage):
    """Counts of a device to whole pixels of the cursor, through a transfer function.

    px = gain(V) dpi / cpi counts, V = 0.0254 |counts| / (cpi h), both axes with the gain of the common
    speed, each axis truncated to whole pixels with its remainder carried until the axis reverses. Nothing
    bounds the cursor: the screen's edge is not its business.

    Parameters: ``function`` a known transfer function; ``cpi`` counts per inch and ``dpi`` px per inch;
    ``period_s`` the time taken for the first report; ``gap_s`` the longest time between two reports that is
    believed. A report with the time of the one before moves with the same gain.
    Memory: 17 floats. Raises ParameterError, and EventError from ``update``.
    Reference: Khalin 2022, sections 2.3 and 2.6.1; Casiez and Roussel 2011.

    >>> stage = PixelTransfer(known.ConstantGain(4.0), cpi=2000.0, dpi=96.0)
    >>> [stage.update((i / 1000, 2.0, -3.0)) for i in range(3)]  # 0.384 and -0.576 px a report
    [(0.0, 0.0), (0.0, -1.0), (1.0, 0.0)]
    """

    parameters = (
        Parameter("cpi", "counts per inch", 1.0, 1e6, "resolution of the device"),
        Parameter("dpi", "px per inch", 1.0, 1e5, "resolution of the screen"),
        Parameter("period_s", "s", 1e-5, 1.0, "time taken for the first report"),
        Parameter("gap_s", "s", 1e-3, 1e3, "longest time between two reports that is believed"),
    )
    width = 3
    loop = staticmethod(loop)

    def __init__(
        self,
        function: known.TransferFunction,
        *,
        cpi: float,
        dpi: float = 96.0,
        period_s: float = 0.001,
        gap_s: float = 0.1,
    ) -> None:
        values: dict[str, Any] = {"cpi": cpi, "dpi": dpi, "period_s": period_s, "gap_s": gap_s}
        check(self.parameters, values)
        self.function = function
        self.lay_out(settings(function, cpi, dpi, period_s, gap_s), STATES)

    def update(self, report: tuple[float, float, float], /) -> tuple[float, float]:
        """Consume one report (t in s, dx and dy in counts) and return the whole pixels moved.

        Raises EventError when time runs backwards or a value is not finite; nothing is then changed.
        """
        t, dx, dy = step(self._memory, *report)
        if t != t:
            last = float(self._memory[AT + T])
            raise EventError(f"report must be finite and not before t = {last!r} s, received {report!r}")
        return dx, dy

    def run(self, t: FloatArray, dx: FloatArray, dy: FloatArray) -> FloatArray:
        """Consume many reports; a row of whole pixels for each. Raises EventError naming the row."""
        rows = np.column_stack([t, dx, dy]).astype(np.float64)
        kept = self._memory.copy()
        out = self.walk(np.zeros(len(rows), np.bool_), rows)
        refused = np.isnan(out[:, 0])
        if refused.any():
            self._memory = kept
            row = int(refused.argmax())
            raise EventError(f"row {row}: report must be finite and not before the last one")
        return out[:, 1:]
