"""Constant velocity over a fixed horizon: what page prefetchers do."""

from __future__ import annotations

from math import nan
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, ROUNDING_S, FloatTable, MotionRow, TenFloats, endpoint

CAPACITY = 8
"""Past samples that are remembered."""


class Settings(Layout):
    """The parameters."""

    horizon_s: float
    window_s: float


class Past(Layout):
    """How many past samples there are, and (t, x, y) of each, the newest first."""

    count: float
    samples: Annotated[FloatTable, CAPACITY, 3]


class State(Layout):
    """What is remembered of the movement."""

    movement: movement.State
    past: Past


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


@law
def remember(past: Past, window_s: float, t: float, x: float, y: float) -> None:
    """Remember a sample if the newest is an eighth of the window old; one of the same time is replaced."""
    count = int(past.count)
    same = count > 0 and past.samples[0, 0] == t
    if count > 0 and not same and t - past.samples[0, 0] < window_s / CAPACITY - ROUNDING_S:
        return
    if not same:
        for i in range(CAPACITY - 1, 0, -1):
            for j in range(3):
                past.samples[i, j] = past.samples[i - 1, j]
        past.count = min(count + 1, CAPACITY)
    past.samples[0, 0], past.samples[0, 1], past.samples[0, 2] = t, x, y


@law
def before(past: Past, window_s: float, t: float) -> tuple[bool, float, float, float]:
    """Whether there is a sample before ``t``; the oldest within the window, else the newest: (t, x, y)."""
    found = -1
    for i in range(int(past.count)):
        age = t - past.samples[i, 0]
        if age > 0.0 and (found < 0 or age <= window_s + ROUNDING_S):
            found = i
    if found < 0:
        return False, t, 0.0, 0.0
    return True, past.samples[found, 0], past.samples[found, 1], past.samples[found, 2]


@law
def step(memory: Memory, motion: TenFloats) -> TenFloats:
    """Carry the mean velocity of the window on over the horizon."""
    m = MotionRow(*motion)
    settings, s, past = memory.settings, memory.state.movement, memory.state.past
    fault, new, _ = movement.follow(s, m)
    if fault != FINE:
        return movement.refuse(s, m, fault)
    if new:
        past.count = 0.0
    phase = movement.phase(s, m)
    any_before, before_t, before_x, before_y = before(past, settings.window_s, m.t)
    remember(past, settings.window_s, m.t, m.x, m.y)
    if not any_before:
        return endpoint(m.t, nan, nan, phase)
    ahead = settings.horizon_s / max(m.t - before_t, settings.window_s / CAPACITY)
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
    states = State.length
