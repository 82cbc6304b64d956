"""The model validation of thesis section 2.6.2: b1 = 4, b2 = 7, T = 600, PTF = arctan, h = 0.01 s."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pointpred.regression import DynamicRegressorExtension
from pointpred.regression.drem import Estimate

B1, B2, GOAL, STEP_S = 4.0, 7.0, 600.0, 0.01
TRUTH = (1.0 / B2, B1 / B2, GOAL)


def corrective_phase() -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Time, position, velocity and acceleration of the model, by an integrator that is not ours."""

    def slope(_: float, state: np.ndarray) -> list[float]:
        return [np.arctan(state[1]), -B1 * state[1] - B2 * (state[0] - GOAL)]

    t = np.arange(0.0, 5.0, STEP_S)
    x, v = solve_ivp(slope, (0.0, 5.0), [0.0, 0.0], t_eval=t, rtol=1e-11, atol=1e-9).y
    return t, x, v, -B1 * v - B2 * (x - GOAL)


def estimate(delay_s: float, gamma: float) -> Estimate:
    stage = DynamicRegressorExtension(3, delay_s=delay_s, gamma=gamma)
    for t, x, v, a in zip(*corrective_phase(), strict=True):
        answer = stage.update((-a, -v, 1.0), x, t)
    assert answer is not None
    return answer


def test_a_tenth_of_a_second_recovers_all_three() -> None:
    found = estimate(0.1, 1e14)
    assert found.values == pytest.approx(TRUTH, rel=1e-4)
    assert found.learnt == pytest.approx(1.0, abs=1e-9)


def test_a_short_delay_leaves_the_goal_short_and_says_so() -> None:
    """The excitation is gone after a second; what was not learnt by then stays unlearnt."""
    gamma = 1.14e14
    found = estimate(0.02, gamma)
    assert found.values[2] == pytest.approx(521.0, abs=3.0)
    assert found.values == pytest.approx([found.learnt * value for value in TRUTH], rel=1e-4)
    assert estimate(0.1, gamma).values[2] == pytest.approx(GOAL, rel=1e-4)


def test_the_operators_are_delays_what_comes_later_changes_nothing() -> None:
    """The printed e^(+i tau s) would put samples at t + i tau into the rows: no causal stage has them."""
    stage = DynamicRegressorExtension(3, delay_s=0.1, gamma=1e14)
    t, x, v, a = corrective_phase()
    half = len(t) // 4
    for i in range(half):
        before = stage.update((-a[i], -v[i], 1.0), x[i], t[i])
    other = stage.fresh()
    for i in range(half + 20):
        scale = 1.0 if i < half else 3.0
        after = other.update((-a[i] * scale, -v[i] * scale, 1.0), x[i], t[i])
        if i == half - 1:
            assert after == before
