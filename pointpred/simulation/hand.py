"""A simulated hand on an office mouse: all its chance follows from one number, in a page as in Python."""

from __future__ import annotations

from math import cos, log, nan, pi, sqrt
from typing import Annotated, NamedTuple

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout, clear
from pointpred.records import METRES_PER_INCH, FloatArray
from pointpred.simulation.loop import DONE, PIECES_MOST, VERIFYING, Memory, step
from pointpred.simulation.person import NORMALS, Traits, grow
from pointpred.simulation.plan import FURTHER_PIECE, Draws, plan
from pointpred.transfer.functions import CONSTANT

PERIOD_S = 0.008
"""Between two reports of an office mouse, of 125 Hz."""
SUBSTEPS = 16
CPI = 2000.0
DPI = 96.0
GAIN = 4.0
"""Of the transfer function, at every speed."""
M1, M2 = 4294967087.0, 4294944443.0
"""The moduli of the generator's two recurrences."""
WARM_UP = 20
"""So many numbers are left out after the seed, which neighbouring seeds have in common."""


class Stream(Layout):
    """The generator: the last three numbers of each recurrence."""

    one: Annotated[FloatArray, 3]
    two: Annotated[FloatArray, 3]


class Hand(Layout):
    """A person, what is drawn for the movement, and the movement."""

    stream: Stream
    traits: Traits
    draws: Draws
    trial: Memory


class Report(NamedTuple):
    """What the mouse reports: s and px from the start of the movement; the phase of ``loop``."""

    t: float
    x: float
    y: float
    pressed: float
    phase: float


LENGTH = Hand.length
RESTING, RELEASED = VERIFYING, DONE
"""From this phase on the hand rests in the target; the button was pressed and released."""


@law
def uniform(s: Stream) -> float:
    """The next number in (0, 1): MRG32k3a of L'Ecuyer (1999), whose products are exact in floats."""
    first = (1403580.0 * s.one[1] - 810728.0 * s.one[0]) % M1
    second = (527612.0 * s.two[2] - 1370589.0 * s.two[0]) % M2
    s.one[0], s.one[1], s.one[2] = s.one[1], s.one[2], first
    s.two[0], s.two[1], s.two[2] = s.two[1], s.two[2], second
    between = first - second if first > second else first - second + M1
    return float(between / (M1 + 1.0))


@law
def normal(s: Stream) -> float:
    """A standard normal number, by Box and Muller."""
    length = sqrt(-2.0 * log(uniform(s)))
    return length * cos(2.0 * pi * uniform(s))


@law
def sow(s: Stream, seed: float) -> None:
    """Begin the generator with a whole number in [0, 2^31 - 3]."""
    number = seed + 1.0
    for i in range(3):
        number = 16807.0 * number % 2147483647.0
        s.one[i] = number
        number = 16807.0 * number % 2147483647.0
        s.two[i] = number
    for _ in range(WARM_UP):
        uniform(s)


@law
def begin(hand: Hand, seed: float, skill: float) -> None:
    """A person of a skill in [0, 1], drawn from the seed, with the mouse."""
    clear(hand)
    sow(hand.stream, seed)
    normals = np.empty(NORMALS)
    for i in range(NORMALS):
        normals[i] = normal(hand.stream)
    grow(hand.traits, skill, normals)
    settings = hand.trial.settings
    settings.period_s = PERIOD_S
    settings.substeps = float(SUBSTEPS)
    settings.px_per_metre = DPI / METRES_PER_INCH
    settings.metres_per_count = METRES_PER_INCH / CPI
    settings.function.kind = CONSTANT
    settings.function.numbers[0] = GAIN


@law
def draw(s: Stream, traits: Traits, draws: Draws) -> None:
    """The chance in the next plan."""
    draws.friction, draws.rate = normal(s), normal(s)
    draws.aim_x, draws.aim_y = normal(s), normal(s)
    draws.reaction, draws.verify, draws.press = normal(s), normal(s), normal(s)
    draws.count = 1.0
    if uniform(s) >= traits.one_piece:
        draws.count = 2.0
        for _ in range(PIECES_MOST - 2):
            if uniform(s) < FURTHER_PIECE * (1.0 - traits.skill):
                draws.count += 1.0
    count = int(draws.count)
    for number in range(count):
        piece = draws.pieces[number]
        last = number == count - 1
        piece.share = normal(s) if last else uniform(s)
        piece.duration, piece.skew = normal(s), normal(s)
        piece.turn, piece.curve = normal(s), normal(s)
        piece.until = uniform(s)
        piece.pause = 0.0 if last else -log(uniform(s))


@law
def aim(hand: Hand, x: float, y: float, width: float) -> None:
    """Begin a movement to a target of ``width`` px, whose centre lies ``x y`` px from the cursor."""
    clear(hand.trial.state)
    draw(hand.stream, hand.traits, hand.draws)
    plan(hand.trial.settings, hand.traits, hand.draws, x, y, width)


@law
def report(hand: Hand) -> tuple[float, float, float, float, float]:
    """Move for one period; the floats of a ``Report``."""
    chance_x, chance_y = normal(hand.stream), normal(hand.stream)
    poll = step(hand.trial, (chance_x, chance_y, 0.0, nan, nan))
    return poll[0], poll[1], poll[2], poll[5], poll[12]
