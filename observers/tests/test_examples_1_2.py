"""Examples 1 and 2 of the thesis: what is printed, what is true, and no certificate where none is valid."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred.errors import CertificateError, DivergenceError
from pointpred_observers import steady_state_map, trajectory
from pointpred_observers.examples import Bioreactor, academic
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.simulations import signals
from pointpred_observers.thesis import residuals, theorem_3_2_1


def largest(found: dict[str, Any]) -> float:
    return max(float(np.abs(one).max()) for one in found.values())


def test_example_1_j_has_one_row() -> None:
    plant, generator = academic()
    found = steady_state_map(plant, generator)
    printed = np.array([[-0.5, 0.0], [0.0, -0.5], [1.5, 0.5]])
    assert np.allclose(found.Pi, printed, atol=1e-12)
    assert found.nullity == 0
    assert found.J.round(12).tolist() == [[1.5, 0.5]]
    assert largest(residuals(plant, generator, printed)) == 0.0


def test_example_1_the_printed_certificate_fails_and_the_printed_gain_can_be_certified() -> None:
    plant, generator = academic()
    found = steady_state_map(plant, generator).Pi
    p, u = [[1.129, 0.332], [0.332, 0.611]], [[-2.837], [-0.03]]
    printed = {
        "P": p, "Theta": [[0.388, 0.024], [0.024, 0.175]], "Gamma": 6.764,
        "Xi": [[5.0, 0.457], [0.457, 3.65]], "U": u,
    }  # fmt: skip
    with pytest.raises(CertificateError, match=r"the LMI has the eigenvalue 0\.933.* cannot explain it"):
        theorem_3_2_1(plant, generator, found).check(printed, rounding=5e-4)
    gain = np.array([[-2.973], [1.565]])
    assert np.allclose(np.linalg.solve(p, u), gain, atol=2e-3)
    design = DrivenObserver.design(plant, generator=generator, Pi=found, gain=gain, decay=0.0)
    assert np.array_equal(design.gain, gain)
    assert min(design.margins.values()) > 0.0
    assert theorem_3_2_1(plant, generator, found).check(design.values) == design.margins


def test_example_1_converges_within_the_certified_bound() -> None:
    plant, generator = academic()
    found = steady_state_map(plant, generator)
    design = DrivenObserver.design(
        plant, generator=generator, Pi=found.Pi, gain=[[-2.973], [1.565]], decay=0.0
    )
    g, m = design.generator, design.gain

    def field(t: float, both: Any) -> Any:
        w, x, z = both[:2], both[2:5], both[5:]
        dx = plant.field(t, x, g.L0 @ w + g.L1 @ plant.f(found.J @ w))
        dz = g.S0 @ z + m @ (plant.output(t, x) - plant.C0 @ found.Pi @ z)
        return np.concatenate([g.S0 @ w, dx, dz])

    times = np.arange(0.0, 30.0, 1.0)
    both = trajectory(field, [0.125, 0.0, 0.5, -0.5, 0.5, 0.25, 0.0], times)
    errors = np.linalg.norm(both[:, :2] - both[:, 5:], axis=1)
    off = both[:, 2:5] - both[:, :2] @ found.Pi.T
    eps = float(np.abs(plant.C0 @ off.T).max())
    assert all(error <= design.bound(t, errors[0], eps=eps) for t, error in zip(times, errors, strict=True))
    assert errors[-1] < 1e-2
    assert np.abs(off[-1]).max() < 5e-3


def test_example_2_the_map_is_right_but_not_unique() -> None:
    reactor = Bioreactor()
    found = steady_state_map(reactor.plant, reactor.generator, relaxed=True)
    assert largest(residuals(reactor.plant, reactor.generator, reactor.printed_map, relaxed=True)) < 1e-14
    assert found.nullity == 1
    difference = reactor.printed_map - found.Pi
    share = float((difference * found.basis[0]).sum())
    assert np.allclose(difference, share * found.basis[0], atol=1e-12)
    assert np.allclose(
        found.basis[0][:, :2], 0.0, atol=1e-12
    )  # it acts on the inflow: S_in1 = S_in2 is assumed


def test_example_2_the_printed_sector_conditions_fail_on_nearly_all_of_the_box() -> None:
    reactor, rng = Bioreactor(), np.random.default_rng(0)
    f, eta1, eta2, slope, sigma = (0.1, -2.0), 0.7, 0.8, 0.1, 0.1
    cross = 0.5 * (f[0] * eta2 * slope + f[1] * eta1)
    w1 = np.array([[f[0] * eta1, cross], [cross, f[1] * eta2 * sigma]])
    box = np.array([eta2, 30.0])
    failed = 0
    for one, other in zip(rng.uniform(size=(2000, 2)) * box, rng.uniform(size=(2000, 2)) * box, strict=True):
        e = one - other
        left = float(e @ f) * float(reactor.second(one)[0] - reactor.second(other)[0])
        failed += left > e @ w1 @ e
    assert failed / 2000 > 0.9


def test_example_2_the_sign_of_u_c1() -> None:
    """What f1 adds to d/dt of e'Pe is -2 e'U C1 (f1(Pi w) - f1(Pi z)), found here by switching f1 off."""
    reactor, gain = Bioreactor(), (0.3, 0.7)
    p = np.array([[2.0, 0.5], [0.5, 1.0]])
    w, z = np.array([0.5, 6.0]), np.array([0.3, 9.0])
    x = (reactor.printed_map @ np.append(w, 12.7))[:2]
    states = np.concatenate([x, w, z])

    def power(gained: tuple[float, float]) -> float:
        field = reactor.field(12.7, states, gained, projected=False)
        return float(2.0 * (w - z) @ p @ (field[2:4] - field[4:]))

    seen = (reactor.printed_map @ np.append(z, 12.7))[:2]
    assert seen.min() > 0.0
    change = reactor.K3 * float((reactor.first(x) - reactor.first(seen))[0])
    u = p @ gain
    assert power(gain) - power((0.0, 0.0)) == pytest.approx(-2.0 * float((w - z) @ u) * change)
    assert abs(change) > 1.0


def reactor_error(gain: tuple[float, float], *, projected: bool) -> tuple[float, Any]:
    reactor = Bioreactor()
    states = trajectory(
        lambda t, one: reactor.field(12.7, one, gain, projected=projected),
        [1.0, 5.0, 0.1, 0.0, 1.0, 20.0],
        [0.0, 10.0, 20.0, 30.0],
        tolerance=1e-6,
    )
    return float(np.linalg.norm(states[-1, 2:4] - states[-1, 4:])), states


def test_example_2_the_printed_gain_loses_without_projection_and_is_slower_with_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    none, free = reactor_error((0.0, 0.0), projected=True)
    printed, _ = reactor_error(Bioreactor.PRINTED_GAIN, projected=True)
    assert none < 1e-2 < printed
    monkeypatch.setattr(signals, "STANDING_MOST", 1000)
    with pytest.raises(DivergenceError, match=r"near t = 0\.00138"):  # the pole of f1
        reactor_error(Bioreactor.PRINTED_GAIN, projected=False)
    pi = Bioreactor().printed_map
    w = np.append(free[-1, 2:4], 12.7)
    assert np.abs(free[-1, :2] - (pi @ w)[:2]).max() < 1e-3
