"""Audits of printed maps, observers and steady states: the examples of the thesis, right and as printed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import solve_sylvester

from observers.tests.printed import check_map, check_observer
from pointpred.errors import CertificateError, ParameterError
from pointpred_observers import Generator, Persidskii, invariant_observer
from pointpred_observers.examples import (
    UNMEASURED,
    Bioreactor,
    academic,
    chua_circuits,
    interlaced_states,
    two_masses,
)
from pointpred_observers.thesis import check_steady_state, theorem_3_3_1, theorem_3_3_2

sp = pytest.importorskip("sympy")
W1, W2, X1 = sp.symbols("w1 w2 x1")
EIGHT, CIRCLE = interlaced_states()
PI1 = sp.Rational(1, 40) * (W1**3 - 7 * W2**3 - 9 * W1**2 * W2 + 7 * W1 * W2**2)
MAPS = (PI1, W1 / 2 - W2 / 2, W1, W2 + W1**3)
INPUT = (W1**3 + 3 * W1**2 * W2 - W1 + W2) / (1 + W1**2)


def test_the_printed_maps_of_examples_1_2_and_4_are_right() -> None:
    plant, generator = academic()
    assert max(check_map(plant, generator, [[-0.5, 0.0], [0.0, -0.5], [1.5, 0.5]]).values()) == 0.0
    with pytest.raises(CertificateError, match=r"A0 Pi .* = 0 fails, its residual is 2, nothing is rounded"):
        check_map(plant, generator, [[-0.5, 0.0], [0.0, -0.5], [1.5, -0.5]])
    reactor = Bioreactor()
    rounded = reactor.printed_map.round(3)
    assert (
        max(check_map(reactor.plant, reactor.generator, rounded, relaxed=True, rounding=5e-4).values()) > 1e-6
    )
    with pytest.raises(CertificateError, match=r"entries rounded by 5e-05 explain at most"):
        check_map(reactor.plant, reactor.generator, rounded, relaxed=True, rounding=5e-5)
    assert max(check_map(*chua_circuits(), np.eye(3)).values()) < 1e-13


def test_what_rounding_explains_is_what_it_does() -> None:
    """Random errors of the entries never exceed what the audit allows, and come close to it."""
    rng = np.random.default_rng(5)
    a, b, s = (
        rng.normal(size=(3, 3)) - 3.0 * np.eye(3),
        rng.normal(size=(3, 1)),
        np.array([[0.0, 1.0], [-1.0, 0.0]]),
    )
    plant, generator = Persidskii(a, None, None, "sin", b), Generator(s, L0=rng.normal(size=(1, 2)))
    pi = solve_sylvester(a, -s, -b @ generator.L0)
    size, worst = 1e-3, 0.0
    allowed = max(float((np.abs(a) @ np.ones((3, 2)) + np.ones((3, 2)) @ np.abs(s)).max() * size), 0.0)
    for _ in range(200):
        moved = pi + size * rng.choice([-1.0, 1.0], size=pi.shape)
        worst = max(worst, *check_map(plant, generator, moved, rounding=size).values())
    assert 0.5 * allowed < worst <= allowed * (1.0 + 1e-9)


def test_the_printed_observer_of_example_5_is_right_for_the_corrected_plant() -> None:
    printed = {
        "S0": [[0.0, 1.0], [-3.6, -2.6]],
        "S1": [0.0, 3.0],
        "J": [-1.0, 0.0],
        "O": [[0.0, 0.0], [1.0, 0.0]],
    }
    upsilon = [[-1.0, 0.0], [0.0, 0.0]]
    assert max(check_observer(two_masses(), UNMEASURED, upsilon, printed).values()) < 1e-12
    a0 = two_masses().A0.copy()
    a0[3, 3] = 0.6 - 2.0
    wrong = Persidskii(a0, two_masses().A1, two_masses().H, "cube", Q=two_masses().Q, C0=np.eye(2, 4))
    with pytest.raises(CertificateError, match=r"S0 Z \+ B C0 - Z A0 = 0 fails, its residual is 1\.2"):
        check_observer(wrong, UNMEASURED, upsilon, printed)


@pytest.mark.parametrize("name", ["S0", "S1", "J", "B", "O"])
def test_each_printed_matrix_is_audited(name: str) -> None:
    plant, upsilon = two_masses(), [[-1.0, 0.0], [0.0, 0.0]]
    now = invariant_observer(plant, UNMEASURED, upsilon).at(0.0)
    printed = {one: getattr(now, one).copy() for one in ("S0", "S1", "J", "B", "O")}
    assert max(check_observer(plant, UNMEASURED, upsilon, printed).values()) < 1e-12
    printed[name][-1, -1] += 0.01
    with pytest.raises(CertificateError, match=f"{name} "):
        check_observer(plant, UNMEASURED, upsilon, printed)
    assert max(check_observer(plant, UNMEASURED, upsilon, printed, rounding=0.011).values()) > 1e-3


def test_printed_observers_that_cannot_be_audited() -> None:
    plant = Persidskii([[-1.0]], [1.0], [1.0], "sin", C0=[1.0], C1=[[1.0]])
    with pytest.raises(ParameterError, match="S1 depends on B where C1 is not 0"):
        check_observer(plant, [[1.0]], None, {"S1": [1.0]})
    with pytest.raises(ParameterError, match="printed may hold S0, S1, J, B, O, received S2"):
        check_observer(plant, [[1.0]], None, {"S2": [[1.0]]})
    with pytest.raises(ParameterError, match="received nothing"):
        check_observer(plant, [[1.0]], None, {})
    with pytest.raises(ParameterError, match=r"S0 has shape \(1, 2\)"):
        check_observer(plant, [[1.0]], None, {"S0": [[1.0, 2.0]]})


def test_a_printed_s0_is_audited_by_the_theorems_of_section_3_3() -> None:
    printed = {"S0": [[-4.0]], "S1": [[1.0]], "J": [[1.0]]}
    values = {"P": 1.0, "Xi": 1.0, "W": 1.0}
    margins = theorem_3_3_1(printed, [(0.0, 1.0)], 1.0).check(values)
    assert margins["the inequality"] == pytest.approx(8.0 - 1.0 - 1.0 - 2.0)
    step = {"S0": [[0.5]], "S1": [[0.1]], "J": [[1.0]]}
    found = theorem_3_3_2(step, [(-1.0, 1.0)]).solve().values
    assert theorem_3_3_2(step, gamma=1.0).check(found)["P > 0"] > 0.0
    with pytest.raises(ParameterError, match="J has 0 rows, needs 1"):
        theorem_3_3_1({"S0": [[-4.0]], "S1": [[1.0]]}, [(0.0, 1.0)])
    with pytest.raises(ParameterError, match="received S2, S0"):
        theorem_3_3_1({"S2": [[-4.0]], "S0": [[1.0]]})
    with pytest.raises(ParameterError, match="needs an InvariantObserver, or printed matrices"):
        theorem_3_3_1("observer")
    with pytest.raises(ParameterError, match="slopes must be"):
        theorem_3_3_1(printed, "steep")


def test_example_8_as_corrected_and_as_printed() -> None:
    assert check_steady_state(EIGHT, CIRCLE, MAPS, INPUT).exact
    with pytest.raises(CertificateError, match=r"x3' leaves .*; x4' leaves"):
        check_steady_state(EIGHT, CIRCLE, (*MAPS[:3], W2 + W1**2), INPUT)
    with pytest.raises(CertificateError, match=r"fails: x4' leaves w1\*\*3 \+ w2$"):
        check_steady_state(EIGHT, CIRCLE, MAPS, (-W1 + 3 * W1**2 * W2) / (1 + W1**2))


def test_a_truncated_series_holds_up_to_its_degree() -> None:
    series = sp.series(INPUT.subs(W2, 0), W1, 0, 4).removeO() + W2 + 3 * W1**2 * W2 - W1**2 * W2
    found = check_steady_state(EIGHT, CIRCLE, MAPS, series, degree=3)
    assert not found.exact
    assert found.degree == 3
    with pytest.raises(CertificateError, match="x4' leaves"):
        check_steady_state(EIGHT, CIRCLE, MAPS, series, degree=5)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((MAPS[:3], INPUT), "needs 4 maps and 0 of the zero dynamics, received 3 and 0"),
        (((*MAPS[:3], X1), INPUT), "x4 must be a function of the generator"),
        ((MAPS, "w1 +"), "needs an expression"),
        ((3, INPUT), "maps must be a list"),
    ],
)
def test_printed_steady_states_that_cannot_be_read(arguments: Any, message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        check_steady_state(EIGHT, CIRCLE, *arguments)
