"""From events to clean samples: what every differentiator does before its own law.

Equal times are one event, gaps restart, time backwards is refused, counts become metres, and the start of a
movement is noticed. The rules are those of the public interface, so all differentiators share them.
"""

from __future__ import annotations

from math import floor

import numpy as np

from pointpred.compiled import law, layout
from pointpred.errors import EventError, EventOrderError
from pointpred.records import (
    LARGEST,
    LATEST_S,
    METRES_PER_INCH,
    ROUNDING_S,
    EventRow,
    FloatArray,
    PointerEvent,
    TenFloats,
)

# Parameters, first in the memory of every differentiator.
METRES_PER_COUNT, METRES_PER_PX, GAP_S, PAUSE_S, SETTINGS = range(5)

# State, relative to `at`: started, time, cursor, buttons, motor position since the restart (m), samples since
# the restart, whether the last motor increment came from counts, time of the restart, motor position that the
# law used last (without what was merged since).
STARTED, T, X, Y, BUTTONS, U, V, SAMPLES, COUNTS, SINCE, LAST_U, LAST_V, STATES = range(13)

REFUSED, MERGED, RESTARTED, MOVED = -1, 0, 1, 2


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
def usable(event: EventRow) -> bool:
    """Whether the values make an event: all within their bounds, buttons whole, counts both or none (NaN)."""
    t, x, y, dx, dy, buttons = event
    if not (abs(t) <= LATEST_S and abs(x) <= LARGEST and abs(y) <= LARGEST and 0.0 <= buttons <= LARGEST):
        return False
    if buttons != floor(buttons):
        return False
    return bool((dx != dx and dy != dy) or (abs(dx) <= LARGEST and abs(dy) <= LARGEST))


@law
def accept(memory: FloatArray, at: int, event: EventRow) -> tuple[int, float, float, float, bool]:
    """Take one event in: (verdict, dt in s, motor position that the law used last in m, movement started).

    A refused event changes nothing. A merged one has changed the motor position, which the law uses at the
    next later time. After a restart the motor position is 0: the law starts there, at rest.
    """
    t, x, y, dx, dy, buttons = event
    started = memory[at + STARTED] == 1.0
    if not usable(event) or (started and t < memory[at + T]):
        return REFUSED, 0.0, 0.0, 0.0, False
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


def is_number(value: object) -> bool:
    """Whether a value is a number by its kind: no word that reads like one, no truth value."""
    return isinstance(value, int | float | np.integer | np.floating) and not isinstance(value, bool)


def refusal(event: PointerEvent, last_t: float | None) -> EventError:
    """Why an event was refused; ``last_t`` is the time it must not precede, if there is one."""
    for name in ("t", "x", "y", "dx", "dy", "buttons"):
        value = getattr(event, name)
        if value is None and name in ("dx", "dy"):
            continue
        high = LATEST_S if name == "t" else LARGEST
        low = 0.0 if name == "buttons" else -high
        if not is_number(value):
            return EventError(f"{name} must be a number, received {value!r}", field=name, value=value)
        if not low <= value <= high:
            message = f"{name} must lie in [{low:g}, {high:g}], received {value!r}"
            return EventError(message, field=name, value=value)
        if name == "buttons" and value != int(value):
            return EventError(f"{name} must be a whole number, received {value!r}", field=name, value=value)
    if (event.dx is None) != (event.dy is None):
        message = f"dx and dy come together or not at all, received {event.dx!r} and {event.dy!r}"
        return EventError(message, field="dx", value=event.dx)
    if last_t is not None and event.t < last_t:
        message = f"t must not run backwards: received {event.t!r} s after {last_t!r} s"
        return EventOrderError(message, field="t", value=event.t)
    return EventError(f"event refused: {event!r}")
