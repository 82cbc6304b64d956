"""The Cramer-Rao bound of any estimator, and the consistency of a filter."""

from __future__ import annotations

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import BoolArray, FloatArray
from pointpred_observers.camera import kinematics
from pointpred_observers.camera.point_filter import PointTrack
from pointpred_observers.camera.scenario import Trajectory

IDENTITY = np.eye(6)


def transition(truth: Trajectory, row: int) -> FloatArray:
    """Phi from a row to the next one: (p, v) is linear, so it is exact except for the change of w."""
    h = float(truth.t[row + 1] - truth.t[row])
    rx, ry, rz = (0.5 * h * (truth.w[row] + truth.w[row + 1])).tolist()
    columns = IDENTITY.ravel().copy()
    for i in range(6):
        kinematics.carry(columns, i, 6, h, (rx, ry, rz))
    return columns.reshape(6, 6)


def information(truth: Trajectory, row: int, variance: float) -> FloatArray:
    """The information of one image about (p, v): H' H / r at the truth."""
    x, y, z = truth.p[row]
    h = np.array([[1.0, 0.0, -x / z], [0.0, 1.0, -y / z]]) / z
    whole = np.zeros((6, 6))
    whole[:3, :3] = h.T @ h / variance
    return whole


def cramer_rao(
    truth: Trajectory,
    *,
    focal_px: float,
    noise_px: float,
    images: BoolArray | None = None,
    gyro_noise: float = 0.0,
    accel_noise: float = 0.0,
) -> FloatArray:
    """The least covariance of an unbiased estimate of (p, v) at each time, NaN while it is not determined.

    Assumes normal pixel noise of standard deviation ``noise_px``, no prior knowledge, and perfect inertial
    sensors unless their noise is passed. With noise that is not normal an estimator can be better.

    J <- (Phi J^-1 Phi' + Q)^-1 + H' H / r, with Phi J^-1 Phi' written as Phi^-T J Phi^-1 while Q is 0.

    Parameters: ``images``, the rows that have one, all by default. Returns (rows, 6, 6).
    Raises ParameterError for a noise that is not positive.

    Reference: Tichavsky, Muravchik, Nehorai 1998, equation (21); for Q = 0 Taylor 1979.
    """
    if not (noise_px > 0.0 and focal_px > 0.0):
        raise ParameterError(
            f"noise_px and focal_px must be positive, received {noise_px!r} and {focal_px!r}",
            field="focal_px" if noise_px > 0.0 else "noise_px",
            value=focal_px if noise_px > 0.0 else noise_px,
        )
    variance = (noise_px / focal_px) ** 2
    taken = np.ones(len(truth.t), np.bool_) if images is None else images
    j = np.zeros((6, 6))
    covariances = np.full((len(truth.t), 6, 6), np.nan)
    for row in range(len(truth.t)):
        if row:
            inverse = np.linalg.inv(transition(truth, row - 1))
            j = _less(inverse.T @ j @ inverse, truth, row, gyro_noise, accel_noise)
        if taken[row]:
            j = j + information(truth, row, variance)
        if np.linalg.cond(j) < 1e13:
            covariances[row] = np.linalg.inv(j)
    return covariances


def _less(j: FloatArray, truth: Trajectory, row: int, gyro_noise: float, accel_noise: float) -> FloatArray:
    """Information after the sensors' noise of one step: (J^-1 + Q)^-1 = J - J (J + Q^-1)^-1 J."""
    if gyro_noise == 0.0 and accel_noise == 0.0:
        return j
    h = float(truth.t[row] - truth.t[row - 1])
    memory = np.concatenate([np.zeros(36), truth.p[row], truth.v[row]])
    kinematics.add_noise(memory, 0, 36, gyro_noise**2 * h, accel_noise**2 * h)
    noise = memory[:36].reshape(6, 6)
    lost = noise @ np.linalg.inv(IDENTITY + j @ noise) @ j
    less: FloatArray = j @ (IDENTITY - lost)
    return 0.5 * (less + less.T)


def normalised_errors(track: PointTrack, truth: Trajectory) -> FloatArray:
    """The normalised estimation error squared (NEES) of each row, NaN before the filter started.

    For a consistent filter it is chi-squared distributed with 6 degrees of freedom and has mean 6.

    Reference: Bar-Shalom, Li, Kirubarajan 2001, section 5.4.2.
    """
    errors = track.state - np.hstack([truth.p, truth.v])
    squares = np.full(len(errors), np.nan)
    for row in np.flatnonzero(track.running):
        squares[row] = errors[row] @ np.linalg.solve(track.covariance[row], errors[row])
    return squares


def consistent(track_errors: FloatArray, share: float = 0.95) -> tuple[float, tuple[float, float]]:
    """The mean of independent NEES values and the interval it should lie in with probability ``share``.

    ``track_errors``: one value per run, at the same time.
    """
    from scipy.stats import chi2

    runs = len(track_errors)
    low, high = (float(chi2.ppf(end, 6 * runs)) / runs for end in (0.5 - 0.5 * share, 0.5 + 0.5 * share))
    return float(np.mean(track_errors)), (low, high)
