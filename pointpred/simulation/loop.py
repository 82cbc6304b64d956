"""The closed pointing loop (2.1): a person, a hand, a mouse, a cursor, one report at a time."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, cos, exp, hypot, pi, sin, sqrt, trunc
from typing import Annotated, NamedTuple

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import FloatTable
from pointpred.transfer import assistance, functions, pixels

QUADRATURE = 16
BISECTIONS = 40
LONGEST_M = 2.0
"""Longest hand movement of one piece, m."""

WAITING, BALLISTIC, CORRECTIVE, VERIFYING, PRESSING, DONE = 0.0, 1.0, 2.0, 3.0, 4.0, 5.0
"""The phases of a trial."""
PIECES_MOST = 4
RING_ROWS = 256
"""So many reports the eyes may be late."""


class Piece(Layout):
    """A sub-movement."""

    share: float
    """Of the way that remains."""
    duration_s: float
    skew: float
    """Of its speed, as ``profile`` takes it."""
    turn: float
    curve: float
    """Turn and curvature, rad."""
    until: float
    """The share of its duration after which the next piece or the corrective phase begins."""


class Settings(Layout):
    """The setup, the person, the trial."""

    period_s: float
    """Between two reports."""
    substeps: float
    """Euler's steps a report."""
    px_per_metre: float
    """On the screen, of what the transfer function returns."""
    metres_per_count: float
    """0: no sensor, the cursor is continuous and seen at once."""
    rho: float
    strength: float
    """The assisted term, 1/s, and its bound as a share of the hand's own motion."""
    function: functions.Function
    b1: float
    """Friction, 1/s."""
    b2: float
    """Feedback in m/s^2 a px, 0 where it follows from ``rate`` and the gain felt."""
    rate: float
    """1/s."""
    muscle_s: float
    """Lag of the muscles."""
    delay_s: float
    """Of the eyes."""
    noise: float
    """As a share of the speed."""
    tremor: float
    """m/s."""
    target_x: float
    target_y: float
    radius: float
    """px from the start of the trial, like the aim."""
    aim_x: float
    aim_y: float
    """Of the last phase."""
    reaction_s: float
    verify_s: float
    press_s: float
    patience_s: float
    count: float
    """How many pieces there are."""
    pieces: Annotated[Sequence[Piece], PIECES_MOST]


class Sight(Layout):
    """Where the cursor, px, and the hand, m, were."""

    x: float
    y: float
    u: float
    v: float


class State(Layout):
    """Where the trial is; zeros at its start."""

    tick: float
    """Reports so far."""
    phase: float
    since: float
    """When it began, s."""
    number: float
    amplitude: float
    angle: float
    """Of the piece; its amplitude in m, its angle in rad."""
    feedback: float
    """b2 of the corrective phase."""
    u: float
    v: float
    vx: float
    vy: float
    ax: float
    ay: float
    """The hand: m, m/s, m/s^2."""
    wander_x: float
    wander_y: float
    """Its wandering, without a unit."""
    x: float
    y: float
    """The cursor, px from the start."""
    counted_x: float
    counted_y: float
    """Counts reported so far."""
    carried: pixels.Carried
    pulled: pixels.Carried
    """What the hand and the assisted term have not moved yet."""
    ring: Annotated[Sequence[Sight], RING_ROWS]
    """What the eyes have yet to see."""


class Memory(Layout):
    """One simulated trial: the settings, then the state."""

    settings: Settings
    state: State


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
def cursor_distance(settings: Settings, amplitude: float, duration: float) -> float:
    """The cursor's distance (px) while the hand moves ``amplitude`` metres by the law without skew.

    The integral of PTF(V) over V = A pi / (2 D) sin pi u by Simpson's rule; over A it is the averaged gain c
    of 2.4.2, corrected.
    """
    peak = 0.5 * pi * amplitude / duration
    total = 0.0
    for i in range(1, QUADRATURE):
        weight = 4.0 if i % 2 == 1 else 2.0
        total += weight * functions.cursor_speed(settings.function, peak * sin(pi * i / QUADRATURE))
    return float(settings.px_per_metre * duration * total / (3.0 * QUADRATURE))


@law
def hand_distance(settings: Settings, distance_px: float, duration: float) -> float:
    """The amplitude (m) that moves the cursor by ``distance_px``: ``cursor_distance`` inverted."""
    low, high = 0.0, LONGEST_M
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        if cursor_distance(settings, middle, duration) < distance_px:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


@law
def ballistic_force(memory: Memory, t: float) -> tuple[float, float]:
    """The open-loop force of the current piece: planned acceleration with friction compensated."""
    settings, s = memory.settings, memory.state
    piece = settings.pieces[int(s.number)]
    duration, curve = piece.duration_s, piece.curve
    share, rate, bend = profile((t - s.since) / duration, piece.skew)
    speed = s.amplitude * rate / duration
    along = s.amplitude * bend / duration**2 + settings.b1 * speed
    across = -2.0 * curve * (rate / duration) * speed
    angle = s.angle + curve * (1.0 - 2.0 * share)
    return along * cos(angle) - across * sin(angle), along * sin(angle) + across * cos(angle)


@law
def cursor_in_mind(memory: Memory, u: float, v: float, speed: float) -> tuple[float, float]:
    """The person's estimate of the cursor: its delayed sight, plus the hand's motion since."""
    settings, s = memory.settings, memory.state
    late = int(settings.delay_s / settings.period_s + 0.5)
    seen = s.ring[(int(s.tick) - late) % RING_ROWS]
    gain = functions.gain(settings.function, speed) * settings.px_per_metre
    return seen.x + gain * (u - seen.u), seen.y + gain * (v - seen.v)


class Place(NamedTuple):
    """Positions and velocities of cursor and hand: ``x y`` px, ``u v`` m, ``vx vy`` m/s."""

    x: float
    y: float
    u: float
    v: float
    vx: float
    vy: float


@law
def acceleration(memory: Memory, t: float, place: Place) -> tuple[float, float]:
    """V' of (2.1): friction -b1 V, and the force of the phase."""
    settings, s = memory.settings, memory.state
    x, y, u, v, vx, vy = place
    b1 = settings.b1
    if s.phase == BALLISTIC:
        along_x, along_y = ballistic_force(memory, t)
        return along_x - b1 * vx, along_y - b1 * vy
    if s.phase != CORRECTIVE:
        return -b1 * vx, -b1 * vy
    if settings.metres_per_count > 0.0:
        x, y = cursor_in_mind(memory, u, v, hypot(vx, vy))
    b2 = s.feedback
    return -b1 * vx - b2 * (x - settings.aim_x), -b1 * vy - b2 * (y - settings.aim_y)


@law
def cursor_rate(settings: Settings, vx: float, vy: float) -> tuple[float, float]:
    """The cursor's velocity of (2.1) without a sensor: (Vx, Vy) / |V| PTF(|V|), px/s."""
    scale = settings.px_per_metre * functions.gain(settings.function, hypot(vx, vy))
    return scale * vx, scale * vy


@law
def advance(memory: Memory, t: float, h: float, extra_x: float, extra_y: float) -> None:
    """One step of h s by the midpoint rule; ``extra`` is the velocity of noise and tremor."""
    settings, s = memory.settings, memory.state
    keep = exp(-0.5 * h / settings.muscle_s) if settings.muscle_s > 0.0 else 0.0
    u, v, vx, vy = s.u, s.v, s.vx, s.vy
    x, y = s.x, s.y
    continuous = settings.metres_per_count == 0.0
    ax, ay = acceleration(memory, t, Place(x, y, u, v, vx, vy))
    ax, ay = ax + keep * (s.ax - ax), ay + keep * (s.ay - ay)
    middle_x, middle_y = vx + 0.5 * h * ax, vy + 0.5 * h * ay
    if continuous:
        dx, dy = cursor_rate(settings, vx + extra_x, vy + extra_y)
        x, y = x + 0.5 * h * dx, y + 0.5 * h * dy
    middle_u, middle_v = u + 0.5 * h * vx, v + 0.5 * h * vy
    bx, by = acceleration(memory, t + 0.5 * h, Place(x, y, middle_u, middle_v, middle_x, middle_y))
    bx, by = bx + keep * (ax - bx), by + keep * (ay - by)
    s.ax, s.ay = bx, by
    s.vx, s.vy = vx + h * bx, vy + h * by
    s.u = u + h * (middle_x + extra_x)
    s.v = v + h * (middle_y + extra_y)
    if continuous:
        dx, dy = cursor_rate(settings, middle_x + extra_x, middle_y + extra_y)
        s.x += h * dx
        s.y += h * dy


@law
def count(position_m: float, metres_per_count: float, counted: float) -> float:
    """Whole counts an axis has moved since the last report; the remainder carries over."""
    return float(trunc(position_m / metres_per_count - counted))


@law
def assist(memory: Memory, own_px: float, hat_x: float, hat_y: float) -> tuple[float, float]:
    """The pull of the assisted transfer function over one report period, px; 0 without an estimate."""
    settings, s = memory.settings, memory.state
    off_x, off_y = hat_x - s.x, hat_y - s.y
    rho, strength = settings.rho, settings.strength
    share = assistance.pull(rho, strength, settings.period_s, own_px, off_x, off_y)
    return (share * off_x, share * off_y) if share > 0.0 else (0.0, 0.0)


@law
def report(memory: Memory, hat_x: float, hat_y: float) -> tuple[float, float]:
    """Poll the sensor: the counts of both axes; the cursor moves by whole pixels.

    With an estimate of the endpoint the cursor is pulled to it (Remark 2.2.1).
    """
    settings, s = memory.settings, memory.state
    unit = settings.metres_per_count
    dx = count(s.u, unit, s.counted_x)
    dy = count(s.v, unit, s.counted_y)
    s.counted_x += dx
    s.counted_y += dy
    gain = functions.gain(settings.function, hypot(dx, dy) * unit / settings.period_s)
    scale = gain * settings.px_per_metre * unit
    pull_x, pull_y = assist(memory, scale * hypot(dx, dy), hat_x, hat_y)
    s.x += pixels.carry(s.carried, 0, scale * dx)
    s.y += pixels.carry(s.carried, 1, scale * dy)
    # A common fraction would be dropped at every poll in which the hand moves against the pull.
    s.x += pixels.carry(s.pulled, 0, pull_x)
    s.y += pixels.carry(s.pulled, 1, pull_y)
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
def enter(s: State, phase: float, t: float) -> None:
    """Begin a phase."""
    s.phase, s.since = phase, t


@law
def correct(memory: Memory, t: float) -> None:
    """Begin the corrective phase; by default b2 follows from the gain at half the present speed."""
    settings, s = memory.settings, memory.state
    enter(s, CORRECTIVE, t)
    s.feedback = settings.b2
    if settings.b2 == 0.0:
        gain = functions.gain(settings.function, 0.5 * hypot(s.vx, s.vy))
        s.feedback = settings.rate**2 / (gain * settings.px_per_metre)


@law
def launch(memory: Memory, number: int, t: float) -> None:
    """Begin a piece towards its share of the remaining way; if that is too short, correct instead."""
    settings, s = memory.settings, memory.state
    way_x, way_y = settings.aim_x - s.x, settings.aim_y - s.y
    way = hypot(way_x, way_y)
    if number >= settings.count or way < max(WORTHWHILE_PX, 2.0 * settings.radius):
        correct(memory, t)
        return
    enter(s, BALLISTIC, t)
    piece = settings.pieces[number]
    s.number = float(number)
    wanted = way * piece.share
    s.amplitude = hand_distance(settings, wanted, piece.duration_s)
    s.angle = atan2(way_y, way_x) + piece.turn


@law
def decide(memory: Memory, t: float) -> None:
    """The person's next phase: wait, move, move again, correct, verify, press, release."""
    settings, s = memory.settings, memory.state
    phase, since = s.phase, s.since
    if phase == WAITING and t >= settings.reaction_s:
        launch(memory, 0, t)
    elif phase == BALLISTIC:
        number = int(s.number)
        piece = settings.pieces[number]
        if t - since >= piece.until * piece.duration_s:
            launch(memory, number + 1, t)
    elif phase == CORRECTIVE:
        off = hypot(s.x - settings.target_x, s.y - settings.target_y)
        slow = hypot(s.vx, s.vy) < SLOW_M_S
        arrived = slow and off < NEAR_SHARE * settings.radius
        if arrived or t > settings.patience_s:
            enter(s, VERIFYING, t)
    elif phase == VERIFYING and t - since >= settings.verify_s:
        enter(s, PRESSING, t)
    elif phase == PRESSING and t - since >= settings.press_s:
        enter(s, DONE, t)


@law
def step(
    memory: Memory, chance: tuple[float, float, float, float, float]
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """One report period: decide, move the hand, poll the sensor, update the delayed sight.

    Takes a ``Chance`` and returns the floats of a ``Poll``.
    """
    settings, s = memory.settings, memory.state
    noise_x, noise_y, late_s, hat_x, hat_y = Chance(*chance)
    period = settings.period_s
    now = s.tick * period
    decide(memory, now)
    keep = exp(-period / WANDER_S)
    fresh = sqrt(1.0 - keep * keep)
    s.wander_x = keep * s.wander_x + fresh * noise_x
    s.wander_y = keep * s.wander_y + fresh * noise_y
    speed = hypot(s.vx, s.vy)
    size = settings.tremor + settings.noise * speed
    extra_x, extra_y = size * s.wander_x, size * s.wander_y
    before_x, before_y = s.x, s.y
    substeps = int(settings.substeps)
    h = period / substeps
    for i in range(substeps):
        advance(memory, now + i * h, h, extra_x, extra_y)
    dx = dy = 0.0
    if settings.metres_per_count > 0.0:
        dx, dy = report(memory, hat_x, hat_y)
    else:
        own_px = hypot(s.x - before_x, s.y - before_y)
        pull_x, pull_y = assist(memory, own_px, hat_x, hat_y)
        s.x += pull_x
        s.y += pull_y
    s.tick += 1.0
    seen = s.ring[int(s.tick) % RING_ROWS]
    seen.x, seen.y = s.x, s.y
    seen.u, seen.v = s.u, s.v
    return (
        s.tick * period + late_s,
        s.x,
        s.y,
        dx,
        dy,
        1.0 if s.phase == PRESSING else 0.0,
        s.u,
        s.v,
        s.vx + extra_x,
        s.vy + extra_y,
        s.ax,
        s.ay,
        s.phase,
        s.number,
    )


@law
def play(memory: Memory, rows: FloatTable, out: FloatTable) -> int:
    """Report after report, a ``Chance`` a row, until the button is released; returns how many there were."""
    for i in range(len(rows)):
        r = rows[i]
        answer = step(memory, (r[0], r[1], r[2], r[3], r[4]))
        for j in range(len(answer)):
            out[i, j] = answer[j]
        if memory.state.phase == DONE:
            return i + 1
    return len(rows)
