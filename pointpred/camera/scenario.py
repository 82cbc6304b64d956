"""Camera movements with known truth: the paper's (45) and others that show limits of observers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray

Profile = Callable[[Any], tuple[Any, Any, Any]]
"""A vector as a function of time; analytic, so that its derivative is exact by a complex step."""
TINY = 1e-30
ACCURACY = 1e-12


class Scenario(msgspec.Struct, frozen=True):
    """A camera that moves past one fixed point.

    ``velocity`` m/s and ``angular`` rad/s in the camera's frame; ``point`` m, its position at t = 0.
    """

    name: str
    velocity: Profile
    angular: Profile
    point: tuple[float, float, float] = (0.0, 0.0, 1.0)


class Trajectory(msgspec.Struct, frozen=True):
    """The truth at each time: point m, velocity m/s, angular velocity rad/s, acceleration m/s^2."""

    t: FloatArray
    p: FloatArray
    v: FloatArray
    w: FloatArray
    a: FloatArray
    """Acceleration of the motion in the camera's frame, gravity removed: v' + w x v, (11)."""

    @property
    def image(self) -> FloatArray:
        """(x, y) = (X/Z, Y/Z), one row a time."""
        flat: FloatArray = self.p[:, :2] / self.p[:, 2:]
        return flat

    @property
    def chi(self) -> FloatArray:
        """1/Z, 1/m."""
        inverse: FloatArray = 1.0 / self.p[:, 2]
        return inverse

    @property
    def eta(self) -> FloatArray:
        """v_z/Z, 1/s."""
        ratio: FloatArray = self.v[:, 2] * self.chi
        return ratio

    @property
    def turn(self) -> FloatArray:
        """The rotation's part of the zero of depth: y w_x - x w_y, 1/s."""
        x, y = self.image.T
        rate: FloatArray = y * self.w[:, 0] - x * self.w[:, 1]
        return rate


def _vector(profile: Profile, t: Any) -> Any:
    return np.stack([value + 0.0 * t for value in profile(t)], axis=-1)


def trajectory(scenario: Scenario, t: FloatArray) -> Trajectory:
    """The truth at increasing times from 0 on, p integrated to 1e-12; raises ParameterError where Z <= 0."""
    from scipy.integrate import solve_ivp

    times = np.asarray(t, np.float64)
    if times.ndim != 1 or len(times) < 2 or times[0] != 0.0 or not (np.diff(times) > 0.0).all():
        raise ParameterError("times must increase from 0, at least two", field="t", value=t)

    def rate(now: float, p: FloatArray) -> FloatArray:
        v, w = _vector(scenario.velocity, now), _vector(scenario.angular, now)
        motion: FloatArray = -v - np.cross(w, p)
        return motion

    solution = solve_ivp(
        rate,
        (0.0, times[-1]),
        scenario.point,
        t_eval=times,
        method="DOP853",
        rtol=ACCURACY,
        atol=ACCURACY,
        max_step=0.25,
    )
    p = solution.y.T
    if not (p[:, 2] > 0.0).all():
        raise ParameterError(f"{scenario.name}: the camera reaches the point before {times[-1]:g} s")
    v, w = _vector(scenario.velocity, times), _vector(scenario.angular, times)
    v_rate = _vector(scenario.velocity, times + 1j * TINY).imag / TINY
    return Trajectory(times, p, v, w, v_rate + np.cross(w, v))


def _paper_velocity(t: Any) -> tuple[Any, Any, Any]:
    forward = -0.3 * np.exp(-0.02 * t) - 0.1 * np.sin(np.pi / 6.0 * t)
    return 0.05 * np.sin(np.pi / 5.0 * t), 1.0 / (t + 5.0), forward


def _paper_angular(t: Any) -> tuple[Any, Any, Any]:
    return 0.05 * np.cos(np.pi / 4.0 * t), -0.06 * np.cos(np.pi / 2.0 * t), 0.0


def _approaching(t: Any) -> tuple[Any, Any, Any]:
    return 0.2 * np.sin(0.8 * t), 0.15 * np.cos(0.5 * t), 0.15 + 0.05 * np.sin(t)


def _axial(t: Any) -> tuple[Any, Any, Any]:
    return 0.0, 0.0, -0.2 - 0.1 * np.sin(t)


def _still(t: Any) -> tuple[Any, Any, Any]:
    return 0.0, 0.0, 0.0


SCENARIOS = {
    one.name: one
    for one in (
        Scenario("paper", _paper_velocity, _paper_angular),
        Scenario("approaching", _approaching, _paper_angular, (0.1, -0.1, 4.0)),
        Scenario("axial", _axial, _still),
        Scenario("rotating", _still, _paper_angular, (0.1, 0.05, 2.0)),
        Scenario("stationary", _still, _still, (0.1, 0.05, 2.0)),
    )
}
"""Names users type. ``axial`` recedes along the ray of the point: its depth is unobservable from images."""
