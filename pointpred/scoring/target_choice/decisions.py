"""Shares and decisions of one trial: compiled laws over its events, the same that a chooser calls."""

from __future__ import annotations

from math import log

import numpy as np

from pointpred.compiled import law
from pointpred.records import FloatArray, row_at
from pointpred.targets import cursor, decision, posterior
from pointpred.targets.choice_law import KEEP

# At each time fraction: whether the likeliest target is the right one, minus the logarithm of the right
# one's share, the largest share, and whether the nearest target is the right one.
RIGHT, LOSS, SURENESS, NEAREST = 0, 1, 2, 3
READ = 4

# Of a trial at one precision: proposals, right ones, retractions, whether the right one stood when the cursor
# entered it, and since when before the entry and before the end.
PROPOSED, PROPOSED_RIGHT, RETRACTED, HIT, LEAD_ENTRY, LEAD_CLICK = 0, 1, 2, 3, 4, 5
ACCOUNT = 6

SMALLEST = 1e-12
"""Of a share in the logarithm of the log loss."""


@law
def weigh(
    events: FloatArray,
    answers: FloatArray,
    table: FloatArray,
    coefficients: FloatArray,
    elsewhere: float,
    shares: FloatArray,
) -> None:
    """The shares of all targets after each event, in a row of ``shares``."""
    memory = np.zeros(cursor.STATES)
    for i in range(len(events)):
        cursor.follow(memory, events[i, 0], events[i, 1], events[i, 2], 0.0)
        posterior.scores(memory, table, row_at(answers, i), coefficients, elsewhere, shares[i])
        posterior.normalise(shares[i])


@law
def nearest(table: FloatArray, x: float, y: float) -> int:
    """The target whose centre is nearest."""
    best, least = 0, np.inf
    for i in range(len(table)):
        far = (table[i, 0] - x) ** 2 + (table[i, 1] - y) ** 2
        if far < least:
            best, least = i, far
    return best


@law
def read(
    events: FloatArray,
    table: FloatArray,
    shares: FloatArray,
    arrival: int,
    right: int,
    fractions: FloatArray,
    out: FloatArray,
) -> None:
    """Read the shares at fractions of the time from the first event to the arrival."""
    i = 0
    for k in range(len(fractions)):
        until = events[0, 0] + fractions[k] * (events[arrival, 0] - events[0, 0])
        while i + 1 < len(events) and events[i + 1, 0] <= until:
            i += 1
        best = decision.likeliest(shares[i], len(table))
        out[k, RIGHT] = 1.0 if best == right else 0.0
        out[k, LOSS] = -log(max(shares[i, right], SMALLEST))
        out[k, SURENESS] = shares[i, best]
        out[k, NEAREST] = 1.0 if nearest(table, events[i, 1], events[i, 2]) == right else 0.0


@law
def account(
    events: FloatArray,
    answers: FloatArray,
    table: FloatArray,
    shares: FloatArray,
    right: int,
    ask: float,
    least_s: float,
    least_px: float,
    out: FloatArray,
) -> None:
    """Decide after each event at one precision and keep the account of the movement."""
    memory = np.zeros(cursor.STATES)
    standing, since, entry, entered_since = decision.NOBODY, 0.0, np.nan, np.nan
    out[:] = 0.0
    out[LEAD_ENTRY] = out[LEAD_CLICK] = np.nan
    for i in range(len(events)):
        t, x, y = events[i, 0], events[i, 1], events[i, 2]
        cursor.follow(memory, t, x, y, 0.0)
        inside = abs(x - table[right, 0]) <= 0.5 * table[right, 2]
        inside = inside and abs(y - table[right, 1]) <= 0.5 * table[right, 3]
        if entry != entry and inside:
            entry = t
            if standing == right:
                entered_since = since
        bounds = ask, KEEP * ask, least_s, least_px
        chosen = decision.decide(memory, table, shares[i], standing, answers[i, 6], bounds)
        if chosen != standing:
            if standing != decision.NOBODY:
                out[RETRACTED] += 1.0
            if chosen != decision.NOBODY:
                out[PROPOSED] += 1.0
                out[PROPOSED_RIGHT] += 1.0 if chosen == right else 0.0
            standing, since = chosen, t
    end = events[len(events) - 1, 0]
    if entry != entry:
        entry = end
        if standing == right:
            entered_since = since
    if entered_since == entered_since:
        out[HIT] = 1.0
        out[LEAD_ENTRY], out[LEAD_CLICK] = entry - entered_since, end - entered_since
