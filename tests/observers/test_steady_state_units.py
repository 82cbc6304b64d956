"""The tolerance of a steady-state map: a share of the matrices, in whatever unit they come."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred.errors import InfeasibleError, ParameterError
from pointpred.observers import Generator, Persidskii, steady_state_map


@pytest.mark.parametrize("scale", [1e-12, 1.0, 1e12])
def test_what_cannot_hold_cannot_hold_in_every_unit(scale: float) -> None:
    """Time in other units multiplies A0, B and S0: Pi stays, and so does what contradicts it."""
    plant = Persidskii([[-scale]], None, None, "sin", B=[scale])
    assert steady_state_map(plant, Generator([[0.0]], L0=[2.0])).Pi == pytest.approx(2.0)
    with pytest.raises(InfeasibleError, match=r"B L0 = 0 cannot hold: the least residual is "):
        steady_state_map(plant, Generator([[-scale]], L0=[2.0]))


def test_a_slow_plant_keeps_a_given_j() -> None:
    """What rounding leaves of J = H Pi is judged by J, not by rates of 1e-12 1/s."""
    plant = Persidskii([[-3e-12]], [0.0], [0.1], "sin", B=[3e-12])
    found = steady_state_map(plant, Generator([[0.0]], J=[0.3], L0=[3.0]))
    assert found.Pi == pytest.approx(3.0)


@pytest.mark.parametrize("tolerance", [0.0, -1e-9, np.inf, np.nan])
def test_a_tolerance_is_a_share(tolerance: float) -> None:
    plant = Persidskii([[-1.0]], None, None, "sin", B=[1.0])
    with pytest.raises(ParameterError, match=r"tolerance must lie in \(0, 1\)"):
        steady_state_map(plant, Generator([[0.0]], L0=[2.0]), tolerance=tolerance)
