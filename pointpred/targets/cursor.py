"""The cursor's own way: its start, its direction, its speed relative to the peak."""

from __future__ import annotations

from math import exp, hypot, inf

from pointpred.compiled import law
from pointpred.records import LARGEST, LATEST_S, ROUNDING_S, FloatArray

PAUSE_S = 0.3
"""The first event after a longer pause starts a movement."""
SPEED_S = 0.03
"""Time constant of the speed."""
SLOWER_S = 0.06
"""Time constant of the speed that it is compared with."""
TRAIL_SHARE = 0.35
"""The trail follows the cursor at this share of its distance from the start."""

# State: whether anything is known, the last event, the start, a point that trails the cursor, the velocity
# in px/s, its size, a slower one, its peak.
KNOWN, T, X, Y, PRESSED, T0, X0, Y0, TRAIL_X, TRAIL_Y, VX, VY, SPEED, SLOW, PEAK, STATES = range(16)


@law
def usable(t: float, x: float, y: float) -> bool:
    """Whether an event's numbers are finite and within the bounds of events."""
    return abs(t) < LATEST_S and abs(x) <= LARGEST and abs(y) <= LARGEST


@law
def follow(memory: FloatArray, t: float, x: float, y: float, pressed: float) -> bool:
    """Take an event in, a usable one that is not before the last; returns whether a button was released."""
    dt = t - memory[T]
    released = memory[PRESSED] == 1.0 and pressed == 0.0
    starts = memory[KNOWN] == 0.0 or released or dt > PAUSE_S + ROUNDING_S
    if starts:
        memory[T0], memory[X0], memory[Y0] = t, x, y
        memory[TRAIL_X], memory[TRAIL_Y] = x, y
        memory[VX] = memory[VY] = memory[SPEED] = memory[SLOW] = memory[PEAK] = 0.0
    else:
        way = hypot(x - memory[X], y - memory[Y])
        far = hypot(x - memory[X0], y - memory[Y0])
        share = 1.0 - exp(-way / (TRAIL_SHARE * far)) if far > 0.0 else 1.0
        memory[TRAIL_X] += share * (x - memory[TRAIL_X])
        memory[TRAIL_Y] += share * (y - memory[TRAIL_Y])
        if dt > 0.0:  # of events at one time, the later position replaces
            share = 1.0 - exp(-dt / SPEED_S)
            memory[VX] += share * ((x - memory[X]) / dt - memory[VX])
            memory[VY] += share * ((y - memory[Y]) / dt - memory[VY])
            memory[SPEED] = hypot(memory[VX], memory[VY])
            memory[SLOW] += (1.0 - exp(-dt / SLOWER_S)) * (memory[SPEED] - memory[SLOW])
        memory[PEAK] = max(memory[PEAK], memory[SPEED])
    memory[KNOWN], memory[PRESSED] = 1.0, pressed
    memory[T], memory[X], memory[Y] = t, x, y
    return released


@law
def until(memory: FloatArray, x: float, y: float, width: float, height: float) -> float:
    """Seconds until the cursor enters a rectangle at its present speed; 0 inside, infinite at rest."""
    dx = max(abs(x - memory[X]) - 0.5 * width, 0.0)
    dy = max(abs(y - memory[Y]) - 0.5 * height, 0.0)
    way = hypot(dx, dy)
    if way == 0.0:
        return 0.0
    return way / memory[SPEED] if memory[SPEED] > 0.0 else inf
