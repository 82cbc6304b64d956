"""Simulated cameras: movements with known truth, the paper's (45) and others, and what sensors read."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.parameter import Parameter, check
from pointpred.records import FloatArray
from pointpred_observers.camera.samples import FOCAL_PX, CameraColumns

Profile = Callable[[Any], tuple[Any, Any, Any]]
"""A vector as a function of time; analytic, so that its derivative is exact by a complex step."""
TINY = 1e-30
ACCURACY = 1e-12
FOCAL = Parameter("focal_px", "px", *FOCAL_PX, "focal length: image plane to px")
SEED = Parameter("seed", "", 0, 2**63, "of the noise", whole=True)
NOISE = (
    Parameter("noise_px", "px", 0.0, 1e3, "pixel noise, uniform in +-noise_px"),
    Parameter("gyro_noise", "rad/s/sqrt(Hz)", 0.0, 1.0, "density of the gyroscope's white noise"),
    Parameter("accel_noise", "m/s^2/sqrt(Hz)", 0.0, 10.0, "density of the accelerometer's white noise"),
    Parameter("dropped", "", 0.0, 1.0, "share of the images that are missing"),
)
LENGTH = (
    Parameter("duration_s", "s", 1e-6, 1e6, "length"),
    Parameter("image_hz", "1/s", 1e-6, 1e6, "images"),
    Parameter("readings", "", 1, 1000, "readings of the inertial sensor an image", whole=True),
)
ROWS_MOST = 10_000_000
"""Most samples of one simulation: about a gigabyte."""


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
        return np.asarray(self.p[:, :2] / self.p[:, 2:])

    @property
    def chi(self) -> FloatArray:
        """1/Z, 1/m."""
        return np.asarray(1.0 / self.p[:, 2])

    @property
    def eta(self) -> FloatArray:
        """v_z/Z, 1/s."""
        return np.asarray(self.v[:, 2] * self.chi)


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
        return np.asarray(-v - np.cross(w, p))

    exact = solve_ivp(
        rate, (0.0, times[-1]), scenario.point, "DOP853", times, rtol=ACCURACY, atol=ACCURACY, max_step=0.25
    )
    p = exact.y.T
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


class Noise(msgspec.Struct, frozen=True):
    """Errors of a simulated sensor; all zero by default.

    ``noise_px``: uniform in +-noise_px, as in the paper (standard deviation noise_px / sqrt(3));
    ``normal``: normal noise of that standard deviation instead. Biases are constant, one number per axis.
    """

    noise_px: float = 0.0
    normal: bool = False
    gyro_noise: float = 0.0
    accel_noise: float = 0.0
    gyro_bias: tuple[float, float, float] = (0.0, 0.0, 0.0)
    accel_bias: tuple[float, float, float] = (0.0, 0.0, 0.0)
    dropped: float = 0.0


def simulate(
    scenario: Scenario,
    *,
    focal_px: float,
    duration_s: float = 10.0,
    image_hz: float = 33.0,
    readings: int = 1,
    noise: Noise | None = None,
    seed: int = 0,
) -> tuple[CameraColumns, Trajectory]:
    """Samples of a scenario, and the truth at the same times.

    ``focal_px`` converts px of noise to radians; it is required because the paper does not state it.
    ``readings`` of the inertial sensor per image; 1e7 samples at most. The first sample always has an image.
    Raises ParameterError.

    >>> samples, truth = simulate(SCENARIOS["paper"], focal_px=800.0, duration_s=1.0)
    >>> len(samples), float(truth.chi[0])
    (34, 1.0)
    """
    check(LENGTH, {"duration_s": duration_s, "image_hz": image_hz, "readings": readings})
    rate_hz = image_hz * readings
    if duration_s * rate_hz > ROWS_MOST:
        product = f"{duration_s:g} s x {image_hz:g} images/s x {readings} readings"
        raise ParameterError(f"at most {ROWS_MOST:.0e} samples can be simulated, received {product}")
    t = np.arange(round(duration_s * rate_hz) + 1) / rate_hz
    truth = trajectory(scenario, t)
    return observed(truth, focal_px=focal_px, readings=readings, noise=noise, seed=seed), truth


def observed(
    truth: Trajectory, *, focal_px: float, readings: int = 1, noise: Noise | None = None, seed: int = 0
) -> CameraColumns:
    """Sensor samples along a trajectory sampled at equal intervals, with an image every ``readings`` rows.

    The same seed gives the same samples. Raises ParameterError.
    """
    noise = noise or Noise()
    given = {"focal_px": focal_px, "seed": seed} | {p.name: getattr(noise, p.name) for p in NOISE}
    check((FOCAL, SEED, *NOISE), given)
    random = np.random.default_rng(int(seed))
    rows, rate_hz = len(truth.t), 1.0 / (truth.t[1] - truth.t[0])
    if noise.normal:
        pixels = random.normal(0.0, noise.noise_px / np.sqrt(3.0), (rows, 2))
    else:
        pixels = random.uniform(-noise.noise_px, noise.noise_px, (rows, 2))
    image = focal_px * truth.image + pixels
    taken = np.arange(rows) % readings == 0
    taken[1:] &= random.uniform(size=rows - 1) >= noise.dropped
    image[~taken] = np.nan
    spread = np.sqrt(rate_hz)
    gyro = truth.w + noise.gyro_bias + spread * noise.gyro_noise * random.normal(size=(rows, 3))
    accel = truth.a + noise.accel_bias + spread * noise.accel_noise * random.normal(size=(rows, 3))
    return CameraColumns(np.column_stack([truth.t, image, gyro, accel]))
