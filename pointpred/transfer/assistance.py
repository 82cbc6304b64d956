"""Assisted transfer functions: a predicted endpoint attracts the cursor, thesis Remark 2.2.1.

The printed term pulls in any direction; the guarded one never pulls against the hand.
"""

from __future__ import annotations

from math import expm1, hypot, inf, nan, sqrt
from typing import NamedTuple

from pointpred.compiled import law
from pointpred.errors import EventError
from pointpred.layout import Layout, clear
from pointpred.parameter import parameter
from pointpred.records import LARGEST, FloatTable, Prediction
from pointpred.regions import as_normal
from pointpred.stage import loop_of
from pointpred.transfer import pixels
from pointpred.transfer.pixels import ReportStage

USUAL_GUARD = (0.5, 0.5, 0.25)
"""``sideways``, ``uncertain`` and ``unclaimed`` unless they are set."""

Way = tuple[float, float, float, float, float]
"""The endpoint minus the cursor, x and y in px, and its covariance sxx, sxy, syy in px^2; NaN: none."""
UNGUIDED: Way = (nan, nan, nan, nan, nan)
"""The way without a prediction."""


class Assisted(Layout):
    """The memory of ``AssistedTransfer``: its own parameters, then that of ``PixelTransfer``."""

    rho: float
    strength: float
    transfer: pixels.Memory


class Guard(Layout):
    """The parameters of ``GuardedTransfer``."""

    rho: float
    strength: float
    sideways: float
    uncertain: float
    unclaimed: float


class Guarded(Layout):
    """The memory of ``GuardedTransfer``: its own parameters, that of ``PixelTransfer``, fractions of help."""

    guard: Guard
    transfer: pixels.Memory
    owed: pixels.Carried


SETTINGS, END = Guard.length + pixels.Settings.length, Guarded.length
"""So many numbers of a ``Guarded`` are parameters, of so many."""


class OffsetReport(NamedTuple):
    """A report, ``t`` s and ``dx dy`` counts, and the endpoint from the cursor, ``off_x off_y`` px or NaN."""

    t: float
    dx: float
    dy: float
    off_x: float
    off_y: float


class GuidedReport(NamedTuple):
    """A report, ``t`` s and ``dx dy`` counts, and a ``Way``."""

    t: float
    dx: float
    dy: float
    off_x: float
    off_y: float
    sxx: float
    sxy: float
    syy: float


@law
def offset_report_at(rows: FloatTable, i: int) -> Way:
    """A row of a table of reports with the way to an endpoint."""
    r = rows[i]
    return r[0], r[1], r[2], r[3], r[4]


@law
def guided_report_at(
    rows: FloatTable, i: int
) -> tuple[float, float, float, float, float, float, float, float]:
    """A row of a table of reports with the way to an endpoint and its covariance."""
    r = rows[i]
    return r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7]


@law
def pull(rho: float, strength: float, dt: float, own_px: float, off_x: float, off_y: float) -> float:
    """The fraction of the offset (T_hat - x, T_hat_y - y) by which the cursor is pulled in ``dt`` s.

    The term -rho (x - T_hat) integrated exactly, 1 - exp(-rho dt), and never longer than ``strength`` times
    the ``own_px`` that the hand moved the cursor; 0 while no endpoint is predicted (NaN).
    """
    length = hypot(off_x, off_y)
    if not 0.0 < length < inf:
        return 0.0
    share = -expm1(-rho * dt)
    return min(share, strength * own_px / length) if strength < inf else share


@law
def assisted_step(
    memory: Assisted, report: tuple[float, float, float, float, float]
) -> tuple[float, float, float]:
    """One ``OffsetReport``: (t, dx in px, dy in px); NaN for a report that is refused."""
    t, dx, dy, off_x, off_y = OffsetReport(*report)
    usable, dt = pixels.accept(memory.transfer, t, dx, dy)
    if not usable or abs(off_x) > LARGEST or abs(off_y) > LARGEST:
        return nan, nan, nan
    scale = pixels.turn(memory.transfer, t, dt, dx, dy)
    x, y = scale * dx, scale * dy
    share = pull(memory.rho, memory.strength, dt, hypot(x, y), off_x, off_y)
    if share > 0.0:
        x += share * off_x
        y += share * off_y
    carried = memory.transfer.state.carried
    return t, pixels.carry(carried, 0, x), pixels.carry(carried, 1, y)


class AssistedTransfer(ReportStage):
    """Counts to whole pixels through a transfer function, pulled towards a predicted endpoint.

    Assumes a good prediction: a wrong one pulls the cursor away, and with an unlimited ``strength`` it moves
    the cursor of a resting hand, which nobody expects. How people react to it is unknown.

    x' = V_mx / V_m PTF(V_m) - rho (x - T_hat), integrated exactly over a report; the pull is bounded to
    ``strength`` times the hand's own motion of the cursor. Below 1 the hand can always leave a wrong
    endpoint.

    Parameters: ``rho`` in 1/s; ``strength``, infinite as printed in the remark; ``function``, ``cpi``,
    ``dpi``, ``period_s``, ``gap_s`` as for ``PixelTransfer``. Memory: 19 floats.
    Raises ParameterError, and EventError from ``update``.
    Reference: Khalin 2022, Remark 2.2.1.

    >>> from pointpred.transfer import ConstantGain
    >>> stage = AssistedTransfer(ConstantGain(4.0), rho=10.0, strength=0.5, cpi=2000.0)
    >>> stage.update((0.0, 20.0, 0.0), (500.0, 0.0))  # 3.84 px by hand, half as much by the pull
    (5.0, 0.0)
    """

    rho: float = parameter("1/s", 0.0, 1e4, "rate at which the cursor is pulled to the endpoint", default=5.0)
    strength: float = parameter("", 0.0, inf, "longest pull as a share of the hand's own motion", default=0.5)
    states = pixels.State.length
    width = 3
    loop = staticmethod(loop_of(assisted_step, offset_report_at))

    def update(
        self, report: tuple[float, float, float], off_px: tuple[float, float] | None = None, /
    ) -> tuple[float, float]:
        """Consume one report (t in s, dx and dy in counts) and return the whole pixels moved.

        ``off_px`` is the predicted endpoint minus the cursor in px, ``None`` without a prediction. Raises
        EventError when time runs backwards or a value is not finite; the stage is then unchanged.
        """
        t, dx, dy = report
        off_x, off_y = (nan, nan) if off_px is None else off_px
        t, dx, dy = assisted_step(self._memory, (t, dx, dy, off_x, off_y))
        if t != t:
            last = float(Assisted(self._memory).transfer.state.t)
            raise EventError(
                f"report must be finite and not before t = {last!r} s, received {report!r}, {off_px!r}",
                value=report,
            )
        return dx, dy


@law
def spread(way_px: float, sxx: float, sxy: float, syy: float, unclaimed: float) -> float:
    """The endpoint's standard deviation along the longest axis of its region, as a share of the way to it.

    ``unclaimed`` without a region (sxx is NaN).
    """
    if sxx != sxx:
        return unclaimed
    if not (abs(sxx) < inf and abs(sxy) < inf and abs(syy) < inf):
        return inf
    return sqrt(max(0.5 * (sxx + syy) + hypot(0.5 * (sxx - syy), sxy), 0.0)) / way_px


@law
def guide(guard: Guard, dt: float, own: tuple[float, float], way: Way) -> tuple[float, float]:
    """The px added to the hand's ``own`` (x, y) in ``dt`` s.

    ``way`` leads from the cursor before the report to the endpoint. Nothing is added for a hand at rest or
    moving away from the endpoint. Along the hand's direction the pull is never negative, never longer than
    ``strength`` of the hand's own way and never past the endpoint; across it is at most ``strength *
    sideways`` of that way times the cosine of the angle to the endpoint.
    """
    own_x, own_y = own
    off_x, off_y, sxx, sxy, syy = way
    moved, distance = hypot(own_x, own_y), hypot(off_x, off_y)
    if not (0.0 < moved < inf and 0.0 < distance < inf):
        return 0.0, 0.0
    trust = 1.0 - spread(distance, sxx, sxy, syy, guard.unclaimed) / guard.uncertain
    to_x, to_y = own_x / moved, own_y / moved
    ahead, beside = off_x * to_x + off_y * to_y, off_y * to_x - off_x * to_y
    if not (trust > 0.0 and ahead > 0.0):
        return 0.0, 0.0
    share = -expm1(-guard.rho * dt)
    longest = guard.strength * moved
    widest = guard.sideways * longest
    along = trust * min(share * ahead, longest, max(ahead - moved, 0.0))
    across = trust * min(max(share * beside * (ahead / distance), -widest), widest)
    return along * to_x - across * to_y, along * to_y + across * to_x


@law
def add(
    guard: Guard, owed: pixels.Carried, dt: float, own: tuple[float, float], way: Way
) -> tuple[float, float]:
    """``guide`` in whole pixels, with the fractions carried.

    Rounding may release a pixel of one axis first; a pixel against the hand is dropped.
    """
    x, y = guide(guard, dt, own, way)
    whole_x, whole_y = pixels.carry(owed, 0, x), pixels.carry(owed, 1, y)
    if whole_x * own[0] + whole_y * own[1] < 0.0:
        clear(owed)
        return 0.0, 0.0
    return whole_x, whole_y


@law
def guarded_step(
    memory: Guarded, report: tuple[float, float, float, float, float, float, float, float]
) -> tuple[float, float, float, float, float]:
    """One ``GuidedReport``: (t, dx px, dy px, and the added part of these); NaN if refused."""
    t, dx, dy, off_x, off_y, sxx, sxy, syy = GuidedReport(*report)
    usable, dt = pixels.accept(memory.transfer, t, dx, dy)
    if not usable or abs(off_x) > LARGEST or abs(off_y) > LARGEST:
        return nan, nan, nan, nan, nan
    scale = pixels.turn(memory.transfer, t, dt, dx, dy)
    own_x, own_y = scale * dx, scale * dy
    carried = memory.transfer.state.carried
    x, y = pixels.carry(carried, 0, own_x), pixels.carry(carried, 1, own_y)
    add_x, add_y = add(memory.guard, memory.owed, dt, (own_x, own_y), (off_x, off_y, sxx, sxy, syy))
    return t, x + add_x, y + add_y, add_x, add_y


class GuardedTransfer(ReportStage):
    """Counts to whole pixels, with bounded assistance towards a predicted endpoint.

    Assumes that the endpoint and its region are reliable: with a wrong endpoint of small region in the hand's
    direction the cursor overshoots and the hand has to come back. It speeds up and bends the motion and never
    slows it, so a hand that would have stopped correctly goes too far.

    x' = V_mx / V_m PTF(V_m) - rho (x - T_hat), the second term integrated over a report, split along and
    across the hand's direction, and bounded: along in [0, strength m] and never past the endpoint, across
    in strength sideways m cos(angle) at most, where m is the hand's own motion and the angle that to the
    endpoint. Both fade as 1 - s / (``uncertain`` d), with s the largest standard deviation of the normal law
    with the same 50 % region, and d the distance of the endpoint. At rest, at angles above 90 degrees and
    without a prediction nothing is added; whole pixels, too, are never added against the hand. With
    ``strength`` 0 it is ``PixelTransfer`` bit for bit.

    Parameters: ``rho`` in 1/s; ``strength`` and ``sideways`` in [0, 1]; ``uncertain`` and ``unclaimed``, the
    s / d of a prediction without a region; the others as for ``PixelTransfer``.
    Memory: 24 floats. Raises ParameterError, and EventError from ``update``.
    Reference: Khalin 2022, Remark 2.2.1, with a bound and a direction.

    >>> from pointpred.transfer import ConstantGain
    >>> stage = GuardedTransfer(ConstantGain(4.0), rho=10.0, strength=0.5, cpi=2000.0)
    >>> sure = Prediction(0.0, 500.0, 0.0, (1.0, 0.0, 1.0), "ballistic", None)
    >>> stage.update((0.0, 20.0, 0.0), sure, (0.0, 0.0))  # 3.84 px by hand, half as much added
    (4.0, 0.0)
    >>> stage.update((0.001, -20.0, 0.0), sure, (4.0, 0.0))  # the hand leaves: nothing is added
    (-3.0, 0.0)
    """

    rho: float = parameter("1/s", 0.0, 1e4, "rate at which the cursor is pulled to the endpoint", default=8.0)
    strength: float = parameter("", 0.0, 1.0, "longest pull as a share of the hand's own motion", default=0.5)
    sideways: float = parameter(
        "",
        0.0,
        1.0,
        "longest pull across the hand's direction, as a share of strength",
        default=USUAL_GUARD[0],
    )
    uncertain: float = parameter(
        "", 1e-3, 1e3, "spread of the endpoint over the way to it at which help ends", default=USUAL_GUARD[1]
    )
    unclaimed: float = parameter(
        "", 0.0, 1e3, "that spread where a predictor claims none", default=USUAL_GUARD[2]
    )
    states = pixels.State.length + pixels.Carried.length
    width = 5
    step = staticmethod(guarded_step)
    loop = staticmethod(loop_of(guarded_step, guided_report_at))

    def update(
        self,
        report: tuple[float, float, float],
        prediction: Prediction | None = None,
        cursor: tuple[float, float] = (0.0, 0.0),
        /,
    ) -> tuple[float, float]:
        """Consume one report (t in s, dx and dy in counts) and return the whole pixels moved.

        ``prediction`` is the newest one before the report, ``cursor`` (px) the cursor before it. Raises
        EventError when time runs backwards or a value is not finite; the stage is then unchanged.
        """
        t, dx, dy, _, _ = self.advance((*report, *way_to(prediction, cursor)))
        if t != t:
            last = float(Guarded(self._memory).transfer.state.t)
            raise EventError(
                f"report must be finite and not before t = {last!r} s, the endpoint within {LARGEST:g} px, "
                f"received {report!r}, {prediction!r} at {cursor!r}",
                value=report,
            )
        return dx, dy


def way_to(prediction: Prediction | None, cursor: tuple[float, float]) -> Way:
    """A prediction as a row of the law: the way to it from the cursor (px), and a covariance (px^2).

    The covariance is that of the normal law with the same 50 % region: Student laws of small tails have no
    covariance.
    """
    if prediction is None:
        return UNGUIDED
    off = prediction.x - cursor[0], prediction.y - cursor[1]
    if prediction.scale is None:
        return *off, nan, nan, nan
    return *off, *as_normal(*prediction.scale, nan if prediction.tail is None else prediction.tail)
