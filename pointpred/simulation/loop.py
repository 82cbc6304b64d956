"""The closed pointing loop (2.1): a person, a hand, a mouse, a cursor, one report at a time."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, exp, hypot, sqrt
from typing import Any, NamedTuple

from pointpred.compiled import law
from pointpred.records import FloatArray, Row
from pointpred.simulation import hand, sensor, slots
from pointpred.transfer import functions

WANDER_S = 0.03
"""Correlation time of motor noise and tremor: half its power lies below 5 Hz."""
NEAR_SHARE = 0.85
SLOW_M_S = 0.008
"""A person stops correcting within this share of the target's radius, below this speed of the hand."""
WORTHWHILE_PX = 10.0
"""A shorter way, or one within the target's width, belongs to the corrective phase."""


class Chance(NamedTuple):
    """Two standard normal numbers, how late the stamp is (s), and the estimated endpoint or NaN (px).

    The endpoint is for an assisted transfer function.
    """

    noise_x: float
    noise_y: float
    late_s: float
    hat_x: float
    hat_y: float


class Poll(NamedTuple):
    """One row per report: an event (px from the start, counts), then hand in m, m/s, m/s^2, phase, piece."""

    t: float
    x: float
    y: float
    dx: float
    dy: float
    buttons: float
    u: float
    v: float
    vx: float
    vy: float
    ax: float
    ay: float
    phase: float
    number: float


INPUTS, OUTPUTS = Chance._fields, Poll._fields


@law
def enter(memory: FloatArray, phase: float, t: float) -> None:
    """Begin a phase."""
    memory[slots.PHASE], memory[slots.SINCE] = phase, t


@law
def correct(memory: FloatArray, t: float) -> None:
    """Begin the corrective phase; by default b2 follows from the gain at half the present speed."""
    enter(memory, slots.CORRECTIVE, t)
    memory[slots.FEEDBACK] = memory[slots.B2]
    if memory[slots.B2] == 0.0:
        gain = functions.gain(memory, slots.FUNCTION, 0.5 * hypot(memory[slots.VX], memory[slots.VY]))
        memory[slots.FEEDBACK] = memory[slots.RATE] ** 2 / (gain * memory[slots.PX_PER_METRE])


@law
def launch(memory: FloatArray, number: int, t: float) -> None:
    """Begin a piece towards its share of the remaining way; if that is too short, correct instead."""
    piece = slots.PIECE + slots.PIECE_SLOTS * number
    way_x, way_y = memory[slots.AIM_X] - memory[slots.X], memory[slots.AIM_Y] - memory[slots.Y]
    way = hypot(way_x, way_y)
    if number >= memory[slots.PIECES] or way < max(WORTHWHILE_PX, 2.0 * memory[slots.RADIUS]):
        correct(memory, t)
        return
    enter(memory, slots.BALLISTIC, t)
    memory[slots.NUMBER] = float(number)
    wanted = way * memory[piece + slots.SHARE]
    memory[slots.AMPLITUDE] = hand.hand_distance(memory, wanted, memory[piece + slots.DURATION_S])
    memory[slots.ANGLE] = atan2(way_y, way_x) + memory[piece + slots.TURN]


@law
def decide(memory: FloatArray, t: float) -> None:
    """The person's next phase: wait, move, move again, correct, verify, press, release."""
    phase, since = memory[slots.PHASE], memory[slots.SINCE]
    if phase == slots.WAITING and t >= memory[slots.REACTION_S]:
        launch(memory, 0, t)
    elif phase == slots.BALLISTIC:
        number = int(memory[slots.NUMBER])
        piece = slots.PIECE + slots.PIECE_SLOTS * number
        if t - since >= memory[piece + slots.UNTIL] * memory[piece + slots.DURATION_S]:
            launch(memory, number + 1, t)
    elif phase == slots.CORRECTIVE:
        off = hypot(memory[slots.X] - memory[slots.TARGET_X], memory[slots.Y] - memory[slots.TARGET_Y])
        slow = hypot(memory[slots.VX], memory[slots.VY]) < SLOW_M_S
        arrived = slow and off < NEAR_SHARE * memory[slots.RADIUS]
        if arrived or t > memory[slots.PATIENCE_S]:
            enter(memory, slots.VERIFYING, t)
    elif phase == slots.VERIFYING and t - since >= memory[slots.VERIFY_S]:
        enter(memory, slots.PRESSING, t)
    elif phase == slots.PRESSING and t - since >= memory[slots.PRESS_S]:
        enter(memory, slots.DONE, t)


@law
def step(
    memory: FloatArray, chance: Row
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """One report period: decide, move the hand, poll the sensor, update the delayed sight.

    Takes a ``Chance`` and returns the floats of a ``Poll``.
    """
    noise_x, noise_y, late_s, hat_x, hat_y = Chance(*chance)
    period = memory[slots.PERIOD_S]
    now = memory[slots.TICK] * period
    decide(memory, now)
    keep = exp(-period / WANDER_S)
    fresh = sqrt(1.0 - keep * keep)
    memory[slots.WANDER_X] = keep * memory[slots.WANDER_X] + fresh * noise_x
    memory[slots.WANDER_Y] = keep * memory[slots.WANDER_Y] + fresh * noise_y
    speed = hypot(memory[slots.VX], memory[slots.VY])
    size = memory[slots.TREMOR] + memory[slots.NOISE] * speed
    extra_x, extra_y = size * memory[slots.WANDER_X], size * memory[slots.WANDER_Y]
    before_x, before_y = memory[slots.X], memory[slots.Y]
    substeps = int(memory[slots.SUBSTEPS])
    h = period / substeps
    for i in range(substeps):
        hand.advance(memory, now + i * h, h, extra_x, extra_y)
    dx = dy = 0.0
    if memory[slots.METRES_PER_COUNT] > 0.0:
        dx, dy = sensor.report(memory, hat_x, hat_y)
    else:
        own_px = hypot(memory[slots.X] - before_x, memory[slots.Y] - before_y)
        pull_x, pull_y = sensor.assist(memory, own_px, hat_x, hat_y)
        memory[slots.X] += pull_x
        memory[slots.Y] += pull_y
    memory[slots.TICK] += 1.0
    row = slots.RING + slots.RING_SLOTS * (int(memory[slots.TICK]) % slots.RING_ROWS)
    memory[row], memory[row + 1] = memory[slots.X], memory[slots.Y]
    memory[row + 2], memory[row + 3] = memory[slots.U], memory[slots.V]
    return (
        memory[slots.TICK] * period + late_s,
        memory[slots.X],
        memory[slots.Y],
        dx,
        dy,
        1.0 if memory[slots.PHASE] == slots.PRESSING else 0.0,
        memory[slots.U],
        memory[slots.V],
        memory[slots.VX] + extra_x,
        memory[slots.VY] + extra_y,
        memory[slots.AX],
        memory[slots.AY],
        memory[slots.PHASE],
        memory[slots.NUMBER],
    )


@law
def chance_at(rows: FloatArray, i: int) -> tuple[float, float, float, float, float]:
    """A row of a table of ``Chance``."""
    r = rows[i]
    return r[0], r[1], r[2], r[3], r[4]


def play_of(step: Callable[..., Any], row_of: Callable[..., Any]) -> Callable[..., int]:
    """The compiled loop around a law ``step(memory, row, *shared)`` until the button is released.

    It returns the number of reports.
    """

    @law
    def play(memory: FloatArray, rows: FloatArray, out: FloatArray, *shared: Any) -> int:
        for i in range(len(rows)):
            answer = step(memory, row_of(rows, i), *shared)
            for j in range(len(answer)):
                out[i, j] = answer[j]
            if memory[slots.PHASE] == slots.DONE:
                return i + 1
        return len(rows)

    return play


play = play_of(step, chance_at)
