"""Which targets are proposed, from how likely each is and where the cursor is."""

from __future__ import annotations

from math import inf

from pointpred.compiled import law
from pointpred.records import FloatArray, FloatTable
from pointpred.targets import cursor, decision
from pointpred.targets.decision import Settings
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, LOG_WEIGHT, NOBODY, WIDTH

KEEP = 0.4
"""A proposal stands while its share is at least this fraction of the required precision."""

OUTSIDE, INSIDE, ENTERED, RELEASED = 0.0, 1.0, 2.0, 3.0
"""Where the cursor is, for each target; ENTERED at the event that took it in, RELEASED once the button came
up while it was there, until it leaves."""


Targets = tuple[FloatTable, FloatArray, FloatArray]
"""The table of the targets; where the cursor is for each; how likely each is, and none of them."""


@law
def innermost(table: FloatTable, inside: FloatArray) -> int:
    """The smallest target that the cursor is in, of equal ones the last; NOBODY where there is none.

    The last, because what stands later in a page is drawn over what stands before it. Targets of weight 0,
    and those in which the button came up, are not looked at.
    """
    best = NOBODY
    for i in range(len(table)):
        if inside[i] == OUTSIDE or inside[i] == RELEASED or table[i, LOG_WEIGHT] == -inf:
            continue
        area = table[i, WIDTH] * table[i, HEIGHT]
        if best == NOBODY or area <= table[best, WIDTH] * table[best, HEIGHT]:
            best = i
    return best


@law
def enter(table: FloatTable, inside: FloatArray, x: float, y: float, released: bool) -> int:
    """Write where the cursor is for each target; returns how many it has just gone into."""
    count = 0
    for i in range(len(table)):
        row = table[i]
        if abs(row[CENTRE_X] - x) <= 0.5 * row[WIDTH] and abs(row[CENTRE_Y] - y) <= 0.5 * row[HEIGHT]:
            if inside[i] == OUTSIDE:
                inside[i] = ENTERED
                count += 1
            else:
                inside[i] = RELEASED if released or inside[i] == RELEASED else INSIDE
        else:
            inside[i] = OUTSIDE
    return count


@law
def decide(
    s: cursor.State,
    released: bool,
    remaining_s: float,
    targets: Targets,
    settings: Settings,
    standing: int,
) -> tuple[int, int, int]:
    """What follows from the shares at an event that the cursor has taken in.

    ``standing``: the target predicted up to now. Writes where the cursor is for each target, and returns the
    target predicted from now on, the target proposed because the cursor is in it (NOBODY where that one is
    predicted), and how many targets the cursor has just gone into. When the button comes up the movement is
    over, and so is everything it proposed: a target that the cursor stays in is not proposed again before the
    cursor has left it.
    """
    table, inside, shares = targets
    if released:
        standing = NOBODY
    count = enter(table, inside, s.x, s.y, released)
    ask, least_s = settings.precision, settings.least_lead_s
    bounds = ask, KEEP * ask, least_s, settings.least_way_px
    chosen = decision.decide(s, table, shares, standing, remaining_s, bounds)
    over = innermost(table, inside)
    return chosen, NOBODY if over == chosen else over, count


@law
def changes(before: tuple[int, int], now: tuple[int, int]) -> tuple[int, int, int, int]:
    """What ends and what begins: a prediction and an entry that end, a prediction and an entry that begin.

    ``before``, ``now``: the target that is predicted, and the one proposed because the cursor is in it.
    NOBODY for what does not change. A target whose reason alone changes stays proposed, which is no change.
    """
    predicted, entered = before
    chosen, over = now
    ends, leaves, begins, enters = predicted, entered, chosen, over
    if predicted == chosen:
        ends = begins = NOBODY
    if entered == over:
        leaves = enters = NOBODY
    if predicted == over:
        ends = enters = NOBODY
    if entered == chosen:
        leaves = begins = NOBODY
    return ends, leaves, begins, enters
