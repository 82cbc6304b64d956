"""From events to clean samples: what every differentiator does before its own law.

Equal times are one event, gaps restart, time backwards is refused, counts become metres, and the start of a
movement is noticed. The rules are those of the public interface, so all differentiators share them.
"""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import (
    FINE,
    METRES_PER_INCH,
    ORDER,
    ROUNDING_S,
    EventRow,
    FloatArray,
    TenFloats,
    fault_of_event,
)


class Settings(Layout):
    """What every differentiator's memory begins with: m per count (0: counts are not used), m per px, s."""

    metres_per_count: float
    metres_per_px: float
    gap_s: float
    pause_s: float


class State(Layout):
    """What is known of the samples since the restart."""

    started: float
    t: float
    x: float
    y: float
    buttons: float
    u: float
    v: float
    """Motor position, m."""
    samples: float
    counts: float
    """Whether the last motor increment came from counts."""
    since: float
    last_u: float
    last_v: float
    """The motor position that the law used last, without what was merged since."""


MERGED, RESTARTED, MOVED = 0, 1, 2


@law
def fill(values: FloatArray, memory: FloatArray) -> None:
    """The settings of counts per inch (0: counts are not used), px per inch, gap and pause in s.

    What else a differentiator may be set follows as it is.
    """
    memory[0] = METRES_PER_INCH / values[0] if values[0] > 0.0 else 0.0
    memory[1] = METRES_PER_INCH / values[1]
    for i in range(2, len(values)):
        memory[i] = values[i]


@law
def accept(settings: Settings, s: State, event: EventRow) -> tuple[int, float, float, float, bool]:
    """Take one event in: (verdict, dt in s, motor position that the law used last in m, movement started).

    A refused event changes nothing; its verdict is the code of its fault, as in ``records``, with a minus. A
    merged one has changed the motor position, which the law uses at the
    next later time. After a restart the motor position is 0: the law starts there, at rest.
    """
    t, x, y, dx, dy, buttons = event
    started = s.started == 1.0
    fault = fault_of_event(event)
    if fault == FINE and started and t < s.t:
        fault = ORDER
    if fault != FINE:
        return -fault, 0.0, 0.0, 0.0, False
    dt = t - s.t
    released = int(s.buttons) & ~int(buttons) != 0
    start = not started or released or dt > settings.pause_s + ROUNDING_S
    counted = dx == dx and settings.metres_per_count > 0.0
    merged = started and dt == 0.0
    # What shares the time of a restart belongs to the place where the device starts, not to a movement.
    restarted = not started or dt > settings.gap_s + ROUNDING_S or (merged and s.samples == 1.0)
    if restarted:
        s.u, s.v = 0.0, 0.0
        s.last_u, s.last_v = 0.0, 0.0
        s.since = t
    elif counted:
        s.u += dx * settings.metres_per_count
        s.v += dy * settings.metres_per_count
    else:
        s.u += (x - s.x) * settings.metres_per_px
        s.v += (y - s.y) * settings.metres_per_px
    s.started = 1.0
    s.t, s.x, s.y = t, x, y
    s.buttons = buttons
    s.counts = 1.0 if counted else 0.0
    if restarted:
        s.samples = 1.0
        return RESTARTED, dt, 0.0, 0.0, start
    if merged:
        return MERGED, 0.0, 0.0, 0.0, start
    before_u, before_v = s.last_u, s.last_v
    s.last_u, s.last_v = s.u, s.v
    s.samples += 1.0
    return MOVED, dt, before_u, before_v, start


@law
def settled(s: State, samples: float, settle_s: float) -> float:
    """1 once there are ``samples`` samples over ``settle_s`` s since the restart, else 0."""
    long_enough = s.t - s.since >= settle_s
    return 1.0 if long_enough and s.samples >= samples else 0.0


@law
def motion(
    s: State,
    event: EventRow,
    hand: tuple[tuple[float, float], tuple[float, float]],
    settled: float,
    start: bool,
) -> TenFloats:
    """The row of the motion after an accepted event; ``hand``: its velocity m/s and acceleration m/s^2."""
    t, x, y, _, _, _ = event
    velocity, acceleration = hand
    vx, vy = velocity
    ax, ay = acceleration
    return t, x, y, vx, vy, ax, ay, settled, 1.0 if start else 0.0, s.counts
