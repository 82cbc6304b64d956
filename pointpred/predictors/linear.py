"""Constant velocity over a fixed horizon: what page prefetchers do."""

from __future__ import annotations

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.events import ROUNDING_S
from pointpred.predictors import movement
from pointpred.predictors.predictor import NONE, REFUSED, Predictor
from pointpred.stage import Parameter, check

KEPT_MOST = 8

HORIZON_S, WINDOW_S, AT = 0, 1, 2
KEPT = AT + movement.STATES  # how many past samples are kept
PAST = KEPT + 1  # (t, x, y) of each, the newest first
STATES = movement.STATES + 1 + 3 * KEPT_MOST


@law
def remember(memory: FloatArray, t: float, x: float, y: float) -> None:
    """Keep a sample if the newest kept is an eighth of the window old; one of the same time is replaced."""
    kept = int(memory[KEPT])
    same = kept > 0 and memory[PAST] == t
    if kept > 0 and not same and t - memory[PAST] < memory[WINDOW_S] / KEPT_MOST - ROUNDING_S:
        return
    if not same:
        for i in range(3 * KEPT_MOST - 1, 2, -1):
            memory[PAST + i] = memory[PAST + i - 3]
        memory[KEPT] = min(kept + 1, KEPT_MOST)
    memory[PAST], memory[PAST + 1], memory[PAST + 2] = t, x, y


@law
def before(memory: FloatArray, t: float) -> tuple[bool, float, float, float]:
    """Whether a sample before ``t`` is kept, and the oldest within the window, else the newest: (t, x, y)."""
    found = -1
    for i in range(int(memory[KEPT])):
        age = t - memory[PAST + 3 * i]
        if age > 0.0 and (found < 0 or age <= memory[WINDOW_S] + ROUNDING_S):
            found = PAST + 3 * i
    if found < 0:
        return False, t, 0.0, 0.0
    return True, memory[found], memory[found + 1], memory[found + 2]


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
    """Carry the mean velocity of the window on over the horizon."""
    accepted, new, _ = movement.follow(memory, AT, t, x, y, vx, vy, ax, ay, start)
    if not accepted:
        return REFUSED
    if new:
        memory[KEPT] = 0.0
    phase = movement.phase(memory, AT, vx, vy)
    known, before_t, before_x, before_y = before(memory, t)
    remember(memory, t, x, y)
    if not known:
        return NONE, NONE, NONE, NONE, NONE, NONE, phase
    ahead = memory[HORIZON_S] / max(t - before_t, memory[WINDOW_S] / KEPT_MOST)
    return x + ahead * (x - before_x), y + ahead * (y - before_y), NONE, NONE, NONE, NONE, phase


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


class LinearPredictor(Predictor):
    """Constant velocity: where the cursor will be after a fixed time if it goes on as it does.

    Assumes that the velocity stays, which no pointing movement does: early it points too near, late too
    far. It predicts a position soon, not the endpoint, and is here because page prefetchers use it.

    x + horizon (x - x_k) / max(t - t_k, window / 8), with (t_k, x_k) the oldest of at most 8 kept samples
    of this movement within the window. The velocity is the cursor's own, in px/s: the hand's would need the
    pointer transfer function, which is unknown and not constant. Samples are kept an eighth of the window
    apart, so that the window means the same at every rate; at 60 Hz they are the last 8 of ForesightJS.

    ``None`` at a movement's first motion. The endpoint is bounded by the way done within the window: at
    most 8 horizon / window times as far ahead. A standstill inside the window pulls the velocity down; a
    reversal shows after half a window. A second motion of the same time replaces the position.

    Parameters: ``horizon_s`` s, ``window_s`` s. Memory: 36 floats. Claims neither region nor time of
    arrival. Raises ParameterError, and EventError from ``update``.

    Reference: ForesightJS (8 positions, 120 ms).

    >>> from pointpred import PointerEvent, build
    >>> pipeline = build("linear", horizon_s=0.1)
    >>> for i in range(30):
    ...     prediction = pipeline.update(PointerEvent(i / 100, 5.0 * i, 0.0))
    >>> round(prediction.x, 6)  # 145 px, 500 px/s
    195.0
    """

    parameters = (
        Parameter("horizon_s", "s", 0.0, 1.0, "how far ahead the velocity is carried on"),
        Parameter("window_s", "s", 1e-3, 1.0, "over how long the velocity is averaged"),
    )
    step = staticmethod(step)
    loop = staticmethod(loop)

    def __init__(self, *, horizon_s: float = 0.12, window_s: float = 0.12) -> None:
        check(self.parameters, {"horizon_s": horizon_s, "window_s": window_s})
        super().__init__([float(horizon_s), float(window_s)], STATES)
