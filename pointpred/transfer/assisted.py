"""The assisted transfer function: the predicted endpoint pulls the cursor, thesis Remark 2.2.1."""

from __future__ import annotations

from math import expm1, hypot, inf
from typing import Any

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.errors import EventError
from pointpred.events import LARGEST
from pointpred.parameter import Parameter, check
from pointpred.stage import CompiledStage
from pointpred.transfer import known, pixels

RHO, STRENGTH, PIXELS = 0, 1, 2
SETTINGS = PIXELS + pixels.SETTINGS


@law
def pull(rho: float, strength: float, dt: float, own_px: float, off_x: float, off_y: float) -> float:
    """The share of the offset (T_hat - x, T_hat_y - y) by which the cursor is pulled in ``dt`` s.

    The term -rho (x - T_hat) integrated exactly, 1 - exp(-rho dt), and never longer than ``strength`` times
    the ``own_px`` that the hand moved the cursor; 0 while no endpoint is predicted (NaN).
    """
    length = hypot(off_x, off_y)
    if not 0.0 < length < inf:
        return 0.0
    share = -expm1(-rho * dt)
    return min(share, strength * own_px / length) if strength < inf else share


@law
def step(
    memory: FloatArray, t: float, dx: float, dy: float, off_x: float, off_y: float
) -> tuple[float, float, float]:
    """One report: (t, dx in px, dy in px); NaN for a report that is refused."""
    ok, dt = pixels.accept(memory, PIXELS, t, dx, dy)
    if not ok or abs(off_x) > LARGEST or abs(off_y) > LARGEST:
        return pixels.NONE, pixels.NONE, pixels.NONE
    scale = pixels.turn(memory, PIXELS, t, dt, dx, dy)
    x, y = scale * dx, scale * dy
    share = pull(memory[RHO], memory[STRENGTH], dt, hypot(x, y), off_x, off_y)
    if share > 0.0:
        x += share * off_x
        y += share * off_y
    carried = PIXELS + pixels.CARRY
    return t, pixels.carry(memory, carried, x), pixels.carry(memory, carried + 1, y)


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table of (t, dx, dy, off_x, off_y)."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        r = rows[i]
        out[i, 0], out[i, 1], out[i, 2] = step(memory, r[0], r[1], r[2], r[3], r[4])


class AssistedTransfer(CompiledStage):
    """Counts to whole pixels through a transfer function, pulled towards a predicted endpoint.

    Assumes that the prediction is worth following: a wrong one pulls the cursor away, and with an unlimited
    ``strength`` it moves a cursor whose hand lies still, which no person expects. How people react to it is
    not known.

    x' = V_mx / V_m PTF(V_m) - rho (x - T_hat), integrated exactly over a report; the pull is bounded to
    ``strength`` times the hand's own motion of the cursor. Below 1 the hand can always leave a wrong
    endpoint.

    Parameters: ``rho`` in 1/s; ``strength``, infinite for the remark as printed; ``function``, ``cpi``,
    ``dpi``, ``period_s``, ``gap_s`` as for ``PixelTransfer``. Memory: 19 floats.
    Raises ParameterError, and EventError from ``update``.
    Reference: Khalin 2022, Remark 2.2.1.

    >>> stage = AssistedTransfer(known.ConstantGain(4.0), rho=10.0, strength=0.5, cpi=2000.0)
    >>> stage.update((0.0, 20.0, 0.0), (500.0, 0.0))  # 3.84 px by hand, half as much by the pull
    (5.0, 0.0)
    """

    parameters = (
        Parameter("rho", "1/s", 0.0, 1e4, "rate at which the cursor is pulled to the endpoint"),
        Parameter("strength", "", 0.0, inf, "longest pull as a share of the hand's own motion"),
        *pixels.PixelTransfer.parameters,
    )
    width = 3
    loop = staticmethod(loop)

    def __init__(
        self,
        function: known.TransferFunction,
        *,
        cpi: float,
        dpi: float = 96.0,
        rho: float = 5.0,
        strength: float = 0.5,
        period_s: float = 0.001,
        gap_s: float = 0.1,
    ) -> None:
        values: dict[str, Any] = {"rho": rho, "strength": strength, "cpi": cpi, "dpi": dpi}
        check(self.parameters, values | {"period_s": period_s, "gap_s": gap_s})
        self.function = function
        own = pixels.settings(function, cpi, dpi, period_s, gap_s)
        self.lay_out([float(rho), float(strength), *own], pixels.STATES)

    def update(
        self, report: tuple[float, float, float], off_px: tuple[float, float] | None = None, /
    ) -> tuple[float, float]:
        """Consume one report (t in s, dx and dy in counts) and return the whole pixels moved.

        ``off_px`` is the predicted endpoint minus the cursor in px, ``None`` where nothing is predicted.
        Raises EventError when time runs backwards or a value is not finite; nothing is then changed.
        """
        off_x, off_y = (pixels.NONE, pixels.NONE) if off_px is None else off_px
        t, dx, dy = step(self._memory, *report, off_x, off_y)
        if t != t:
            last = float(self._memory[PIXELS + pixels.T])
            raise EventError(
                f"report must be finite and not before t = {last!r} s, received {report!r}, {off_px!r}"
            )
        return dx, dy
