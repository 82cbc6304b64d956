"""The peer of the observer: an extended Kalman filter of a point's place and the camera's velocity."""

from __future__ import annotations

from math import sqrt

import msgspec
import numpy as np

from pointpred.camera import point_law
from pointpred.camera.camera_stage import CameraStage
from pointpred.camera.samples import FOCAL, CameraColumns, CameraSample
from pointpred.columns import BoolArray, FloatArray
from pointpred.parameter import Parameter, check


class PointEstimate(msgspec.Struct, frozen=True):
    """Place of the point m and velocity of the camera m/s, both in the camera's frame, with their covariance.

    ``state`` = (X, Y, Z, v_x, v_y, v_z); ``restarts`` counts how often the filter began anew.
    """

    t: float
    state: FloatArray
    covariance: FloatArray
    restarts: int = 0

    @property
    def chi(self) -> float:
        """1/Z, 1/m."""
        return 1.0 / float(self.state[2])

    @property
    def eta(self) -> float:
        """v_z/Z, 1/s."""
        return float(self.state[5]) * self.chi

    @property
    def depth_spread(self) -> float:
        """Standard deviation of Z, m."""
        return sqrt(float(self.covariance[2, 2]))

    @property
    def eta_spread(self) -> float:
        """Standard deviation of v_z/Z, 1/s, to first order."""
        slope = np.array([-self.eta * self.chi, self.chi])
        return sqrt(float(slope @ self.covariance[np.ix_((2, 5), (2, 5))] @ slope))


class PointTrack(msgspec.Struct, frozen=True):
    """Estimates as arrays, NaN where the filter had not started; a state is 6 numbers, a covariance 6 x 6."""

    t: FloatArray
    state: FloatArray
    covariance: FloatArray
    running: BoolArray
    restarts: int

    def at(self, row: int) -> PointEstimate | None:
        """One row as a record, ``None`` where the filter had not started."""
        if not self.running[row]:
            return None
        return PointEstimate(float(self.t[row]), self.state[row], self.covariance[row], self.restarts)


class PointFilter(CameraStage):
    """Extended Kalman filter of (p, v) from a tracked point, a gyroscope and an accelerometer.

    Assumes sensors without bias, gravity already removed, and independent pixel errors of one size that is
    known. Prediction is exactly linear in these coordinates; only the image is linearised, so it must not
    start before the depth is roughly known: pseudo-linear least squares over the images so far, with the
    noise's part taken out, hands over once the depth's standard deviation is ``share`` of the depth. It says
    nothing before, and never where the images tell no depth: a camera that rests, only turns, or moves along
    the ray of the point. A point that comes nearer than 0.1 mm makes it begin anew, which is counted.

    p' = -v - w x p, v' = a - w x v; x = X/Z, y = Y/Z.

    Parameters: ``focal_px`` px; ``noise_px`` px, standard deviation of a coordinate (n / sqrt(3) for noise
    uniform in +-n); ``gyro_noise`` rad/s/sqrt(Hz); ``accel_noise`` m/s^2/sqrt(Hz); ``share`` of the depth:
    above 0.15 some runs start wrong and stay wrong;
    ``gap_s`` s. Memory: 178 floats. Returns PointEstimate or ``None`` from ``update``, PointTrack from
    ``run``. Raises ParameterError; EventError and EventOrderError from ``update`` and ``run``.

    Reference: Bar-Shalom, Li, Kirubarajan 2001, section 10.3 (extended Kalman filter) and 5.4 (consistency).

    >>> from pointpred.camera.samples import simulate
    >>> from pointpred.camera.scenario import SCENARIOS
    >>> samples, truth = simulate(SCENARIOS["paper"], focal_px=800.0, duration_s=5.0)
    >>> track = PointFilter(focal_px=800.0, noise_px=0.1).run(samples)
    >>> bool(abs(track.state[-1, 2] - truth.p[-1, 2]) < 5e-3)
    True
    """

    parameters = (
        FOCAL,
        Parameter("noise_px", "px", 1e-3, 1e3, "standard deviation of a coordinate in the image"),
        Parameter("gyro_noise", "rad/s/sqrt(Hz)", 0.0, 1.0, "density of the gyroscope's white noise"),
        Parameter("accel_noise", "m/s^2/sqrt(Hz)", 0.0, 10.0, "density of the accelerometer's white noise"),
        Parameter("share", "", 1e-3, 0.5, "relative standard deviation of the depth at which it starts"),
        Parameter("gap_s", "s", 1e-3, 10.0, "longest silence of the inertial sensor that is bridged"),
    )
    width = point_law.WIDTH
    step = staticmethod(point_law.answered)
    loop = staticmethod(point_law.loop)
    at_started, at_t, at_gap = point_law.STARTED, point_law.T, point_law.GAP_S

    def __init__(
        self,
        *,
        focal_px: float,
        noise_px: float = 1.0,
        gyro_noise: float = 0.0,
        accel_noise: float = 0.0,
        share: float = 0.1,
        gap_s: float = 1.0,
    ) -> None:
        own = {"focal_px": focal_px, "noise_px": noise_px, "gyro_noise": gyro_noise}
        own |= {"accel_noise": accel_noise, "share": share, "gap_s": gap_s}
        check(self.parameters, own)
        variances = [
            (float(noise_px) / float(focal_px)) ** 2,
            float(gyro_noise) ** 2,
            float(accel_noise) ** 2,
        ]
        self.lay_out([float(focal_px), *variances, float(share), float(gap_s)], point_law.STATES)

    def update(self, sample: CameraSample, /) -> PointEstimate | None:
        """Consume one sample; ``None`` before the start. A refused sample changes nothing."""
        row = self.advance(sample)
        if row[44] != 1.0:
            return None
        return PointEstimate(row[0], np.array(row[1:7]), np.reshape(row[7:43], (6, 6)), int(row[43]))

    def run(self, columns: CameraColumns) -> PointTrack:
        """Consume a table; a refused row raises its error and nothing is consumed."""
        out = self.table(columns)
        running = out[:, 44] == 1.0
        restarts = int(out[-1, 43]) if len(out) else 0
        return PointTrack(out[:, 0], out[:, 1:7], out[:, 7:43].reshape(-1, 6, 6), running, restarts)
