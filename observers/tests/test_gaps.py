"""What is minimised says how far from the least it may be, at every door that minimises."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred_observers import invariant_observer
from pointpred_observers.camera import camera_box, camera_system
from pointpred_observers.examples import UNMEASURED, academic, chua_circuits, two_masses
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.proofs import matrix_inequalities
from pointpred_observers.proofs.affine import Affine
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.solver import Answer, run
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import certify_convergence
from pointpred_observers.triangular.interlaced_observer import certify as certify_interlaced
from pointpred_observers.unknown_input.observer import UnknownInputObserver

CALM = {"turn": (-0.02, 0.02), "a_z": (-0.1, 0.1), "w": (0.0, 0.0), "dw": (0.0, 0.0)}
DOORS: dict[str, Any] = {
    "observer": lambda: DrivenObserver.design(academic()[0], generator=academic()[1], decay=0.0).gap,
    "observer with a sector": lambda: (
        DrivenObserver.design(
            chua_circuits(0.3)[0], generator=chua_circuits(0.3)[1], Pi=np.eye(3), decay=0.0
        ).gap
    ),
    "convergence": lambda: (
        certify_convergence(invariant_observer(two_masses(1.0), UNMEASURED, [[-1, 0], [0, 0]]), decay=0.2).gap
    ),
    "reduced order": lambda: ReducedOrderObserver.design(two_masses(), Pi=UNMEASURED, decay=0.5).gap,
    "interlaced": lambda: certify_interlaced([[0.0, 1.0], [-1.0, 0.0]], [[1.0, 1.0]], decay=0.25).gap,
    "unknown input": lambda: (
        UnknownInputObserver.design(camera_system(), camera_box((-0.4, -0.05), **CALM), 0.01).certificate.gap
    ),
}


@pytest.mark.parametrize("door", list(DOORS))
def test_the_answer_tells_its_gap(door: str) -> None:
    assert 0.0 <= DOORS[door]() < 1e-2


def test_where_the_solver_fails_on_the_minimum_bisection_comes_near_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    a = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [-6.0, -11.0, -6.0]])

    def least() -> Any:
        problem = MatrixInequalities("Lyapunov").positive("P", 3)
        problem.below("A'P + PA", lambda v: a.T @ v.P + v.P @ a)
        return problem.solve(minimise=lambda v: np.trace(v.P))

    wanted = least()

    def stalled(problem: Affine, *, margin: float | None) -> Answer:
        if margin is not None:
            return Answer("user_limit", None, -np.inf, None)
        return run(problem, margin=margin)

    monkeypatch.setattr(matrix_inequalities, "run", stalled)
    reached = least()
    assert reached.gap == np.inf  # nothing is proved without multipliers
    assert wanted.objective <= reached.objective <= 1.1 * wanted.objective
