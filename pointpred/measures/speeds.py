"""Speed and acceleration of one recorded movement, smoothed without delay, and its sub-movements."""

from __future__ import annotations

from itertools import pairwise
from math import ceil, hypot
from typing import NamedTuple

import numpy as np

from pointpred.measures.paths import reversals
from pointpred.records import FloatArray

RATE_HZ = 100.0
SMOOTHING_S = 0.02
"""Standard deviation of the Gaussian that smooths: half of the power passes at 6.6 Hz."""
SHARE = 0.05
"""A sub-movement stands out by more than this share of the highest speed or acceleration,"""
SPEED_NOISE_PX_S, ACCELERATION_NOISE_PX_S2 = 15.0, 940.0
"""and by more than these: four standard deviations of what the rounding to whole pixels does."""


class Velocities(NamedTuple):
    """A movement at 100 Hz: times from its beginning s, velocity px/s, acceleration px/s²."""

    t: FloatArray
    vx: FloatArray
    vy: FloatArray
    ax: FloatArray
    ay: FloatArray

    @property
    def speed(self) -> FloatArray:
        """The length of the velocity, px/s."""
        return np.hypot(self.vx, self.vy)

    @property
    def acceleration(self) -> FloatArray:
        """The rate of the speed, px/s²: the acceleration along the path; 0 at rest."""
        speed = self.speed
        scale = np.where(speed > 0.0, speed, 1.0)
        return (self.vx * self.ax + self.vy * self.ay) / scale

    def along(self, dx: float, dy: float) -> tuple[FloatArray, FloatArray]:
        """Velocity and acceleration in the direction of (dx, dy), which must have a length."""
        ux, uy = dx / hypot(dx, dy), dy / hypot(dx, dy)
        return ux * self.vx + uy * self.vy, ux * self.ax + uy * self.ay


def velocities(t: FloatArray, x: FloatArray, y: FloatArray, begin_s: float | None = None) -> Velocities:
    """Velocity and acceleration of a recorded movement, by central differences of the smoothed path.

    Positions are interpolated to 100 Hz and smoothed by a Gaussian of 20 ms, forwards and backwards alike.
    Beyond the samples the cursor is taken to rest. Whole pixels become a noise of some 4 px/s. ``begin_s``:
    the time of the first answer, not before the first sample, which it is by default.
    """
    step, begin = 1.0 / RATE_HZ, float(t[0]) if begin_s is None else begin_s
    count = max(2, int((t[-1] - begin) * RATE_HZ + 1.0 + 1e-9))
    reach = ceil(4.0 * SMOOTHING_S * RATE_HZ)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) * step / SMOOTHING_S) ** 2)
    kernel /= kernel.sum()
    more = 2  # on either side, for the two differences
    times = begin + step * np.arange(-more - reach, count + more + reach)
    last = np.append(np.diff(t) > 0.0, True)  # of samples at one time the later position counts
    columns = []
    for axis in (x, y):
        path = np.interp(times, t[last], axis[last])
        velocity = np.gradient(np.convolve(path, kernel, "valid"), step)
        columns.append((velocity[more:-more], np.gradient(velocity, step)[more:-more]))
    (vx, ax), (vy, ay) = columns
    return Velocities(step * np.arange(count, dtype=np.float64), vx, vy, ax, ay)


def persistent_submovements(speed: FloatArray, share: float = SHARE) -> int:
    """How many peaks of the speed, px/s, persist: more than ``share`` of the highest one, and 15 px/s.

    The persistence of a peak is its height above the higher one of the two valleys that part it from higher
    peaks; the speed before and after the movement is 0.

    Reference: Edelsbrunner, Letscher and Zomorodian 2002, Topological persistence and simplification.
    """
    least = max(share * float(speed.max(initial=0.0)), SPEED_NOISE_PX_S)
    turns = reversals(np.concatenate([[0.0], speed, [0.0]]), least)
    return (len(turns) + 1) // 2


def meyer_submovements(velocity: FloatArray, acceleration: FloatArray, share: float = SHARE) -> int:
    """How many sub-movements Meyer's criteria find in a velocity along a line, px/s.

    A new one begins where the velocity passes through zero (the movement returns, or goes on after a stop),
    where the speed rises again (its rate passes through zero upwards), and where the braking eases and grows
    again. Meyer et al. filtered positions and took every such place; here the speed must exceed ``share`` of
    the highest and 15 px/s between two zeros, and the acceleration turn by more than ``share`` of its largest
    magnitude and 940 px/s².

    Reference: Meyer, Abrams, Kornblum, Wright and Smith 1988, Optimality in human motor performance.
    """
    slow = max(share * float(np.abs(velocity).max(initial=0.0)), SPEED_NOISE_PX_S)
    least = max(share * float(np.abs(acceleration).max(initial=0.0)), ACCELERATION_NOISE_PX_S2)
    ends = [0, *(np.flatnonzero(np.diff(np.sign(velocity))) + 1).tolist(), len(velocity)]
    count = 0
    for first, stop in pairwise(ends):
        if np.abs(velocity[first:stop]).max(initial=0.0) <= slow:
            continue
        count += 1
        forwards = np.sign(velocity[first]) * acceleration[first:stop]
        braking = int(np.argmax(forwards < 0.0)) if (forwards < 0.0).any() else stop
        for turn in reversals(forwards, least).tolist():
            count += int(turn > braking and forwards[turn + 1] < forwards[turn])
    return count
