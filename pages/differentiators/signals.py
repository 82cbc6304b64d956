"""Signals whose derivatives are known: what the error bounds of differentiators are stated on."""

from __future__ import annotations

from collections.abc import Callable

import msgspec
import numpy as np

from pointpred.records import METRES_PER_INCH, EventColumns, FloatArray

DPI = 96.0
CPI = 2000.0
JITTER_S = 1e-4
"""Time stamps of quantised signals are off by at most this much, either way."""
SEED = 20220101

Derivatives = tuple[FloatArray, FloatArray, FloatArray]


class Signal(msgspec.Struct, frozen=True):
    """Events with the true velocity m/s and acceleration m/s^2 along x at each, and the time of the peak."""

    events: EventColumns
    velocity: FloatArray
    acceleration: FloatArray
    cpi: float | None = None
    peak_s: float | None = None


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
