"""Which targets are proposed, from how likely each is and where the cursor is."""

from __future__ import annotations

from math import inf

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import FloatArray, FloatTable
from pointpred.targets import cursor, decision, heading, ledger, past
from pointpred.targets.decision import Settings
from pointpred.targets.posterior import EFFECTIVE
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, LOG_WEIGHT, NOBODY, WIDTH

KEEP = 0.4
"""A proposal stands while its share is at least this fraction of the required precision."""

OUTSIDE, INSIDE, ENTERED, RELEASED = 0.0, 1.0, 2.0, 3.0
"""Where the cursor is, for each target; ENTERED at the event that took it in, RELEASED once the button came
up while it was there, until it leaves."""


LEAST_PX = 16.0
"""Side of the smallest place: what people point at is hardly smaller, and the scatter near a place is 0."""

Targets = tuple[FloatTable, FloatArray, FloatArray]
"""The table of the targets; where the cursor is for each; how likely each is, and none of them."""


class State(Layout):
    """The target that is predicted, and the one that is proposed because the cursor is in it, or NOBODY."""

    predicted: float
    entered: float


STATES = State.length
"""For JavaScript that makes a memory."""


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


@law
def update(
    s: State,
    memory: heading.Memory,
    targets: Targets,
    keys: FloatTable,
    settings: Settings,
    account: ledger.Account,
    rows: FloatTable,
    out: FloatArray,
) -> bool:
    """Decide after the event that ``memory`` took in last; returns whether something changes.

    Writes where the cursor is, what is proposed, and into ``out`` what ``changes`` says; what became of
    proposals goes into the account and its ``rows``. ``keys``: the numbers of the targets.
    """
    inside, now = targets[1], memory.cursor
    released = memory.movement.released == 1.0
    before = int(s.predicted), int(s.entered)
    left_s = memory.movement.remaining_s
    chosen, over, count = decide(now, released, left_s, targets, settings, before[0])
    if before[0] == chosen and before[1] == over and count == 0:
        return False
    for i in range(len(inside)):
        if inside[i] == ENTERED:
            ledger.note_entry(account, rows, now.t, keys[i, past.ID])
    if before[0] != chosen and before[0] != NOBODY:
        ledger.note_end(account, rows, now.t, keys[before[0], past.ID], released)
    if before[0] != chosen and chosen != NOBODY:
        ledger.note_proposal(account, rows, now.t, keys[chosen, past.ID])
    if before[1] != over and over != NOBODY:
        account.movement.entered += 1.0
    s.predicted, s.entered = chosen, over
    out[0], out[1], out[2], out[3] = changes(before, (chosen, over))
    return True


@law
def place_of(keys: FloatTable, key: float, first: int) -> int:
    """Where the target of a number is, looked for from ``first`` on and around; NOBODY where it is not."""
    for k in range(len(keys)):
        i = (first + k) % len(keys)
        if keys[i, past.ID] == key:
            return i
    return NOBODY


@law
def replace(
    s: State,
    t: float,
    before: tuple[FloatTable, FloatArray],
    now: tuple[FloatTable, FloatArray],
    account: ledger.Account,
    rows: FloatTable,
) -> tuple[bool, bool]:
    """Go on with other targets: the numbers of those before and where the cursor was, and those from now on.

    Returns whether the predicted target is gone, and the one proposed because the cursor is in it. ``t``: of
    the last event, s.
    """
    keys, inside = before
    new_keys, new_inside = now
    near = 0
    for i in range(len(new_keys)):
        place = place_of(keys, new_keys[i, past.ID], near)
        new_inside[i] = OUTSIDE
        if place != NOBODY:
            new_inside[i] = INSIDE if inside[place] == ENTERED else inside[place]
            near = place + 1
    predicted, entered = int(s.predicted), int(s.entered)
    if predicted != NOBODY:
        s.predicted = place_of(new_keys, keys[predicted, past.ID], predicted)
        if s.predicted == NOBODY:
            ledger.note_end(account, rows, t, keys[predicted, past.ID], False)
    if entered != NOBODY:
        s.entered = place_of(new_keys, keys[entered, past.ID], entered)
    return predicted != NOBODY and s.predicted == NOBODY, entered != NOBODY and s.entered == NOBODY


@law
def reset(s: State, inside: FloatArray) -> None:
    """Nothing is proposed; a target that the cursor is in has to be left before it is entered again."""
    s.predicted = s.entered = NOBODY
    for i in range(len(inside)):
        if inside[i] != OUTSIDE:
            inside[i] = RELEASED


@law
def lay_places(places: FloatTable, table: FloatTable, keys: FloatTable, shares: FloatArray) -> None:
    """Places as targets. ``places``: x, y, p, number, spread, a row each; ``shares``: also of none of them.

    The rectangle of a place is the square that its visits scatter in: as wide as a target of that scatter.
    """
    known = 0.0
    for i in range(len(places)):
        table[i, CENTRE_X], table[i, CENTRE_Y], table[i, LOG_WEIGHT] = places[i, 0], places[i, 1], 0.0
        shares[i], keys[i, past.ID] = places[i, 2], places[i, 3]
        table[i, WIDTH] = table[i, HEIGHT] = max(EFFECTIVE * places[i, 4], LEAST_PX)
        known += places[i, 2]
    shares[len(places)] = max(1.0 - known, 0.0)
