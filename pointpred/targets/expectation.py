"""What a person's past says of registered targets before a movement shows anything."""

from __future__ import annotations

from math import exp, inf, log

import numpy as np

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, LOG_WEIGHT, WIDTH

# A row of a table of places: position in px, how likely it is before the movement, scatter of visits in px.
X, Y, BEFORE, SPREAD, FIELDS = range(5)
NONE = -1


@law
def target_of(table: FloatArray, place: FloatArray) -> int:
    """The target that a place belongs to; NONE for none.

    Of those that it lies in the smallest; of others the nearest within the scatter of its visits.
    """
    best, least, smallest = NONE, inf, inf
    for i in range(len(table)):
        target = table[i]
        across = abs(place[X] - target[CENTRE_X]) - 0.5 * target[WIDTH]
        away = max(across, abs(place[Y] - target[CENTRE_Y]) - 0.5 * target[HEIGHT], 0.0)
        area = target[WIDTH] * target[HEIGHT]
        nearer = away < least or (away == least and area < smallest)
        if target[LOG_WEIGHT] > -inf and away <= place[SPREAD] and nearer:
            best, least, smallest = i, away, area
    return best


@law
def expect(table: FloatArray, own: FloatArray, known: FloatArray) -> None:
    """Write the weights of targets with what is known of the person.

    ``own``: the logarithms of the caller's weights; ``known``: a row for each place. Of n targets, one whose
    places have the shares b before the movement gets the weight w (1 + n sum b): without any place nothing
    changes. Targets of weight 0 keep it.
    """
    count = len(table)
    shares = np.zeros(count)
    for i in range(count):
        table[i, LOG_WEIGHT] = own[i]
    for k in range(len(known)):
        owner = target_of(table, known[k])
        if owner != NONE:
            shares[owner] += known[k, BEFORE]
    total = 0.0
    for i in range(count):
        table[i, LOG_WEIGHT] += log(1.0 + count * shares[i])
        total += exp(table[i, LOG_WEIGHT])
    if total == 0.0:
        return
    for i in range(count):
        table[i, LOG_WEIGHT] -= log(total)
