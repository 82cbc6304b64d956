"""Events one by one: the cursor's way, the shares of all targets, and which of them are proposed."""

from __future__ import annotations

from math import inf

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.targets import cursor, decision, posterior
from pointpred.targets.rectangles import LOG_WEIGHT

KEEP = 0.4
"""A proposal stands while its share is at least this part of the precision asked for."""


OUTSIDE, INSIDE, ENTERED, RELEASED = 0.0, 1.0, 2.0, 3.0
"""Where the cursor is, for each target; ENTERED at the event that took it in, RELEASED once the button came
up while it was there, until it leaves."""


@law
def innermost(table: FloatArray, inside: FloatArray) -> int:
    """The smallest target that the cursor is in, of equal ones the last; NOBODY where there is none.

    The last, because what stands later in a page is drawn over what stands before it. Targets of weight 0,
    and those in which the button came up, are not looked at.
    """
    best = decision.NOBODY
    for i in range(len(table)):
        if inside[i] == OUTSIDE or inside[i] == RELEASED or table[i, LOG_WEIGHT] == -inf:
            continue
        if best == decision.NOBODY or table[i, 2] * table[i, 3] <= table[best, 2] * table[best, 3]:
            best = i
    return best


@law
def step(
    memory: FloatArray,
    table: FloatArray,
    t: float,
    x: float,
    y: float,
    pressed: float,
    answer: FloatArray,
    coefficients: FloatArray,
    settings: FloatArray,
    standing: int,
    inside: FloatArray,
    shares: FloatArray,
) -> tuple[int, int, int]:
    """Take one usable event in, with the prediction made at it, a row of ``PredictionColumns``.

    Writes ``inside`` and ``shares``, and returns the target predicted from now on, the target proposed
    because the cursor is in it (NOBODY where that one is predicted), and how many targets the cursor has just
    gone into. When the button comes up the movement is over, and so is everything it proposed: a target that
    the cursor stays in is not proposed again before the cursor has left it.
    """
    released = cursor.follow(memory, t, x, y, pressed)
    if released:
        standing = decision.NOBODY
    elsewhere = settings[posterior.ELSEWHERE]
    posterior.scores(memory, table, answer, coefficients, elsewhere, shares)
    posterior.normalise(shares)
    entered = 0
    for i in range(len(table)):
        row = table[i]
        if abs(row[0] - x) <= 0.5 * row[2] and abs(row[1] - y) <= 0.5 * row[3]:
            entered += inside[i] == OUTSIDE
            if inside[i] == OUTSIDE:
                inside[i] = ENTERED
            else:
                inside[i] = RELEASED if released or inside[i] == RELEASED else INSIDE
        else:
            inside[i] = OUTSIDE
    ask, least_s = settings[posterior.PRECISION], settings[posterior.LEAST_LEAD_S]
    least_px = settings[posterior.LEAST_WAY_PX]
    chosen = decision.decide(memory, table, shares, standing, answer[6], ask, KEEP * ask, least_s, least_px)
    over = innermost(table, inside)
    return chosen, decision.NOBODY if over == chosen else over, entered


@law
def unusable(memory: FloatArray, events: FloatArray) -> int:
    """The first row that ``step`` must not be given, -1 where all are usable."""
    before = memory[cursor.T] if memory[cursor.KNOWN] == 1.0 else -inf
    for i in range(len(events)):
        t = events[i, 0]
        if not cursor.usable(t, events[i, 1], events[i, 2]) or t < before:
            return i
        before = t
    return -1


@law
def walk(
    memory: FloatArray,
    table: FloatArray,
    events: FloatArray,
    answers: FloatArray,
    first: int,
    coefficients: FloatArray,
    settings: FloatArray,
    standing: int,
    over: int,
    inside: FloatArray,
    shares: FloatArray,
    told: FloatArray,
) -> tuple[int, int, int, int]:
    """Take rows in, from ``first`` up to and with the one at which there is something to note.

    ``standing`` and ``over``: the targets that are proposed now, by prediction and by entry. Returns how many
    rows are then taken in, and what ``step`` says of the last. ``told``: the likeliest targets after each of
    its rows, the last rows of all, and behind their places their shares.
    """
    most = told.shape[1] // 2
    for i in range(first, len(events)):
        pressed = float(int(events[i, 5]) & 1)
        t, x, y, answer = events[i, 0], events[i, 1], events[i, 2], answers[i]
        chosen, now_over, entered = step(
            memory, table, t, x, y, pressed, answer, coefficients, settings, standing, inside, shares
        )
        place = i - (len(events) - len(told))
        if place >= 0:
            decision.rank(shares, len(table), told[place, :most])
            for k in range(most):
                told[place, most + k] = shares[int(told[place, k])]
        if chosen != standing or now_over != over or entered > 0:
            return i + 1, chosen, now_over, entered
    return len(events), standing, over, 0
