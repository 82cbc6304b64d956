"""No prediction: the endpoint is where the cursor is now. The floor every predictor is scored against."""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, MotionRow, TenFloats, endpoint


@law
def step(s: movement.State, motion: TenFloats) -> TenFloats:
    """The cursor's position is the answer."""
    m = MotionRow(*motion)
    fault, _, _ = movement.follow(s, m)
    if fault != FINE:
        return movement.refuse(s, m, fault)
    return endpoint(m.t, m.x, m.y, movement.phase(s, m))


class HoldPredictor(Predictor):
    """No prediction: the cursor's own position.

    Assumes nothing, says nothing early. Always answers. Memory: 9 floats.

    >>> from pointpred import PointerEvent, build
    >>> pipeline = build("hold")
    >>> prediction = pipeline.update(PointerEvent(0.0, 3.0, 4.0))
    >>> prediction.x, prediction.y
    (3.0, 4.0)
    """

    step = staticmethod(step)
    claims_time = False
    states = movement.State.length
