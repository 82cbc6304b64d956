"""Examples 3 and 4 of the thesis: what is printed, what is true, and no certificate where none is valid."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from observers.tests.solvers import solved_by
from pointpred.errors import CertificateError, InfeasibleError
from pointpred_observers import steady_state_map, thesis, trajectory
from pointpred_observers.examples import ROBOT_INPUT_MODIFIED, academic, chua_circuits, robotic_arm
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.interconnected.tracking import closed_loop

CHUA_GAIN = [[-0.34], [1.32], [5.35]]


def largest(found: dict[str, Any]) -> float:
    return max(float(np.abs(one).max()) for one in found.values())


def test_example_3_what_holds_and_what_does_not() -> None:
    plant, regulator = robotic_arm()
    assert largest(thesis.residuals(plant, regulator, np.eye(4))) < 1e-12
    with pytest.raises(InfeasibleError, match=r"Assumption 3\.2\.3: no choice satisfies the inequalities"):
        thesis.theorem_3_2_2(plant, regulator, np.eye(4)).solve()
    with pytest.raises(InfeasibleError, match=r"Assumption 3\.2\.6: no choice satisfies the inequalities"):
        thesis.theorem_3_2_3(
            plant, regulator, np.eye(4), thesis.sector_bounds(plant, Sigma1=np.eye(4), Psi1=np.eye(4))
        ).solve()
    held = thesis.theorem_3_2_3(plant, regulator, np.eye(4)).solve()
    assert min(held.margins.values()) > 0.0
    modified, driven = robotic_arm(ROBOT_INPUT_MODIFIED)
    certificate = thesis.certify_tracking(modified, driven, np.eye(4))
    assert min(certificate.margins.values()) > 0.0
    with pytest.raises(InfeasibleError, match=r"Assumption 3\.2\.3"):
        thesis.certify_tracking(plant, regulator, np.eye(4))


def test_example_3_the_reason_is_that_no_input_drives_the_link() -> None:
    """J S~ = 0 makes the block of f(Jw) zero: it needs P S~ + J' Omega = 0, so S~'P S~ = 0 with P > 0."""
    plant, regulator = robotic_arm()
    tilde = regulator.S1 + regulator.G @ plant.C1
    assert (plant.H @ tilde == 0.0).all()
    assert np.abs(tilde).max() > 1.0


def test_example_3_the_observer_converges_and_the_plant_need_not_follow() -> None:
    plant, regulator = robotic_arm()

    def field(t: float, both: Any) -> Any:
        rho = [np.sin(2.0 * np.pi * t)]
        reference = both[8:]
        u = regulator.L0 @ reference + regulator.L1 @ plant.f(plant.H @ reference) + rho
        return np.concatenate(
            [closed_loop(plant, regulator, t, both[:8], rho=rho), plant.field(t, reference, u)]
        )

    start = np.array([0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0])
    both = trajectory(field, start, np.arange(0.0, 12.1, 0.5), tolerance=1e-8)
    z = np.linalg.norm(both[:, :4] - both[:, 4:8], axis=1)
    follows = np.linalg.norm(both[:, :4] - both[:, 8:], axis=1)
    assert z[-1] < 1e-3
    assert follows[-4:].min() > 0.5


def test_example_4_the_equalities_hold_with_exact_fractions() -> None:
    plant, generator = chua_circuits()
    assert largest(thesis.residuals(plant, generator, np.eye(3))) < 1e-14
    assert np.allclose(steady_state_map(plant, generator).Pi, np.eye(3), atol=1e-12)
    printed = generator.L1.copy()
    printed[0, 0] = 2.857
    wrong = generator.__class__(generator.S0, generator.S1, generator.J, None, generator.L0, printed)
    assert largest(thesis.residuals(plant, wrong, np.eye(3))) == pytest.approx(2.857 + 20.0 / 7.0)


def test_example_4_the_circuits_synchronise() -> None:
    plant, g = chua_circuits()

    def field(t: float, both: Any) -> Any:
        w, x = both[:3], both[3:]
        f = plant.f(g.J @ w)
        return np.concatenate([g.S0 @ w + g.S1 @ f, plant.field(t, x, g.L0 @ w + g.L1 @ f)])

    start = [0.2, 0.0, 0.2, 0.65, 0.0, 0.5]
    both = trajectory(field, start, np.arange(0.0, 20.1, 1.0))
    errors = np.abs(both[:, :3] - both[:, 3:]).max(axis=1)
    assert errors[-1] < 1e-3 * errors[0]
    assert np.abs(both[:, 0]).max() > 0.9  # it oscillates on


def synchronised(reach: float) -> DrivenObserver:
    plant, generator = chua_circuits(reach)
    return DrivenObserver.design(plant, generator=generator, Pi=np.eye(3), decay=0.0)


def test_example_4_no_valid_certificate_covers_the_trajectory() -> None:
    plant, generator = chua_circuits(1.0)
    p = [[0.223, -1.16, 0.087], [-1.16, 8.398, -0.589], [0.087, -0.589, 0.066]]
    printed = {
        "P": p, "Gamma": 10.933,
        "Theta": [[0.46, -1.073, 0.093], [-1.073, 5.489, 0.077], [0.093, 0.077, 0.118]],
        "Xi": [[6.5664, -0.7234, 0.0832], [-0.7234, 12.4347, -0.4819], [0.0832, -0.4819, 6.4706]],
        "U": np.array(p) @ CHUA_GAIN, "W": [[0.25, -2.5, 0.1], [-2.5, 0.0, 0.0], [0.1, 0.0, 0.0]],
    }  # fmt: skip
    theorem = thesis.theorem_3_2_1(plant, generator, np.eye(3), F=[[0.5], [-5.0], [0.2]])
    with pytest.raises(
        CertificateError, match=r"D = diag\(0\) has the eigenvalue -2\.38\d+, must lie above 0"
    ):
        theorem.check(printed, rounding=5e-4)
    assert theorem.margins(printed)["the LMI"] > 0.0
    for gain in (None, CHUA_GAIN):
        with pytest.raises(InfeasibleError, match="no choice satisfies the inequalities"):
            DrivenObserver.design(plant, generator=generator, Pi=np.eye(3), gain=gain, decay=0.0)
    near = synchronised(0.5)
    assert min(near.margins.values()) > 0.0
    with pytest.raises(
        CertificateError, match=r"the trajectory reaches 0\.99, the slopes hold within 0\.5 only"
    ):
        near.region(0.99)


def test_two_solvers_agree_on_the_examples() -> None:
    pytest.importorskip("cvxopt", reason="the second solver is a tool of the tests only")
    plant, generator = academic()
    found = steady_state_map(plant, generator).Pi
    with solved_by("CVXOPT"):
        first = DrivenObserver.design(plant, generator=generator, Pi=found, decay=0.0)
        second = synchronised(0.3)
    assert first.values["Gamma"][0, 0] == pytest.approx(
        DrivenObserver.design(plant, generator=generator, Pi=found, decay=0.0).values["Gamma"][0, 0], rel=1e-4
    )
    assert second.values["Gamma"][0, 0] == pytest.approx(synchronised(0.3).values["Gamma"][0, 0], rel=1e-5)


@pytest.mark.parametrize("solver", ["CLARABEL", "CVXOPT"])
def test_two_solvers_agree_on_what_holds_in_example_3(solver: str) -> None:
    """Each one's matrices pass the audit, and each one's bound of the least gamma2 holds for the other."""
    pytest.importorskip("cvxopt", reason="the second solver is a tool of the tests only")
    plant, regulator = robotic_arm()
    modified, driven = robotic_arm(ROBOT_INPUT_MODIFIED)
    with solved_by(solver):
        with pytest.raises(InfeasibleError, match="no choice satisfies the inequalities"):
            thesis.theorem_3_2_2(plant, regulator, np.eye(4)).solve()
        holds = thesis.theorem_3_2_2(modified, driven, np.eye(4)).solve()
        least = thesis.theorem_3_2_3(plant, regulator, np.eye(4)).solve(minimise=lambda v: v.gamma2)
    assert min(holds.margins.values()) > 0.0
    assert min(least.margins.values()) > 0.0
    assert least.objective is not None
    assert least.gap is not None
    assert least.objective * (1.0 - least.gap) <= 32.4778
    assert least.objective >= 32.47
    if solver == "CLARABEL":
        assert least.objective == pytest.approx(32.4777, rel=2e-3)
