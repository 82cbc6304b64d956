"""The rules for making and withdrawing proposals from probabilities."""

from __future__ import annotations

from math import hypot
from typing import NamedTuple

from pointpred.compiled import law
from pointpred.records import FloatArray, FloatTable
from pointpred.targets import cursor
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, NOBODY, WIDTH


class Settings(NamedTuple):
    """A chooser's settings, as ``Chooser`` says what they are."""

    precision: float
    least_lead_s: float
    least_way_px: float


LOWEST, HIGHEST = Settings(0.01, 0.0, 0.0), Settings(0.999, 10.0, 1000.0)
USUAL = Settings(0.5, 0.0, 3.0)
"""Their bounds and their defaults."""


@law
def likeliest(shares: FloatArray, count: int) -> int:
    """The target with the largest share, the first of equal ones; NOBODY where there is none."""
    best = NOBODY
    for i in range(count):
        if best == NOBODY or shares[i] > shares[best]:
            best = i
    return best


@law
def rank(shares: FloatArray, count: int, order: FloatArray) -> None:
    """The places of the largest shares into ``order``, best first, the first of equal ones before the others.

    There are at least as many targets as places in ``order``.
    """
    for k in range(len(order)):
        order[k] = NOBODY
    for i in range(count):
        place = len(order)
        while place > 0 and (order[place - 1] == NOBODY or shares[i] > shares[int(order[place - 1])]):
            place -= 1
        if place < len(order):
            for later in range(len(order) - 1, place, -1):
                order[later] = order[later - 1]
            order[place] = i


@law
def early(s: cursor.State, row: FloatArray, remaining_s: float, least_s: float) -> bool:
    """Whether a proposal of this target would still come in time: the cursor is not there at once.

    It is there at once where both say so: the way to its edge over the present speed, and the predicted time
    left, where one is claimed (predictors that go by speed alone call a hand at rest arrived).
    """
    left = cursor.until(s, row[CENTRE_X], row[CENTRE_Y], row[WIDTH], row[HEIGHT])
    if left == 0.0:
        return False
    if remaining_s == remaining_s:
        left = max(left, remaining_s)
    return left >= least_s


@law
def decide(
    s: cursor.State,
    table: FloatTable,
    shares: FloatArray,
    standing: int,
    remaining_s: float,
    bounds: tuple[float, float, float, float],
) -> int:
    """The target that is proposed from now on, NOBODY for none; ``bounds``: (ask, keep, least_s, least_px).

    One that stands is kept while its share is at least ``keep``, unless another reaches ``ask``. Without
    one, the likeliest is proposed from ``ask`` on, if early enough, and if the cursor is at least
    ``least_px`` from where the movement started. ``keep`` lies below ``ask``: a share that trembles about
    either changes nothing twice.
    """
    ask, keep, least_s, least_px = bounds
    best = likeliest(shares, len(table))
    if best == NOBODY:
        return NOBODY
    if standing != NOBODY and (best == standing or shares[best] < ask):
        return standing if shares[standing] >= keep else NOBODY
    far = hypot(s.x - s.x0, s.y - s.y0)
    if shares[best] >= ask and far >= least_px and early(s, table[best], remaining_s, least_s):
        return best
    if standing != NOBODY and shares[standing] >= keep:
        return standing
    return NOBODY
