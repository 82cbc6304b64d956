"""What a person took before: how likely each target is before a movement shows anything.

Five rules answer: the weights that the caller gave, how often each target was taken, which were taken lately,
what was taken after the last one, and how often targets of this kind and size were. Each finished movement to
a target shares a visit among the rules by how likely each had made it; the weights of the rules are these
visits, with earlier ones forgotten. So a rule that predicts nothing counts for little. In the same way the
share of movements to none of the targets is learned.
"""

from __future__ import annotations

from math import exp, inf, log
from typing import Annotated

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Known, Layout
from pointpred.records import FloatArray, FloatTable
from pointpred.targets.rectangles import LOG_WEIGHT

GIVEN, OFTEN, LATELY, AFTER, ALIKE, RULES = range(6)
FIRST_RULES = (12.0, 1.0, 1.0, 1.0, 1.0)
"""Visits that the first belief in each rule counts for."""
FADING_OF = 4.0
"""After so many visits it counts for half of them."""
ID, KIND, KEYS = range(3)
"""Of a target: a number for its id, and one for its kind and size."""
CAPACITY = 64
"""Movements that are remembered."""
KEEP = 0.97
"""Forgetting factor of the visits per movement."""
GIVEN_OF = 1.0
"""Of every other rule what the caller's weights say counts for so many visits."""
LATE_AGE, OFTEN_AGE = 3.0, 40.0
"""After so many movements a visit weighs 1 / e for LATELY, and for the other rules."""
FIRST_OF = 1.0
"""Movements that the first belief in the share of none of the targets counts for."""
NONE_MOST = 0.99
"""The largest share of movements to none of the targets."""

MOST = 1.001 / (1.0 - KEEP)
NUMBER_MOST = float(2**48)
NO_TARGET = 0.0
"""Stands for a movement to none of the targets."""


class Past(Layout):
    """What is known of a person: the last targets, the newest first; visits by rule, to targets, to none."""

    count: Annotated[float, Known("movements held", 0.0, CAPACITY, whole=True)]
    ids: Annotated[FloatArray, CAPACITY, Known("targets taken", 0.0, NUMBER_MOST, whole=True)]
    kinds: Annotated[FloatArray, CAPACITY, Known("kinds of targets taken", 0.0, NUMBER_MOST, whole=True)]
    rules: Annotated[FloatArray, RULES, Known("visits as each rule of targets has them", 0.0, MOST)]
    to: Annotated[float, Known("visits to targets", 0.0, MOST)]
    none: Annotated[float, Known("visits to none of the targets", 0.0, MOST)]


@law
def elsewhere(s: Past, first: float) -> float:
    """The share of movements to none of the targets; ``first``: what it is at least, and at first."""
    learned = (first * FIRST_OF + s.none) / (FIRST_OF + s.to + s.none)
    return float(max(min(learned, NONE_MOST), first))


@law
def add_visit(s: Past, k: int, keys: FloatTable, out: FloatTable) -> None:
    """Add the target that was taken ``k`` movements ago to the visits of each rule, as far as it is there."""
    place, alike = -1, 0.0
    for i in range(len(keys)):
        if keys[i, ID] == s.ids[k]:
            place = i
        if keys[i, KIND] == s.kinds[k]:
            alike += out[GIVEN, i]
    weight = exp(-k / OFTEN_AGE)
    if place >= 0:
        out[OFTEN, place] += weight
        out[LATELY, place] += exp(-k / LATE_AGE)
        if k + 1 < int(s.count) and s.ids[0] != NO_TARGET and s.ids[k + 1] == s.ids[0]:
            out[AFTER, place] += weight
    if alike > 0.0:
        for i in range(len(keys)):
            if keys[i, KIND] == s.kinds[k]:
                out[ALIKE, i] += weight * out[GIVEN, i] / alike


@law
def shares(s: Past, own: FloatArray, keys: FloatTable, out: FloatTable) -> None:
    """The share of each target by each rule, a row each, whose sum is one.

    ``own``: the logarithms of the caller's weights over their sum; ``out``: zeros.
    """
    for i in range(len(own)):
        out[GIVEN, i] = exp(own[i]) if own[i] > -inf else 0.0
    for k in range(int(s.count)):
        if s.ids[k] != NO_TARGET:
            add_visit(s, k, keys, out)
    for rule in range(OFTEN, RULES):
        total = GIVEN_OF
        for i in range(len(own)):
            out[rule, i] = out[rule, i] if out[GIVEN, i] > 0.0 else 0.0
            total += out[rule, i]
        for i in range(len(own)):
            out[rule, i] = (out[rule, i] + GIVEN_OF * out[GIVEN, i]) / total


@law
def rule_weight(s: Past, rule: int) -> float:
    """The weight of a rule among all: the first belief fades as visits are shared."""
    fading, total = FADING_OF / (FADING_OF + s.to), 0.0
    for k in range(RULES):
        total += s.rules[k] + FIRST_RULES[k] * fading
    return float((s.rules[rule] + FIRST_RULES[rule] * fading) / total)


@law
def weigh(s: Past, own: FloatArray, keys: FloatTable, table: FloatTable) -> None:
    """Write the weights of the targets before a movement, as logarithms, into their table."""
    if s.to == 0.0:
        for i in range(len(own)):
            table[i, LOG_WEIGHT] = own[i]
        return
    by_rule = np.zeros((RULES, len(own)))
    shares(s, own, keys, by_rule)
    for i in range(len(own)):
        total = 0.0
        for rule in range(RULES):
            total += rule_weight(s, rule) * by_rule[rule, i]
        table[i, LOG_WEIGHT] = log(total) if total > 0.0 else -inf


@law
def learn(s: Past, own: FloatArray, keys: FloatTable, taken: int) -> None:
    """Learn from a movement to the target of this place, below 0: to none of them."""
    s.to *= KEEP
    s.none *= KEEP
    if taken < 0:
        s.none += 1.0
    else:
        s.to += 1.0
        by_rule = np.zeros((RULES, len(own)))
        shares(s, own, keys, by_rule)
        total = 0.0
        for rule in range(RULES):
            by_rule[rule, taken] *= rule_weight(s, rule)
            total += by_rule[rule, taken]
        for rule in range(RULES):
            s.rules[rule] = KEEP * s.rules[rule] + (by_rule[rule, taken] / total if total > 0.0 else 0.0)
    s.count = min(s.count + 1.0, CAPACITY)
    for k in range(int(s.count) - 1, 0, -1):
        s.ids[k], s.kinds[k] = s.ids[k - 1], s.kinds[k - 1]
    s.ids[0] = keys[taken, ID] if taken >= 0 else NO_TARGET
    s.kinds[0] = keys[taken, KIND] if taken >= 0 else NO_TARGET
