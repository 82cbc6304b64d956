"""Every public door with each of its arguments wrong in turn: an error of pointpred's own, or an answer."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import Any

import numpy as np
import pytest

import pointpred_observers as o
from observers.tests.printed import check_map, check_observer
from pointpred.errors import ParameterError, PointpredError
from pointpred_observers.interconnected.design import DrivenObserver, FullOrderObserver
from pointpred_observers.interconnected.persidskii_stage import PersidskiiStage
from pointpred_observers.interconnected.realisation import MissingInputs
from pointpred_observers.interconnected.regulator import Regulator
from pointpred_observers.plants.linear_systems import as_plant
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import (
    assumption_3_2_2,
    assumption_3_2_3,
    assumption_4_4_2,
    certify_convergence,
    certify_tracking,
    check_steady_state,
    closed_loop,
    design_state_feedback,
    regulator_equations,
    regulator_stage,
    residuals,
    sector_bounds,
    theorem_3_2_1,
    theorem_3_2_2,
    theorem_3_2_3,
    theorem_3_3_1,
    theorem_3_3_2,
    theorem_4_4_1,
    undetectable,
)
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver
from pointpred_observers.triangular.interlaced_observer import certify as certify_interlaced
from pointpred_observers.unknown_input.observer import UnknownInputObserver

sp = pytest.importorskip("sympy")
X1, X2, U, W1, W2 = sp.symbols("x1 x2 u w1 w2")
PLANT = o.Persidskii(
    [[-1.0, 0.5], [0.0, -2.0]], [0.0, -1.0], [1.0, 0.0], "tanh", [0.0, 1.0], None, [1.0, 0.0]
)
GENERATOR = o.Generator([[0.0]], [[0.0]], L0=[[4.0]], L1=[[1.0]])
PI = [[1.0], [2.0]]
SMALL = o.Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0])
TRACKED = o.Generator([[-3.0]], [-2.0], [[1.0]], [2.0], [0.0], [-1.0])
SYSTEM = o.SymbolicSystem((X1, X2), (-X1 + X2**2, -X2 + U), U, outputs=(X2,))
CIRCLE = o.SymbolicGenerator((W1, W2), (W2, -W1))
STEADY = o.interlaced(SYSTEM, CIRCLE, 1, W1, degree=2)
REDUCED = o.design(PLANT, "reduced")
BOX = o.Box({"k": (-3.0, -1.0)})
VARYING = o.ParameterVaryingSystem(
    lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]), [[1.0], [0.0]], np.eye(1, 2)
)
ERRORS = REDUCED.error_system()
REGULATED = {"plant": SMALL, "regulator": TRACKED, "Pi": [[1.0]]}
CHAIN = o.SymbolicSystem((X1, X2), (X2, (2 + X1) * U), U)

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
FLAGS = {"relaxed", "injection"}
"""Arguments whose truth value alone counts."""

DOORS: list[tuple[Callable[..., Any], dict[str, Any]]] = [
    (
        o.Persidskii,
        {
            "A0": [[-1.0]],
            "A1": [1.0],
            "H": [1.0],
            "f": "tanh",
            "B": [1.0],
            "Q": [1.0],
            "C0": [1.0],
            "C1": [[0.0]],
            "slopes": (0, 1),
            "time": "continuous",
            "domain": 1.0,
        },
    ),
    (
        o.Generator,
        {
            "S0": [[0.0]],
            "S1": [0.0],
            "J": [1.0],
            "G": [1.0],
            "L0": [1.0],
            "L1": [1.0],
            "E": [1.0],
            "f": "sin",
        },
    ),
    (
        o.steady_state_map,
        {"plant": PLANT, "generator": GENERATOR, "relaxed": False, "times": None, "tolerance": 1e-9},
    ),
    (residuals, {"plant": PLANT, "generator": GENERATOR, "Pi": PI}),
    (
        DrivenObserver.design,
        {"plant": PLANT, "generator": GENERATOR, "Pi": PI, "gain": [[2.0]], "decay": 1.0},
    ),
    (
        theorem_3_2_1,
        {"plant": PLANT, "generator": GENERATOR, "Pi": PI, "F": None},
    ),
    (theorem_3_2_2, REGULATED),
    (theorem_3_2_3, {**REGULATED, "sector": None}),
    (assumption_3_2_2, {"plant": PLANT, "generator": GENERATOR, "Pi": PI, "decay": 0.5}),
    (assumption_3_2_3, REGULATED),
    (assumption_4_4_2, {"steady": STEADY, "region": {X2: (-1, 1)}, "decay": 0.5}),
    (certify_tracking, {**REGULATED, "sector": None, "tolerance": 1e-6}),
    (
        closed_loop,
        {"plant": SMALL, "regulator": TRACKED, "t": 0.0, "both": np.zeros(2), "rho": None},
    ),
    (sector_bounds, {"plant": PLANT, "Sigma1": [[1.0, 0.0], [0.0, 0.0]]}),
    (
        ReducedOrderObserver.design,
        {"plant": PLANT, "Pi": [[0.0, 1.0]], "decay": 1.0},
    ),
    (
        o.invariant_observer,
        {"plant": PLANT, "Pi": [[0.0, 1.0]], "Upsilon": [[0.0]], "B": None, "injection": True, "rates": None},
    ),
    (REDUCED.stage, {"start": [0, 0], "step_s": 1e-2}),
    (certify_convergence, {"observer": REDUCED.observer, "decay": 0.5, "gamma": 0.5, "times": [0.0]}),
    (
        theorem_3_3_1,
        {"observer": REDUCED.observer, "slopes": (0, 1), "gamma": 1.0, "F": None, "times": None},
    ),
    (theorem_3_3_2, {"observer": REDUCED.observer, "slopes": (0, 1), "gamma": 1.0, "times": None}),
    (theorem_4_4_1, {"a": [[0.0]], "c": [[1.0]]}),
    (certify_interlaced, {"a": [[0.0]], "c": [[1.0]], "decay": 0.5, "gain": [[1.0]]}),
    (undetectable, {"A": [[0.0]], "C": [[1.0]], "time": "continuous"}),
    (o.invariant_zeros, {"a": np.eye(2), "f": np.eye(2, 1), "c": np.eye(1, 2)}),
    (o.invariant_zeros, {"a": VARYING, "f": BOX}),
    (o.Box, {"bounds": {"k": (0.0, 1.0)}}),
    (
        o.ParameterVaryingSystem,
        {
            "a": np.eye(2),
            "f": np.eye(2, 1),
            "c": np.eye(1, 2),
            "rates": None,
            "decoupled": None,
            "sizes": [1.0, 1.0],
            "time": "continuous",
        },
    ),
    (UnknownInputObserver.design, {"plant": VARYING, "box": BOX, "decay": 0.5, "output_decay": 5.0}),
    (
        o.interlaced,
        {
            "system": CHAIN,
            "generator": CIRCLE,
            "upper": 0,
            "first": W1,
            "zero": None,
            "degree": 2,
            "region": {W1: (-1, 1), W2: (-1, 1)},
        },
    ),
    (
        o.interlaced,
        {"system": SYSTEM, "generator": CIRCLE, "upper": 1, "first": W1, "degree": 2, "region": None},
    ),
    (o.SymbolicGenerator, {"states": (W1, W2), "field": (W2, -W1)}),
    (o.SymbolicSystem, {"states": (X1, X2), "field": (-X1, U), "input": U, "zero": (), "outputs": (X1,)}),
    (
        InterlacedObserver.design,
        {"plant": STEADY, "decay": 0.3, "gain": [[1.0], [0.0]], "start": [0, 0], "gap_s": 1.0},
    ),
    (check_map, {"plant": PLANT, "generator": GENERATOR, "Pi": PI, "rounding": 0.1}),
    (
        check_observer,
        {"plant": PLANT, "Pi": [[0.0, 1.0]], "Upsilon": [[0.0]], "printed": {"O": [[1.0]]}, "rounding": 0.1},
    ),
    (
        check_steady_state,
        {
            "system": SYSTEM,
            "generator": CIRCLE,
            "maps": STEADY.maps,
            "input": STEADY.input,
            "zero": (),
            "degree": None,
        },
    ),
    (o.c2d, {"system": PLANT, "step_s": 0.1, "method": "zoh"}),
    (as_plant, {"system": PLANT}),
    (o.l2_gain, {"system": ERRORS}),
    (o.certify_decay, {"system": ERRORS, "decay": 0.5}),
    (design_state_feedback, {"plant": PLANT, "decay": 1.0, "L1": [[0.0]]}),
    (
        Regulator.design,
        {
            "plant": SMALL,
            "decay": 1.0,
            "observer_decay": 1.0,
            "L1": [[0.0]],
            "reference": None,
            "following": None,
        },
    ),
    (regulator_equations, {"plant": PLANT, "generator": GENERATOR, "following": ([[1.0, 0.0]], [[1.0]])}),
    (
        o.stage,
        {"observer": o.design(PLANT, "driven", generator=GENERATOR, Pi=PI, decay=0.0), "step_s": 0.1},
    ),
    (o.design, {"plant": PLANT, "kind": "full", "decay": 1.0}),
    (regulator_stage, {"plant": SMALL, "regulator": TRACKED, "start": [0]}),
    (
        PersidskiiStage,
        {
            "N": [[-1.0]],
            "L": [1.0],
            "J": [[1.0]],
            "K": [1.0],
            "f": "tanh",
            "time": "continuous",
            "missing": MissingInputs.held(1, 1, 1),
        },
    ),
    (
        o.trajectory,
        {"field": lambda t, x: -x, "start": [1.0], "times": [0.0, 0.1], "time": "continuous", "step_s": 0.1},
    ),
    (
        o.simulate,
        {
            "plant": PLANT,
            "observer": REDUCED,
            "times": [0.0, 0.01, 0.02],
            "start": [1.0, 1.0],
            "estimate": [0.0, 0.0],
            "input": [1.0],
            "disturbance": [0.0, 0.0],
            "noise": 0.1,
            "seed": 1,
        },
    ),
    (FullOrderObserver.design, {"plant": PLANT, "decay": 1.0, "gain": [[3.0], [0.0]]}),
    (o.CornerSystem, {"box": BOX, "A": [[-1.0]], "F": [[1.0]], "C": [[1.0]], "rates": {}, "sizes": [1.0]}),
    (o.audit, {"observer": REDUCED}),
]


SLOW = {
    *(ReducedOrderObserver.design, Regulator.design, design_state_feedback, certify_convergence),
    *(assumption_4_4_2, InterlacedObserver.design),
}
"""Doors that take more than a second for all their arguments."""
CASES = [
    pytest.param(door, right, id=door.__qualname__, marks=[pytest.mark.slow] if door in SLOW else [])
    for door, right in DOORS
]


@pytest.mark.parametrize(("door", "right"), CASES)
def test_no_argument_leads_to_a_raw_error(door: Callable[..., Any], right: dict[str, Any]) -> None:
    door(**right)
    for name in right.keys() - FLAGS:
        for value in WRONG:
            with suppress(PointpredError):
                door(**{**right, name: value})


def test_a_plant_without_outputs_is_named() -> None:
    bare = o.Persidskii([[-1.0]], None, None, "sin", B=[1.0])
    with pytest.raises(ParameterError, match="an observer needs an output: give the plant C0 or C1"):
        o.design(bare, "driven", generator=o.Generator([[0.0]], L0=[1.0]), Pi=[[1.0]], decay=0.0)


def test_matrices_and_regions_in_the_forms_that_people_write() -> None:
    fixed = o.ParameterVaryingSystem([[-1.0, 1.0], [0.0, -2.0]], [[1.0], [0.0]], [[1.0, 0.0]])
    assert UnknownInputObserver.design(fixed, o.Box({"any": (0.0, 1.0)}), 0.5).certificate.margin > 0.0
    for region in ({W1: (-1.0, 1.0), "w2": (-1.0, 1.0)}, [(-1.0, 1.0), (-1.0, 1.0)]):
        assert o.interlaced(CHAIN, CIRCLE, 0, W1, region=region).exact
    with pytest.raises(ParameterError, match="region needs w2, received"):
        o.interlaced(CHAIN, CIRCLE, 0, W1, region={W1: (-1.0, 1.0)})
