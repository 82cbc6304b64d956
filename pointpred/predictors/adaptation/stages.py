"""A person's bias, widths and tempo at each stage of progress, learned from finished movements.

A stage is a share of the time that has passed, as predicted: 0.1, 0.3 ... 0.9; between two of them lines.
"""

from __future__ import annotations

from math import exp, floor, log, sqrt
from typing import NamedTuple

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.stage import Slot, offsets

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

# A stage, relative to its place: the normal equations of the bias, its two coefficients, what believing it
# was and would have been worth; sums for the widths; the same for the tempo.
G00, G01, G11, R0, R1, TOTAL, AHEAD, BIAS_PAID, BIAS_SIZE, COUNT, WIDE, BROAD, TEMPO, TIMED = range(14)
TEMPO_PAID, TEMPO_SIZE, WIDTH = range(14, 17)
LEARNED = STAGES * WIDTH

LARGEST = 1e30
"""Sums of squares reach no further: coordinates and widths are bounded."""
MOST_SHARE = 1e3
"""The bias is no more than so many times the whole way and the way ahead."""
MOVEMENTS = 1.001 / (1.0 - KEEP)
"""What a sum comes to that takes in 1 with each movement, for ever; rounding included."""
MOST_TEMPO = TEMPO_MOST * MOVEMENTS
MOST_TEMPO_PAID = max(MOST_TEMPO / TEMPO_OF, 1.0) ** 2 / TEMPO_OFF**2 * MOVEMENTS
_STAGE = (
    Slot("normal equations, diagonal", 1, 0.0, LARGEST),
    Slot("normal equations, side", 1, -LARGEST, LARGEST),
    Slot("normal equations, diagonal", 1, 0.0, LARGEST),
    Slot("right side", 2, -LARGEST, LARGEST),
    Slot("bias", 2, -MOST_SHARE, MOST_SHARE),
    Slot("bias paid", 1, -(FURTHEST**2) * MOVEMENTS, FURTHEST**2 * MOVEMENTS),
    Slot("bias size", 1, 0.0, FURTHEST**2 * MOVEMENTS),
    Slot("movements", 1, 0.0, MOVEMENTS),
    Slot("squares of the widths", 2, 0.0, LARGEST),
    Slot("tempo", 1, -MOST_TEMPO, MOST_TEMPO),
    Slot("movements timed", 1, 0.0, MOVEMENTS),
    Slot("tempo paid", 1, -MOST_TEMPO_PAID, MOST_TEMPO_PAID),
    Slot("tempo size", 1, 0.0, MOST_TEMPO_PAID),
)
SLOTS = _STAGE * STAGES
"""What is known of a person at each stage, in the order of the layout."""


class Moment(NamedTuple):
    """What was predicted at a moment of a movement.

    ``t`` s, cursor ``x y`` px and ``reached`` px from the start, in the direction ``ux uy``; the way ahead
    along and across it and the widths of its law in px, the law's tail, the time left in s.
    """

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


# The moment of a stage, relative to its place: whether there is one, and its parts, the time first.
PRESENT, PARTS, MOMENT = offsets(1, len(Moment._fields))
T = PARTS
STATES = STAGES * MOMENT


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
def belief(memory: FloatArray, at: int, paid: int) -> float:
    """Share of a correction that has paid so far: 0 to 1."""
    return float(min(max(memory[at + paid] / (memory[at + paid + 1] + DOUBT), 0.0), 1.0))


@law
def bias(memory: FloatArray, at: int, total: float, along: float) -> float:
    """What a stage adds to the way ahead, px."""
    return float(memory[at + TOTAL] * total + memory[at + AHEAD] * along)


@law
def width_log(memory: FloatArray, at: int, which: int) -> float:
    """Logarithm of what a stage multiplies a width by."""
    return float(0.5 * log((memory[at + which] + WIDTHS_OF) / (memory[at + COUNT] + WIDTHS_OF)))


@law
def tempo(memory: FloatArray, at: int) -> float:
    """Logarithm of what a stage multiplies the time left by."""
    return float(memory[at + TEMPO] / (memory[at + TIMED] + TEMPO_OF))


@law
def tempo_factor(memory: FloatArray, at: int) -> float:
    """What a stage multiplies the time left by."""
    return float(exp(tempo(memory, at) * belief(memory, at, TEMPO_PAID)))


@law
def correct(
    memory: FloatArray, at: int, share: float, total: float, along: float
) -> tuple[float, float, float, float]:
    """(bias px, factors of the width along, the width across, the time left)."""
    stage, part = interpolation(share)
    shift, wide, broad, slow = 0.0, 0.0, 0.0, 0.0
    for side in range(2):
        a, weight = at + (stage + side) * WIDTH, part if side == 1 else 1.0 - part
        shift += weight * bias(memory, a, total, along) * belief(memory, a, BIAS_PAID)
        wide += weight * width_log(memory, a, WIDE)
        broad += weight * width_log(memory, a, BROAD)
        slow += weight * tempo(memory, a) * belief(memory, a, TEMPO_PAID)
    return shift, exp(wide), exp(broad), exp(slow)


@law
def bounded(value: float, most: float) -> float:
    """The value, no further from zero than ``most``."""
    return min(max(value, -most), most)


@law
def solve(memory: FloatArray, at: int) -> None:
    """The coefficients of the bias from the normal equations."""
    g00, g01, g11 = memory[at + G00] + RIDGE, memory[at + G01], memory[at + G11] + RIDGE
    determinant = max(g00 * g11 - g01 * g01, RIDGE * RIDGE)  # never less, but for rounding
    by_total = (g11 * memory[at + R0] - g01 * memory[at + R1]) / determinant
    by_ahead = (g00 * memory[at + R1] - g01 * memory[at + R0]) / determinant
    memory[at + TOTAL] = bounded(by_total, MOST_SHARE)
    memory[at + AHEAD] = bounded(by_ahead, MOST_SHARE)


@law
def scale(memory: FloatArray, at: int, which: int, off: float, tail: float) -> None:
    """One step towards the scale of a Student law: what is far off counts little."""
    before = (memory[at + which] + WIDTHS_OF) / (memory[at + COUNT] + WIDTHS_OF)
    memory[at + which] += (tail + 1.0) / (tail + off * off / before) * off * off


@law
def record(memory: FloatArray, place: int, moment: Moment) -> None:
    """Write the moment of a stage."""
    memory[place + PRESENT] = 1.0
    for i in range(len(moment)):
        memory[place + PARTS + i] = moment[i]


@law
def moment_at(memory: FloatArray, place: int) -> Moment:
    """The moment of a stage."""
    p = memory[place + PARTS : place + MOMENT]
    return Moment(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11])


@law
def learn(memory: FloatArray, at: int, m: Moment, x: float, y: float, t: float) -> None:
    """Learn from one stage of a finished movement: where it ended, and when the cursor came to rest."""
    for i in range(WIDTH):
        if i != TOTAL and i != AHEAD:
            memory[at + i] *= KEEP
    dx, dy = x - m.x, y - m.y
    off = (dx * m.ux + dy * m.uy - m.along) / m.wide
    aside = (dy * m.ux - dx * m.uy - m.across) / m.broad
    total = sqrt((m.reached + m.along) ** 2 + m.across**2)
    shift = bias(memory, at, total, m.along) / m.wide
    rest = off - shift
    paid = bounded(shift, FURTHEST)
    memory[at + BIAS_PAID] += paid * bounded(off, FURTHEST)
    memory[at + BIAS_SIZE] += paid * paid
    weight = (m.tail + 1.0) / (m.tail + rest * rest)
    f0, f1 = total / m.wide, m.along / m.wide
    memory[at + G00] += weight * f0 * f0
    memory[at + G01] += weight * f0 * f1
    memory[at + G11] += weight * f1 * f1
    memory[at + R0] += weight * f0 * off
    memory[at + R1] += weight * f1 * off
    solve(memory, at)
    scale(memory, at, WIDE, rest, m.tail)
    scale(memory, at, BROAD, aside, m.tail)
    left = t - m.t
    if left > 0.0:
        late = bounded(log(left / m.left), TEMPO_MOST)
        slow = tempo(memory, at)
        memory[at + TEMPO_PAID] += slow * late / TEMPO_OFF**2
        memory[at + TEMPO_SIZE] += slow * slow / TEMPO_OFF**2
        memory[at + TEMPO] += late
        memory[at + TIMED] += 1.0
    memory[at + COUNT] += 1.0
