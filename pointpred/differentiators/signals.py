"""Signals whose derivatives are known: what the error bounds of differentiators are stated on."""

from __future__ import annotations

from collections.abc import Callable

import msgspec
import numpy as np

from pointpred.accelerations import Accelerations
from pointpred.records import METRES_PER_INCH, EventColumns, FloatArray

DPI = 96.0
CPI = 2000.0
JITTER_S = 1e-4
"""Time stamps of quantised signals are off by at most this much, either way."""
SEED = 20220101

Derivatives = tuple[FloatArray, FloatArray, FloatArray]


class Signal(msgspec.Struct, frozen=True):
    """Events with the true velocity m/s and acceleration m/s^2 along x at each, and the time of the peak.

    Errors count from ``since_s`` on.
    """

    events: EventColumns
    velocity: FloatArray
    acceleration: FloatArray
    cpi: float | None = None
    peak_s: float | None = None
    since_s: float = 0.0


def constant(t: FloatArray) -> Derivatives:
    """A hand at rest 0.05 m from the screen's edge."""
    zero = np.zeros_like(t)
    return zero + 0.05, zero, zero


def ramp(t: FloatArray) -> Derivatives:
    """0.3 m/s from the first event on."""
    return 0.3 * t, np.full_like(t, 0.3), np.zeros_like(t)


def parabola(t: FloatArray) -> Derivatives:
    """1 m/s^2 from rest."""
    return 0.5 * t**2, t, np.ones_like(t)


def sine(t: FloatArray) -> Derivatives:
    """0.05 m at 1 Hz, which passes zero at full speed at the first event."""
    rate = 2.0 * np.pi
    return 0.05 * np.sin(rate * t), 0.05 * rate * np.cos(rate * t), -0.05 * rate**2 * np.sin(rate * t)


def minimum_jerk(
    t: FloatArray, distance: float = 0.1, duration: float = 0.7, start: float = 0.2
) -> Derivatives:
    """A reach of ``distance`` m in ``duration`` s after ``start`` s of rest, and rest after it."""
    s = np.clip((t - start) / duration, 0.0, 1.0)
    return (
        distance * s**3 * (10.0 - 15.0 * s + 6.0 * s**2),
        distance / duration * 30.0 * s**2 * (1.0 - s) ** 2,
        distance / duration**2 * 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s),
    )


def exact(path: Callable[..., Derivatives], rate_hz: float, length_s: float = 1.1) -> Signal:
    """A path sampled at equal intervals; the cursor's position in px is not rounded."""
    t = np.arange(round(length_s * rate_hz)) / rate_hz
    position, velocity, acceleration = path(t)
    events = EventColumns.of(t, position * (DPI / METRES_PER_INCH), np.zeros_like(t))
    return Signal(events, velocity, acceleration, None, _peak_s(path))


def quantised(
    path: Callable[..., Derivatives], rate_hz: float, *, counts: bool = True, length_s: float = 1.1
) -> Signal:
    """A path in whole counts at 2000 CPI (or in whole px at 96 dpi), sampled on time but stamped off time."""
    t = np.arange(round(length_s * rate_hz)) / rate_hz
    position, velocity, acceleration = path(t)
    stamps = t + np.random.default_rng(SEED).uniform(-JITTER_S, JITTER_S, len(t))
    cursor = np.round(position * (DPI / METRES_PER_INCH))
    device = np.round(position * (CPI / METRES_PER_INCH))
    zero = np.zeros_like(t)
    if not counts:
        return Signal(EventColumns.of(stamps, cursor, zero), velocity, acceleration, None, _peak_s(path))
    events = EventColumns.of(stamps, cursor, zero, np.diff(device, prepend=device[0]), zero)
    return Signal(events, velocity, acceleration, CPI, _peak_s(path))


def _peak_s(path: Callable[..., Derivatives]) -> float | None:
    """Minimum jerk alone has one velocity peak."""
    return 0.55 if path is minimum_jerk else None


SIGNALS: dict[str, Callable[[], Signal]] = {
    "constant": lambda: exact(constant, 1000.0),
    "ramp": lambda: exact(ramp, 1000.0),
    "parabola": lambda: exact(parabola, 1000.0),
    "sine": lambda: exact(sine, 1000.0),
    "minimum jerk": lambda: exact(minimum_jerk, 1000.0),
    "minimum jerk, 2000 CPI, 1 kHz": lambda: quantised(minimum_jerk, 1000.0),
    "minimum jerk, 2000 CPI, 125 Hz": lambda: quantised(minimum_jerk, 125.0),
}
"""The columns of the table of error bounds: 1.1 s each, at 1 kHz unless the name says otherwise."""


SENSOR_HZ = 1600.0
SENSOR_NOISE_M_S2 = 0.05
SENSOR_BEHIND_S = 0.004
"""The clock of the accelerometer is so far behind that of the events."""
TURN_RAD, TILT_RAD, SENSOR_SCALE = 0.3, (0.03, -0.05), 1.04
BIAS_M_S2 = (0.15, -0.2, 0.1)
GRAVITY_M_S2 = 9.81
LEARNED_S = 6.0
"""Movements in the plane before the one that counts: from them a sensor is learned."""


def there_and_back(t: FloatArray) -> Derivatives:
    """Reaches of 0.1 m in 0.7 s and back, each after 0.2 s of rest; after ``LEARNED_S`` one alone."""
    period = 0.9
    number = np.minimum(np.floor(np.maximum(t, 0.0) / period), np.floor(LEARNED_S / period) - 1.0)
    alone = t >= LEARNED_S
    since = np.where(alone, t - LEARNED_S, t - number * period)
    position, velocity, acceleration = minimum_jerk(since)
    back = np.where(alone, 0.0, number % 2.0)
    return (
        0.1 * back + (1.0 - 2.0 * back) * position,
        (1.0 - 2.0 * back) * velocity,
        (1.0 - 2.0 * back) * acceleration,
    )


def sensed(rate_hz: float) -> Signal:
    """``minimum jerk`` in whole counts, along x, after movements in the plane, with an accelerometer.

    Stamps of events are off time; the sensor is turned, tilted, biased, of a wrong scale, noisy, and its
    clock is behind. The last reach goes along x only.
    """
    length_s = LEARNED_S + 1.1
    t = np.arange(round(length_s * rate_hz)) / rate_hz
    random = np.random.default_rng(SEED)
    stamps = t + random.uniform(-JITTER_S, JITTER_S, len(t))
    x, velocity, acceleration = there_and_back(t)
    device = np.round(np.column_stack([x, _across(t)[0]]) * (CPI / METRES_PER_INCH))
    counts = np.diff(device, prepend=device[:1], axis=0)
    cursor = np.round(device * (DPI / CPI))
    events = EventColumns.of(stamps, cursor[:, 0], cursor[:, 1], counts[:, 0], counts[:, 1])
    sensor_t = np.arange(round(length_s * SENSOR_HZ)) / SENSOR_HZ
    inside = np.column_stack(
        [there_and_back(sensor_t)[2], _across(sensor_t)[2], np.full(len(sensor_t), GRAVITY_M_S2)]
    )
    force = inside @ _mounting().T + BIAS_M_S2 + SENSOR_NOISE_M_S2 * random.standard_normal(inside.shape)
    samples = np.column_stack([sensor_t - SENSOR_BEHIND_S, force])
    beside = Accelerations(samples, np.searchsorted(sensor_t, stamps, side="right"))
    events = EventColumns(events.table, events.begin, beside)
    return Signal(events, velocity, acceleration, CPI, LEARNED_S + 0.55, LEARNED_S)


def _across(t: FloatArray) -> Derivatives:
    """The path along y: as along x, half as far and 0.45 s later, until what counts."""
    position, velocity, acceleration = there_and_back(np.minimum(t - 0.45, LEARNED_S - 0.6))
    return 0.5 * position, 0.5 * velocity, 0.5 * acceleration


def _mounting() -> FloatArray:
    """From the axes of the device to those of the sensor: turned about the upright axis, then tilted."""
    c, s = np.cos(TURN_RAD), np.sin(TURN_RAD)
    (roll, pitch), upright = TILT_RAD, np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    cr, sr, cp, sp = np.cos(roll), np.sin(roll), np.cos(pitch), np.sin(pitch)
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, cr, -sr], [0.0, sr, cr]])
    about_y = np.array([[cp, 0.0, sp], [0.0, 1.0, 0.0], [-sp, 0.0, cp]])
    turned: FloatArray = SENSOR_SCALE * (upright @ about_y @ about_x)
    return turned


SENSED_SIGNALS: dict[str, Callable[[], Signal]] = {
    "minimum jerk, 2000 CPI, 1 kHz": lambda: sensed(1000.0),
    "minimum jerk, 2000 CPI, 125 Hz": lambda: sensed(125.0),
}
"""Signals with an accelerometer beside them; the names are those of the reach without one."""
