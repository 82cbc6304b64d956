"""Tables on the camera that take no Monte Carlo: the print audited, and designs."""

from __future__ import annotations

from typing import Any

import numpy as np

from pages.data import Table
from pointpred.errors import InfeasibleError
from pointpred_observers.camera import (
    SCENARIOS,
    camera_box,
    camera_system,
    printed,
    trajectory,
)
from pointpred_observers.unknown_input.boxes import Box
from pointpred_observers.unknown_input.observer import UnknownInputObserver

FOCAL, RATE_HZ = 800.0, 33.0


def residuals() -> Table:
    """How far printed equations are from the derivative of the trajectory, beside the corrected ones."""
    truth = trajectory(SCENARIOS["paper"], np.arange(331) / RATE_HZ)
    expected = printed.derivatives(truth)
    (x, y), (wx, wy, _), (vx, vy, _) = truth.image.T, truth.w.T, truth.v.T
    chi, eta = truth.chi, truth.eta
    corrected = truth.a[:, 2] * chi + wy * vx * chi - wx * vy * chi + eta**2 + truth.turn * eta
    system, point = camera_system(), {"w_x": 0.05, "w_y": -0.06}
    _, t = printed.decoupling_matrices(0.05, -0.06)
    least = float(np.linalg.eigvalsh(printed.P)[0])
    rows = [
        ("chi' in (12)", "right", _tiny(chi * (eta + y * wx - x * wy) - expected[:, 2])),
        ("chi' in (14)", _share(printed.chi_rate_14(truth) - expected[:, 2], expected[:, 2]), "as (12)"),
        (
            "eta' in (12), (14)",
            _share(printed.eta_rate_12(truth) - expected[:, 3], expected[:, 3]),
            _tiny(corrected - expected[:, 3]),
        ),
        ("T F, below (23)", _tiny(t @ system.f(point)), _tiny(system.t(point) @ system.f(point))),
        ("least eigenvalue of P, demanded >= 1e-12", f"{least:.2g}", "P >= I by scale"),
    ]
    return Table.of(("what", "largest error as printed", "corrected"), rows)


def asked() -> list[tuple[tuple[str, str], Box, float]]:
    """What is designed: ranges of eta at two thirds of the largest sigma, or at 0.01 1/s where there is none.

    The bounds of eta and sigma in 1/s as the tables name them, the box, and sigma.
    """
    bounds = {"turn": (-0.02, 0.02), "a_z": (-0.1, 0.1), "w": (-0.06, 0.06), "dw": (-0.1, 0.1)}
    listed = []
    for eta in ((-2.0, -0.2), (-2.0, -0.05), (-2.0, -0.03), (-2.0, -0.015), (-0.4, 0.1)):
        sigma = max(4.0 / 3.0 * -(eta[1] + 0.02), 0.01)
        listed.append(((f"[{eta[0]:g}, {eta[1]:g}]", f"{sigma:.3g}"), camera_box(eta, **bounds), sigma))
    return listed


def designs() -> Table:
    """What can be designed: certificates, and refusals."""
    rows = []
    for names, box, sigma in asked():
        try:
            one = UnknownInputObserver.design(camera_system(), box, sigma).certificate
            cells = (f"{one.largest_sigma:.3g}", f"{one.phi1:.3g}", f"{one.phi2:.3g}", f"{one.margin:.1e}")
        except InfeasibleError as none:
            cells = ("none" if "no sigma" in str(none) else "?", "refused", "-", "-")
        rows.append((*names, *cells))
    return Table.of(("eta 1/s", "sigma 1/s", "largest", "phi1", "phi2 s", "margin"), rows)


def _share(error: Any, of: Any) -> str:
    """An error, and how large it is beside the largest value of what it is an error of."""
    return f"{_tiny(error)}, {np.abs(error).max() / np.abs(of).max():.0%} of the largest"


def _tiny(values: Any) -> str:
    return f"{np.abs(values).max():.2g}"
