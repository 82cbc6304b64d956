"""A second solver in place of the product's, to compare with."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest


@contextmanager
def solved_by(name: str) -> Iterator[None]:
    """Let a solver of cvxpy solve every problem posed within."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pointpred_observers.proofs.solver.SOLVER", name)
        yield
