"""Keeps the regions of 50 and 80 % true for one person.

Each finished movement is judged at nine shares of its time, as a scorer judges: did its end lie inside the
region of 50 % that was stated there, and inside that of 80 %? The radius of a region that held too few ends
grows and that of one that held too many shrinks (``levels``). The Student law that has both radii is what is
stated next. The regions of the mixture (``mixed_region``) are judged at the same moments.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import exp, log
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Known, Layout
from pointpred.predictors.adaptation import levels, mixed_region, moments
from pointpred.predictors.mixture import LEVELS, corrected_radius, heaviness, squared_radius_over_tail
from pointpred.records import SixFloats
from pointpred.stage import copy_values

JUDGED = 9
"""A movement is judged at 10, 20 ... 90 % of its time."""
LIGHTEST, HEAVIEST = 0.02, 4.0
"""Bounds on 2 / tail: below is as good as normal, above the region of 95 % is of no use."""
HALVINGS = 12

MOVEMENTS_MOST = 1e6
"""The count stops here: the step has long been at its least."""
MOST = 48
"""Moments that are remembered."""


class Radii(Layout):
    """What is known of a person: movements so far, the offsets of the single law and of the mixture."""

    movements: Annotated[float, Known("movements judged", 0.0, MOVEMENTS_MOST, whole=True)]
    single: levels.Offsets
    mixed: levels.Offsets


class Moment(Layout):
    """What was stated at a time: endpoint, scale matrix, tail; the mixture."""

    t: float
    x: float
    y: float
    sxx: float
    sxy: float
    syy: float
    tail: float
    mixture: mixed_region.Mixture


class Movement(Layout):
    """What was stated in the movement."""

    series: moments.Series
    moments: Annotated[Sequence[Moment], MOST]


@law
def widen(s: Radii, share: float, tail: float) -> tuple[float, float]:
    """(factor of the scale matrix, tail) of the law whose regions of both levels have the learned radii.

    Their ratio fixes the tail. Where the ratio is out of a tail's bounds, both radii miss by the same factor.
    """
    if s.movements == 0.0:
        return 1.0, tail
    heavy_now = heaviness(tail)
    first, second = levels.offset(s.single, share, 0), levels.offset(s.single, share, 1)
    near = log(corrected_radius(LEVELS[0], heavy_now, first) * 2.0 / heavy_now)
    far = log(corrected_radius(LEVELS[1], heavy_now, second) * 2.0 / heavy_now)
    ratio, low, high = exp(far - near), LIGHTEST, HEAVIEST
    for _ in range(HALVINGS):
        heavy = 0.5 * (low + high)
        if squared_radius_over_tail(LEVELS[1], heavy) < ratio * squared_radius_over_tail(LEVELS[0], heavy):
            low = heavy
        else:
            high = heavy
    heavy = 0.5 * (low + high)
    half, most = squared_radius_over_tail(LEVELS[0], heavy), squared_radius_over_tail(LEVELS[1], heavy)
    both = half * most * (2.0 / heavy) ** 2
    return exp(0.5 * (near + far - log(both))), 2.0 / heavy


@law
def record(stated: Movement, cursor: tuple[float, float, float], region: SixFloats) -> int:
    """Remember the law stated at a moment, when the cursor is at (t, x, y): endpoint, scale matrix, tail.

    Returns the number of the moment, whose mixture is then to be written; -1 for none.
    """
    last = stated.moments[max(int(stated.series.count) - 1, 0)]
    number, full = moments.next_moment(stated.series, last.t, cursor, MOST)
    if number < 0:
        return -1
    if full:
        for k in range(1, number):
            copy_values(stated.moments[2 * k].memory, stated.moments[k].memory)
    m = stated.moments[number]
    m.t = cursor[0]
    m.x, m.y, m.sxx, m.sxy, m.syy, m.tail = region
    return number


@law
def probability_within(region: SixFloats, x: float, y: float) -> float:
    """Share of the probability that a law, as ``record`` takes it, gives to places nearer than the end."""
    centre_x, centre_y, sxx, sxy, syy, tail = region
    dx, dy = x - centre_x, y - centre_y
    determinant = sxx * syy - sxy * sxy
    if not determinant > 0.0:
        return 1.0
    far = (syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / determinant
    return float(1.0 - exp(-0.5 * tail * log(1.0 + max(far, 0.0) / tail)))


@law
def learn(s: Radii, stated: Movement, place_of_end: tuple[float, float], span: tuple[float, float]) -> None:
    """Judge a movement over ``span``, its start and end in s, which ended at a place in px.

    A stage learns from the share of the true time that it stands for, whatever share was predicted there.
    """
    if stated.series.count == 0.0:
        return
    x, y = place_of_end
    s.movements = min(s.movements + 1.0, MOVEMENTS_MOST)
    step = levels.step_after(s.movements)
    k = 0
    for judged in range(1, JUDGED + 1):
        share = judged / (JUDGED + 1.0)
        while k + 1 < stated.series.count and moments.has_come(
            stated.series, stated.moments[k + 1].t, span, share
        ):
            k += 1
        m = stated.moments[k]
        within = probability_within((m.x, m.y, m.sxx, m.sxy, m.syy, m.tail), x, y)
        for which in range(len(LEVELS)):
            levels.learn(s.single, share, which, within <= LEVELS[which], step)
        mixed_region.judge(s.mixed, m.mixture, place_of_end, share, step)
