"""Constant velocity over a fixed horizon: what page prefetchers do."""

from __future__ import annotations

from math import nan

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.events import ROUNDING_S
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor, loop_over_motions
from pointpred.rows import REFUSED, MotionRow, Row, TenFloats, endpoint

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
def step(memory: FloatArray, motion: Row) -> TenFloats:
    """Carry the mean velocity of the window on over the horizon."""
    m = MotionRow(*motion)
    accepted, new, _ = movement.follow(memory, AT, m)
    if not accepted:
        return REFUSED
    if new:
        memory[KEPT] = 0.0
    phase = movement.phase(memory, AT, m)
    known, before_t, before_x, before_y = before(memory, m.t)
    remember(memory, m.t, m.x, m.y)
    if not known:
        return endpoint(m.t, nan, nan, phase)
    ahead = memory[HORIZON_S] / max(m.t - before_t, memory[WINDOW_S] / KEPT_MOST)
    return endpoint(m.t, m.x + ahead * (m.x - before_x), m.y + ahead * (m.y - before_y), phase)


loop = loop_over_motions(step)


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

    horizon_s: float = parameter("s", 0.0, 1.0, "how far ahead the velocity is carried on", default=0.12)
    window_s: float = parameter("s", 1e-3, 1.0, "over how long the velocity is averaged", default=0.12)
    step = staticmethod(step)
    loop = staticmethod(loop)
    states = STATES
