"""Which targets fire a prefetch: several at once, each early where its probability reaches the threshold.

A target fires when the cursor enters it at the latest, and a firing is never withdrawn. Only a firing for a
target that the cursor never enters costs something. So a target is judged by the probability that the cursor
goes through it, more than by the probability that the movement ends there.
"""

from __future__ import annotations

from math import hypot, inf, log

import numpy as np

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.targets import cursor, decision
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, LOG_WEIGHT, WIDTH

ARMED, FIRED, RESTING, PREDICTED, ENTERED = 0.0, 1.0, 2.0, 3.0, 4.0
"""Of each target: nothing yet; fired in this movement; fired before it and not left since; fires at this
call, by prediction or because the cursor is in it."""

BEGAN, COUNT, STATES = cursor.STATES, cursor.STATES + 1, cursor.STATES + 2
"""Places in the memory behind those of the cursor: when the movement began, s, and its firings."""

PATHS, NEGLIGIBLE = 8, 1e-3
"""The cursor is taken to go straight to one of so many likeliest targets, each of at least this share."""
LEAST_WAY_PX = 3.0
"""Nothing is predicted nearer to where the movement started."""
REFERENCE_S, SHORTEST_S, LONGEST_S = 0.25, 0.005, 5.0
"""Times to contact count as logarithms over the first, within the bounds of the others."""
AGE_S = 1.0
"""The longest time since the start that counts."""
SMALLEST, LEAST_VISITS = 1e-6, 0.05
"""Bounds on probabilities and on their sum in logarithms."""

THRESHOLD, ELSEWHERE = 0.5, 0.02
"""Defaults: how likely a visit of a target must be, and the share of movements that go to none of them."""
BASE, END, SPENT, NEAR, FAR, AGE, PASSED, SURE, LATE_S, LATE, SETTINGS = range(11)
"""Places of the settings."""
FITTED = (1.72, 0.665, 0.0555, 0.336, 0.227, 0.26, 0.687, 3.18, 0.103, 0.477)
"""Settings by ``python -m pages.intent.fit``, for shares by ``posterior.FITTED_PAGES``."""

Targets = tuple[FloatArray, FloatArray, FloatArray, FloatArray]
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
def visit(x: float, y: float, table: FloatArray, shares: FloatArray, out: FloatArray) -> None:
    """How likely the cursor goes through each target: its share, and the shares of what lies behind it.

    The cursor is taken to go straight to the centre of one of the PATHS likeliest targets.
    """
    ends = np.empty(PATHS)
    decision.rank(shares, len(table), ends)
    for i in range(len(table)):
        total = shares[i]
        for place in range(PATHS):
            end = int(ends[place])
            if end == decision.NOBODY or end == i or shares[end] < NEGLIGIBLE:
                continue
            to_x, to_y = table[end, CENTRE_X] - x, table[end, CENTRE_Y] - y
            if contact(x, y, to_x, to_y, table[i]) <= 1.0:
                total += shares[end]
        out[i] = total


@law
def begin(memory: FloatArray, table: FloatArray, fired: FloatArray) -> None:
    """Arm every target anew where a movement has begun; those that it starts in first have to be left."""
    for i in range(len(table)):
        if fired[i] == PREDICTED or fired[i] == ENTERED:
            fired[i] = FIRED
    if memory[BEGAN] == memory[cursor.T0]:
        return
    memory[BEGAN], memory[COUNT] = memory[cursor.T0], 0.0
    for i in range(len(table)):
        if fired[i] != ARMED:
            fired[i] = RESTING if inside(memory[cursor.X0], memory[cursor.Y0], table[i]) else ARMED


@law
def urgency(memory: FloatArray, row: FloatArray, settings: FloatArray) -> float:
    """The term of the time to contact: a parabola in its logarithm, 0 at REFERENCE_S."""
    left_s = cursor.until(memory, row[CENTRE_X], row[CENTRE_Y], row[WIDTH], row[HEIGHT])
    near = -log(min(max(left_s, SHORTEST_S), LONGEST_S) / REFERENCE_S)
    return float(settings[NEAR] * near - settings[FAR] * near * near)


@law
def log_odds(p: float) -> float:
    """Logarithm of p over 1 - p, finite also at 0 and 1."""
    p = min(max(p, SMALLEST), 1.0 - SMALLEST)
    return log(p / (1.0 - p))


@law
def step(memory: FloatArray, targets: Targets, shares: FloatArray, settings: FloatArray) -> int:
    """Decide which targets fire now; returns how many.

    ``memory``: STATES floats, the first of which ``cursor.follow`` has brought up to the last event; it need
    not be called at every event, once a frame is enough. ``targets``: the table, the thresholds, and what is
    written: how likely the cursor goes through each target, and a state of each, PREDICTED or ENTERED where
    it fires at this call. ``shares``: those of the targets, and of none of them. A target fires once a
    movement, and is armed again where the next one begins, or if that starts in it, once the cursor has left
    it. A target of weight 0 never fires.

    A target fires where the sum of these terms reaches the logarithm of the odds of its threshold. The
    threshold, in (0, 1), is how likely it must be that the cursor goes through the target; higher fires later
    and less often.

    - BASE, and the logarithm of the odds of a visit;
    - plus PASSED times the logarithm of the expected number of targets visited, without those it is in;
    - plus AGE times the time since the start, s, at most AGE_S;
    - plus NEAR n - FAR n², where n is the logarithm of REFERENCE_S over the time to contact;
    - plus END times the logarithm of the share over the probability of a visit, which is at most 0;
    - minus SURE times the share of the likeliest target;
    - minus SPENT times the firings of this movement so far.

    It also fires where the cursor's own line meets it within LATE_S s and the probability of a visit is at
    least LATE and the threshold.
    """
    table, thresholds, visits, fired = targets
    begin(memory, table, fired)
    x, y = memory[cursor.X], memory[cursor.Y]
    visit(x, y, table, shares, visits)
    passed, sure = 0.0, 0.0
    for i in range(len(table)):
        if not inside(x, y, table[i]):
            passed, sure = passed + visits[i], max(sure, shares[i])
    common = settings[BASE] + settings[PASSED] * log(max(passed, LEAST_VISITS)) - settings[SURE] * sure
    common += settings[AGE] * min(memory[cursor.T] - memory[cursor.T0], AGE_S)
    moves = hypot(x - memory[cursor.X0], y - memory[cursor.Y0]) >= LEAST_WAY_PX
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
        likely = max(visits[i], SMALLEST)
        score = common + log_odds(likely) + settings[END] * log(max(shares[i], SMALLEST) / likely)
        score += urgency(memory, table[i], settings) - settings[SPENT] * (memory[COUNT] + count)
        line_s = contact(x, y, memory[cursor.VX], memory[cursor.VY], table[i])
        late = line_s <= settings[LATE_S] and likely >= max(settings[LATE], thresholds[i])
        if late or score >= log_odds(thresholds[i]):
            fired[i], count = PREDICTED, count + 1
    memory[COUNT] += count
    return count
