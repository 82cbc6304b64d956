"""What a reduced-order design refuses, and that it says why."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred.errors import InfeasibleError, ParameterError
from pointpred_observers import Persidskii, invariant_observer
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import certify_convergence

OPEN = Persidskii(np.diag([-1.0, -2.0, -3.0, -4.0]), None, None, "sin", C0=np.eye(2, 4))
PI = np.eye(4)[2:]
LOST = Persidskii([[0.0, 0.0], [0.0, 1.0]], None, None, "sin", C0=[1.0, 0.0])
REFUSED: list[tuple[Any, type, str]] = [
    (
        lambda: ReducedOrderObserver.design(LOST),
        InfeasibleError,
        "not detectable: the mode of the eigenvalue 1",
    ),
    (
        lambda: ReducedOrderObserver.design(OPEN, Pi=PI, decay=0.0),
        ParameterError,
        "decay must be finite and above 0",
    ),
    (
        lambda: ReducedOrderObserver.design(OPEN, Pi=np.eye(2, 4)),
        ParameterError,
        "rows of Pi and C0 must be independent",
    ),
    (
        lambda: ReducedOrderObserver.design(Persidskii(-np.eye(2), None, None, "sin", C0=np.eye(2))),
        ParameterError,
        "nothing to observe",
    ),
    (
        lambda: ReducedOrderObserver.design(
            Persidskii(-np.eye(2), None, None, "sin", C0=[1.0, 0.0], Q=lambda t: [t, t])
        ),
        ParameterError,
        "a design needs constant matrices; Q vary",
    ),
    (
        lambda: certify_convergence(invariant_observer(LOST, [[0.0, 1.0]], [[0.0]]), gamma=-1.0),
        ParameterError,
        "gamma must be finite and above 0, received -1",
    ),
    (
        lambda: certify_convergence(
            invariant_observer(
                Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", C0=[1.0, 0.0]),
                [[0.0, 1.0]],
                [[-3.0]],
            ),
            decay=50.0,
        ),
        InfeasibleError,
        "Theorem 3.3.1",
    ),
]


@pytest.mark.parametrize(("call", "kind", "message"), REFUSED)
def test_what_cannot_be_certified_is_told_why(call: Any, kind: type, message: str) -> None:
    with pytest.raises(kind, match=message):
        call()
