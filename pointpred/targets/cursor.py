"""The cursor's own way: its start, its direction, its speed relative to the peak."""

from __future__ import annotations

from math import exp, hypot, inf

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import LARGEST, LATEST_S, ROUNDING_S

PAUSE_S = 0.3
"""The first event after a longer pause starts a movement."""
SPEED_S = 0.03
"""Time constant of the speed."""
SLOWER_S = 0.06
"""Time constant of the speed that it is compared with."""
TRAIL_SHARE = 0.35
"""The trail follows the cursor at this share of its distance from the start."""


class State(Layout):
    """What is known of the cursor."""

    known: float
    """Whether anything is."""
    t: float
    x: float
    y: float
    pressed: float
    """The last event."""
    t0: float
    x0: float
    y0: float
    """The start of the movement."""
    trail_x: float
    trail_y: float
    """A point that trails the cursor."""
    vx: float
    vy: float
    """The velocity, px/s."""
    speed: float
    slow: float
    peak: float
    """Its size, a slower one, its peak."""


KNOWN, T, X, Y, PRESSED, T0 = (part.at for part in State.parts[:6])
STATES = State.length
"""For JavaScript that looks at the memory itself."""


@law
def usable(t: float, x: float, y: float) -> bool:
    """Whether an event's numbers are finite and within the bounds of events."""
    return abs(t) < LATEST_S and abs(x) <= LARGEST and abs(y) <= LARGEST


@law
def begins(s: State, t: float, pressed: float) -> bool:
    """Whether a movement begins with this event: the first, one after a pause, or the release of a button."""
    return s.known == 0.0 or (s.pressed == 1.0 and pressed == 0.0) or t - s.t > PAUSE_S + ROUNDING_S


@law
def follow(s: State, t: float, x: float, y: float, pressed: float) -> bool:
    """Take an event in, a usable one that is not before the last; returns whether a button was released."""
    dt = t - s.t
    released = s.pressed == 1.0 and pressed == 0.0
    if begins(s, t, pressed) or t == s.t0:  # of events at one time, the later position replaces
        s.t0, s.x0, s.y0 = t, x, y
        s.trail_x, s.trail_y = x, y
        s.vx = s.vy = s.speed = s.slow = s.peak = 0.0
    else:
        way = hypot(x - s.x, y - s.y)
        far = hypot(x - s.x0, y - s.y0)
        share = 1.0 - exp(-way / (TRAIL_SHARE * far)) if far > 0.0 else 1.0
        s.trail_x += share * (x - s.trail_x)
        s.trail_y += share * (y - s.trail_y)
        if dt > 0.0:
            share = 1.0 - exp(-dt / SPEED_S)
            s.vx += share * ((x - s.x) / dt - s.vx)
            s.vy += share * ((y - s.y) / dt - s.vy)
            s.speed = hypot(s.vx, s.vy)
            s.slow += (1.0 - exp(-dt / SLOWER_S)) * (s.speed - s.slow)
        s.peak = max(s.peak, s.speed)
    s.known, s.pressed = 1.0, pressed
    s.t, s.x, s.y = t, x, y
    return released


@law
def until(s: State, x: float, y: float, width: float, height: float) -> float:
    """Seconds until the cursor enters a rectangle at its present speed; 0 inside, infinite at rest."""
    dx = max(abs(x - s.x) - 0.5 * width, 0.0)
    dy = max(abs(y - s.y) - 0.5 * height, 0.0)
    way = hypot(dx, dy)
    if way == 0.0:
        return 0.0
    return way / s.speed if s.speed > 0.0 else inf
