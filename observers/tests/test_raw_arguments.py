"""Arguments of the wrong kind: a named error, never what Python says of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from pointpred.errors import ParameterError
from pointpred_observers import Generator, Persidskii, invariant_observer
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.plants.boxes import Box
from pointpred_observers.plants.varying import ParameterVaryingSystem
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import certify_tracking, undetectable
from pointpred_observers.triangular.interlaced_observer import certify
from pointpred_observers.unknown_input.observer import UnknownInputObserver

PLANT = Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", C0=[1.0, 0.0])
DRIVEN = Persidskii([[-1.0]], None, None, "sin", B=[1.0], C0=[1.0])
CONSTANT = Generator([[0.0]], L0=[1.0])
WRONG: list[Any] = ["fast", 1.0 + 1.0j, None, True, np.nan, np.inf, -1.0]


def unknown_input(columns: int = 1, axis: str = "k", decay: Any = 0.05, **more: Any) -> Any:
    system = ParameterVaryingSystem(
        lambda p: np.diag([-1.0, -2.0 - p["k"]]), lambda p: np.eye(2, columns), np.eye(1, 2)
    )
    return UnknownInputObserver.design(system, Box({axis: (0.0, 1.0)}), decay, **more)


NOT_NEEDED = "output_decay must be finite and above 0"
TAKING: dict[str, Callable[[Any], Any]] = {
    "decay must be finite and not below 0": lambda v: DrivenObserver.design(
        DRIVEN, generator=CONSTANT, Pi=[[1.0]], decay=v
    ),
    "decay must be finite and above 0": lambda v: ReducedOrderObserver.design(PLANT, decay=v),
    NOT_NEEDED: lambda v: unknown_input(output_decay=v),
    "decay must be finite and above 0, received": lambda v: certify([[0.0]], [[1.0]], decay=v),
    "tolerance must lie in": lambda v: invariant_observer(PLANT, [[0.0, 1.0]], [[-3.0]], tolerance=v),
}


@pytest.mark.parametrize(
    ("told", "value"),
    [(told, value) for told in TAKING for value in WRONG if value is not None or told != NOT_NEEDED],
)
def test_what_is_no_such_number_is_named(told: str, value: Any) -> None:
    with pytest.raises(ParameterError, match=told):
        TAKING[told](value)


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: undetectable([[1.0]], [[1.0]], time="foo"), "time must be 'continuous' or 'discrete'"),
        (lambda: Generator(np.zeros((0, 0))), "S0 needs at least one state, received none"),
        (lambda: MatrixInequalities("empty").positive("P", 1).solve(), "at least one inequality"),
        (lambda: unknown_input(columns=0), "F needs a column for each unknown input"),
        (lambda: unknown_input(axis="other"), "the system needs the variable 'k', the box has other"),
    ],
)
def test_what_is_missing_is_named(call: Callable[[], Any], told: str) -> None:
    with pytest.raises(ParameterError, match=told):
        call()


@pytest.mark.parametrize("value", WRONG)
def test_the_tolerance_of_tracking_is_a_share(value: Any) -> None:
    with pytest.raises(ParameterError, match="tolerance must lie in"):
        certify_tracking(DRIVEN, CONSTANT, [[1.0]], tolerance=value)


def test_sound_arguments_pass() -> None:
    assert unknown_input().certificate.margin > 0.0
    assert certify_tracking(
        Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0]),
        Generator([[-3.0]], [-2.0], None, [2.0], [0.0], [-1.0]),
        [[1.0]],
    )
