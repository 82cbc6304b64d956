"""Minimum-jerk inversion: how far along a minimum-jerk movement is, from its speed against its peak."""

from __future__ import annotations

from math import hypot, nan, sqrt

from pointpred.compiled import law
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, MotionRow, TenFloats, endpoint


@law
def progress(ratio: float) -> tuple[float, float]:
    """Share of the time and of the way done, from the speed as a share of its peak, after the peak."""
    tau = 0.5 * (1.0 + sqrt(1.0 - sqrt(min(max(ratio, 0.0), 1.0))))
    return tau, tau * tau * tau * (10.0 - tau * (15.0 - 6.0 * tau))


@law
def step(s: movement.State, motion: TenFloats) -> TenFloats:
    """Divide the way done by the share that the speed says is done."""
    m = MotionRow(*motion)
    fault, _, _ = movement.follow(s, m)
    if fault != FINE:
        return movement.refuse(s, m, fault)
    phase = movement.phase(s, m)
    if s.peak < movement.STILL_M_S:
        return endpoint(m.t, nan, nan, phase)
    tau, done = progress(hypot(m.vx, m.vy) / s.peak)
    ahead = (1.0 - done) / done
    return (
        m.t,
        m.x + ahead * (m.x - s.x0),
        m.y + ahead * (m.y - s.y0),
        nan,
        nan,
        nan,
        (m.t - s.t0) * (1.0 - tau) / tau,
        phase,
        nan,
        nan,
    )


class MinimumJerkPredictor(Predictor):
    """Minimum-jerk inversion: the speed as a share of its peak tells how much of the way is done.

    Assumes one straight movement from rest with the speed profile of least jerk; nothing is trained. Exact
    for such a movement from its peak on. Up to the peak, which nobody can know to come, it doubles the way
    done, so it says too little; a late second peak makes it double again, and it never points back after
    an overshoot. A sub-movement below the peak is read as a late part of the same movement.

    With r = v / v_peak, r = 1 up to the peak: v / v_peak = 16 tau^2 (1 - tau)^2 gives the share of the time
    tau = (1 + sqrt(1 - sqrt r)) / 2, and s = 10 tau^3 - 15 tau^4 + 6 tau^5 the share of the way. Endpoint =
    cursor + (cursor - start) (1 - s) / s, remaining time = time since the start (1 - tau) / tau.

    The start is where ``Motion.start`` last was. ``None`` until the speed first reaches 2 mm/s; the
    endpoint is then never farther ahead than the start lies behind. A still cursor (r = 0) has arrived. A
    second motion of the same time replaces the position. Of the speed only its ratio to the peak matters,
    so the hand's speed stands for the cursor's, as far as the gain between them is constant.

    Memory: 9 floats. Claims no region. Raises EventError from ``update``.

    Reference: Flash, Hogan 1985; the speed peak halfway also in Khalin 2022, section 2.6.3.

    >>> from pointpred import Motion
    >>> predictor = MinimumJerkPredictor()
    >>> predictor.update(Motion(0.0, 100.0, 0.0, 0.0, 0.0, 0.0, 0.0, True, start=True)) is None
    True
    >>> peak = predictor.update(Motion(0.3, 200.0, 0.0, 0.5, 0.0, 0.0, 0.0, True))
    >>> round(peak.x, 6), round(peak.remaining_s, 6)
    (300.0, 0.3)
    """

    step = staticmethod(step)
    states = movement.State.length
