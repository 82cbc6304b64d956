"""An accelerometer on the mouse of a simulated person: what it measures while the hand moves."""

from __future__ import annotations

from math import cos, sin

import msgspec
import numpy as np

from pointpred.accelerations import Accelerations
from pointpred.extras import require
from pointpred.parameter import Parameter, check
from pointpred.records import FloatArray
from pointpred.simulation.movement import Movement

GRAVITY_M_S2 = 9.81
SMOOTH_S = 0.005
"""Over so long the path is smoothed: the hand's noise is a velocity without an acceleration."""
BOUNDS = (
    Parameter("rate_hz", "Hz", 50.0, 20_000.0, "samples a second"),
    Parameter("offset_s", "s", -0.02, 0.02, "how far its clock is behind that of the events"),
    Parameter("late_s", "s", 0.0, 0.05, "how long after its time a sample comes"),
    Parameter("noise", "m/s^2", 0.0, 100.0, "standard deviation of a sample"),
    Parameter("vibration", "1/s", 0.0, 100.0, "more of it for each m/s of the hand's speed"),
    Parameter("scale", "", 0.5, 2.0, "of its output"),
    Parameter("yaw_rad_m", "rad/m", -20.0, 20.0, "how far the mouse turns a metre to the right"),
)


class Accelerometer(msgspec.Struct, frozen=True):
    """How a sensor stands on the mouse, and its errors.

    ``bias`` m/s^2 along its axes; ``tilt`` rad of the shell about both axes of the mouse; ``turn`` rad about
    the third. ``vibration`` is white noise that grows with the speed, from feet and pad. ``yaw_rad_m``: a
    mouse that turns at the rate w while it moves at v feels w x v, because the counts turn with it.
    """

    rate_hz: float = 1600.0
    offset_s: float = 0.0
    late_s: float = 0.0
    noise: float = 0.0
    vibration: float = 0.0
    bias: tuple[float, float, float] = (0.0, 0.0, 0.0)
    tilt: tuple[float, float] = (0.0, 0.0)
    turn: float = 0.0
    scale: float = 1.0
    yaw_rad_m: float = 0.0

    @classmethod
    def drawn(cls, generator: np.random.Generator) -> Accelerometer:
        """A cheap sensor, fixed by hand: the assumptions of the measured page."""
        normal = generator.standard_normal
        return cls(
            offset_s=float(generator.uniform(-0.006, 0.006)),
            noise=0.05,
            vibration=float(generator.uniform(0.2, 1.0)),
            bias=tuple((0.2 * normal(3)).tolist()),
            tilt=tuple((0.05 * normal(2)).tolist()),
            turn=float(0.2 * normal()),
            scale=float(1.0 + 0.02 * normal()),
            yaw_rad_m=float(generator.uniform(0.0, 3.0)),
        )

    @property
    def matrix(self) -> FloatArray:
        """From the axes of the mouse (x right, y towards the hand, z up) to those of the sensor."""
        roll, pitch = self.tilt
        about_z = np.array(
            [[cos(self.turn), -sin(self.turn), 0.0], [sin(self.turn), cos(self.turn), 0.0], [0.0, 0.0, 1.0]]
        )
        about_x = np.array([[1.0, 0.0, 0.0], [0.0, cos(roll), -sin(roll)], [0.0, sin(roll), cos(roll)]])
        about_y = np.array([[cos(pitch), 0.0, sin(pitch)], [0.0, 1.0, 0.0], [-sin(pitch), 0.0, cos(pitch)]])
        turned: FloatArray = self.scale * (about_z @ about_y @ about_x)
        return turned


def felt(
    movement: Movement, sensor: Accelerometer, generator: np.random.Generator, t: FloatArray
) -> Accelerations:
    """What the sensor measures during a movement, beside events at ``t`` s from its start.

    A sample stands before the first event that is not earlier than the sample comes, whatever its stamp.
    Assumes a sensor above the one of the counts. The same generator gives the same samples. Raises
    ParameterError, and MissingExtraError without scipy.
    """
    require("train", "a simulated accelerometer")
    from scipy.ndimage import gaussian_filter1d

    check(BOUNDS, {one.name: getattr(sensor, one.name) for one in BOUNDS})
    path = np.concatenate([np.zeros((1, 2)), np.column_stack([movement.column("u"), movement.column("v")])])
    period = (movement.table[-1, 0] - movement.table[0, 0]) / (len(movement.table) - 1)
    period = round(period / 1e-6) * 1e-6  # stamps are late by chance, polls are not
    smooth = gaussian_filter1d(path, SMOOTH_S / period, axis=0, mode="nearest")
    speed = np.gradient(smooth, period, axis=0)
    push = np.gradient(speed, period, axis=0)
    yaw = sensor.yaw_rad_m * speed[:, 0]
    push += np.column_stack([-yaw * speed[:, 1], yaw * speed[:, 0]])
    polls = period * np.arange(len(path))
    times = np.arange(generator.uniform(0.0, 1.0 / sensor.rate_hz), polls[-1], 1.0 / sensor.rate_hz)
    inside = np.full((len(times), 3), GRAVITY_M_S2)
    for axis in (0, 1):
        inside[:, axis] = np.interp(times, polls, push[:, axis])
    size = sensor.noise + sensor.vibration * np.interp(times, polls, np.hypot(*speed.T))
    force = (
        inside @ sensor.matrix.T + sensor.bias + size[:, None] * generator.standard_normal((len(times), 3))
    )
    before = np.searchsorted(times + sensor.late_s, t, side="right")
    return Accelerations(np.column_stack([times - sensor.offset_s, force]), before)
