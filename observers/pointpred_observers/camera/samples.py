"""Samples of a camera with an inertial sensor: records, columns, and simulation from a trajectory."""

from __future__ import annotations

from typing import NamedTuple

import msgspec
import numpy as np

from pointpred.columns import Columns
from pointpred.errors import ParameterError
from pointpred.parameter import Parameter, check, is_number
from pointpred_observers.camera.scenario import Scenario, Trajectory, trajectory

FOCAL_PX = (1.0, 1e6)
FOCAL = Parameter("focal_px", "px", *FOCAL_PX, "focal length: image plane to px")
NOISE = (
    Parameter("noise_px", "px", 0.0, 1e3, "pixel noise, uniform in +-noise_px"),
    Parameter("gyro_noise", "rad/s/sqrt(Hz)", 0.0, 1.0, "density of the gyroscope's white noise"),
    Parameter("accel_noise", "m/s^2/sqrt(Hz)", 0.0, 10.0, "density of the accelerometer's white noise"),
    Parameter("dropped", "", 0.0, 1.0, "share of the images that are missing"),
)
ROWS_MOST = 10_000_000
"""Most samples of one simulation: about a gigabyte."""


class CameraSample(msgspec.Struct, frozen=True):
    """A reading of the inertial sensor, with the tracked point if an image was taken at that time.

    ``t`` s; ``x y`` px from the principal point, x right, y down, ``None`` without an image; ``wx wy wz``
    rad/s; ``ax ay az`` m/s^2 of the motion in the camera's frame, gravity already removed (10).
    """

    t: float
    x: float | None
    y: float | None
    wx: float
    wy: float
    wz: float
    ax: float
    ay: float
    az: float


class SampleRow(NamedTuple):
    """A ``CameraSample`` as a row of floats; x and y are NaN where there is no image."""

    t: float
    x: float
    y: float
    wx: float
    wy: float
    wz: float
    ax: float
    ay: float
    az: float


class CameraColumns(Columns[CameraSample]):
    """Camera samples as columns; x and y are NaN where there is no image."""

    names = SampleRow._fields

    def samples(self) -> list[CameraSample]:
        """The rows as records."""
        return list(self)

    def _record(self, row: list[float]) -> CameraSample:
        t, x, y, *rest = row
        return CameraSample(t, x if x == x else None, y if y == y else None, *rest)


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

    >>> from pointpred_observers.camera.scenario import SCENARIOS
    >>> samples, truth = simulate(SCENARIOS["paper"], focal_px=800.0, duration_s=1.0)
    >>> len(samples), float(truth.chi[0])
    (34, 1.0)
    """
    for name, value in (("duration_s", duration_s), ("image_hz", image_hz)):
        if not (is_number(value) and 0.0 < value <= 1e6):
            raise ParameterError(f"{name} must lie in (0, 1e6], received {value!r}", field=name, value=value)
    if isinstance(readings, bool) or not isinstance(readings, int) or not 1 <= readings <= 1000:
        raise ParameterError(
            f"readings must be a whole number in [1, 1000], received {readings!r}",
            field="readings",
            value=readings,
        )
    _check_seed(seed)
    rate_hz = image_hz * readings
    if duration_s * rate_hz > ROWS_MOST:
        product = f"{duration_s:g} s x {image_hz:g} images/s x {readings} readings"
        raise ParameterError(
            f"at most {ROWS_MOST:.0e} samples can be simulated, received {product}",
            field="duration_s",
            value=duration_s,
        )
    t = np.arange(round(duration_s * rate_hz) + 1) / rate_hz
    truth = trajectory(scenario, t)
    return observed(truth, focal_px=focal_px, readings=readings, noise=noise, seed=seed), truth


def observed(
    truth: Trajectory, *, focal_px: float, readings: int = 1, noise: Noise | None = None, seed: int = 0
) -> CameraColumns:
    """Sensor samples along a trajectory sampled at equal intervals, with an image every ``readings`` rows.

    The same seed gives the same samples. Raises ParameterError.
    """
    _check_seed(seed)
    noise = noise or Noise()
    check((FOCAL, *NOISE), {"focal_px": focal_px, **{p.name: getattr(noise, p.name) for p in NOISE}})
    random = np.random.default_rng(seed)
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


def _check_seed(seed: int) -> None:
    if isinstance(seed, bool) or not isinstance(seed, int) or seed < 0:
        raise ParameterError(
            f"seed must be a whole number not below 0, received {seed!r}", field="seed", value=seed
        )
