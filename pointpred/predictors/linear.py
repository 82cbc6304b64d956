"""Constant velocity over a fixed horizon: what page prefetchers do."""

from __future__ import annotations

from math import nan

from pointpred.compiled import law
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, ROUNDING_S, FloatArray, MotionRow, TenFloats, endpoint
from pointpred.stage import offsets

CAPACITY = 8
"""Past samples that are remembered."""
# The parameters; the movement; how many past samples there are, and (t, x, y) of each, the newest first.
HORIZON_S, WINDOW_S, AT, COUNT, PAST, END = offsets(1, 1, movement.State.length, 1, 3 * CAPACITY)


@law
def remember(memory: FloatArray, t: float, x: float, y: float) -> None:
    """Remember a sample if the newest is an eighth of the window old; one of the same time is replaced."""
    count = int(memory[COUNT])
    same = count > 0 and memory[PAST] == t
    if count > 0 and not same and t - memory[PAST] < memory[WINDOW_S] / CAPACITY - ROUNDING_S:
        return
    if not same:
        for i in range(3 * CAPACITY - 1, 2, -1):
            memory[PAST + i] = memory[PAST + i - 3]
        memory[COUNT] = min(count + 1, CAPACITY)
    memory[PAST], memory[PAST + 1], memory[PAST + 2] = t, x, y


@law
def before(memory: FloatArray, t: float) -> tuple[bool, float, float, float]:
    """Whether there is a sample before ``t``; the oldest within the window, else the newest: (t, x, y)."""
    place = -1
    for i in range(int(memory[COUNT])):
        age = t - memory[PAST + 3 * i]
        if age > 0.0 and (place < 0 or age <= memory[WINDOW_S] + ROUNDING_S):
            place = PAST + 3 * i
    if place < 0:
        return False, t, 0.0, 0.0
    return True, memory[place], memory[place + 1], memory[place + 2]


@law
def step(memory: FloatArray, motion: TenFloats) -> TenFloats:
    """Carry the mean velocity of the window on over the horizon."""
    m = MotionRow(*motion)
    fault, new, _ = movement.follow(movement.State(memory, AT), m)
    if fault != FINE:
        return movement.refuse(movement.State(memory, AT), m, fault)
    if new:
        memory[COUNT] = 0.0
    phase = movement.phase(movement.State(memory, AT), m)
    any_before, before_t, before_x, before_y = before(memory, m.t)
    remember(memory, m.t, m.x, m.y)
    if not any_before:
        return endpoint(m.t, nan, nan, phase)
    ahead = memory[HORIZON_S] / max(m.t - before_t, memory[WINDOW_S] / CAPACITY)
    return endpoint(m.t, m.x + ahead * (m.x - before_x), m.y + ahead * (m.y - before_y), phase)


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
    claims_time = False
    states = END - AT
