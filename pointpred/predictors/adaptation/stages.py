"""A person's bias, widths and tempo at each stage of progress, learned from finished movements.

A stage is a share of the time that has passed, as predicted: 0.1, 0.3 ... 0.9; between two of them lines.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import exp, floor, log, sqrt
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Known, Layout

STAGES = 5
KEEP = 0.97
"""Forgetting factor per movement."""
RIDGE = 20.0
"""Ridge: precision of the prior of no bias, relative to one movement's."""
DOUBT = 5.0
"""Squared shifts that must have helped before half of a correction is applied."""
WIDTHS_OF = 2.0
"""Weight of the common widths, in movements."""
TEMPO_OF = 10.0
"""Weight of the common tempo, in movements."""
FURTHEST = 4.0
"""No single movement is further off than so many widths."""
TEMPO_MOST, TEMPO_OFF = 0.4, 0.3
"""The largest and the usual error of the logarithm of the time left."""

LARGEST = 1e30
"""Sums of squares reach no further: coordinates and widths are bounded."""
MOST_SHARE = 1e3
"""The bias is no more than so many times the whole way and the way ahead."""
MOVEMENTS = 1.001 / (1.0 - KEEP)
"""What a sum comes to that takes in 1 with each movement, for ever; rounding included."""
MOST_TEMPO = TEMPO_MOST * MOVEMENTS
MOST_TEMPO_PAID = max(MOST_TEMPO / TEMPO_OF, 1.0) ** 2 / TEMPO_OFF**2 * MOVEMENTS
DIAGONAL = Known("normal equations, diagonal", 0.0, LARGEST)
RIGHT_SIDE = Known("right side", -LARGEST, LARGEST)
BIAS = Known("bias", -MOST_SHARE, MOST_SHARE)
SQUARES = Known("squares of the widths", 0.0, LARGEST)


class Stage(Layout):
    """What is known of a person at a stage."""

    g00: Annotated[float, DIAGONAL]
    """The normal equations of the bias."""
    g01: Annotated[float, Known("normal equations, side", -LARGEST, LARGEST)]
    g11: Annotated[float, DIAGONAL]
    r0: Annotated[float, RIGHT_SIDE]
    r1: Annotated[float, RIGHT_SIDE]
    total: Annotated[float, BIAS]
    """The bias as a share of the whole way, and of the way ahead."""
    ahead: Annotated[float, BIAS]
    bias_paid: Annotated[float, Known("bias paid", -(FURTHEST**2) * MOVEMENTS, FURTHEST**2 * MOVEMENTS)]
    """What believing it was worth, and would have been worth at most."""
    bias_size: Annotated[float, Known("bias size", 0.0, FURTHEST**2 * MOVEMENTS)]
    count: Annotated[float, Known("movements", 0.0, MOVEMENTS)]
    wide: Annotated[float, SQUARES]
    """Sums for the widths along and across."""
    broad: Annotated[float, SQUARES]
    tempo: Annotated[float, Known("tempo", -MOST_TEMPO, MOST_TEMPO)]
    """The sum of the logarithms of what the time left was, over what was said."""
    timed: Annotated[float, Known("movements timed", 0.0, MOVEMENTS)]
    tempo_paid: Annotated[float, Known("tempo paid", -MOST_TEMPO_PAID, MOST_TEMPO_PAID)]
    tempo_size: Annotated[float, Known("tempo size", 0.0, MOST_TEMPO_PAID)]


class Moment(Layout):
    """What was predicted at the moment of a stage, ``present`` if there is one.

    ``t`` s, cursor ``x y`` px and ``reached`` px from the start, in the direction ``ux uy``; the way ahead
    along and across it and the widths of its law in px, the law's tail, the time left in s.
    """

    present: float
    t: float
    x: float
    y: float
    ux: float
    uy: float
    along: float
    across: float
    wide: float
    broad: float
    tail: float
    left: float
    reached: float


class Stages(Layout):
    """What is known of a person at each stage."""

    stages: Annotated[Sequence[Stage], STAGES]


@law
def interpolation_among(share: float, count: int) -> tuple[int, float]:
    """Of so many stages the one before a share of the time, and how far the share is from it to the next."""
    spot = min(max(share * count - 0.5, 0.0), count - 1.0)
    stage = min(floor(spot), count - 2)
    return int(stage), spot - stage


@law
def interpolation(share: float) -> tuple[int, float]:
    """The stage before a share of the time, and how far the share is from it to the next."""
    return interpolation_among(share, STAGES)


@law
def belief(paid: float, size: float) -> float:
    """Share of a correction that has paid so far: 0 to 1."""
    return float(min(max(paid / (size + DOUBT), 0.0), 1.0))


@law
def bias(s: Stage, total: float, along: float) -> float:
    """What a stage adds to the way ahead, px."""
    return float(s.total * total + s.ahead * along)


@law
def width_log(s: Stage, squares: float) -> float:
    """Logarithm of what a stage multiplies a width by, from the sum for it."""
    return float(0.5 * log((squares + WIDTHS_OF) / (s.count + WIDTHS_OF)))


@law
def tempo(s: Stage) -> float:
    """Logarithm of what a stage multiplies the time left by."""
    return float(s.tempo / (s.timed + TEMPO_OF))


@law
def tempo_factor(s: Stage) -> float:
    """What a stage multiplies the time left by."""
    return float(exp(tempo(s) * belief(s.tempo_paid, s.tempo_size)))


@law
def correct(known: Stages, share: float, total: float, along: float) -> tuple[float, float, float, float]:
    """(bias px, factors of the width along, the width across, the time left)."""
    stage, part = interpolation(share)
    shift, wide, broad, slow = 0.0, 0.0, 0.0, 0.0
    for side in range(2):
        s, weight = known.stages[stage + side], part if side == 1 else 1.0 - part
        shift += weight * bias(s, total, along) * belief(s.bias_paid, s.bias_size)
        wide += weight * width_log(s, s.wide)
        broad += weight * width_log(s, s.broad)
        slow += weight * tempo(s) * belief(s.tempo_paid, s.tempo_size)
    return shift, exp(wide), exp(broad), exp(slow)


@law
def bounded(value: float, most: float) -> float:
    """The value, no further from zero than ``most``."""
    return min(max(value, -most), most)


@law
def solve(s: Stage) -> None:
    """The coefficients of the bias from the normal equations."""
    g00, g01, g11 = s.g00 + RIDGE, s.g01, s.g11 + RIDGE
    determinant = max(g00 * g11 - g01 * g01, RIDGE * RIDGE)  # never less, but for rounding
    by_total = (g11 * s.r0 - g01 * s.r1) / determinant
    by_ahead = (g00 * s.r1 - g01 * s.r0) / determinant
    s.total = bounded(by_total, MOST_SHARE)
    s.ahead = bounded(by_ahead, MOST_SHARE)


@law
def scale(s: Stage, squares: float, off: float, tail: float) -> float:
    """What the sum for a width grows by, as a Student law has it: what is far off counts little."""
    before = (squares + WIDTHS_OF) / (s.count + WIDTHS_OF)
    return (tail + 1.0) / (tail + off * off / before) * off * off


@law
def forget(s: Stage) -> None:
    """Discount what earlier movements taught; the bias is computed again."""
    total, ahead, sums = s.total, s.ahead, s.memory
    for i in range(Stage.length):
        sums[i] *= KEEP
    s.total, s.ahead = total, ahead


@law
def learn(s: Stage, m: Moment, x: float, y: float, t: float) -> None:
    """Learn from one stage of a finished movement: where it ended, and when the cursor came to rest."""
    forget(s)
    dx, dy = x - m.x, y - m.y
    off = (dx * m.ux + dy * m.uy - m.along) / m.wide
    aside = (dy * m.ux - dx * m.uy - m.across) / m.broad
    total = sqrt((m.reached + m.along) ** 2 + m.across**2)
    shift = bias(s, total, m.along) / m.wide
    rest = off - shift
    paid = bounded(shift, FURTHEST)
    s.bias_paid += paid * bounded(off, FURTHEST)
    s.bias_size += paid * paid
    weight = (m.tail + 1.0) / (m.tail + rest * rest)
    f0, f1 = total / m.wide, m.along / m.wide
    s.g00 += weight * f0 * f0
    s.g01 += weight * f0 * f1
    s.g11 += weight * f1 * f1
    s.r0 += weight * f0 * off
    s.r1 += weight * f1 * off
    solve(s)
    s.wide += scale(s, s.wide, rest, m.tail)
    s.broad += scale(s, s.broad, aside, m.tail)
    left = t - m.t
    if left > 0.0:
        late = bounded(log(left / m.left), TEMPO_MOST)
        slow = tempo(s)
        s.tempo_paid += slow * late / TEMPO_OFF**2
        s.tempo_size += slow * slow / TEMPO_OFF**2
        s.tempo += late
        s.timed += 1.0
    s.count += 1.0
