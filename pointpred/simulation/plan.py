"""A person's plan of one trial, drawn before it begins, and the initial memory of the loop."""

from __future__ import annotations

from math import inf, log2

import msgspec
import numpy as np

from pointpred.records import METRES_PER_INCH, FloatArray
from pointpred.simulation import slots
from pointpred.simulation.person import Person
from pointpred.transfer import TransferFunction

PATIENCE_S = 5.0
"""After this many seconds a person clicks where the cursor is."""
SMALLEST_PIECE_S = 0.16
LATER_PIECE = 0.65
"""Duration of a later, shorter piece as a share of the first one's."""
MOST_AIM_OFF = 0.33
"""Largest offset of the aim from the centre, as a share of the target's width."""
SUBSTEPS = 2


class Setup(msgspec.Struct, frozen=True):
    """The device and the screen: counts per inch, px per inch, seconds between polls.

    ``rho`` (1/s) above 0 makes the transfer function an assisted one; ``strength`` bounds its pull to a share
    of the hand's own motion, infinite as printed in Remark 2.2.1.
    """

    transfer: TransferFunction
    cpi: float = 2000.0
    dpi: float = 96.0
    period_s: float = 0.001
    rho: float = 0.0
    strength: float = inf


class Aim(msgspec.Struct, frozen=True):
    """A target relative to the start of the trial: centre and width, px."""

    x: float
    y: float
    width: float

    @property
    def distance(self) -> float:
        """To the centre, px."""
        return float(np.hypot(self.x, self.y))


def memory(person: Person, setup: Setup, aim: Aim, generator: np.random.Generator) -> FloatArray:
    """The flat memory of one trial: setup, person and a plan drawn from the generator; the state is zero."""
    flat = np.zeros(slots.SIZE)
    flat[slots.PERIOD_S] = setup.period_s
    flat[slots.SUBSTEPS] = SUBSTEPS
    flat[slots.PX_PER_METRE] = setup.dpi / METRES_PER_INCH
    flat[slots.METRES_PER_COUNT] = METRES_PER_INCH / setup.cpi
    flat[slots.RHO], flat[slots.STRENGTH] = setup.rho, setup.strength
    flat[slots.FUNCTION : slots.B1] = setup.transfer.slots
    flat[slots.B1] = person.friction * _varied(generator, 0.05)
    flat[slots.RATE] = person.rate * _varied(generator, 0.08)
    flat[slots.MUSCLE_S] = person.muscle_s
    flat[slots.DELAY_S] = min(person.delay_s, (slots.RING_ROWS - 1) * setup.period_s)
    flat[slots.NOISE] = person.noise
    flat[slots.TREMOR] = person.tremor_m_s
    flat[slots.TARGET_X], flat[slots.TARGET_Y], flat[slots.RADIUS] = aim.x, aim.y, 0.5 * aim.width
    flat[slots.AIM_X], flat[slots.AIM_Y] = _aim(person, aim, generator)
    flat[slots.REACTION_S] = person.reaction_s * _varied(generator, 0.18)
    flat[slots.VERIFY_S] = person.verify_s * _varied(generator, 0.25)
    flat[slots.PRESS_S] = person.press_s * _varied(generator, 0.15)
    flat[slots.PATIENCE_S] = PATIENCE_S
    count = _pieces(person, generator)
    flat[slots.PIECES] = count
    first_s = person.base_s + person.per_bit_s * log2(aim.distance / aim.width + 1.0)
    for number in range(count):
        at = slots.PIECE + slots.PIECE_SLOTS * number
        flat[at : at + slots.PIECE_SLOTS] = _piece(person, first_s, number, count, generator)
    return flat


def _aim(person: Person, aim: Aim, generator: np.random.Generator) -> tuple[float, float]:
    """The point a person aims at: scattered about the centre, always well inside the target."""
    off_x, off_y = generator.standard_normal(2) * person.aim_sd * aim.width
    shrink = min(1.0, MOST_AIM_OFF * aim.width / max(float(np.hypot(off_x, off_y)), 1e-9))
    return aim.x + shrink * float(off_x), aim.y + shrink * float(off_y)


def _pieces(person: Person, generator: np.random.Generator) -> int:
    """One to four pieces, more with less skill."""
    if generator.uniform() < person.one_piece:
        return 1
    return 2 + int(generator.binomial(slots.PIECES_MOST - 2, 0.55 * (1.0 - person.skill)))


def _piece(
    person: Person, first_s: float, number: int, count: int, generator: np.random.Generator
) -> list[float]:
    """Share, duration, skew, turn, curvature, and when the next phase begins, of one piece."""
    last = number == count - 1
    share = generator.normal(person.reach, person.reach_sd) if last else generator.uniform(0.60, 0.88)
    duration = first_s * (1.0 if number == 0 else LATER_PIECE) * _varied(generator, 0.10)
    skew = float(np.clip(person.skew + 0.08 * generator.standard_normal(), -0.2, 0.6))
    turn = generator.normal(0.0, person.turn_sd)
    curve = person.curvature + generator.normal(0.0, 0.4 * person.turn_sd)
    duration = max(duration, SMALLEST_PIECE_S)
    if last:
        until = generator.uniform(0.78, 0.94)
    else:
        until = generator.uniform(0.90, 1.0) + generator.exponential(person.pause_s) / duration
    return [max(float(share), 0.3), duration, skew, float(turn), float(curve), min(float(until), 1.6)]


def _varied(generator: np.random.Generator, spread: float) -> float:
    """A random factor near 1, bounded."""
    return float(np.exp(spread * np.clip(generator.standard_normal(), -2.5, 2.5)))
