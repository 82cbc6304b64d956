"""Examples 5 to 7: what their pages say of the print is true."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from evidence.rendering import filled
from pointpred.errors import CertificateError, InfeasibleError
from pointpred_observers import NonlinearRegressor, Persidskii, invariant_observer, trajectory
from pointpred_observers.examples import UNMEASURED, fused, pushes, two_masses, two_sensors
from pointpred_observers.reduced_order.reversed_certificate import theorem_3_3_1
from pointpred_observers.thesis import certify_convergence, regression_margin

PAGES = Path(__file__).parents[1] / "docs"
PRINTED = [[-1.0, 0.0], [0.0, 0.0]]


def test_example_5_is_the_equations_3_59() -> None:
    plant, random = two_masses(), np.random.default_rng(5)
    for _ in range(20):
        x, t = random.standard_normal(4), random.uniform(0.0, 9.0)
        spring = 3.0 * (x[0] - x[2]) + 3.0 * (x[0] - x[2]) ** 3 + 0.6 * (x[1] - x[3])
        wanted = [
            x[1],
            -spring + 0.2 * np.sin(10.0 * t),
            x[3],
            spring - 0.6 * x[2] - 2.0 * x[3] + np.sin(t),
        ]
        assert plant.field(t, x, rho=pushes(t)) == pytest.approx(wanted)


def test_the_printed_entry_makes_another_s0_than_the_printed_one() -> None:
    a0 = two_masses().A0.copy()
    a0[3, 3] = 0.6 - 2.0
    wrong = Persidskii(a0, None, None, "cube", C0=np.eye(2, 4))
    said = np.array([[0.0, 1.0], [-3.6, -2.6]])
    right = invariant_observer(two_masses(), UNMEASURED, PRINTED).at(0.0).S0
    assert right == pytest.approx(said, abs=1e-12)
    assert np.abs(invariant_observer(wrong, UNMEASURED, PRINTED).at(0.0).S0 - said).max() > 1.0


def test_without_the_second_column_of_q_the_global_observer_is_not_invariant() -> None:
    observer, plant, x = (
        invariant_observer(two_masses(), UNMEASURED, [[-1, 0], [0, 1]]),
        two_masses(),
        np.ones(4),
    )
    z, u = observer.at(0.0).Z, np.array([0.5, 0.7])
    moved = z @ plant.field(0.0, x, rho=u)
    assert observer.field(0.0, z @ x, x[:2], u) == pytest.approx(moved, abs=1e-12)
    assert np.abs(observer.field(0.0, z @ x, x[:2], [0.5, 0.0]) - moved).max() > 0.1


def test_no_w_suits_the_printed_f() -> None:
    """At slope 0 the left side is 0: W must not be negative; for F = (F1, 0) it may be 0."""
    now = invariant_observer(two_masses(), UNMEASURED, PRINTED).at(0.0)
    p = np.array([[0.267, 0.0547], [0.0547, 0.031]])
    assert (p @ now.S1)[:, 0] == pytest.approx([0.1641, 0.093])
    audit = theorem_3_3_1([now], ((0.0, 2.25),), 0.5)
    values = {"P": p, "Xi": np.array([[0.384, -0.006], [-0.006, 0.027]]), "W": np.diag([-0.1875, 0.0])}
    with pytest.raises(CertificateError, match=r"D = diag\(0\) has the eigenvalue -0\.1875"):
        audit.check(values)
    for slope in np.linspace(0.0, 2.25, 10):
        sector = 0.5 * slope * (np.outer([0.25, 0.0], now.J) + np.outer([0.25, 0.0], now.J).T)
        assert np.linalg.eigvalsh(-sector).min() >= 0.0


def test_the_printed_upsilon_is_certified_near_and_not_far() -> None:
    near = certify_convergence(invariant_observer(two_masses(1.0), UNMEASURED, PRINTED), decay=0.2)
    assert min(near.margins.values()) > 0.0
    with pytest.raises(InfeasibleError, match="no choice satisfies the inequalities"):
        certify_convergence(invariant_observer(two_masses(2.0), UNMEASURED, PRINTED))


def test_example_6_converges_although_the_condition_of_theorem_3_3_3_fails() -> None:
    t = np.arange(0.0, 40.0, 0.01)
    j, weight, x = two_sensors(t)
    period = t < 2.0 * np.pi
    assert regression_margin(t[period], j[period], weight[period], 0.75).margin < -1.0
    stage = NonlinearRegressor(2, f="atan", gain=0.75)
    found = stage.walk(np.zeros(len(t), np.bool_), np.column_stack([t, j, fused(t), weight]))

    def slope(now: float, w: np.ndarray) -> np.ndarray:
        row, share, _ = two_sensors(now)
        s = row @ w
        return np.asarray(0.75 * row * (fused(now) - (1.0 - share) * s - share * np.arctan(s)))

    other = trajectory(slope, [0.0, 0.0], t[::200], tolerance=1e-9)
    assert found[::200] == pytest.approx(other, abs=1e-3)
    error = np.linalg.norm(found - x, axis=1)
    assert error[0] > 5.0
    assert error[3000:].max() < 0.2


@pytest.mark.recordings
def test_the_table_of_example_7_is_that_of_the_data() -> None:
    if not os.environ.get("POINTPRED_RECORDINGS"):
        pytest.skip("POINTPRED_RECORDINGS is not set")
    from evidence.observers.sniffer import recursion, starts
    from evidence.rendering import shown
    from pointpred_observers.reproduction.thesis import sniffer

    file = Path(os.environ["POINTPRED_RECORDINGS"], "sniffer.csv")
    if not file.is_file():
        pytest.skip("sniffer.csv is not in the folder of recordings")
    data = sniffer(file)
    assert data is not None
    page = (PAGES / "example-7.md").read_text(encoding="utf-8")
    assert filled(page, "sniffer", shown(starts(*data))) == page
    rows, outputs = data
    normal = rows.T @ rows
    late = recursion(rows[3:], outputs[3:], rows[:3].T @ rows[:3], np.zeros(4))
    ordinary = np.linalg.solve(normal, rows.T @ outputs)
    # The first three samples count in the matrix, and their outputs nowhere.
    assert late == pytest.approx(np.linalg.solve(normal, rows[3:].T @ outputs[3:]), abs=1e-6)
    assert np.abs(late - ordinary).max() > 3.0
