"""From events to clean samples: what every differentiator does before its own law.

Equal times are one event, gaps restart, time backwards is refused, counts become metres, and the start of a
movement is noticed. The rules are those of the public interface, so all differentiators share them.
"""

from __future__ import annotations

from math import floor

import numpy as np

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.events import CPI, DPI, LARGEST, LATEST_S, ROUNDING_S, PointerEvent
from pointpred.stage import Parameter, check

METRES_PER_INCH = 0.0254

# Parameters, first in the memory of every differentiator.
METRES_PER_COUNT, METRES_PER_PX, GAP_S, PAUSE_S = 0, 1, 2, 3
SETTINGS = 4

# State, relative to `at`: started, time, cursor, buttons, motor position since the restart (m), samples since
# the restart, whether the last motor increment came from counts, time of the restart, motor position that the
# law saw last (without what was merged since).
STARTED, T, X, Y, BUTTONS, U, V, SEEN, COUNTS, SINCE, SEEN_U, SEEN_V = 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11
STATES = 12

REFUSED, MERGED, RESTARTED, MOVED = -1, 0, 1, 2

PARAMETERS = (
    Parameter("cpi", "counts per inch", *CPI, "resolution of the device; None: counts are not used"),
    Parameter("dpi", "px per inch", *DPI, "resolution of the screen, used where counts are not"),
    Parameter("gap_s", "s", 1e-3, 1e3, "a longer gap between events means that the device was still"),
    Parameter("pause_s", "s", 1e-3, 1e3, "the first event after a longer pause starts a movement"),
)


@law
def usable(t: float, x: float, y: float, dx: float, dy: float, buttons: float) -> bool:
    """Whether the values make an event: all within their bounds, buttons whole, counts both or none (NaN)."""
    if not (abs(t) <= LATEST_S and abs(x) <= LARGEST and abs(y) <= LARGEST and 0.0 <= buttons <= LARGEST):
        return False
    if buttons != floor(buttons):
        return False
    return bool((dx != dx and dy != dy) or (abs(dx) <= LARGEST and abs(dy) <= LARGEST))


@law
def accept(
    memory: FloatArray, at: int, t: float, x: float, y: float, dx: float, dy: float, buttons: float
) -> tuple[int, float, float, float, bool]:
    """Take one event in: (verdict, dt in s, motor position the law saw last in m, movement started).

    A refused event changes nothing. A merged one has changed the motor position, which the law sees at the
    next later time. After a restart the motor position is 0: the law starts there, at rest.
    """
    started = memory[at + STARTED] == 1.0
    if not usable(t, x, y, dx, dy, buttons) or (started and t < memory[at + T]):
        return REFUSED, 0.0, 0.0, 0.0, False
    dt = t - memory[at + T]
    released = int(memory[at + BUTTONS]) & ~int(buttons) != 0
    start = not started or released or dt > memory[PAUSE_S] + ROUNDING_S
    counted = dx == dx and memory[METRES_PER_COUNT] > 0.0
    merged = started and dt == 0.0
    # What shares the time of a restart belongs to the place where the device starts, not to a movement.
    restarted = not started or dt > memory[GAP_S] + ROUNDING_S or (merged and memory[at + SEEN] == 1.0)
    if restarted:
        memory[at + U], memory[at + V] = 0.0, 0.0
        memory[at + SEEN_U], memory[at + SEEN_V] = 0.0, 0.0
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
        memory[at + SEEN] = 1.0
        return RESTARTED, dt, 0.0, 0.0, start
    if merged:
        return MERGED, 0.0, 0.0, 0.0, start
    before_u, before_v = memory[at + SEEN_U], memory[at + SEEN_V]
    memory[at + SEEN_U], memory[at + SEEN_V] = memory[at + U], memory[at + V]
    memory[at + SEEN] += 1.0
    return MOVED, dt, before_u, before_v, start


@law
def settled(memory: FloatArray, at: int, samples: float, settle_s: float) -> float:
    """1 once there are ``samples`` samples over ``settle_s`` s since the restart, else 0."""
    long_enough = memory[at + T] - memory[at + SINCE] >= settle_s
    return 1.0 if long_enough and memory[at + SEEN] >= samples else 0.0


def settings(cpi: float | None, dpi: float, gap_s: float, pause_s: float) -> list[float]:
    """The shared parameters as they stand first in the memory."""
    return [0.0 if cpi is None else METRES_PER_INCH / cpi, METRES_PER_INCH / dpi, gap_s, pause_s]


def is_number(value: object) -> bool:
    """Whether a value is a number by its kind: no word that reads like one, no truth value."""
    return isinstance(value, int | float | np.integer | np.floating) and not isinstance(value, bool)


def explain(event: PointerEvent, last_t: float | None) -> EventError:
    """Why an event was refused, in words; ``last_t`` is the time it must not precede, if there is one."""
    for name in ("t", "x", "y", "dx", "dy", "buttons"):
        value = getattr(event, name)
        if value is None and name in ("dx", "dy"):
            continue
        high = LATEST_S if name == "t" else LARGEST
        low = 0.0 if name == "buttons" else -high
        if not is_number(value):
            return EventError(f"{name} must be a number, received {value!r}")
        if not low <= value <= high:
            return EventError(f"{name} must lie in [{low:g}, {high:g}], received {value!r}")
        if name == "buttons" and value != int(value):
            return EventError(f"buttons must be a whole number, received {value!r}")
    if (event.dx is None) != (event.dy is None):
        return EventError(f"dx and dy come together or not at all, received {event.dx!r} and {event.dy!r}")
    if last_t is not None and event.t < last_t:
        return EventOrderError(f"t must not run backwards: received {event.t!r} s after {last_t!r} s")
    return EventError(f"event refused: {event!r}")


def named(cpi: float | None, dpi: float, gap_s: float, pause_s: float) -> dict[str, float]:
    """The shared parameters by name, checked: each on its own, and no pause shorter than a gap."""
    values = {"cpi": 1.0 if cpi is None else cpi, "dpi": dpi, "gap_s": gap_s, "pause_s": pause_s}
    check(PARAMETERS, values)
    if pause_s < gap_s:
        raise ParameterError(f"pause_s must be at least gap_s = {gap_s:g} s, received {pause_s:g} s")
    return values
