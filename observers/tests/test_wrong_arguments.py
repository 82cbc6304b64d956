"""Every public door with each of its arguments wrong in turn: an error of pointpred's own, or an answer."""

from __future__ import annotations

from contextlib import suppress
from functools import partial
from typing import Any

import numpy as np
import pytest

import pointpred_observers as o
from observers.tests import kept_designs as kept
from pointpred.errors import ParameterError, PointpredError
from pointpred_observers import thesis
from pointpred_observers.interconnected.design import DrivenObserver, FullOrderObserver
from pointpred_observers.interconnected.persidskii_stage import MissingInputs, PersidskiiStage
from pointpred_observers.interconnected.regulator import Regulator
from pointpred_observers.plants.linear_systems import as_plant
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver
from pointpred_observers.triangular.interlaced_observer import certify as certify_interlaced
from pointpred_observers.unknown_input.observer import UnknownInputObserver

X1, X2, U, W1, W2, CIRCLE = kept.X1, kept.X2, kept.U, kept.W1, kept.W2, kept.CIRCLE
PLANT, GENERATOR, PI = kept.DRIVEN, kept.CONSTANT, [[1.0], [2.0]]
SMALL = o.Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0])
TRACKED = o.Generator([[-3.0]], [-2.0], [[1.0]], [2.0], [0.0], [-1.0])
SYSTEM = o.SymbolicSystem((X1, X2), (-X1 + X2**2, -X2 + U), U, outputs=(X2,))
STEADY = o.interlaced(SYSTEM, CIRCLE, 1, W1, degree=2)
REDUCED = o.design(PLANT, "reduced")
BOX = o.Box({"k": (-3.0, -1.0)})
VARYING = o.ParameterVaryingSystem(
    lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]), [[1.0], [0.0]], np.eye(1, 2)
)
ERRORS = REDUCED.error_system()
REGULATED = {"plant": SMALL, "regulator": TRACKED, "Pi": [[1.0]]}
CHAIN = o.SymbolicSystem((X1, X2), (X2, (2 + X1) * U), U)

ROW, NONE = [[0.0, 1.0]], np.zeros(0)
REGION = {W1: (-1, 1), W2: (-1, 1)}
SQUARE = {"a": np.eye(2), "f": np.eye(2, 1), "c": np.eye(1, 2)}
FOLLOWED = {"system": SYSTEM, "generator": CIRCLE, "maps": STEADY.maps, "input": STEADY.input}
STAGE = {"N": [[-1.0]], "L": [1.0], "J": [[1.0]], "K": [1.0]}
RUN = {"plant": PLANT, "observer": REDUCED, "times": [0.0, 0.01, 0.02], "disturbance": [0.0, 0.0]}
ERROR = {"A": [[[-3.0]]], "B": [[[1.0]]], "C": [[1.0]]}
TURNING = np.column_stack([np.cos(np.arange(8.0)), np.sin(np.arange(8.0))])
WRONG: list[Any] = [
    None,
    "text",
    np.nan,
    1.0 + 2.0j,
    [],
    {"a": 1},
    [[1.0, 2.0, 3.0]],
    [["a"]],
    [[1.0], [2.0, 3.0]],
    np.zeros((0, 0)),
    PLANT,
]
DOORS: list[partial[Any]] = [
    partial(o.Persidskii, **SMALL.matrices(0.0), f="tanh", slopes=(0, 1), time="continuous", domain=1.0),
    partial(o.Generator, S0=[[0.0]], S1=[0.0], J=[1.0], G=[1.0], L0=[1.0], L1=[1.0], E=[1.0], f="sin"),
    partial(o.steady_state_map, plant=PLANT, generator=GENERATOR, relaxed=False, times=None, tolerance=1e-9),
    partial(thesis.residuals, plant=PLANT, generator=GENERATOR, Pi=PI),
    partial(DrivenObserver.design, plant=PLANT, generator=GENERATOR, Pi=PI, gain=[[2.0]], decay=1.0),
    partial(thesis.theorem_3_2_1, plant=PLANT, generator=GENERATOR, Pi=PI, F=None),
    partial(thesis.theorem_3_2_2, **REGULATED),
    partial(thesis.theorem_3_2_3, **REGULATED, sector=None),
    partial(thesis.assumption_3_2_2, plant=PLANT, generator=GENERATOR, Pi=PI, decay=0.5),
    partial(thesis.assumption_3_2_3, **REGULATED),
    partial(thesis.assumption_4_4_2, steady=STEADY, region={X2: (-1, 1)}, decay=0.5),
    partial(thesis.certify_tracking, **REGULATED, sector=None, tolerance=1e-6),
    partial(thesis.closed_loop, plant=SMALL, regulator=TRACKED, t=0.0, both=np.zeros(2), rho=None),
    partial(thesis.sector_bounds, plant=PLANT, Sigma1=[[1.0, 0.0], [0.0, 0.0]]),
    partial(ReducedOrderObserver.design, plant=PLANT, Pi=[[0.0, 1.0]], decay=1.0),
    partial(o.invariant_observer, plant=PLANT, Pi=ROW, Upsilon=[[0.0]], B=None, injection=True, rates=None),
    partial(REDUCED.stage, start=[0, 0], step_s=1e-2),
    partial(thesis.certify_convergence, observer=REDUCED.observer, decay=0.5, gamma=0.5, times=[0.0]),
    partial(thesis.theorem_3_3_1, observer=REDUCED.observer, slopes=(0, 1), gamma=1.0, F=None, times=None),
    partial(thesis.theorem_3_3_2, observer=REDUCED.observer, slopes=(0, 1), gamma=1.0, times=None),
    partial(thesis.theorem_4_4_1, a=[[0.0]], c=[[1.0]]),
    partial(certify_interlaced, a=[[0.0]], c=[[1.0]], decay=0.5, gain=[[1.0]]),
    partial(thesis.undetectable, A=[[0.0]], C=[[1.0]], time="continuous"),
    partial(o.invariant_zeros, **SQUARE),
    partial(o.invariant_zeros, a=VARYING, f=BOX),
    partial(o.Box, bounds={"k": (0.0, 1.0)}),
    partial(
        o.ParameterVaryingSystem, **SQUARE, rates=None, decoupled=None, sizes=[1.0, 1.0], time="discrete"
    ),
    partial(UnknownInputObserver.design, plant=VARYING, box=BOX, decay=0.5, output_decay=5.0),
    partial(o.interlaced, system=CHAIN, generator=CIRCLE, upper=0, first=W1, zero=None, region=REGION),
    partial(o.interlaced, system=SYSTEM, generator=CIRCLE, upper=1, first=W1, degree=2, region=None),
    partial(o.SymbolicGenerator, states=(W1, W2), field=(W2, -W1)),
    partial(o.SymbolicSystem, states=(X1, X2), field=(-X1, U), input=U, zero=(), outputs=(X1,)),
    partial(InterlacedObserver.design, plant=STEADY, decay=0.3, gain=[[1.0], [0.0]], start=[0, 0], gap_s=1.0),
    partial(thesis.check_steady_state, **FOLLOWED, zero=(), degree=None),
    partial(o.c2d, system=PLANT, step_s=0.1, method="zoh"),
    partial(as_plant, system=PLANT),
    partial(o.l2_gain, system=ERRORS),
    partial(o.certify_decay, system=ERRORS, decay=0.5),
    partial(thesis.design_state_feedback, plant=PLANT, decay=1.0, L1=[[0.0]]),
    partial(Regulator.design, plant=SMALL, observer_decay=1.0, L1=[[0.0]], reference=None, following=None),
    partial(thesis.regulator_equations, plant=PLANT, generator=GENERATOR, following=([[1.0, 0.0]], [[1.0]])),
    partial(o.stage, observer=o.design(PLANT, "driven", generator=GENERATOR, Pi=PI, decay=0.0), step_s=0.1),
    partial(o.design, plant=PLANT, kind="full", decay=1.0),
    partial(thesis.regulator_stage, plant=SMALL, regulator=TRACKED, start=[0]),
    partial(
        PersidskiiStage,
        **STAGE,
        f="tanh",
        time="continuous",
        missing=MissingInputs.expected([[0.0]], [[0.0]], 1),
    ),
    partial(
        o.trajectory, field=lambda t, x: -x, start=[1.0], times=[0.0, 0.1], time="continuous", step_s=0.1
    ),
    partial(o.simulate, **RUN, start=[1.0, 1.0], estimate=[0.0, 0.0], input=[1.0], noise=0.1, seed=1),
    partial(FullOrderObserver.design, plant=PLANT, decay=1.0, gain=[[3.0], [0.0]]),
    partial(o.CornerSystem, box=BOX, A=[[-1.0]], F=[[1.0]], C=[[1.0]], rates={}, sizes=[1.0]),
    partial(o.audit, observer=REDUCED),
    partial(o.GradientRegressor, count=2, outputs=1, gain=1.0, time="discrete", start=[0.0, 0.0]),
    partial(o.NonlinearRegressor, count=2, gain=1.0, f="atan", start=[0.0, 0.0]),
    partial(o.RecursiveLeastSquares, count=2, ridge=1.0, start=[0.0, 0.0]),
    partial(o.persistent_excitation, t=[0.0, 1.0], signal=np.eye(2), window=0.5),
    partial(thesis.regression_margin, t=np.arange(8.0), regressor=TURNING, weight=np.zeros(8), gain=1.0),
    partial(o.ErrorSystem, **ERROR, names=[""], disturbances={"d": 1}, time="continuous"),
]


SLOW = {
    ReducedOrderObserver.design,
    Regulator.design,
    InterlacedObserver.design,
    thesis.design_state_feedback,
    thesis.certify_convergence,
    thesis.assumption_4_4_2,
}
"""Doors that take more than a second for all their arguments."""
CASES = [
    pytest.param(one, id=one.func.__qualname__, marks=[pytest.mark.slow] if one.func in SLOW else [])
    for one in DOORS
]


@pytest.mark.parametrize("door", CASES)
def test_no_argument_leads_to_a_raw_error(door: partial[Any]) -> None:
    door()
    for name in door.keywords:
        for value in WRONG:
            with suppress(PointpredError):
                door(**{name: value})


HUGE = 10**400
LINEAR = o.Persidskii([[0.0, 1.0], [0.0, 0.0]], B=[0.0, 1.0], C0=[1.0, 0.0])
DIAGONAL = {"A": -np.eye(2), "F": np.eye(2, 1)}


def follow(reference: Any) -> Any:
    return o.design(LINEAR, "regulator", reference=reference, following=([[1.0, 0.0]], [[1.0]]))


NAMED: list[tuple[str, Any]] = [
    ("A0", lambda: o.Persidskii([[HUGE]])),
    ("decay", lambda: o.design(LINEAR, decay=HUGE)),
    ("start", lambda: o.simulate(**RUN | {"start": [HUGE, 1.0]})),
    ("signal", lambda: o.persistent_excitation([0.0, 1.0], [[HUGE], [1.0]], 0.5)),
    ("k", lambda: o.Box({"k": (0.0, HUGE)})),
    ("slopes", lambda: o.Persidskii([[-1.0]], [1.0], [1.0], "sin", slopes=(0.0, HUGE))),
    ("gain", lambda: o.GradientRegressor(2, gain=HUGE)),
    ("reference", lambda: follow("x")),
    ("reference", lambda: follow(LINEAR)),
    ("noise", lambda: o.simulate(**RUN | {"disturbance": None, "noise": [[1, 2], [3]]})),
    ("field", lambda: o.trajectory(lambda t, x: "x", [1.0], [0.0, 1.0])),
    ("field", lambda: o.trajectory(lambda t, x: [1.0, 2.0], [1.0], [0.0, 1.0], time="discrete")),
    (
        "domain",
        lambda: o.ErrorSystem(**ERROR, names=[""], disturbances={"d": 1}, time="discrete", domain=NONE),
    ),
    ("relaxed", lambda: o.steady_state_map(PLANT, GENERATOR, relaxed=NONE)),
    ("injection", lambda: o.invariant_observer(PLANT, ROW, [[0.0]], injection=NONE)),
    ("estimate", lambda: o.stage(kept.design("regulator"), estimate=NONE)),
    ("C", lambda: o.CornerSystem(BOX, **DIAGONAL, C="1")),
]


@pytest.mark.parametrize(("field", "call"), NAMED)
def test_a_wrong_argument_is_named(field: str, call: Any) -> None:
    with pytest.raises(ParameterError) as refused:
        call()
    assert refused.value.field == field


def test_matrices_and_regions_in_the_forms_that_people_write() -> None:
    fixed = o.ParameterVaryingSystem([[-1.0, 1.0], [0.0, -2.0]], [[1.0], [0.0]], [[1.0, 0.0]])
    assert UnknownInputObserver.design(fixed, o.Box({"any": (0.0, 1.0)}), 0.5).certificate.margin > 0.0
    for region in ({W1: (-1.0, 1.0), "w2": (-1.0, 1.0)}, [(-1.0, 1.0), (-1.0, 1.0)]):
        assert o.interlaced(CHAIN, CIRCLE, 0, W1, region=region).exact
    with pytest.raises(ParameterError, match="region needs w2, received"):
        o.interlaced(CHAIN, CIRCLE, 0, W1, region={W1: (-1.0, 1.0)})
