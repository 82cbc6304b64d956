"""Which targets fire a prefetch: several at once, each early where its probability reaches the threshold.

A target fires when the cursor enters it at the latest, and a firing is never withdrawn. Only a firing for a
target that the cursor never enters costs something. So a target is judged by the probability that the cursor
goes through it, more than by the probability that the movement ends there.
"""

from __future__ import annotations

from collections.abc import Hashable
from math import exp, hypot, inf, log
from typing import NamedTuple

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.parameter import Parameter, check
from pointpred.records import FloatArray, FloatTable, SixFloats
from pointpred.targets import cursor, decision
from pointpred.targets.chooser import Aimed
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, LOG_WEIGHT, NOBODY, WIDTH

ARMED, FIRED, RESTING, PREDICTED, ENTERED = 0.0, 1.0, 2.0, 3.0, 4.0
"""Of each target: nothing yet; fired in this movement; fired before it and not left since; fires at this
call, by prediction or because the cursor is in it."""


class State(Layout):
    """The cursor, and when the movement began, s."""

    cursor: cursor.State
    began: float


STATES = State.length
"""For JavaScript that makes a memory."""

PATHS, NEGLIGIBLE = 8, 1e-3
"""The cursor is taken to go straight to one of so many likeliest targets, each of at least this share."""
LEAST_WAY_PX = 3.0
"""Nothing is predicted nearer to where the movement started."""
REFERENCE_S, SHORTEST_S, LONGEST_S = 0.25, 0.005, 5.0
"""Times to contact count as logarithms over the first, within the bounds of the others."""
SMALLEST, LEAST_VISITS = 1e-6, 0.05
"""Bounds on probabilities and on their sum in logarithms."""
ROUNDING = 1e-6
"""What rounding may add to a way, px, or to a sum of terms."""

THRESHOLD = 0.5
"""Unless given, how likely a visit of a target must be."""


class Settings(Layout):
    """What ``step`` weighs."""

    base: float
    end: float
    near: float
    far: float
    passed: float
    sure: float


FITTED = (1.445, 0.84, 0.375, 0.148, 0.666, 2.595)
"""Settings by ``python -m evidence intent fit``, for shares by ``posterior.FITTED_PAGES``."""


class Expected(NamedTuple):
    """How many targets the cursor is expected to go through; the share of the likeliest."""

    passed: float
    sure: float


Targets = tuple[FloatTable, FloatArray, FloatArray, FloatArray]
"""The table of the targets; of each its threshold, how likely it is visited, and its state."""


@law
def contact(x: float, y: float, dx: float, dy: float, row: FloatArray) -> float:
    """How many steps (dx, dy) from (x, y) until the rectangle is met, 0 inside; infinite if it never is."""
    enters, leaves = 0.0, inf
    for axis in range(2):
        step = dx if axis == 0 else dy
        off = row[CENTRE_X] - x if axis == 0 else row[CENTRE_Y] - y
        half = 0.5 * (row[WIDTH] if axis == 0 else row[HEIGHT])
        if step == 0.0:
            if abs(off) > half:
                return inf
        else:
            near, far = (off - half) / step, (off + half) / step
            enters, leaves = max(enters, min(near, far)), min(leaves, max(near, far))
    return enters if enters <= leaves else inf


@law
def inside(x: float, y: float, row: FloatArray) -> bool:
    """Whether a point lies in a rectangle, its border included."""
    return bool(abs(row[CENTRE_X] - x) <= 0.5 * row[WIDTH] and abs(row[CENTRE_Y] - y) <= 0.5 * row[HEIGHT])


@law
def visit(x: float, y: float, table: FloatTable, shares: FloatArray, out: FloatArray) -> None:
    """How likely the cursor goes through each target: its share, and the shares of what lies behind it.

    The cursor is taken to go straight to the centre of one of the PATHS likeliest targets.
    """
    ends = np.empty(PATHS)
    decision.rank(shares, len(table), ends)
    for i in range(len(table)):
        out[i] = shares[i]
    for place in range(PATHS):
        end = int(ends[place])
        if end == NOBODY or shares[end] < NEGLIGIBLE:
            continue
        to_x, to_y = table[end, CENTRE_X] - x, table[end, CENTRE_Y] - y
        middle_x, middle_y = x + 0.5 * to_x, y + 0.5 * to_y
        across, down = 0.5 * abs(to_x) + ROUNDING, 0.5 * abs(to_y) + ROUNDING
        for i in range(len(table)):
            far_x, far_y = abs(table[i, CENTRE_X] - middle_x), abs(table[i, CENTRE_Y] - middle_y)
            if far_x > across + 0.5 * table[i, WIDTH] or far_y > down + 0.5 * table[i, HEIGHT]:
                continue  # aside of the way: most targets
            if i != end and contact(x, y, to_x, to_y, table[i]) <= 1.0:
                out[i] += shares[end]


@law
def begin(s: State, table: FloatTable, fired: FloatArray) -> None:
    """Arm every target anew where a movement has begun; those that it starts in first have to be left."""
    for i in range(len(table)):
        if fired[i] == PREDICTED or fired[i] == ENTERED:
            fired[i] = FIRED
    if s.began == s.cursor.t0:
        return
    s.began = s.cursor.t0
    for i in range(len(table)):
        if fired[i] != ARMED:
            fired[i] = RESTING if inside(s.cursor.x0, s.cursor.y0, table[i]) else ARMED


@law
def log_odds(p: float) -> float:
    """Logarithm of p over 1 - p, finite also at 0 and 1."""
    p = min(max(p, SMALLEST), 1.0 - SMALLEST)
    return log(p / (1.0 - p))


@law
def terms(s: cursor.State, row: FloatArray, share: float, visited: float, expected: Expected) -> SixFloats:
    """What the settings weigh of one target, in their order."""
    left_s = cursor.until(s, row[CENTRE_X], row[CENTRE_Y], row[WIDTH], row[HEIGHT])
    near = -log(min(max(left_s, SHORTEST_S), LONGEST_S) / REFERENCE_S)
    end = log(max(share, SMALLEST) / max(visited, SMALLEST))
    return 1.0, end, near, -near * near, log(max(expected.passed, LEAST_VISITS)), -expected.sure


@law
def score(
    s: cursor.State, row: FloatArray, share: float, visited: float, expected: Expected, settings: Settings
) -> float:
    """What ``step`` compares with the logarithm of the odds of a target's threshold."""
    t0, t1, t2, t3, t4, t5 = terms(s, row, share, visited, expected)
    total = log_odds(visited) + settings.base * t0 + settings.end * t1 + settings.near * t2
    total += settings.far * t3 + settings.passed * t4 + settings.sure * t5
    return total


@law
def least_visit(lowest: float, expected: Expected, settings: Settings) -> float:
    """How likely a visit must be at least for ``score`` to reach the lowest threshold, wherever it is."""
    soon, late = log(REFERENCE_S / SHORTEST_S), log(LONGEST_S / REFERENCE_S)
    most = max(settings.near * soon, -settings.near * late) + max(-settings.far, 0.0) * soon * soon
    most += max(settings.end * log(SMALLEST), 0.0) + settings.base + ROUNDING
    most += settings.passed * log(max(expected.passed, LEAST_VISITS)) - settings.sure * expected.sure
    return 1.0 / (1.0 + exp(most - log_odds(lowest)))


@law
def expect(x: float, y: float, table: FloatTable, visits: FloatArray, shares: FloatArray) -> Expected:
    """What lies ahead of the cursor, without the targets that it is in."""
    passed, sure = 0.0, 0.0
    for i in range(len(table)):
        if not inside(x, y, table[i]):
            passed, sure = passed + visits[i], max(sure, shares[i])
    return Expected(passed, sure)


@law
def step(s: State, targets: Targets, shares: FloatArray, settings: Settings) -> int:
    """Decide which targets fire now; returns how many.

    ``s``: ``cursor.follow`` has brought its cursor up to the last event; this need not be called at every
    event, once a frame is enough. ``targets``: the table, the thresholds, and what is
    written: how likely the cursor goes through each target, and a state of each, PREDICTED or ENTERED where
    it fires at this call. ``shares``: those of the targets, and of none of them. A target fires once a
    movement, and is armed again where the next one begins, or if that starts in it, once the cursor has left
    it. A target of weight 0 never fires.

    A target fires where the sum of these terms reaches the logarithm of the odds of its threshold. The
    threshold, in (0, 1), is how likely it must be that the cursor goes through the target; higher fires later
    and less often.

    - ``base``, and the logarithm of the odds of a visit;
    - plus ``passed`` times the logarithm of the expected number of targets visited, without those it is in;
    - plus ``near`` n - ``far`` n², where n is the logarithm of REFERENCE_S over the time to contact;
    - plus ``end`` times the logarithm of the share over the probability of a visit, which is at most 0;
    - minus ``sure`` times the share of the likeliest target.
    """
    table, thresholds, visits, fired = targets
    begin(s, table, fired)
    x, y = s.cursor.x, s.cursor.y
    visit(x, y, table, shares, visits)
    expected = expect(x, y, table, visits, shares)
    moves = hypot(x - s.cursor.x0, y - s.cursor.y0) >= LEAST_WAY_PX
    lowest = 1.0
    for i in range(len(table)):
        lowest = min(lowest, thresholds[i])
    least = least_visit(lowest, expected, settings)
    count = 0
    for i in range(len(table)):
        if table[i, LOG_WEIGHT] == -inf:
            continue
        if inside(x, y, table[i]):
            if fired[i] == ARMED:
                fired[i], count = ENTERED, count + 1
            continue
        if fired[i] == RESTING:
            fired[i] = ARMED
        if fired[i] != ARMED or not moves:
            continue
        if least > SMALLEST and visits[i] < least:
            continue  # nothing else can make up for that: most targets
        reached = score(s.cursor, table[i], shares[i], visits[i], expected, settings)
        if reached >= log_odds(thresholds[i]):
            fired[i], count = PREDICTED, count + 1
    return count


FITTED_SETTINGS: FloatArray = np.array(FITTED)


class Prefetcher:
    """Fires prefetches: several targets at once, each early where its probability reaches the threshold.

    ``update`` decides by the shares of the pipeline after its last event. Each target fires once a movement,
    when the cursor enters it at the latest; a firing is never withdrawn. ``threshold`` in (0, 1) is how
    likely it must be that the cursor goes through the target, on a scale on which 0.5 fires about as often as
    a straight line of 120 ms does; higher fires later and less often, 1 at entry only. Memory: 17 floats of
    the cursor and the movement, 3 a target. Raises ParameterError.

    >>> from pointpred import PointerEvent, build
    >>> from pointpred.targets import around
    >>> targets = [around("left", -400.0, 0.0, 40.0), around("right", 400.0, 0.0, 40.0)]
    >>> pipeline = build("minimum-jerk", targets=targets)
    >>> prefetcher = Prefetcher(pipeline)
    >>> for i in range(60):
    ...     _ = pipeline.update(PointerEvent(i / 100, 400.0 * (i / 60) ** 2 * (3 - 2 * i / 60), 0.0))
    ...     for id in prefetcher.update():
    ...         print(id)
    right
    """

    parameters = (
        Parameter("threshold", "", 0.0, 1.0, "how likely it must be that the cursor goes through the target"),
    )

    def __init__(self, pipeline: Aimed, *, threshold: float = THRESHOLD) -> None:
        check(self.parameters, {"threshold": threshold})
        self.pipeline = pipeline
        self._aim = pipeline.aim  # from now on it follows the cursor
        self._threshold = threshold
        self._state = State(np.zeros(State.length))
        self._ids: tuple[Hashable, ...] = ()
        self._fired, self._thresholds, self._visits = np.zeros(0), np.zeros(0), np.zeros(0)

    @property
    def visits(self) -> FloatArray:
        """How likely the cursor goes through each target after the last event, in their order."""
        return self._visits.copy()

    def update(self) -> tuple[Hashable, ...]:
        """Decide after the pipeline's last event: the targets that fire now, in their order.

        Where others are registered than before, one that stays and has fired does not fire again.
        """
        aim = self.pipeline.aim
        if aim.ids is not self._ids:
            known = dict(zip(self._ids, self._fired.tolist(), strict=True))
            self._ids, count = aim.ids, len(aim.ids)
            self._fired = np.array([known.get(id, ARMED) for id in self._ids])
            self._thresholds, self._visits = np.full(count, self._threshold), np.zeros(count)
        self._state.cursor.memory[:] = aim.cursor.memory
        targets = aim.table, self._thresholds, self._visits, self._fired
        if step(self._state.memory, targets, aim.shares, FITTED_SETTINGS) == 0:
            return ()
        return tuple(self._ids[i] for i in np.flatnonzero(self._fired >= PREDICTED).tolist())

    def reset(self) -> None:
        """Forget the movement, as the pipeline's ``reset`` does.

        What has fired is armed again, but for a target that the next event lies in.
        """
        self._state = State(np.zeros(State.length))
        self._fired[self._fired != ARMED] = RESTING
