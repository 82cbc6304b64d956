"""What a person's past says of registered targets before a movement shows anything."""

from __future__ import annotations

from collections.abc import Sequence
from math import exp, inf, log

import numpy as np

from pointpred.compiled import law
from pointpred.errors import ParameterError
from pointpred.records import LARGEST, FloatArray, FloatTable, Place
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, LOG_WEIGHT, WIDTH

# A row of a table of places: position in px, how likely it is now and before the movement, scatter of visits
# in px.
X, Y, P, BEFORE, SPREAD, FIELDS = range(6)
NONE = -1

LEAST_PX = 16.0
"""Size of the smallest place: what people point at is hardly smaller, and the scatter near a place is 0."""
WHOLE = 1.0 + 1e-9
"""The largest share of a place: sums of shares are rounded."""
LOWEST = np.array([-LARGEST, -LARGEST, 0.0, 0.0, 0.0])
HIGHEST = np.array([LARGEST, LARGEST, WHOLE, WHOLE, LARGEST])
"""Bounds of the numbers of a place."""


@law
def target_of(table: FloatTable, place: FloatArray) -> int:
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
def expect(table: FloatTable, own: FloatArray, known: FloatTable) -> None:
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


def place_table(places: Sequence[Place]) -> FloatArray:
    """The places as a table, a row each, in their order.

    Raises ParameterError for an ``id`` that occurs twice, and for a number that is out of bounds: positions
    and spreads within those of positions, px, shares in [0, 1], up to rounding.
    """
    ids = [place.id for place in places]
    if len(set(ids)) < len(ids):
        twice = next(id for id in ids if ids.count(id) > 1)
        raise ParameterError(
            f"the id of a place must occur once, received {twice!r} twice", field="id", value=twice
        )
    rows = [(place.x, place.y, place.p, place.before, place.spread) for place in places]
    table = np.array(rows, dtype=np.float64).reshape(-1, FIELDS)
    wrong = np.argwhere(~((table >= LOWEST) & (table <= HIGHEST)))
    for row, column in wrong[:1].tolist():
        name, value = ("x", "y", "p", "before", "spread")[column], rows[row][column]
        raise ParameterError(
            f"{name} of place {ids[row]!r} must lie in [{LOWEST[column]:g}, {HIGHEST[column]:g}], "
            f"received {value!r}",
            field=name,
            value=value,
        )
    return table
