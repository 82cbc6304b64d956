"""The tolerance of a steady-state map: a share of the matrices, in whatever unit they come."""

from __future__ import annotations

import numpy as np
import pytest

from observers.tests.printed import check_map
from pointpred.errors import CertificateError, InfeasibleError, ParameterError
from pointpred_observers import Generator, Persidskii, steady_state_map
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.thesis import certify_tracking


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


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_a_wrong_map_is_refused_however_large_an_entry_is_elsewhere(unit: float) -> None:
    """Inputs in units of 1e-9 make B large; the map 5 in place of 1 is wrong in all of them."""
    plant = Persidskii([[-1.0]], None, None, "sin", B=[unit], C0=[1.0])
    generator = Generator([[0.0]], L0=[1.0 / unit])
    with pytest.raises(
        InfeasibleError, match=r"Assumption 3\.2\.1: A0 Pi .* residual is 4, 0\.7 of its terms"
    ):
        DrivenObserver.design(plant, generator=generator, Pi=[[5.0]], decay=0.0)
    with pytest.raises(CertificateError, match="residual is 4, nothing is rounded"):
        check_map(plant, generator, [[5.0]])
    assert (
        min(DrivenObserver.design(plant, generator=generator, Pi=[[1.0]], decay=0.0).margins.values()) > 0.0
    )


@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
def test_one_row_of_a_map_does_not_hide_another(unit: float) -> None:
    """The second state, in other units, does not follow the map; the first row's terms are larger."""
    plant = Persidskii(np.diag([-1.0, -2.0]), None, None, "sin", B=[1.0, 2.0 * unit], C0=[[1.0, 0.0]])
    generator = Generator([[0.0]], L0=[1.0])
    right = np.array([[1.0], [unit]])
    assert steady_state_map(plant, generator).Pi == pytest.approx(right)
    with pytest.raises(InfeasibleError, match=r"0\.0005 of its terms"):
        DrivenObserver.design(plant, generator=generator, Pi=right * [[1.0], [1.001]], decay=0.0)


def test_tracking_refuses_a_map_in_small_units() -> None:
    """A0 = -1e7 belongs to the other state: it does not excuse the map of the first."""
    plant = Persidskii(np.diag([-1.0, -1e7]), None, None, "sin", np.array([[1e-7], [1e7]]), None, np.eye(2))
    regulator = Generator([[-1.0]], None, None, [[0.0, 0.0]], [1.0])
    with pytest.raises(InfeasibleError, match=r"Assumption 3\.2\.1: A0 Pi"):
        certify_tracking(plant, regulator, [[3e-3], [1.0]])


def test_rounding_in_a_map_of_the_caller_is_no_failure() -> None:
    """1e-17 stands where 0 is meant, in a row and in a matrix of its own."""
    plant = Persidskii(
        [[0.0, 1.0], [-2.0, -3.0]], [0.0, -2.0], [1.0, 0.0], "sin", [0.0, 1.0], None, [1.0, 0.0]
    )
    generator = Generator([[0.0, 1.0], [-2.0, -3.0]], [1e-17, -2.0], None, None, np.array([[1e-17, 0.0]]))
    assert (
        min(
            DrivenObserver.design(
                plant, generator=generator, Pi=np.eye(2) + 1e-17, decay=0.0
            ).margins.values()
        )
        > 0.0
    )


@pytest.mark.parametrize("unit", [1e-3, 1.0, 1e11])
def test_one_column_of_a_map_does_not_hide_another(unit: float) -> None:
    """The first state follows the second signal wrongly, whose unit may be that of the second state."""
    plant = Persidskii(np.diag([-1.0, -1.0]), None, None, "sin", np.eye(2), None, np.eye(2))
    right = np.array([[1e4, 4e-4 * unit], [0.0, 8e-4 * unit]])
    generator = Generator(np.zeros((2, 2)), L0=right)
    assert min(DrivenObserver.design(plant, generator=generator, Pi=right, decay=0.0).margins.values()) > 0.0
    with pytest.raises(InfeasibleError, match=r"Assumption 3\.2\.1: A0 Pi .* 0\.3 of its terms"):
        DrivenObserver.design(plant, generator=generator, Pi=right * [[1.0, 2.0], [1.0, 1.0]], decay=0.0)
