"""No prediction: the endpoint is where the cursor is now. The floor every predictor is scored against."""

from __future__ import annotations

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.predictors import movement
from pointpred.predictors.predictor import NONE, REFUSED, Predictor

AT = 0


@law
def step(
    memory: FloatArray,
    t: float,
    x: float,
    y: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    settled: float,
    start: float,
) -> tuple[float, float, float, float, float, float, float]:
    """The cursor's position is the answer."""
    accepted, _, _ = movement.follow(memory, AT, t, x, y, vx, vy, ax, ay, start)
    if not accepted:
        return REFUSED
    return x, y, NONE, NONE, NONE, NONE, movement.phase(memory, AT, vx, vy)


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        r = rows[i]
        answer = step(memory, r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8])
        out[i, 0] = r[0]
        for j in range(len(answer)):
            out[i, j + 1] = answer[j]


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
    loop = staticmethod(loop)

    def __init__(self) -> None:
        super().__init__([], movement.STATES)
