"""Events one by one: the cursor's way, the shares of all targets, and which of them are proposed."""

from __future__ import annotations

from math import inf

from pointpred.compiled import law
from pointpred.records import FloatArray, FloatTable, PredictionRow, TenFloats, row_at
from pointpred.targets import cursor, decision, posterior
from pointpred.targets.posterior import Coefficients, Settings
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, LOG_WEIGHT, WIDTH

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
    best = decision.NOBODY
    for i in range(len(table)):
        if inside[i] == OUTSIDE or inside[i] == RELEASED or table[i, LOG_WEIGHT] == -inf:
            continue
        area = table[i, WIDTH] * table[i, HEIGHT]
        if best == decision.NOBODY or area <= table[best, WIDTH] * table[best, HEIGHT]:
            best = i
    return best


@law
def holder(table: FloatTable, x: float, y: float) -> int:
    """The smallest target that holds a point, of equal ones the nearest; NOBODY where there is none."""
    best, smallest, least = decision.NOBODY, inf, inf
    for i in range(len(table)):
        row = table[i]
        across, down = abs(row[CENTRE_X] - x), abs(row[CENTRE_Y] - y)
        if across <= 0.5 * row[WIDTH] and down <= 0.5 * row[HEIGHT]:
            area, away = row[WIDTH] * row[HEIGHT], across + down
            if area < smallest or (area == smallest and away < least):
                best, smallest, least = i, area, away
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
def propose(
    s: cursor.State,
    event: tuple[float, float, float, float],
    released: bool,
    remaining_s: float,
    targets: Targets,
    settings: Settings,
    standing: int,
) -> tuple[int, int, int]:
    """What follows from the shares at an event that ``cursor.follow`` has taken in, as ``step``."""
    _, x, y, _ = event
    table, inside, shares = targets
    if released:
        standing = decision.NOBODY
    count = enter(table, inside, x, y, released)
    ask, least_s = settings.precision, settings.least_lead_s
    bounds = ask, KEEP * ask, least_s, settings.least_way_px
    chosen = decision.decide(s, table, shares, standing, remaining_s, bounds)
    over = innermost(table, inside)
    return chosen, decision.NOBODY if over == chosen else over, count


@law
def step_with_shares(
    s: cursor.State,
    event: tuple[float, float, float, float],
    remaining_s: float,
    targets: Targets,
    settings: Settings,
    standing: int,
) -> tuple[int, int, int]:
    """``step`` where the shares have been written by somebody who knows them."""
    t, x, y, pressed = event
    released = cursor.follow(s, t, x, y, pressed)
    return propose(s, event, released, remaining_s, targets, settings, standing)


@law
def step(
    s: cursor.State,
    event: tuple[float, float, float, float],
    answer: TenFloats,
    targets: Targets,
    coefficients: Coefficients,
    settings: Settings,
    standing: int,
) -> tuple[int, int, int]:
    """Take in one usable event (t, x, y, pressed), with the prediction made at it.

    ``answer``: a ``PredictionRow``; ``standing``: the target predicted up to now. Writes where the
    cursor is and the shares, and returns the target predicted from now on, the target proposed because the
    cursor is in it (NOBODY where that one is predicted), and how many targets the cursor has just gone into.
    When the button comes up the movement is over, and so is everything it proposed: a target that the cursor
    stays in is not proposed again before the cursor has left it.
    """
    t, x, y, pressed = event
    table, _, shares = targets
    p = PredictionRow(*answer)
    released = cursor.follow(s, t, x, y, pressed)
    posterior.scores(s, table, answer, coefficients, settings.elsewhere, shares)
    posterior.normalise(shares)
    return propose(s, event, released, p.remaining_s, targets, settings, standing)


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
        ends = begins = decision.NOBODY
    if entered == over:
        leaves = enters = decision.NOBODY
    if predicted == over:
        ends = enters = decision.NOBODY
    if entered == chosen:
        leaves = begins = decision.NOBODY
    return ends, leaves, begins, enters


@law
def unusable(s: cursor.State, events: FloatTable) -> int:
    """The first row that ``step`` must not be given, -1 where all are usable."""
    before = s.t if s.known == 1.0 else -inf
    for i in range(len(events)):
        t = events[i, 0]
        if not cursor.usable(t, events[i, 1], events[i, 2]) or t < before:
            return i
        before = t
    return -1


@law
def walk(
    s: cursor.State,
    tables: tuple[FloatTable, FloatTable, FloatTable],
    first: int,
    targets: Targets,
    coefficients: Coefficients,
    settings: Settings,
    proposed: tuple[int, int],
) -> tuple[int, int, int, int]:
    """Take in rows, from ``first`` up to and with the one at which there is something to note.

    ``tables``: the events, the predictions made at them, and a table for the likeliest targets after each of
    the last rows, *none of them* among them: their places, and behind these their shares. ``proposed``: the
    targets that are proposed now, by prediction and by entry. Returns how many rows are then taken in, and
    what ``step`` returns at the last.
    """
    events, answers, likeliest = tables
    shares = targets[2]
    standing, over = proposed
    most = likeliest.shape[1] // 2
    for i in range(first, len(events)):
        event = events[i, 0], events[i, 1], events[i, 2], float(int(events[i, 5]) & 1)
        chosen, now_over, entered = step(
            s, event, row_at(answers, i), targets, coefficients, settings, standing
        )
        place = i - (len(events) - len(likeliest))
        if place >= 0:
            decision.rank(shares, len(shares), likeliest[place, :most])
            for k in range(most):
                likeliest[place, most + k] = shares[int(likeliest[place, k])]
        if chosen != standing or now_over != over or entered > 0:
            return i + 1, chosen, now_over, entered
    return len(events), standing, over, 0
