"""The assisted transfer function with a safety rule: it helps the hand and never works against it."""

from __future__ import annotations

from typing import Any

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.errors import EventError
from pointpred.events import LARGEST, Prediction
from pointpred.parameter import Parameter, check
from pointpred.regions import as_normal
from pointpred.stage import CompiledStage
from pointpred.transfer import assisted_guard, known, pixels

PIXELS = assisted_guard.SETTINGS
OWED = PIXELS + pixels.SETTINGS + pixels.STATES
STATES = pixels.STATES + pixels.CARRIED
NONE = pixels.NONE
UNGUIDED = (NONE, NONE, NONE, NONE, NONE)
"""The way to the endpoint and the covariance where nothing is predicted."""

GUARD_PARAMETERS = (
    Parameter("rho", "1/s", 0.0, 1e4, "rate at which the cursor is pulled to the endpoint"),
    Parameter("strength", "", 0.0, 1.0, "longest pull as a share of the hand's own motion"),
    Parameter("sideways", "", 0.0, 1.0, "longest pull across the hand's direction, as a share of strength"),
    Parameter("uncertain", "", 1e-3, 1e3, "spread of the endpoint over the way to it at which help ends"),
    Parameter("unclaimed", "", 0.0, 1e3, "that spread where a predictor claims none"),
)


@law
def step(
    memory: FloatArray,
    t: float,
    dx: float,
    dy: float,
    off_x: float,
    off_y: float,
    sxx: float,
    sxy: float,
    syy: float,
) -> tuple[float, float, float, float, float]:
    """One report: (t, dx px, dy px, and of these what was added); NaN for a report that is refused."""
    ok, dt = pixels.accept(memory, PIXELS, t, dx, dy)
    if not ok or abs(off_x) > LARGEST or abs(off_y) > LARGEST:
        return NONE, NONE, NONE, NONE, NONE
    scale = pixels.turn(memory, PIXELS, t, dt, dx, dy)
    own_x, own_y = scale * dx, scale * dy
    carried = PIXELS + pixels.CARRY
    x, y = pixels.carry(memory, carried, own_x), pixels.carry(memory, carried + 1, own_y)
    add_x, add_y = assisted_guard.add(memory, 0, OWED, dt, own_x, own_y, off_x, off_y, sxx, sxy, syy)
    return t, x + add_x, y + add_y, add_x, add_y


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table of (t, dx, dy, off_x, off_y, sxx, sxy, syy)."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        r = rows[i]
        answer = step(memory, r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7])
        for j in range(len(answer)):
            out[i, j] = answer[j]


class GuardedTransfer(CompiledStage):
    """Counts to whole pixels, helped towards a predicted endpoint as far as that is safe.

    Assumes that the way from the cursor to the endpoint and the region around it are honest: a wrong endpoint
    with a small region, in the direction of the hand, is followed, and the hand has to come back. It only
    speeds up and bends; it never slows the cursor down, so a hand that would have stopped right goes too far.

    x' = V_mx / V_m PTF(V_m) - rho (x - T_hat), the second term integrated over a report, split along and
    across the hand's direction, and bounded: along in [0, strength m] and never past the endpoint, across
    in strength sideways m cos(angle) at most, where m is what the hand itself moves and the angle that to the
    endpoint. Both fade as 1 - s / (``uncertain`` d), with s the largest standard deviation of
    the normal law with the same 50 % region, and d the distance of the endpoint. At rest, at angles above 90
    degrees and without a prediction nothing is added; whole pixels, too, are never added against the hand.
    With ``strength`` 0 it is ``PixelTransfer`` bit for bit.

    Parameters: ``rho`` in 1/s; ``strength`` and ``sideways`` in [0, 1]; ``uncertain`` and ``unclaimed``, what
    s / d is taken to be where a predictor claims no region; the others as for ``PixelTransfer``.
    Memory: 24 floats. Raises ParameterError, and EventError from ``update``.
    Reference: Khalin 2022, Remark 2.2.1, with a bound and a direction.

    >>> stage = GuardedTransfer(known.ConstantGain(4.0), rho=10.0, strength=0.5, cpi=2000.0)
    >>> sure = Prediction(0.0, 500.0, 0.0, (1.0, 0.0, 1.0), "ballistic", None)
    >>> stage.update((0.0, 20.0, 0.0), sure, (0.0, 0.0))  # 3.84 px by hand, half as much added
    (4.0, 0.0)
    >>> stage.update((0.001, -20.0, 0.0), sure, (4.0, 0.0))  # the hand leaves: nothing is added
    (-3.0, 0.0)
    """

    parameters = (*GUARD_PARAMETERS, *pixels.PixelTransfer.parameters)
    width = 5
    loop = staticmethod(loop)

    def __init__(
        self,
        function: known.TransferFunction,
        *,
        cpi: float,
        dpi: float = 96.0,
        rho: float = 8.0,
        strength: float = 0.5,
        sideways: float = 0.5,
        uncertain: float = 0.5,
        unclaimed: float = 0.25,
        period_s: float = 0.001,
        gap_s: float = 0.1,
    ) -> None:
        guard: dict[str, Any] = {"rho": rho, "strength": strength, "sideways": sideways}
        guard |= {"uncertain": uncertain, "unclaimed": unclaimed}
        check(self.parameters, guard | {"cpi": cpi, "dpi": dpi, "period_s": period_s, "gap_s": gap_s})
        self.function = function
        own = pixels.settings(function, cpi, dpi, period_s, gap_s)
        self.lay_out([*map(float, guard.values()), *own], STATES)

    def advance(
        self, t: float, dx: float, dy: float, guidance: tuple[float, float, float, float, float] = UNGUIDED
    ) -> tuple[float, float, float, float, float]:
        """``update`` in plain numbers: (t, dx px, dy px, of these added in x, in y), NaN where refused.

        ``guidance``: way to the endpoint in x and y (px), and sxx, sxy, syy (px^2); NaN where there is none.
        """
        return step(self._memory, t, dx, dy, *guidance)

    def update(
        self,
        report: tuple[float, float, float],
        prediction: Prediction | None = None,
        cursor: tuple[float, float] = (0.0, 0.0),
        /,
    ) -> tuple[float, float]:
        """Consume one report (t in s, dx and dy in counts) and return the whole pixels moved.

        ``prediction`` is the newest one before the report, ``cursor`` (px) where it finds the cursor.
        Raises EventError when time runs backwards or a value is not finite; nothing is then changed.
        """
        t, dx, dy, _, _ = self.advance(*report, guidance(prediction, cursor))
        if t != t:
            last = float(self._memory[PIXELS + pixels.T])
            raise EventError(
                f"report must be finite and not before t = {last!r} s, the endpoint within {LARGEST:g} px, "
                f"received {report!r}, {prediction!r} at {cursor!r}"
            )
        return dx, dy


def guidance(
    prediction: Prediction | None, cursor: tuple[float, float]
) -> tuple[float, float, float, float, float]:
    """A prediction as the law wants it: the way to it from the cursor (px), and a covariance (px^2).

    The covariance is that of the normal law with the same 50 % region: Student laws of small tails have none.
    """
    if prediction is None:
        return UNGUIDED
    way = prediction.x - cursor[0], prediction.y - cursor[1]
    if prediction.scale is None:
        return *way, NONE, NONE, NONE
    return *way, *as_normal(*prediction.scale, NONE if prediction.tail is None else prediction.tail)
