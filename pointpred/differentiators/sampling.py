"""From events to clean samples: what every differentiator does before its own law.

Equal times are one event, gaps restart, time backwards is refused, counts become metres, and the start of a
movement is noticed. The rules are those of the public interface, so all differentiators share them.
"""

from __future__ import annotations

from pointpred.compiled import law, layout
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

# Parameters, first in the memory of every differentiator.
METRES_PER_COUNT, METRES_PER_PX, GAP_S, PAUSE_S, SETTINGS = range(5)

# State, relative to `at`: started, time, cursor, buttons, motor position since the restart (m), samples since
# the restart, whether the last motor increment came from counts, time of the restart, motor position that the
# law used last (without what was merged since).
STARTED, T, X, Y, BUTTONS, U, V, SAMPLES, COUNTS, SINCE, LAST_U, LAST_V, STATES = range(13)

MERGED, RESTARTED, MOVED = 0, 1, 2


@layout
def fill(values: FloatArray, memory: FloatArray) -> None:
    """The settings of counts per inch (0: counts are not used), px per inch, gap and pause in s.

    What else a differentiator may be set follows as it is.
    """
    memory[METRES_PER_COUNT] = METRES_PER_INCH / values[0] if values[0] > 0.0 else 0.0
    memory[METRES_PER_PX] = METRES_PER_INCH / values[1]
    for i in range(GAP_S, len(values)):
        memory[i] = values[i]


@law
def accept(memory: FloatArray, at: int, event: EventRow) -> tuple[int, float, float, float, bool]:
    """Take one event in: (verdict, dt in s, motor position that the law used last in m, movement started).

    A refused event changes nothing; its verdict is the code of its fault, as in ``records``, with a minus. A
    merged one has changed the motor position, which the law uses at the
    next later time. After a restart the motor position is 0: the law starts there, at rest.
    """
    t, x, y, dx, dy, buttons = event
    started = memory[at + STARTED] == 1.0
    fault = fault_of_event(event)
    if fault == FINE and started and t < memory[at + T]:
        fault = ORDER
    if fault != FINE:
        return -fault, 0.0, 0.0, 0.0, False
    dt = t - memory[at + T]
    released = int(memory[at + BUTTONS]) & ~int(buttons) != 0
    start = not started or released or dt > memory[PAUSE_S] + ROUNDING_S
    counted = dx == dx and memory[METRES_PER_COUNT] > 0.0
    merged = started and dt == 0.0
    # What shares the time of a restart belongs to the place where the device starts, not to a movement.
    restarted = not started or dt > memory[GAP_S] + ROUNDING_S or (merged and memory[at + SAMPLES] == 1.0)
    if restarted:
        memory[at + U], memory[at + V] = 0.0, 0.0
        memory[at + LAST_U], memory[at + LAST_V] = 0.0, 0.0
        memory[at + SINCE] = t
    elif counted:
        memory[at + U] += dx * memory[METRES_PER_COUNT]
        memory[at + V] += dy * memory[METRES_PER_COUNT]
    else:
        memory[at + U] += (x - memory[at + X]) * memory[METRES_PER_PX]
        memory[at + V] += (y - memory[at + Y]) * memory[METRES_PER_PX]
    memory[at + STARTED] = 1.0
    memory[at + T], memory[at + X], memory[at + Y] = t, x, y
    memory[at + BUTTONS] = buttons
    memory[at + COUNTS] = 1.0 if counted else 0.0
    if restarted:
        memory[at + SAMPLES] = 1.0
        return RESTARTED, dt, 0.0, 0.0, start
    if merged:
        return MERGED, 0.0, 0.0, 0.0, start
    before_u, before_v = memory[at + LAST_U], memory[at + LAST_V]
    memory[at + LAST_U], memory[at + LAST_V] = memory[at + U], memory[at + V]
    memory[at + SAMPLES] += 1.0
    return MOVED, dt, before_u, before_v, start


@law
def settled(memory: FloatArray, at: int, samples: float, settle_s: float) -> float:
    """1 once there are ``samples`` samples over ``settle_s`` s since the restart, else 0."""
    long_enough = memory[at + T] - memory[at + SINCE] >= settle_s
    return 1.0 if long_enough and memory[at + SAMPLES] >= samples else 0.0


@law
def motion(
    memory: FloatArray,
    at: int,
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
    return t, x, y, vx, vy, ax, ay, settled, 1.0 if start else 0.0, memory[at + COUNTS]
