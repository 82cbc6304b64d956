"""The least gamma of the camera's observer beside a computation with 40 digits."""

from __future__ import annotations

import mpmath
import pytest

from evidence.observers.designs import minimum
from pointpred_observers.camera import camera_box, camera_system
from pointpred_observers.unknown_input.gains import ROOMS
from pointpred_observers.unknown_input.observer import UnknownInputObserver

DIGITS = 40


@pytest.mark.parametrize("a_z", [0.1, *(pytest.param(one, marks=pytest.mark.slow) for one in (0.5, 2.0))])
@pytest.mark.parametrize("decay", [0.005, 0.025, 0.045, 0.046, 0.0475])
def test_the_least_gamma_is_the_least(decay: float, a_z: float) -> None:
    box = camera_box((-2.0, -0.07), turn=(-0.02, 0.02), a_z=(-a_z, a_z), w=(-0.06, 0.06), dw=(-0.1, 0.1))
    with mpmath.workdps(DIGITS):
        wanted = float(minimum(2.0 * decay, box.bounds))
    gamma = UnknownInputObserver.design(camera_system(), box, decay).certificate.gamma
    assert gamma / ROOMS[0].factor == pytest.approx(wanted, rel=5e-3)
