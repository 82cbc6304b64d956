"""Keeps the regions of 50 and 80 % true for one person.

Each finished movement is judged at nine shares of its time, as a scorer judges: did its end lie inside the
region of 50 % that was stated there, and inside that of 80 %? The radius of a region that held too few ends
grows and that of one that held too many shrinks (online conformal prediction, a quantile tracker for each
level and stage). The Student law that has both radii is what is stated next.

Reference: Gibbs, Candes 2021, "Adaptive conformal inference under distribution shift".
"""

from __future__ import annotations

from math import exp, log

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.predictors.adaptation import moments
from pointpred.predictors.adaptation.stages import STAGES, interpolation
from pointpred.stage import Slot, offsets

LEVELS = (0.5, 0.8)
"""The levels of the regions whose coverage is adapted."""
JUDGED = 9
"""A movement is judged at 10, 20 ... 90 % of its time."""
STEP, STEP_OF, STEP_LEAST = 6.0, 5.0, 0.2
"""The step after the n-th movement is STEP / (n + STEP_OF), and never less than STEP_LEAST."""
FURTHEST = 6.0
"""Bound on an offset, the logarithm of what a squared radius or its normal radius is multiplied by."""
LIGHTEST, HEAVIEST = 0.02, 4.0
"""Bounds on 2 / tail: below is as good as normal, above the region of 95 % is of no use."""
HALVINGS = 12

# What is learned, relative to its place: movements so far; at each stage, the offset of each level.
MOVEMENTS, OFFSETS, LEARNED = offsets(1, STAGES * len(LEVELS))
MOVEMENTS_MOST = 1e6
"""The count stops here: the step has long been at its least."""
SLOTS = (
    Slot("movements judged", 1, 0.0, MOVEMENTS_MOST, whole=True),
    Slot("radii of the levels", STAGES * len(LEVELS), -FURTHEST, FURTHEST),
)
"""What is known of a person's levels, in the order of the layout."""

# A moment of the movement (``moments``): its time and the law that was stated: endpoint, scale matrix, tail.
_, X, Y, SXX, SXY, SYY, TAIL, MOMENT = range(8)
MOST = 48
"""Moments that are remembered."""
STATES = moments.FIRST + MOMENT * MOST
LOWEST, HIGHEST = 1e-6, 40.0
"""Bounds on 2 / tail as a predictor states it: no exponential overflows."""


@law
def squared_radius(level: float, heavy: float) -> float:
    """Squared radius of a level's region over the tail; ``heavy``: 2 / tail.

    The Student law of ``pointpred.regions.reach`` in the form that is compiled here.
    """
    return float(exp(-heavy * log(1.0 - level)) - 1.0)


@law
def corrected_radius(level: float, heavy: float, offset: float) -> float:
    """``squared_radius`` of a level with its offset.

    A region that held too few ends grows by the same factor, whatever the tail. One that held too many
    becomes the region of a lower level, whose squared radius under a normal law is smaller by that factor:
    with a heavy tail it shrinks much more. Otherwise the two radii would come nearer to each other than any
    Student law has them.
    """
    lower = exp(min(offset, 0.0))
    return float(exp(max(offset, 0.0)) * (exp(-heavy * log(1.0 - level) * lower) - 1.0))


@law
def offset(memory: FloatArray, at: int, share: float, which: int) -> float:
    """The offset of a level at a share of the time: on lines between the stages."""
    stage, part = interpolation(share)
    low = at + OFFSETS + len(LEVELS) * stage + which
    return float(memory[low] + part * (memory[low + len(LEVELS)] - memory[low]))


@law
def widen(memory: FloatArray, at: int, share: float, tail: float) -> tuple[float, float]:
    """(factor of the scale matrix, tail) of the law whose regions of both levels have the learned radii.

    Their ratio fixes the tail. Where the ratio is out of a tail's bounds, both radii miss by the same factor.
    """
    if memory[at + MOVEMENTS] == 0.0:
        return 1.0, tail
    heavy_now = min(max(2.0 / tail, LOWEST), HIGHEST)
    near = log(corrected_radius(LEVELS[0], heavy_now, offset(memory, at, share, 0)) * 2.0 / heavy_now)
    far = log(corrected_radius(LEVELS[1], heavy_now, offset(memory, at, share, 1)) * 2.0 / heavy_now)
    ratio, low, high = exp(far - near), LIGHTEST, HEAVIEST
    for _ in range(HALVINGS):
        heavy = 0.5 * (low + high)
        if squared_radius(LEVELS[1], heavy) < ratio * squared_radius(LEVELS[0], heavy):
            low = heavy
        else:
            high = heavy
    heavy = 0.5 * (low + high)
    both = squared_radius(LEVELS[0], heavy) * squared_radius(LEVELS[1], heavy) * (2.0 / heavy) ** 2
    return exp(0.5 * (near + far - log(both))), 2.0 / heavy


@law
def record(
    memory: FloatArray,
    at: int,
    t: float,
    cursor_x: float,
    cursor_y: float,
    stated: tuple[float, float, float, float, float, float],
) -> None:
    """Remember the law stated at a moment: endpoint, scale matrix, tail."""
    last = moments.new_moment(memory, at, (t, cursor_x, cursor_y), MOMENT, MOST)
    if last < 0:
        return
    for i in range(len(stated)):
        memory[last + X + i] = stated[i]


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
def add(memory: FloatArray, slot: int, change: float) -> None:
    """Change an offset, within its bounds."""
    memory[slot] = min(max(memory[slot] + change, -FURTHEST), FURTHEST)


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
    step = max(STEP / (memory[person + MOVEMENTS] + STEP_OF), STEP_LEAST)
    k = 0
    for judged in range(1, JUDGED + 1):
        share = judged / (JUDGED + 1.0)
        k = moments.moment_at(memory, at, k, span, share, MOMENT)
        within = probability_within(memory, at + moments.FIRST + MOMENT * k, x, y)
        stage, part = interpolation(share)
        for which in range(len(LEVELS)):
            missed = LEVELS[which] - 1.0 if within <= LEVELS[which] else LEVELS[which]
            low = person + OFFSETS + len(LEVELS) * stage + which
            add(memory, low, step * (1.0 - part) * missed)
            add(memory, low + len(LEVELS), step * part * missed)
