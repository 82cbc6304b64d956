"""Identification on simulated counts through both of the thesis's functions (section 2.6.1)."""

import numpy as np
import pytest

from pointpred.reproduction.transfer_functions import (
    best_polynomial,
    gain_error,
    identify,
    rebuilding_errors,
    simulate_trials,
)
from pointpred.transfer import ConstantGain, SigmoidGain, averaged_gain

SEED = 31


def test_the_constant_gain_is_within_five_percent_after_48_trials() -> None:
    truth = ConstantGain(4.0)
    error = gain_error(identify(simulate_trials(truth, SEED), "windows, gain"), truth)
    assert error.largest < 0.05
    assert error.median < 0.01


def test_the_sigmoid_is_within_one_and_a_half_of_the_best_polynomial() -> None:
    truth = SigmoidGain()
    best = gain_error(best_polynomial(truth), truth)
    assert best.largest == pytest.approx(0.065, abs=0.001)
    trials = simulate_trials(truth, SEED)
    error = gain_error(identify(trials, "windows, gain"), truth)
    assert best.largest < error.largest < 1.5 * best.largest
    assert error.median < 0.03
    assert gain_error(identify(trials, "windows, samples"), truth).largest > error.largest


def test_the_position_of_a_fresh_trial_is_rebuilt_from_the_hand_s_speed() -> None:
    for truth, median, most in ((ConstantGain(4.0), 2.0, 4.0), (SigmoidGain(), 10.0, 30.0)):
        found = identify(simulate_trials(truth, SEED), "windows, gain")
        off = rebuilding_errors(found, simulate_trials(truth, SEED + 1))
        assert np.median(off) < median
        assert off.max() < most


def test_the_simulated_trials_are_what_they_claim() -> None:
    truth = SigmoidGain()
    for i, events in enumerate(simulate_trials(truth, SEED)[:6]):
        way = np.hypot(events.x[-1] - events.x[0], events.y[-1] - events.y[0]) * 0.0254 / 96.0
        assert way == pytest.approx((0.075, 0.150)[i % 2], rel=0.03)
        assert (events.table[:, 1:5] == np.round(events.table[:, 1:5])).all()
        assert 0.0001 > np.diff(events.t).std() > 0.00002


def test_the_averaged_gain_of_the_sigmoid() -> None:
    assert averaged_gain(SigmoidGain(), 0.1) == pytest.approx(1.78, abs=0.005)
    assert averaged_gain(SigmoidGain(), 0.3) == pytest.approx(5.73, abs=0.005)
