"""Plants of scipy and python-control, taken by every door as their Persidskii systems are."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy import signal

from observers.tests import kept_designs as kept
from pointpred.errors import ParameterError
from pointpred_observers import (
    Generator,
    Persidskii,
    c2d,
    invariant_observer,
    steady_state_map,
    thesis,
    trajectory,
)
from pointpred_observers.files import decoded, encoded
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.interconnected.regulator import Regulator
from pointpred_observers.interconnected.tracking import closed_loop
from pointpred_observers.plants.linear_systems import as_plant
from pointpred_observers.plants.nonlinearity import KNOWN, true_slopes, value
from pointpred_observers.reduced_order.design import ReducedOrderObserver

A, B, C, D = [[0.0, 1.0], [-2.0, -0.5]], [[0.0], [1.0]], [[1.0, 0.0]], [[0.0]]
OWN = Persidskii(A, None, None, "identity", B, C0=C)
CIRCLE = Generator([[0.0, 1.0], [-1.0, 0.0]], L0=[[1.0, 0.0]])
REGULATOR = Regulator.design(OWN)
PI = steady_state_map(OWN, CIRCLE).Pi

DOORS: dict[str, Callable[[Any], Any]] = {
    "steady_state_map": lambda p: steady_state_map(p, CIRCLE).Pi,
    "residuals": lambda p: thesis.residuals(p, CIRCLE, PI)["A0 Pi - Pi G C0 Pi - Pi S0 + B L0"],
    "design_observer": lambda p: DrivenObserver.design(p, generator=CIRCLE, Pi=PI, decay=0.5).gain,
    "certify_tracking": lambda p: thesis.certify_tracking(
        p, REGULATOR.regulator, REGULATOR.Pi
    ).regulator.values["P"],
    "closed_loop": lambda p: closed_loop(p, REGULATOR.regulator, 0.0, [1.0, 2.0, 3.0, 4.0]),
    "regulator_stage": lambda p: thesis.regulator_stage(p, REGULATOR.regulator, start=[1.0, 2.0]).update(
        0.0, [1.0]
    ),
    "design_reduced_order": lambda p: ReducedOrderObserver.design(p, decay=2.0).Upsilon,
    "invariant_observer": lambda p: invariant_observer(p, [[0.0, 1.0]], [[-3.0]]).at(0.0).S0,
    "certify_convergence": lambda p: thesis.certify_convergence(
        invariant_observer(p, [[0.0, 1.0]], [[-3.0]])
    ).values["P"],
    "design_state_feedback": lambda p: thesis.design_state_feedback(p).L0,
    "design_regulator": lambda p: Regulator.design(p).regulator.S0,
    "regulator_equations": lambda p: thesis.regulator_equations(p, CIRCLE).Pi,
    "c2d": lambda p: c2d(p, 0.1).A0,
}


@pytest.mark.parametrize("door", DOORS)
def test_every_door_takes_a_state_space_system(door: str) -> None:
    expected = DOORS[door](OWN)
    assert np.array_equal(DOORS[door](signal.StateSpace(A, B, C, D)), expected)


def test_systems_of_python_control() -> None:
    control = pytest.importorskip("control", reason="python-control is a tool of the tests only")
    for system in (control.ss(A, B, C, D), control.ss(control.tf([1.0], [1.0, 0.5, 2.0]))):
        design = ReducedOrderObserver.design(system, decay=2.0)
        assert design.certificate.bound.decay >= 2.0 - 1e-9
    sampled = control.c2d(control.ss(A, B, C, D), 0.1)
    assert as_plant(sampled).time == "discrete"
    assert np.array_equal(as_plant(sampled).A0, sampled.A)
    plant = as_plant(control.tf([1.0], [1.0, 0.5, 2.0]))
    assert np.poly(plant.A0) == pytest.approx([1.0, 0.5, 2.0])
    for one in (control.frd([1.0, 2.0], [1.0, 2.0]), control.tf([1.0, 1.0, 1.0], [1.0, 1.0])):
        with pytest.raises(ParameterError, match="must have a state-space form, received a"):
            as_plant(one)
    assert as_plant(control.ss(A, B, C, D, None)).time == "continuous"
    assert as_plant(control.ss(A, B, C, D, True)).time == "discrete"
    own = control.poles(control.ss(A, B, C, D))
    assert np.sort_complex(np.linalg.eigvals(as_plant(control.ss(A, B, C, D)).A0)) == pytest.approx(
        np.sort_complex(own)
    )


def test_systems_of_scipy() -> None:
    assert as_plant(signal.lti(A, B, C, D)).time == "continuous"
    assert as_plant(signal.dlti(A, B, C, D, dt=0.1)).time == "discrete"
    for one in (
        signal.TransferFunction([1.0], [1.0, 0.5, 2.0]),
        signal.ZerosPolesGain([], [-1.0, -2.0], 3.0),
    ):
        plant = as_plant(one)
        w, response = signal.freqresp(one, [0.7])
        inside = plant.C0 @ np.linalg.solve(1j * w[0] * np.eye(2) - plant.A0, plant.B)
        assert complex(inside[0, 0]) == pytest.approx(complex(response[0]))


def test_tracking_without_a_nonlinearity() -> None:
    certificate = thesis.certify_tracking(OWN, REGULATOR.regulator, REGULATOR.Pi)
    for values, a in (
        (certificate.regulator.values, OWN.A0 + OWN.B @ REGULATOR.feedback.L0),
        (certificate.error.values, OWN.A0 - REGULATOR.observer.gain @ OWN.C0),
    ):
        assert np.linalg.eigvalsh(a.T @ values["P"] + values["P"] @ a).max() < 0.0


A0 = np.array([[0.0, 1.0], [-2.0, -0.3]])


PLANT = Persidskii(A0, [0.0, -0.5], [1.0, 0.0], "sin", [0.0, 1.0], [1.0, 0.0], [1.0, 0.0])


def test_the_linear_part_is_that_of_scipy() -> None:
    held = c2d(PLANT, 0.2)
    drive = np.hstack([PLANT.A1, PLANT.B, PLANT.Q])
    ad, bd, *_ = signal.cont2discrete((A0, drive, PLANT.C0, np.zeros((1, 3))), 0.2)
    assert pytest.approx(ad, abs=1e-14) == held.A0
    assert np.hstack([held.A1, held.B, held.Q]) == pytest.approx(bd, abs=1e-14)
    assert (held.time, held.slopes, held.C0.tolist()) == ("discrete", PLANT.slopes, PLANT.C0.tolist())


def test_a_linear_plant_under_held_inputs_is_exact() -> None:
    plant = Persidskii(A0, None, None, "sin", [0.0, 1.0])
    held, rng, x = c2d(plant, 0.3), np.random.default_rng(1), np.array([1.0, 0.0])
    for k in range(8):
        u = rng.normal(size=1)
        true = trajectory(lambda t, one: plant.field(t, one, u), x, [0.0, 0.3])[-1]  # noqa: B023
        x = held.field(k, x, u)
        assert x == pytest.approx(true, abs=1e-9)


@pytest.mark.parametrize("method", ["zoh", "euler"])
def test_half_the_step_is_half_the_error(method: str) -> None:
    true = trajectory(PLANT.field, [1.0, 0.0], [0.0, 2.0])[-1]
    errors = []
    for count in (100, 200, 400):
        sampled = c2d(PLANT, 2.0 / count, method=method)
        end = trajectory(sampled.field, [1.0, 0.0], np.arange(count + 1), time="discrete")[-1]
        errors.append(np.abs(end - true).max())
    assert np.array(errors[:-1]) / errors[1:] == pytest.approx(2.0, rel=0.05)


def test_euler_keeps_the_steady_state_map() -> None:
    pi = steady_state_map(kept.DRIVEN, kept.CONSTANT).Pi
    sampled = [c2d(one, 0.1, method="euler") for one in (kept.DRIVEN, kept.CONSTANT)]
    assert max(np.abs(one).max() for one in thesis.residuals(*sampled, pi).values()) < 1e-14
    assert steady_state_map(*sampled).Pi == pytest.approx(pi)


def test_a_generator_of_another_time_is_refused() -> None:
    generator = kept.CONSTANT
    sampled = c2d(generator, 0.1)
    assert sampled.time == "discrete"
    with pytest.raises(ParameterError, match="a continuous generator, received a discrete one"):
        c2d(sampled, 0.1)
    with pytest.raises(ParameterError, match="the generator is discrete and the plant continuous"):
        steady_state_map(PLANT, sampled)
    with pytest.raises(ParameterError, match="the generator is continuous and the plant discrete"):
        steady_state_map(c2d(PLANT, 0.1), Generator([[0.0]], time="continuous"))
    assert decoded(encoded(sampled)).time == "discrete"
    assert decoded(encoded(generator)).time is None


def plant(f: Any, slopes: Any, domain: float = np.inf) -> Persidskii:
    return Persidskii(
        [[0.0, 1.0], [-1.0, -1.0]], [0.0, -1.0], [1.0, 0.0], f, C0=[1.0, 0.0], slopes=slopes, domain=domain
    )


NARROW = [
    ("cube", [[0.0, 0.5]], 1.0, "between 0 and 3"),
    ("tanh", (0.5, 0.6), 0.5, "between 0.786448 and 1"),
    ("tanh", (0.9, 1.0), np.inf, "everywhere: its slopes there lie between 0 and 1"),
    ("saturation", (0.0, 0.5), np.inf, "between 0 and 1"),
    ("cube", (0.0, 3.0), np.inf, "between 0 and inf"),
]


@pytest.mark.parametrize(("f", "slopes", "domain", "words"), NARROW)
def test_slopes_narrower_than_those_of_a_name_are_refused(
    f: str, slopes: Any, domain: float, words: str
) -> None:
    with pytest.raises(ParameterError, match=words) as wrong:
        plant(f, slopes, domain)
    assert wrong.value.field == "slopes"


@pytest.mark.parametrize("name", KNOWN)
@pytest.mark.parametrize("domain", [0.5, 1.0, 2.0, 4.0])
def test_the_true_slopes_of_a_name_are_those_of_its_differences(name: str, domain: float) -> None:
    low, high = true_slopes(KNOWN[name].code, domain)
    s = np.linspace(-domain, domain, 4001)
    steps = np.diff([value(KNOWN[name].code, float(one)) for one in s]) / np.diff(s)
    assert low == pytest.approx(steps.min(), abs=3e-3 * max(1.0, high))
    assert high == pytest.approx(steps.max(), abs=3e-3 * max(1.0, high))
    assert plant(name, (low, high), domain).slopes == ((low, high),)
    assert plant(name, (low - 1.0, high + 1.0), domain).domain == domain


WRONG = [
    (np.tanh, (0.0, 0.5), np.inf, "slopes of f must hold everywhere"),
    (np.tanh, (0.9, 1.0), 1.0, "within 1: between -1"),
    (lambda s: s**3, (0.0, 3.0), 2.0, "rises by"),
    (lambda s: 1.0 / s, (-1.0, 1.0), 1.0, "at arguments of 0 it returns"),
    (lambda s: 1j * s, (0.0, 1.0), 1.0, "complex"),
    (lambda s: np.zeros(3), None, 1.0, r"the shape \(3,\), need \(1,\)"),
]


@pytest.mark.parametrize(("f", "slopes", "domain", "words"), WRONG, ids=[row[3] for row in WRONG])
def test_a_function_that_violates_its_slopes_is_refused(
    f: Any, slopes: Any, domain: float, words: str
) -> None:
    with pytest.raises(ParameterError, match=words):
        plant(f, slopes, domain)


def test_functions_with_their_true_slopes_are_taken() -> None:
    for f, slopes, domain in [
        (np.tanh, (0.0, 1.0), np.inf),
        (lambda s: s * np.abs(s), (0.0, 8.0), 4.0),
        (lambda s: 1e6 + 1e-3 * np.sin(s), (-1e-3, 1e-3), np.inf),
        (np.sin, (np.cos(1e-3), 1.0), 1e-3),
        (lambda s: 1.0 / s, None, np.inf),  # nothing is said of its slopes
    ]:
        assert plant(f, slopes, domain).domain == domain
    both = Persidskii(-np.eye(2), np.eye(2), np.eye(2), np.arctan, slopes=[(0.0, 1.0), (-1.0, 1.0)])
    assert both.at(0.0).f.checked == np.inf


def test_another_function_of_a_file_must_fit_its_slopes() -> None:
    text = encoded(plant(np.tanh, (0.0, 1.0)))
    assert decoded(text, functions={"f": np.arctan}).slopes == ((0.0, 1.0),)
    with pytest.raises(ParameterError, match="component 0 rises by"):
        decoded(text, functions={"f": np.sin})
    narrow = encoded(plant("tanh", (-0.5, 1.0))).replace(b"-0.5", b"0.5")
    with pytest.raises(ParameterError, match="'tanh', must hold everywhere"):
        decoded(narrow)


def rotation(s: Any) -> Any:
    return np.array([np.tanh(s[0] + 1e-6 * s[1]), np.tanh(s[1])])


MIXED = [
    (lambda s: s[::-1], (1.0, 1.0), np.inf, "component 1 may depend upon argument 1 only"),
    (lambda s: s[::-1], (1.0, 1.0), 1e-9, "as argument 0 moves from"),
    (rotation, (0.0, 1.1), np.inf, "component 0 may depend upon argument 0 only"),
    (lambda s: s * np.array([1.0, np.cos(s[0] * s[1] - s[1] ** 2)]), (-9.0, 9.0), 1.0, "component 1 may"),
]


@pytest.mark.parametrize(("f", "slopes", "domain", "words"), MIXED)
def test_slopes_of_a_function_that_mixes_its_arguments_are_refused(
    f: Any, slopes: Any, domain: float, words: str
) -> None:
    """Corner proofs take f for diagonal; with f = (s2, s1) x' = -x + A1 f(x) was proved, and x grows."""
    with pytest.raises(ParameterError, match=words) as wrong:
        Persidskii(-np.eye(2), [[0.0, 5.0], [-5.0, 0.0]], np.eye(2), f, slopes=slopes, domain=domain)
    assert wrong.value.field == "f"
    assert Persidskii(-np.eye(2), np.eye(2), np.eye(2), f).slopes is None


def test_a_function_with_slopes_is_called_within_its_domain_only_and_seldom() -> None:
    seen: list[Any] = []

    def f(s: Any) -> Any:
        seen.append(s.copy())
        s[:] = np.arcsin(s)  # in place: what f does to its argument is its own affair
        return s

    Persidskii(-np.eye(3), np.eye(3), np.eye(3), f, slopes=(1.0, 2e4), domain=0.999)
    assert np.abs(seen).max() <= 0.999
    assert len(seen) < 200


def test_slopes_need_as_many_arguments_as_components() -> None:
    with pytest.raises(ParameterError, match=r"3 components .* and 2 arguments"):
        Persidskii(-np.eye(2), np.ones((2, 3)), np.eye(2), lambda s: np.full(3, s.sum()), slopes=(0.0, 1.0))
