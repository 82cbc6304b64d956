"""Files and observers whose certificate proves nothing are refused, in every unit and at every door."""

from __future__ import annotations

import json
import warnings
import zlib
from fractions import Fraction
from typing import Any

import mpmath
import msgspec
import numpy as np
import pytest

import pointpred_observers as o
from evidence.observers.plants import DOORS, KINDS, Problem
from observers.tests import kept_designs as kept
from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred_observers import Generator, Persidskii, audit, thesis
from pointpred_observers.cli.observer_results import print_audit, print_design, summary
from pointpred_observers.files import decoded, encoded
from pointpred_observers.interconnected import design as interconnected
from pointpred_observers.interconnected.design import FullOrderObserver
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.solver import Affine, reach
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.reduced_order.reversed_certificate import certified_convergence
from pointpred_observers.reduced_order.reversed_connection import InvariantObserver
from pointpred_observers.unknown_input.observer import UnknownInputObserver


def pendulum(push: float = 1.0) -> o.Persidskii:
    return o.Persidskii([[0.0, 1.0], [0.0, -0.3]], [0.0, -2.0], [1.0, 0.0], "sin", [0.0, push], C0=[1.0, 0.0])


def wrong(push: float, share: float, **more: Any) -> tuple[ReducedOrderObserver, InvariantObserver]:
    """A design, and its observer with ``share`` of the right B."""
    design = o.design(pendulum(push), "reduced", decay=1.0)
    b, pi = design.observer.at(0.0).B, design.observer.document().Pi
    return design, o.invariant_observer(
        pendulum(push), pi, design.Upsilon, B=share * b, injection=True, **more
    )


@pytest.mark.parametrize("name", ["P", "F"])
def test_a_small_matrix_must_be_symmetric_to_the_last_bit(name: str) -> None:
    a = [[-1.0, 0.0, 0.0], [0.0, -2.0, 1.0], [0.0, 1.0, -0.5]]
    system = o.CornerSystem(
        o.Box({"k": (1.0, 3.0)}), A=[a, a], F=[[0.0], [0.0], [1.0]], C=[[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    )
    file = json.loads(encoded(UnknownInputObserver.design(system, system.box, decay=0.5)))
    gain = [[-4.0, 0.0], [-1.0, 0.0], [0.0, 5.0]]  # N has the eigenvalue 3
    skew = np.diag([1e-12] * 3)
    skew[0, 1] = -5e-9
    file["certificate"] |= {"P": np.diag([1e-12] * 3).tolist(), "F": np.eye(3).tolist(), name: skew.tolist()}
    file["gains"] = [gain, gain]
    with pytest.raises(CertificateError, match=f"{name} must be symmetric .* transpose by 5e-09"):
        decoded(json.dumps(file))


@pytest.mark.parametrize("entry", [-1e160, -1e300, -1e308])
@pytest.mark.parametrize("time", ["continuous", "discrete"])
def test_gains_that_overflow_are_refused_in_words(entry: float, time: str) -> None:
    shift = np.eye(2) if time == "continuous" else np.zeros((2, 2))
    corners = [np.array([[0.5, 0.1], [last, 0.2]]) - shift for last in (-0.1, -0.3)]
    system = o.CornerSystem(o.Box({"k": (0.1, 0.3)}), A=corners, F=[[1.0], [0.0]], C=[[1.0, 0.0]], time=time)
    design = UnknownInputObserver.design(system, system.box, decay=0.15)
    gains, proof = design.gains.copy(), design.certificate
    gains[1][0][0] = entry
    assert proof.force is not None
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises((CertificateError, ParameterError), match=r"too large|\(27c\) has the eigenvalue"):
            UnknownInputObserver.certified(system, system.box, gains, proof.P, proof.force, proof.decay)


@pytest.mark.parametrize("push", [1.0, 1e12])
def test_no_tolerance_certifies_an_observer_that_breaks_its_equalities(push: float) -> None:
    """Also not where a large entry of B, in small units, would make any residual a small share of it."""
    design, observer = wrong(push, 2.0, tolerance=0.99)
    for claim in (
        lambda: thesis.certify_convergence(observer, decay=0.9),
        lambda: certified_convergence(observer, design.certificate.values),
        lambda: observer.error_system(),
        lambda: o.simulate(
            pendulum(push),
            ReducedOrderObserver(observer, design.Upsilon, design.certificate),
            times=np.arange(0.0, 0.1, 0.01),
        ),
    ):
        with pytest.raises(CertificateError, match=r"S0 Z \+ B C0 - Z A0 - Z' = 0 fails: its residual is"):
            claim()
    ran = o.simulate(pendulum(push), observer, times=np.arange(0.0, 0.1, 0.01))
    assert not ran.bound.size


def test_slow_rates_do_not_hide_an_equality_that_fails() -> None:
    plant = o.Persidskii(np.array([[0.0, 1.0], [0.0, -0.3]]) * 1e-12, None, None, "sin", C0=[1.0, 0.0])
    design = o.design(plant, "reduced", decay=1e-12)
    b, pi = design.observer.at(0.0).B, design.observer.document().Pi
    with pytest.raises(CertificateError, match=r"S0 Z .* = 0 fails"):
        thesis.certify_convergence(o.invariant_observer(plant, pi, design.Upsilon, B=2.0 * b), decay=0.9e-12)


def test_a_file_with_a_certificate_and_a_loose_tolerance_is_refused() -> None:
    design, observer = wrong(1.0, 2.0, tolerance=0.99)
    file = json.loads(encoded(design))
    file |= {"tolerance": 0.99, "B": observer.at(0.0).B.tolist()}
    with pytest.raises(CertificateError, match=r"tolerance is 0\.99, but a certificate needs"):
        decoded(json.dumps(file))
    without = {key: one for key, one in file.items() if key not in ("certificate", "certificate_gap", "gap")}
    assert isinstance(decoded(json.dumps({**without, "kind": "invariant observer"})), InvariantObserver)


def test_in_small_units_a_wrong_j_is_not_near_h_pi() -> None:
    plant = o.Persidskii([[-2.0]], [1.0], [1e-7], "sin", C0=[1.0])
    generator = o.Generator([[-2.0]], [1.0], J=[[3e-7]])
    with pytest.raises(ParameterError, match="J must be H Pi"):
        thesis.theorem_3_2_1(plant, generator, [[1.0]])


@pytest.mark.parametrize("unit", [1e-10, 1.0, 1e10])
def test_an_upsilon_that_meets_c1_proves_nothing_in_any_unit(unit: float) -> None:
    """w = Pi x + Upsilon y contains f here; small units of w once hid it below an absolute tolerance."""
    plant = o.Persidskii([[0.0, 1.0], [0.0, -1.0]], [0.0, 0.1], [-3.0, 1.0], "tanh", C0=[1.0, 0.0], C1=[-0.1])
    with pytest.raises((CertificateError, InfeasibleError), match="Upsilon C1 = 0"):
        thesis.certify_convergence(o.invariant_observer(plant, [[0.0, unit]], [[-3.0 * unit]]))


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_rounding_in_upsilon_is_no_failure(unit: float) -> None:
    """The first output holds f, and Upsilon holds rounding where it must not use it."""
    plant = o.Persidskii(
        [[0.0, 1.0], [0.0, -1.0]], [0.0, -0.1], [-1.0, 1.0], "tanh",
        C0=[[0.0, unit], [1.0, 0.0]], C1=[[unit], [0.0]],
    )  # fmt: skip
    observer = o.invariant_observer(plant, [[0.0, 1.0]], [[1e-17 / unit, -1.0]])
    assert observer.at(0.0).shares["Upsilon C1"] == 0.0
    observer = o.invariant_observer(plant, [[0.0, 1.0]], [[1e-12 / unit, -1.0]])
    assert observer.at(0.0).shares["Upsilon C1"] == 1.0


@pytest.mark.parametrize(
    ("place", "change"), [("Pi", 1.001), ("L0", 1.001), ("F", 0.5)], ids=["map", "input", "followed"]
)
def test_equations_of_a_file_are_computed_again(place: str, change: float) -> None:
    file = json.loads(encoded(kept.design("servo")))
    assert "residuals" not in file["equations"]
    file["equations"][place] = (change * np.array(file["equations"][place])).tolist()
    with pytest.raises(CertificateError, match=r"the regulator equations do not hold: .* is left in "):
        decoded(json.dumps(file))


def test_the_regulator_of_a_file_applies_its_equations() -> None:
    file = json.loads(encoded(kept.design("servo")))
    lead = np.array(file["regulator"]["L0"])
    lead[:, -1] += 1.0
    file["regulator"]["L0"] = lead.tolist()
    with pytest.raises((CertificateError, InfeasibleError)):
        decoded(json.dumps(file))


PLANT = o.Persidskii([[-1.0]], [0.0], [1.0], "sin", [1.0], None, [1.0])
FOLLOWED = o.Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0])
OTHER = o.Generator([[-0.5]], [0.3], [1.0], None, [0.5], [0.3], None, "cube")


def regulator(f: Any) -> o.Generator:
    return o.Generator([[-3.0]], [-2.0], [1.0], [2.0], [0.0], [-1.0], None, f)


@pytest.mark.parametrize(
    "prove",
    [
        lambda: o.design(PLANT, "driven", generator=OTHER, Pi=[[1.0]], decay=0.0),
        lambda: thesis.theorem_3_2_1(PLANT, OTHER, [[1.0]]),
        lambda: thesis.certify_tracking(FOLLOWED, regulator("cube"), [[1.0]]),
        lambda: thesis.theorem_3_2_2(FOLLOWED, regulator("cube"), [[1.0]]),
        lambda: thesis.theorem_3_2_3(FOLLOWED, regulator("cube"), [[1.0]]),
        lambda: thesis.closed_loop(FOLLOWED, regulator("cube"), 0.0, [1.0, 1.0]),
        lambda: thesis.regulator_equations(PLANT, OTHER),
        lambda: o.design(
            o.Persidskii([[-1.0]], None, None, "sin", [1.0], None, [1.0]),
            "driven",
            generator=OTHER,
            Pi=[[1.0]],
            decay=0.0,
        ),
    ],
)
def test_no_proof_for_one_f_speaks_of_another(prove: Any) -> None:
    with pytest.raises(ParameterError, match="has an f of its own, cube, and the plant") as refused:
        prove()
    assert refused.value.field == "f"


@pytest.mark.parametrize(("name", "value"), [("f", "cube"), ("J", [[0.5, 0.0]])])
def test_a_regulator_of_a_file_has_the_f_and_the_j_of_its_proof(name: str, value: Any) -> None:
    mass = o.Persidskii([[0.0, 1.0], [0.0, 0.0]], [0.0, 1.0], [1.0, 0.0], "sin", [0.0, 1.0], None, [1.0, 0.0])
    file = json.loads(encoded(o.design(mass, "regulator")))
    file["regulator"][name] = value
    with pytest.raises(ParameterError, match=r"an f of its own|J must be H Pi") as refused:
        decoded(json.dumps(file))
    assert refused.value.field == name


def test_j_is_h_pi_also_where_f_cancels() -> None:
    """A1 = 0 and S1 = B L1: the relaxed equalities hold for any J, the proof speaks of J = H Pi."""
    generator = o.Generator([[-2.0]], [1.0], [0.5], None, [-1.0], [1.0])
    with pytest.raises(ParameterError, match="J must be H Pi"):
        o.design(PLANT, "driven", generator=generator, Pi=[[1.0]], decay=0.0)


MOTOR = Persidskii(
    [[0.0, 1.0, 0.0], [0.0, -0.5, 4.0], [0.0, -0.2, -8.0]], None, None, "sin", [0.0, 0.0, 2.0], None,
    [1.0, 0.0, 0.0],
)  # fmt: skip


CART = Persidskii([[0.0, 1.0], [0.0, 0.0]], None, None, "sin", C0=[1.0, 0.0])


def edge() -> MatrixInequalities:
    problem = MatrixInequalities("edge").positive("P", 2)
    return problem.above("P - 2", lambda v: v.P - 2.0 * np.eye(2), strict=False)


def test_a_margin_of_zero_is_for_prints_and_searches_only() -> None:
    values = {"P": 2.0 * np.eye(2)}
    assert edge().check(values)["P - 2"] == 0.0
    with pytest.raises(CertificateError, match=r"P - 2 has the eigenvalue 0, must lie above 0"):
        edge().check(values, printed=False)
    slightly = {"P": np.diag([2.0, 2.0 - 1e-12])}
    edge().check(slightly)
    with pytest.raises(CertificateError, match=r"P - 2 has the eigenvalue -1\.\d*e-12"):
        edge().check(slightly, printed=False)


def test_the_rounding_of_p_m_counts_where_p_is_nearly_singular() -> None:
    """With U = P M as it is computed the inequality holds, with the M that runs it fails in exact numbers."""
    small = 1e-11
    p = np.array([[1.0, 1.0 - small], [1.0 - small, 1.0]])

    def energy(m: float) -> tuple[Fraction, Fraction]:
        """What the gain takes along (1, -1), as it is and as computed."""
        u = [Fraction(float(one)) for one in p @ [m, -m]]
        return 4 * Fraction(m) * (1 - Fraction(float(p[0, 1]))), 2 * (u[0] - u[1])

    gains = np.random.default_rng(8).uniform(0.5, 1.0, 100).tolist()
    m = max(gains, key=lambda one: float(energy(one)[1] / energy(one)[0]))
    theta = float(sum(energy(m)) / 2)
    assert energy(m)[0] < theta < energy(m)[1]
    plant = Persidskii(-small * np.ones((2, 2)), None, None, "sin", C0=[1.0, -1.0])
    values = {"P": p, "Theta": theta * np.eye(2), "Gamma": np.array([[1e14]]), "Xi": 1e14 * np.eye(2)}
    with pytest.raises(CertificateError, match="the LMI has the eigenvalue"):
        interconnected.certified_design(plant, Generator(plant.A0), np.eye(2), [[m], [-m]], values)


def test_no_proof_reaches_beyond_the_rounding_of_the_coefficients() -> None:
    """The slope of P is 0 up to rounding: what it is in truth nobody knows."""
    slope, floor = (np.array([[1.0]]), np.array([[[1e-16]]])), (np.eye(1), -np.ones((1, 1, 1)))
    none, one = np.full(1, -np.inf), np.eye(1)
    problem = Affine([slope, floor], 1, np.zeros(1), one, none, None, [(0, 1)])
    assert 1e12 < reach(problem, [one, 1e-16 * one]) < 1e33
    grown = msgspec.structs.replace(problem, blocks=[(np.array([[1.0]]), np.array([[[1.0]]])), floor])
    assert reach(grown, [one, one]) < 1e17


@pytest.mark.parametrize(
    ("door", "decay"),
    [
        (FullOrderObserver.design, 1e10),
        (ReducedOrderObserver.design, 1e12),
        (ReducedOrderObserver.design, 1e9),
    ],
)
def test_an_observable_plant_is_never_refused_for_every_p(door: Any, decay: float) -> None:
    refused = ""
    try:
        door(MOTOR, decay=decay)
    except InfeasibleError as failure:
        refused = str(failure)
    except UndecidedError:
        pass
    assert "inf" not in refused
    assert "cannot hold" not in refused


def test_an_equality_that_only_rounding_violates_is_undecided() -> None:
    plant = Persidskii(MOTOR.A0, [0.0, -2.0, 0.0], [1.0, 0.0, 0.0], "sin", C0=[1.0, 0.0, 0.0])
    with pytest.raises(UndecidedError, match=r"too large for the arithmetic"):
        ReducedOrderObserver.design(plant, decay=1e9)


def test_a_design_that_fails_its_own_audit_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(*given: Any, **options: Any) -> None:
        raise CertificateError("Theorem 3.2.1: the LMI has the eigenvalue 1, must lie below 0")

    monkeypatch.setattr(interconnected, "certified_design", failing)
    with pytest.raises(UndecidedError, match=r"the LMI has the eigenvalue 1.*require less decay"):
        FullOrderObserver.design(CART)


def test_one_gain_without_a_certificate_refuses_no_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """The audit of a rounded gain seeks a P for this gain alone: that there is none says little."""

    def failing(*given: Any, **options: Any) -> None:
        raise CertificateError("Theorem 3.2.1: the LMI has the eigenvalue 1, must lie below 0")

    def refusing(*given: Any, gain: Any = None, **options: Any) -> Any:
        if gain is not None:
            raise InfeasibleError("no P for this gain")
        return every(*given, gain=gain, **options)

    every = interconnected.driven
    monkeypatch.setattr(interconnected, "certified_design", failing)
    monkeypatch.setattr(interconnected, "driven", refusing)
    with pytest.raises(UndecidedError, match="no P for this gain"):
        FullOrderObserver.design(CART)


def test_a_design_whose_least_bound_fails_its_audit_has_a_larger_one() -> None:
    """A mode that the outputs hardly show: rounding eats the margins of the least bound, not the largest."""
    hidden = Persidskii(
        [[0.924, 0.01, 0.02], [0.064, 0.931, -0.038], [-0.012, -0.014, 1.081]],
        [0.024, 0.005, 0.038],
        [0.049, 0.316, -0.546],
        "tanh",
        C0=[[0.09663, -1.2465, -0.26549], [0.29526, 0.94951, 0.16074]],
        time="discrete",
    )
    design = FullOrderObserver.design(hidden, decay=0.02)
    assert min(design.margins.values()) > 0.0
    assert design.gap == np.inf
    with mpmath.workdps(40):
        a, b, h, c, m, p = (
            mpmath.matrix(np.atleast_2d(one).tolist())
            for one in (hidden.A0, hidden.A1, hidden.H, hidden.C0, design.gain, design.values["P"])
        )
        for slope in (0, 1):
            onward = a + slope * b * h - m * c
            lost = mpmath.exp(-2 * mpmath.mpf("0.02")) * p - onward.T * p * onward
            assert min(mpmath.eigsy((lost + lost.T) / 2, eigvals_only=True)) > 0


def test_the_gap_of_a_file_is_a_claim(capsys: pytest.CaptureFixture[str]) -> None:
    design = FullOrderObserver.design(CART)
    document = json.loads(encoded(design))
    with pytest.raises(ParameterError, match=r"gap must be a number not below 0, .* received -5") as wrong:
        decoded(json.dumps({**document, "gap": -5}))
    assert wrong.value.field == "gap"
    print_audit(design, audit(design))
    assert "as stored, not recomputed" in " ".join(capsys.readouterr().out.split())
    print_design(design)
    assert "not recomputed" not in capsys.readouterr().out
    for stored, shown in ((1e9, None), (11.0, None), (9.5, 9.5), (None, None)):
        claimed = decoded(json.dumps({**document, "gap": stored}))
        assert summary(claimed)["gap"] == shown
        print_audit(claimed, claimed.margins)
        assert ("not known" if shown is None else "950.00%") in capsys.readouterr().out


def plant_of_the_table(door: str, kind: str, seed: int) -> Problem:
    return Problem(kind, np.random.default_rng([zlib.crc32(door.encode()), KINDS.index(kind), seed]))


NEAR_THE_LIMIT = (
    ("`design_observer`", "stiff", 12),
    ("`UnknownInputObserver.design`", "random", 17),
    ("`UnknownInputObserver.design`", "stiff", 9),
)
"""Problems whose first answer fails the audit of the gains that run: which of them, the processor decides."""


def test_a_design_whose_gains_round_too_far_is_searched_again() -> None:
    """One with more room passes the audit; how far it is from the least is then not known."""
    gaps = []
    for problem in NEAR_THE_LIMIT:
        design = DOORS[problem[0]](plant_of_the_table(*problem))
        gaps.append(design.gap if hasattr(design, "gap") else design.certificate.gap)
        assert audit(design)
        assert decoded(encoded(design)) is not None
    assert np.inf in gaps


def test_the_rounding_of_large_terms_off_the_diagonal_is_no_proof() -> None:
    """A0 - M C0 is exactly ((-.001, 1), (-2, -.001)): P S0 - U C0 loses the 1 and the 2 to 2^53."""
    s, m, p = [[-1e-3, 1.0], [2.0**53 - 2.0, -1e-3]], [[0.0], [2.0**53]], np.diag([1.0, 0.7481628719198741])
    plant = o.Persidskii(s, C0=[1.0, 0.0])
    values = {"P": p, "Theta": 1e-3 * p, "Gamma": np.array([[2.0**106 * 1e6]]), "Xi": 1e6 * np.eye(2)}
    with pytest.raises(CertificateError, match="of its terms: that may be rounding"):
        interconnected.certified_design(plant, o.Generator(s), np.eye(2), m, values)


def test_a_fast_discrete_observer_is_not_refused_for_every_p() -> None:
    plant = o.Persidskii([[0.9]], C0=[[1.0]], time="discrete")
    assert o.design(plant, "full", decay=10.0).bound.decay >= 10.0
    # An error that is 0 after one step.
    assert o.design(plant, "full", decay=12.0, gain=[[0.9]]).bound.decay == pytest.approx(12.0)
    with pytest.raises(ParameterError, match="decay must be at most 12 in discrete time, received 20"):
        o.design(plant, "full", decay=20.0)
