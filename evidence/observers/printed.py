"""Equations as the camera paper prints them, for audits only."""

from __future__ import annotations

import numpy as np

from pointpred.records import FloatArray
from pointpred_observers.camera.scenario import Trajectory


def derivatives(truth: Trajectory) -> FloatArray:
    """(x, y, chi, eta)' of a trajectory by the chain rule on p' = -v - w x p and v' = a - w x v alone.

    Uses (7) and (11), none of the audited equations.
    """
    p_rate = -truth.v - np.cross(truth.w, truth.p)
    v_rate = truth.a - np.cross(truth.w, truth.v)
    chi = truth.chi
    image_rate = (p_rate[:, :2] - truth.image * p_rate[:, 2:]) * chi[:, None]
    chi_rate = -p_rate[:, 2] * chi**2
    return np.column_stack([image_rate, chi_rate, v_rate[:, 2] * chi + truth.v[:, 2] * chi_rate])


def eta_rate_12(truth: Trajectory) -> FloatArray:
    """Second line of (12) as printed: four of its six signs are wrong."""
    (x, y), (wx, wy, _) = truth.image.T, truth.w.T
    (vx, vy, _), chi, eta = truth.v.T, truth.chi, truth.eta
    rate: FloatArray = (
        truth.a[:, 2] * chi - wy * vx * chi + wx * vy * chi + eta**2 - y * eta * wx + x * wy * eta
    )
    return rate


def chi_rate_14(truth: Trajectory) -> FloatArray:
    """First entry of f_u in (14) as printed: all three signs are wrong."""
    x, y = truth.image.T
    rate: FloatArray = -truth.chi * (truth.eta + y * truth.w[:, 0] - x * truth.w[:, 1])
    return rate


def decoupling_matrices(wx: float, wy: float) -> tuple[FloatArray, FloatArray]:
    """E and T as printed below (23): with this T the unknown input passes, T F = (0; 0; 0; 2 w_y, -2 w_x)."""
    e = np.array([[-1.0, 0.0], [0.0, -1.0], [0.0, 0.0], [-wy, wx]])
    t = np.diag([0.0, 0.0, 1.0, 1.0])
    t[3, :2] = -wy, wx
    return e, t


def gain_inequality(
    gamma_i: FloatArray,
    t_i: FloatArray,
    c: FloatArray,
    p: FloatArray,
    w_i: FloatArray,
    force: FloatArray,
    sigma: float,
) -> FloatArray:
    """(27c) as printed, with + W C: it is a proof for Gamma + K C, while (44) uses Gamma - K C."""
    corner = gamma_i.T @ p + p @ gamma_i + w_i @ c + c.T @ w_i.T + sigma * p
    return np.block([[corner, p @ t_i], [t_i.T @ p, -force]])


P = np.array(
    [
        [0.0034, -2.0580e-8, 0.0, 0.0],
        [-2.0580e-8, 0.0034, 0.0, 0.0],
        [0.0, 0.0, 9.8857e-13, 0.0],
        [0.0, 0.0, 0.0, 1.6109e-13],
    ]
)
"""The P of section V: its least eigenvalue lies below the required chi_1."""
CHI_1, SIGMA, GAMMA = 1e-12, 1e-2, 9.5492e-13
