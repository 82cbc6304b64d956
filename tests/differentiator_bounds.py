"""How wrong each differentiator is on each signal: the measure, and the bounds it is held to."""

from __future__ import annotations

from collections.abc import Callable

import msgspec
import numpy as np

from pointpred.differentiators import DIFFERENTIATORS, Differentiator
from pointpred.errors import ParameterError
from tests.signals import Signal

PEAK_WINDOW_S = 0.15
"""The velocity peak is the vertex of the parabola fitted this far round the true peak."""


class Errors(msgspec.Struct, frozen=True):
    """Errors while ``settled``: RMS and largest, m/s and m/s^2; lateness of the velocity peak s.

    ``settling_s`` is the time from the first event to the first settled one.
    """

    velocity_rms: float
    velocity_largest: float
    acceleration_rms: float
    acceleration_largest: float
    delay_s: float | None = None
    settling_s: float = 0.0


def measure(differentiator: Differentiator, signal: Signal) -> Errors:
    """Run a differentiator without memory over a signal; its resolution must be the signal's.

    Raises ParameterError when it does not settle before the signal ends.
    """
    motions = differentiator.fresh().run(signal.events)
    settled = motions.settled == 1.0
    if not settled.any():
        raise ParameterError(f"{type(differentiator).__name__} does not settle within {motions.t[-1]:g} s")
    velocity = (motions.vx - signal.velocity)[settled]
    acceleration = (motions.ax - signal.acceleration)[settled]
    delay = None
    if signal.peak_s is not None:
        near = settled & (np.abs(motions.t - signal.peak_s) <= PEAK_WINDOW_S)
        curve = np.polyfit(motions.t[near] - signal.peak_s, motions.vx[near], 2)
        delay = float(-curve[1] / (2.0 * curve[0]))
    return Errors(
        float(np.sqrt(np.mean(velocity**2))),
        float(np.abs(velocity).max()),
        float(np.sqrt(np.mean(acceleration**2))),
        float(np.abs(acceleration).max()),
        delay,
        float(motions.t[settled][0] - motions.t[0]),
    )


def named(name: str, signal: Signal) -> Differentiator:
    """A differentiator with its defaults, at the resolution of a signal."""
    kind: Callable[..., Differentiator] = DIFFERENTIATORS[name]
    return kind(cpi=signal.cpi)


def _exact(settling_s: float) -> Errors:
    """A law without any error but rounding."""
    return Errors(1e-12, 1e-12, 1e-9, 1e-9, None, settling_s)


BOUNDS: dict[str, dict[str, Errors]] = {
    "homogeneous": {
        "constant": _exact(0.048),
        "ramp": Errors(0.0012, 0.023, 0.16, 1.4, None, 0.048),
        "parabola": Errors(0.00066, 0.00066, 0.0037, 0.0038, None, 0.048),
        "sine": Errors(0.0018, 0.029, 0.17, 2.0, None, 0.048),
        "minimum jerk": Errors(0.00046, 0.00078, 0.012, 0.067, 0.00061, 0.048),
        "minimum jerk, 2000 CPI, 1 kHz": Errors(0.0022, 0.011, 0.2, 0.93, 0.0015, 0.048),
        "minimum jerk, 2000 CPI, 125 Hz": Errors(0.0025, 0.008, 0.29, 0.93, 0.0012, 0.051),
    },
    "kalman": {
        "constant": _exact(0.036),
        "ramp": Errors(7.1e-06, 0.00012, 0.00038, 0.0057, None, 0.036),
        "parabola": Errors(4.5e-06, 6.7e-05, 0.0003, 0.0027, None, 0.036),
        "sine": Errors(0.0016, 0.0024, 0.19, 0.29, None, 0.036),
        "minimum jerk": Errors(0.0011, 0.0028, 0.14, 0.35, 0.0002, 0.036),
        "minimum jerk, 2000 CPI, 1 kHz": Errors(0.0013, 0.004, 0.14, 0.36, 0.0002, 0.036),
        "minimum jerk, 2000 CPI, 125 Hz": Errors(0.0019, 0.0047, 0.17, 0.42, 0.00057, 0.051),
    },
    "difference": {
        "constant": _exact(0.0021),
        "ramp": _exact(0.0021),
        "parabola": Errors(0.00065, 0.00066, 1e-9, 1e-9, None, 0.0021),
        "sine": Errors(0.00088, 0.0013, 0.012, 0.017, None, 0.0021),
        "minimum jerk": Errors(0.00044, 0.00077, 0.0082, 0.023, 0.00065, 0.0021),
        "minimum jerk, 2000 CPI, 1 kHz": Errors(0.016, 0.079, 26.0, 130.0, 0.0011, 0.0021),
        "minimum jerk, 2000 CPI, 125 Hz": Errors(0.004, 0.011, 0.37, 1.3, 0.0052, 0.017),
    },
}
"""For each differentiator with its defaults and each signal: about 1.3 times what was measured."""
