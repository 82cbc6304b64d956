"""Keeps the regions of 50 and 80 % true for one person.

Each finished movement is judged at nine shares of its time, as a scorer judges: did its end lie inside the
region of 50 % that was stated there, and inside that of 80 %? The radius of a region that held too few ends
grows and that of one that held too many shrinks (``levels``). The Student law that has both radii is what is
stated next. The regions of the mixture (``mixed_region``) are judged at the same moments.
"""

from __future__ import annotations

from math import exp, log

from pointpred.compiled import law
from pointpred.predictors.adaptation import levels, mixed_region, moments
from pointpred.predictors.mixture import LEVELS, corrected_radius, heaviness, squared_radius_over_tail
from pointpred.records import FloatArray
from pointpred.stage import Slot, offsets

JUDGED = 9
"""A movement is judged at 10, 20 ... 90 % of its time."""
LIGHTEST, HEAVIEST = 0.02, 4.0
"""Bounds on 2 / tail: below is as good as normal, above the region of 95 % is of no use."""
HALVINGS = 12

# What is learned, relative to its place: movements so far; at each stage, the offset of each level, of the
# single law and of the mixture.
MOVEMENTS, OFFSETS, MIXED, LEARNED = offsets(1, levels.OFFSETS, mixed_region.LEARNED)
MOVEMENTS_MOST = 1e6
"""The count stops here: the step has long been at its least."""
SLOTS = (
    Slot("movements judged", 1, 0.0, MOVEMENTS_MOST, whole=True),
    levels.SLOT,
    *mixed_region.SLOTS,
)
"""What is known of a person's levels, in the order of the layout."""

# A moment of the movement (``moments``): its time and the law that was stated: endpoint, scale matrix, tail;
# the mixture that was stated.
_, X, Y, SXX, SXY, SYY, TAIL, MIXTURE = range(8)
MOMENT = MIXTURE + mixed_region.MIXTURE
MOST = 48
"""Moments that are remembered."""
STATES = moments.FIRST + MOMENT * MOST


@law
def widen(memory: FloatArray, at: int, share: float, tail: float) -> tuple[float, float]:
    """(factor of the scale matrix, tail) of the law whose regions of both levels have the learned radii.

    Their ratio fixes the tail. Where the ratio is out of a tail's bounds, both radii miss by the same factor.
    """
    if memory[at + MOVEMENTS] == 0.0:
        return 1.0, tail
    heavy_now, own = heaviness(tail), at + OFFSETS
    first, second = levels.offset(memory, own, share, 0), levels.offset(memory, own, share, 1)
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
def record(
    memory: FloatArray,
    at: int,
    t: float,
    cursor_x: float,
    cursor_y: float,
    stated: tuple[float, float, float, float, float, float],
) -> int:
    """Remember the law stated at a moment: endpoint, scale matrix, tail.

    Returns where the mixture stated there is to be written; -1 for nowhere.
    """
    last = moments.new_moment(memory, at, (t, cursor_x, cursor_y), MOMENT, MOST)
    if last < 0:
        return -1
    for i in range(len(stated)):
        memory[last + X + i] = stated[i]
    return last + MIXTURE


@law
def probability_within(memory: FloatArray, moment: int, x: float, y: float) -> float:
    """Share of the probability that a moment's law gives to places nearer than the end (x, y)."""
    dx, dy = x - memory[moment + X], y - memory[moment + Y]
    sxx, sxy, syy = memory[moment + SXX], memory[moment + SXY], memory[moment + SYY]
    determinant, tail = sxx * syy - sxy * sxy, memory[moment + TAIL]
    if not determinant > 0.0:
        return 1.0
    far = (syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / determinant
    return float(1.0 - exp(-0.5 * tail * log(1.0 + max(far, 0.0) / tail)))


@law
def learn(
    memory: FloatArray, person: int, at: int, place_of_end: tuple[float, float], span: tuple[float, float]
) -> None:
    """Judge a movement over ``span``, its start and end in s, which ended at a place in px.

    A stage learns from the share of the true time that it stands for, whatever share was predicted there.
    """
    if memory[at + moments.COUNT] == 0.0:
        return
    x, y = place_of_end
    memory[person + MOVEMENTS] = min(memory[person + MOVEMENTS] + 1.0, MOVEMENTS_MOST)
    step = levels.step_after(memory[person + MOVEMENTS])
    k = 0
    for judged in range(1, JUDGED + 1):
        share = judged / (JUDGED + 1.0)
        k = moments.moment_at(memory, at, k, span, share, MOMENT)
        moment = at + moments.FIRST + MOMENT * k
        within = probability_within(memory, moment, x, y)
        for which in range(len(LEVELS)):
            levels.learn(memory, person + OFFSETS, share, which, within <= LEVELS[which], step)
        mixed_region.judge(memory, person + MIXED, moment + MIXTURE, place_of_end, share, step)
