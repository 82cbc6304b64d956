"""The hand: its planned ballistic profile, the forces on it, and one step of (2.1)."""

from __future__ import annotations

from math import cos, exp, hypot, pi, sin
from typing import NamedTuple

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.simulation import slots
from pointpred.transfer import functions

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
