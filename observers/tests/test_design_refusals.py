"""What cannot be, told in words that say what to do: one row a refusal; and modes that no output shows."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import signal

import pointpred_observers as o
from observers.tests import kept_designs as kept
from pointpred.errors import InfeasibleError, ParameterError
from pointpred_observers import Generator, Persidskii, thesis
from pointpred_observers.interconnected.design import DrivenObserver, FullOrderObserver
from pointpred_observers.interconnected.regulator import Regulator
from pointpred_observers.plants.linear_systems import as_plant
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import undetectable
from pointpred_observers.triangular.interlaced_observer import certify, output_matrix
from pointpred_observers.unknown_input.observer import UnknownInputObserver

CART, SYMBOLIC = kept.CART, kept.SYMBOLIC
LAG = Persidskii([[-1.0]], None, None, "sin", [1.0], None, [1.0])
VARYING = Persidskii(lambda t: [[-1.0]], [1.0], [1.0], "sin", C0=[1.0])
CUBIC = Persidskii([[0.0, 1.0], [0.0, -1.0]], [0.0, -1.0], [0.0, 1.0], "cube", [0.0, 1.0], None, [1.0, 0.0])
GROWING = Persidskii([[0.0, 0.0], [0.0, 1.0]], None, None, "sin", [1.0, 0.0], None, [1.0, 0.0])
BARE = Persidskii([[-1.0]], None, None, "sin")


def observer(**more: Any) -> Any:
    return o.invariant_observer(CART, **{"Pi": [[0.0, 1.0]], "Upsilon": [[-3.0]], **more})


def steady(*outputs: Any) -> Any:
    system = o.SymbolicSystem((kept.X1, kept.X2), SYMBOLIC.field, kept.U, outputs=outputs)
    return o.interlaced(system, kept.CIRCLE, 1, kept.W1, degree=2)


def unknown_input(a: Any = None, f: Any = None, *, rates: Any = None, time: str = "continuous") -> Any:
    given_a = a or (lambda p: np.diag([-1.0, -2.0 - p["k"]]))
    given_f = f or (lambda p: np.eye(2, 1))
    system = o.ParameterVaryingSystem(given_a, given_f, np.eye(1, 2), rates=rates, time=time)
    return UnknownInputObserver.design(system, o.Box({"k": (0.0, 1.0)}), 0.05)


REFUSED: list[tuple[Callable[[], Any], str]] = [
    (lambda: Persidskii([]), "A0 is empty: a plant needs at least one state"),
    (lambda: Persidskii([[-1.0]], [1.0], f="sin"), "A1 needs H, .* 1 rows of 1 entries"),
    (lambda: Persidskii([[-1.0]], [1.0], [1.0], "sinus"), "f must be a function or one of identity, sin"),
    (lambda: Persidskii([[-1.0]], [1.0], [1.0], "sin", slopes=(1.0, 0.0)), "slopes need low <= high"),
    (lambda: Persidskii([[-1.0]], time="hybrid"), "time must be 'continuous' or 'discrete', .* 'hybrid'"),
    (lambda: Generator(np.zeros((0, 0))), "S0 needs at least one state, received none"),
    (lambda: o.steady_state_map(LAG, Generator([[0.0]], [1.0], L0=[1.0], f="tanh")), "relaxed=True"),
    (lambda: as_plant(signal.TransferFunction([1.0, 0.0], [1.0, 1.0])), "needs D = 0: subtract D u"),
    (lambda: o.c2d(o.c2d(LAG, 0.1), 0.1), "needs a continuous plant"),
    (lambda: o.c2d(VARYING, 0.1), "constant matrices; A0 vary"),
    (lambda: o.c2d(LAG, 0.1, method="tustin"), "method must be 'zoh' or 'euler'"),
    (
        lambda: o.design(BARE, "driven", generator=kept.CONSTANT, Pi=[[1.0]]),
        "give the plant C0 or C1",
    ),
    (lambda: FullOrderObserver.design(CART, decay=0.0), "decay must be finite and above 0, received 0"),
    (lambda: FullOrderObserver.design(CUBIC), "needs bounded slopes"),
    (lambda: ReducedOrderObserver.design(CART, Pi=[[1.0, 0.0]]), "rows of Pi and C0 must be independent"),
    (
        lambda: ReducedOrderObserver.design(Persidskii([[-1.0]], C0=lambda t: [[t]])),
        "; C0 vary",
    ),
    (lambda: thesis.theorem_3_3_1("observer"), "needs an InvariantObserver, or printed matrices"),
    (lambda: thesis.assumption_3_2_2(LAG, Generator([[-2.0]], G=[1.0], L0=[1.0])), "needs Pi"),
    (lambda: thesis.assumption_4_4_2(steady(kept.X2)), "region needs x2"),
    (
        lambda: thesis.assumption_4_4_2(steady(kept.X2), {kept.X2: (1.0, 0.0)}),
        "region needs finite low <= high for x2",
    ),
    (lambda: thesis.regulator_stage(LAG, Generator([[-1.0]], G=[1.0])), "a regulator needs J"),
    (lambda: thesis.regulator_equations(LAG, Generator([[0.0]], G=[1.0])), "generator without G"),
    (lambda: thesis.design_state_feedback(BARE), "needs an input"),
    (lambda: Regulator.design(LAG, reference=Generator([[0.0]])), "together"),
    (
        lambda: Regulator.design(
            LAG, reference=Generator([[0.0]], [1.0], [1.0]), following=([[1.0]], [[1.0]])
        ),
        "a reference is linear",
    ),
    (lambda: output_matrix(steady()), "needs outputs of the system, received none"),
    (lambda: output_matrix(steady(kept.X1)), r"output 1 must be C w with numbers C"),
    (lambda: certify([[0.0]], [[1.0]], decay=-1.0), "decay must be finite and above 0"),
    (lambda: unknown_input(f=lambda p: np.zeros((2, 0))), "F needs a column for each unknown input"),
    (
        lambda: unknown_input(f=lambda p: np.array([[0.0], [1.0]])),
        r"rank\(C F\) = 0 < rank\(F\) = 1",
    ),
    (lambda: unknown_input(f=lambda p: np.array([[1.0], [p["k"]]])), "F varies with k: its rate must be"),
    (
        lambda: unknown_input(f=lambda p: np.array([[1.0], [p["k"]]]), rates={"k": "dk"}),
        "needs the axis dk",
    ),
    (
        lambda: unknown_input(lambda p: np.diag([-1.0, p["z"]])),
        "needs the variable 'z', the box has k",
    ),
    (lambda: unknown_input(lambda p: np.diag([-1.0, p["k"] ** 2 - 3.0])), "must be affine in each variable"),
    (lambda: unknown_input(rates={"k": "dk"}, time="discrete"), "needs no rates"),
    (lambda: kept.design("unknown input").stage(np.zeros(2), noise=1.0), "noise and density come together"),
    (lambda: o.Box({"a": (1.0, 0.0)}), "a needs low <= high"),
    (lambda: o.Box({f"p{i}": (0.0, 1.0) for i in range(13)}), "at most 12 axes with a width, received 13"),
    (lambda: o.Box({"a": (0.0, 1.0), "b": (0.0, 1.0)}).weights({"a": 0.5}), "a point needs a, b, received a"),
    (lambda: MatrixInequalities("empty").positive("P", 1).solve(), "at least one inequality"),
    (
        lambda: MatrixInequalities("b").positive("P", 2).below("a", lambda v: v.P @ v.P).solve(),
        "a must be affine",
    ),
    (lambda: o.audit(CART), "an audit needs a design with a certificate, received"),
    (lambda: o.persistent_excitation([0.0, 1.0], [[1.0], [1.0]], 1.5), r"window must lie in \(0, 1\].*1.5"),
    (lambda: o.RecursiveLeastSquares(2, start=[0.0, 0.0]), "start needs a ridge above 0"),
]


@pytest.mark.parametrize(("call", "told"), REFUSED)
def test_what_cannot_be_says_what_to_do(call: Callable[[], Any], told: str) -> None:
    with pytest.raises(ParameterError, match=told):
        call()


INFEASIBLE: list[tuple[Callable[[], Any], str]] = [
    (lambda: ReducedOrderObserver.design(GROWING), "not detectable: the mode of the eigenvalue 1"),
    (lambda: FullOrderObserver.design(GROWING), r"^\(A0, C0\) is not detectable"),
    (
        lambda: FullOrderObserver.design(
            Persidskii([[0.0, 0.0], [0.0, -1.0]], [0.0, 1.0], [0.0, 1.0], "tanh", C0=[0.0, 1.0])
        ),
        r"^\(A0 \+ A1 D H, C0 \+ C1 D H\), D = diag\(0\), is not detectable",
    ),
    (lambda: thesis.design_state_feedback(GROWING), "no input moves the mode of the eigenvalue 1"),
    (lambda: thesis.certify_convergence(observer(), decay=50.0), "Theorem 3.3.1"),
]


@pytest.mark.parametrize(("call", "told"), INFEASIBLE)
def test_what_no_choice_makes_possible_is_named(call: Callable[[], Any], told: str) -> None:
    with pytest.raises(InfeasibleError, match=told):
        call()


@given(st.integers(0, 2**31), st.sampled_from(["continuous", "discrete"]))
@settings(max_examples=25)
def test_undetectable_modes_are_those_of_the_hidden_block(seed: int, time: str) -> None:
    rng = np.random.default_rng(seed)
    seen, hidden = rng.normal(size=(2, 2)), np.array([[0.9, 0.7], [-0.7, 0.9]])
    whole = np.block([[seen, np.zeros((2, 2))], [rng.normal(size=(2, 2)), hidden]])
    turn = np.linalg.qr(rng.normal(size=(4, 4)))[0]
    c = np.array([[1.0, 0.4, 0.0, 0.0]])
    found = undetectable(turn @ whole @ turn.T, c @ turn.T, time)
    assert sorted(one.imag for one in found) == pytest.approx([-0.7, 0.7], abs=1e-6)
    assert undetectable(turn @ whole @ turn.T, np.eye(4), time) == []


def test_a_hidden_mode_is_named_before_any_solver(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "cvxpy", None)
    s0 = [[0.0, 3.0], [-3.0, 0.0]]
    plant = Persidskii(s0, None, None, "sin", C0=[0.0, 0.0])
    with pytest.raises(InfeasibleError, match=r"the mode of the eigenvalue 0[+-]3j never shows"):
        DrivenObserver.design(plant, generator=Generator(s0), Pi=np.eye(2), decay=0.0)


def test_a_mode_that_only_one_slope_hides_is_refused_patiently() -> None:
    """Near a slope of 0.09 the output does not show a mode of -0.07 1/s, so that no gain makes it faster."""
    plant = Persidskii(
        [
            [0.038, -0.164, 0.294, -0.08],
            [0.119, -0.09, 0.074, -0.668],
            [0.087, 0.002, -0.083, 0.402],
            [-0.07, 0.263, -0.458, -0.357],
        ],
        [0.016, -0.422, -0.057, -0.524],
        [0.285, -0.441, -0.093, -0.707],
        "tanh",
        C0=[0.776, -0.744, 1.406, -0.454],
    )
    with pytest.raises(InfeasibleError, match="no choice satisfies the inequalities"):
        FullOrderObserver.design(plant, decay=0.5)


def test_infeasible_is_said_where_no_single_gain_serves_all_slopes() -> None:
    # Each corner is detectable alone; f swaps the sign with which the state shows in the output.
    plant = Persidskii([[1.0]], [[0.0]], [[1.0]], "sin", C1=[[1.0]])
    with pytest.raises(InfeasibleError, match="no choice satisfies the inequalities"):
        DrivenObserver.design(plant, generator=Generator([[1.0]], [[0.0]]), Pi=[[1.0]], decay=0.0)


@pytest.mark.parametrize(
    ("plant", "pi", "told"),
    [
        (Persidskii([[-1.0]], [1.0], [1.0], "cube", C0=[1.0]), [[1.0]], "a design needs bounded slopes"),
        (Persidskii([[-1.0]], [1.0], [1.0], np.sin, C0=[1.0]), [[1.0]], "a design needs slopes"),
        (VARYING, [[1.0]], "A0 vary: use plant.at"),
        (Persidskii([[-1.0]], [1.0], [1.0], "sin", C0=[1.0]), [[1.0, 2.0]], r"Pi has shape \(1, 2\)"),
        (Persidskii([[-1.0]], [1.0], [1.0], "sin", C0=[1.0]), [[2.0]], "J must be H Pi, differs by 1"),
        (
            Persidskii([[-1.0]], np.ones((1, 9)), np.ones((9, 1)), "sin", C0=[1.0]),
            [[1.0]],
            "at most 8 components",
        ),
    ],
)
def test_designs_that_cannot_start(plant: Persidskii, pi: Any, told: str) -> None:
    generator = Generator([[-1.0]], np.ones((1, plant.k)), J=np.ones((plant.r, 1)))
    with pytest.raises(ParameterError, match=told):
        DrivenObserver.design(plant, generator=generator, Pi=pi, decay=0.0)


@pytest.mark.parametrize("scale", [1e-8, 1.0, 1e8])
@pytest.mark.parametrize("shown", [1e-8, 1.0, 1e8])
def test_detectable_is_detectable_in_every_unit(scale: float, shown: float) -> None:
    a = scale * np.array([[1.0, 1.0], [0.0, -2.0]])
    assert undetectable(a, [[shown, 0.0]]) == []
    assert undetectable(a.T, [[0.0, shown]]) == []
    hidden = undetectable(scale * np.diag([1.0, -2.0]), [[0.0, shown]])
    assert [one / scale for one in hidden] == pytest.approx([1.0 + 0.0j])


MOTOR = [[0.0, 1.0, 0.0], [0.0, -1.0, 5.0], [0.0, -5.0, -100.0]]


@pytest.mark.parametrize(("factor", "decay"), [(1.0, 1e20), (1.0, 1e300), (1e298, 5.0), (1e-300, 5.0)])
@pytest.mark.parametrize("door", [ReducedOrderObserver.design, FullOrderObserver.design, Regulator.design])
def test_numbers_that_cannot_be_computed_with_are_refused(door: Any, factor: float, decay: float) -> None:
    plant = Persidskii(factor * np.array(MOTOR), None, None, "sin", [0.0, 0.0, 100.0], None, [1.0, 0.0, 0.0])
    # at 1e20 1/s some processors still compute, and prove that no matrices of a size that floats hold will do
    proved = InfeasibleError if decay == 1e20 else ParameterError
    with pytest.raises((ParameterError, proved), match=r"too many powers of ten apart|no choice satisfies"):
        door(plant, decay=decay)
