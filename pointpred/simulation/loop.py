"""The closed pointing loop (2.1): a person, a hand, a mouse, a cursor, one report at a time."""

from __future__ import annotations

from math import atan2, cos, exp, hypot, pi, sin, sqrt, trunc
from typing import NamedTuple

from pointpred.compiled import law
from pointpred.records import FloatArray, FloatTable
from pointpred.simulation import slots
from pointpred.transfer import assistance, functions, pixels

QUADRATURE = 16
BISECTIONS = 40
LONGEST_M = 2.0
"""Longest hand movement of one piece, m."""


@law
def profile(u: float, skew: float) -> tuple[float, float, float]:
    """Share of the way at share u of the time, and its first two derivatives.

    (1 - cos pi s) / 2 with s = u + skew u (1 - u): the thesis's ballistic law (2.4.2) for skew 0, an earlier
    peak of the speed for skew > 0. |skew| < 1 keeps the speed positive.
    """
    if u < 0.0:
        return 0.0, 0.0, 0.0
    if u > 1.0:
        return 1.0, 0.0, 0.0
    s = pi * (u + skew * u * (1.0 - u))
    rate = pi * (1.0 + skew * (1.0 - 2.0 * u))
    speed = 0.5 * sin(s) * rate
    return 0.5 * (1.0 - cos(s)), speed, 0.5 * (cos(s) * rate * rate - 2.0 * pi * skew * sin(s))


@law
def cursor_distance(memory: FloatArray, amplitude: float, duration: float) -> float:
    """The cursor's distance (px) while the hand moves ``amplitude`` metres by the law without skew.

    The integral of PTF(V) over V = A pi / (2 D) sin pi u by Simpson's rule; over A it is the averaged gain c
    of 2.4.2, corrected.
    """
    peak = 0.5 * pi * amplitude / duration
    total = 0.0
    for i in range(1, QUADRATURE):
        weight = 4.0 if i % 2 == 1 else 2.0
        total += weight * functions.cursor_speed(memory, slots.FUNCTION, peak * sin(pi * i / QUADRATURE))
    return float(memory[slots.PX_PER_METRE] * duration * total / (3.0 * QUADRATURE))


@law
def hand_distance(memory: FloatArray, distance_px: float, duration: float) -> float:
    """The amplitude (m) that moves the cursor by ``distance_px``: ``cursor_distance`` inverted."""
    low, high = 0.0, LONGEST_M
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        if cursor_distance(memory, middle, duration) < distance_px:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


@law
def ballistic_force(memory: FloatArray, t: float) -> tuple[float, float]:
    """The open-loop force of the current piece: planned acceleration with friction compensated."""
    piece = slots.PIECE + slots.PIECE_SLOTS * int(memory[slots.NUMBER])
    duration = memory[piece + slots.DURATION_S]
    curve = memory[piece + slots.CURVE]
    share, rate, bend = profile((t - memory[slots.SINCE]) / duration, memory[piece + slots.SKEW])
    speed = memory[slots.AMPLITUDE] * rate / duration
    along = memory[slots.AMPLITUDE] * bend / duration**2 + memory[slots.B1] * speed
    across = -2.0 * curve * (rate / duration) * speed
    angle = memory[slots.ANGLE] + curve * (1.0 - 2.0 * share)
    return along * cos(angle) - across * sin(angle), along * sin(angle) + across * cos(angle)


@law
def cursor_in_mind(memory: FloatArray, u: float, v: float, speed: float) -> tuple[float, float]:
    """The person's estimate of the cursor: its delayed sight, plus the hand's motion since."""
    late = int(memory[slots.DELAY_S] / memory[slots.PERIOD_S] + 0.5)
    row = slots.RING + slots.RING_SLOTS * ((int(memory[slots.TICK]) - late) % slots.RING_ROWS)
    gain = functions.gain(memory, slots.FUNCTION, speed) * memory[slots.PX_PER_METRE]
    return memory[row] + gain * (u - memory[row + 2]), memory[row + 1] + gain * (v - memory[row + 3])


class Place(NamedTuple):
    """Positions and velocities of cursor and hand: ``x y`` px, ``u v`` m, ``vx vy`` m/s."""

    x: float
    y: float
    u: float
    v: float
    vx: float
    vy: float


@law
def acceleration(memory: FloatArray, t: float, place: Place) -> tuple[float, float]:
    """V' of (2.1): friction -b1 V, and the force of the phase."""
    x, y, u, v, vx, vy = place
    b1 = memory[slots.B1]
    if memory[slots.PHASE] == slots.BALLISTIC:
        along_x, along_y = ballistic_force(memory, t)
        return along_x - b1 * vx, along_y - b1 * vy
    if memory[slots.PHASE] != slots.CORRECTIVE:
        return -b1 * vx, -b1 * vy
    if memory[slots.METRES_PER_COUNT] > 0.0:
        x, y = cursor_in_mind(memory, u, v, hypot(vx, vy))
    b2 = memory[slots.FEEDBACK]
    return (
        -b1 * vx - b2 * (x - memory[slots.AIM_X]),
        -b1 * vy - b2 * (y - memory[slots.AIM_Y]),
    )


@law
def cursor_rate(memory: FloatArray, vx: float, vy: float) -> tuple[float, float]:
    """The cursor's velocity of (2.1) without a sensor: (Vx, Vy) / |V| PTF(|V|), px/s."""
    scale = memory[slots.PX_PER_METRE] * functions.gain(memory, slots.FUNCTION, hypot(vx, vy))
    return scale * vx, scale * vy


@law
def advance(memory: FloatArray, t: float, h: float, extra_x: float, extra_y: float) -> None:
    """One step of h s by the midpoint rule; ``extra`` is the velocity of noise and tremor."""
    keep = exp(-0.5 * h / memory[slots.MUSCLE_S]) if memory[slots.MUSCLE_S] > 0.0 else 0.0
    u, v, vx, vy = memory[slots.U], memory[slots.V], memory[slots.VX], memory[slots.VY]
    x, y = memory[slots.X], memory[slots.Y]
    continuous = memory[slots.METRES_PER_COUNT] == 0.0
    ax, ay = acceleration(memory, t, Place(x, y, u, v, vx, vy))
    ax, ay = ax + keep * (memory[slots.AX] - ax), ay + keep * (memory[slots.AY] - ay)
    middle_x, middle_y = vx + 0.5 * h * ax, vy + 0.5 * h * ay
    if continuous:
        dx, dy = cursor_rate(memory, vx + extra_x, vy + extra_y)
        x, y = x + 0.5 * h * dx, y + 0.5 * h * dy
    middle_u, middle_v = u + 0.5 * h * vx, v + 0.5 * h * vy
    bx, by = acceleration(memory, t + 0.5 * h, Place(x, y, middle_u, middle_v, middle_x, middle_y))
    bx, by = bx + keep * (ax - bx), by + keep * (ay - by)
    memory[slots.AX], memory[slots.AY] = bx, by
    memory[slots.VX], memory[slots.VY] = vx + h * bx, vy + h * by
    memory[slots.U] = u + h * (middle_x + extra_x)
    memory[slots.V] = v + h * (middle_y + extra_y)
    if continuous:
        dx, dy = cursor_rate(memory, middle_x + extra_x, middle_y + extra_y)
        memory[slots.X] += h * dx
        memory[slots.Y] += h * dy


@law
def count(position_m: float, metres_per_count: float, counted: float) -> float:
    """Whole counts an axis has moved since the last report; the remainder carries over."""
    return float(trunc(position_m / metres_per_count - counted))


@law
def assist(memory: FloatArray, own_px: float, hat_x: float, hat_y: float) -> tuple[float, float]:
    """The pull of the assisted transfer function over one report period, px; 0 without an estimate."""
    off_x, off_y = hat_x - memory[slots.X], hat_y - memory[slots.Y]
    rho, strength = memory[slots.RHO], memory[slots.STRENGTH]
    share = assistance.pull(rho, strength, memory[slots.PERIOD_S], own_px, off_x, off_y)
    return (share * off_x, share * off_y) if share > 0.0 else (0.0, 0.0)


@law
def report(memory: FloatArray, hat_x: float, hat_y: float) -> tuple[float, float]:
    """Poll the sensor: the counts of both axes; the cursor moves by whole pixels.

    With an estimate of the endpoint the cursor is pulled to it (Remark 2.2.1).
    """
    unit = memory[slots.METRES_PER_COUNT]
    dx = count(memory[slots.U], unit, memory[slots.COUNTED_X])
    dy = count(memory[slots.V], unit, memory[slots.COUNTED_Y])
    memory[slots.COUNTED_X] += dx
    memory[slots.COUNTED_Y] += dy
    gain = functions.gain(memory, slots.FUNCTION, hypot(dx, dy) * unit / memory[slots.PERIOD_S])
    scale = gain * memory[slots.PX_PER_METRE] * unit
    pull_x, pull_y = assist(memory, scale * hypot(dx, dy), hat_x, hat_y)
    memory[slots.X] += pixels.carry(memory, slots.CARRY, scale * dx)
    memory[slots.Y] += pixels.carry(memory, slots.CARRY + 1, scale * dy)
    # A common fraction would be dropped at every poll in which the hand moves against the pull.
    memory[slots.X] += pixels.carry(memory, slots.PULLED, pull_x)
    memory[slots.Y] += pixels.carry(memory, slots.PULLED + 1, pull_y)
    return dx, dy


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
    memory[slots.AMPLITUDE] = hand_distance(memory, wanted, memory[piece + slots.DURATION_S])
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
    memory: FloatArray, chance: tuple[float, float, float, float, float]
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
        advance(memory, now + i * h, h, extra_x, extra_y)
    dx = dy = 0.0
    if memory[slots.METRES_PER_COUNT] > 0.0:
        dx, dy = report(memory, hat_x, hat_y)
    else:
        own_px = hypot(memory[slots.X] - before_x, memory[slots.Y] - before_y)
        pull_x, pull_y = assist(memory, own_px, hat_x, hat_y)
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
def play(memory: FloatArray, rows: FloatTable, out: FloatTable) -> int:
    """Report after report, a ``Chance`` a row, until the button is released; returns how many there were."""
    for i in range(len(rows)):
        r = rows[i]
        answer = step(memory, (r[0], r[1], r[2], r[3], r[4]))
        for j in range(len(answer)):
            out[i, j] = answer[j]
        if memory[slots.PHASE] == slots.DONE:
            return i + 1
    return len(rows)
