"""Samples that are stamped late or early, come twice, are missing, or run backwards: one rule for each."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns
from pointpred.accelerations import Accelerations
from pointpred.differentiators import InertialDifferentiator, KalmanDifferentiator, fused_path, inertial
from pointpred.errors import EventError, EventOrderError
from tests.reference.inertial_bench import Bench

VELOCITY_VARIANCE = inertial.FILTER + fused_path.COVARIANCE + fused_path.VELOCITY * (fused_path.SIZE + 1)
LONG = Bench(8.0, 0.3, 0.0, 0.05)


@pytest.mark.parametrize("every", [1, 8], ids=["1 kHz", "125 Hz"])
@pytest.mark.parametrize("behind_s", [-0.006, 0.006, 0.012])
def test_a_clock_behind_or_ahead_of_the_events_is_a_delay_that_is_found(behind_s: float, every: int) -> None:
    """The velocity is off by a fifth of what the filter without samples is, however coarse the events."""
    differentiator = InertialDifferentiator()
    off = LONG.off(differentiator.run(LONG.stamped(behind_s, every)), 5.0)
    plain = LONG.off(KalmanDifferentiator().run(LONG.events[::every]), 5.0)
    sensor = differentiator.sensor
    assert sensor is not None
    assert sensor.known
    assert sensor.delay_s == pytest.approx(behind_s, abs=0.001)
    assert off < 0.2 * plain


@pytest.mark.parametrize("late_s", [0.003, 0.010])
def test_samples_that_come_late_with_the_right_stamps(late_s: float) -> None:
    """So long the last acceleration holds; what comes more than 4 ms late is learned from, but not used."""
    before = np.searchsorted(LONG.sample_t + late_s, LONG.t, side="right")
    late = EventColumns(LONG.events.table, None, Accelerations(LONG.samples, before))
    differentiator = InertialDifferentiator()
    motions = differentiator.run(late)
    plain = KalmanDifferentiator().run(LONG.events)
    sensor = differentiator.sensor
    assert sensor is not None
    assert sensor.delay_s == pytest.approx(0.0, abs=0.001)
    assert sensor.known == (late_s < 0.004)
    if sensor.known:
        assert LONG.off(motions, 5.0) < 0.2 * LONG.off(plain, 5.0)
    else:
        assert motions.table[LONG.t > 5.0].tobytes() == plain.table[LONG.t > 5.0].tobytes()


def test_a_sample_that_comes_twice_counts_once() -> None:
    bench = Bench(1.0, 0.3, 0.004, 0.05)
    counts = np.full(len(bench.samples), 2)
    twice = Accelerations(np.repeat(bench.samples, counts, axis=0), 2 * bench.beside.accelerations.before)
    once = InertialDifferentiator()
    wanted = once.run(bench.beside).table
    again = InertialDifferentiator()
    assert again.run(EventColumns(bench.events.table, None, twice)).table.tobytes() == wanted.tobytes()
    moving = once.remembered()
    for t in np.arange(1.2, 1.6, 0.001).tolist():  # at rest, where each sample is a measurement
        once.sense(t, *bench.zero.tolist())
        for _ in range(2):
            again.sense(t, *bench.zero.tolist())
    assert again.remembered() == once.remembered() != moving


def test_of_two_samples_of_one_time_the_later_one_acts() -> None:
    bench = Bench(1.0, 0.3, 0.004, 0.05)
    right, wrong_first = InertialDifferentiator(), InertialDifferentiator()
    for differentiator in (right, wrong_first):
        differentiator.run(bench.beside)
    force = bench.samples[-1, 1:].tolist()
    right.sense(1.0, *force)
    wrong_first.sense(1.0, *force)
    wrong_first.sense(1.0, 50.0, 50.0, 50.0)
    wrong_first.sense(1.0, *force)
    event = bench.events[999]
    later = type(event)(1.001, event.x, event.y)
    assert wrong_first.update(later) == right.update(later)


def test_a_hole_of_20_ms_costs_little_and_a_longer_one_leaves_the_kalman_filter() -> None:
    for hole_s in (0.02, 0.3):
        keep = (LONG.sample_t < 6.0) | (LONG.sample_t >= 6.0 + hole_s)
        motions = InertialDifferentiator().run(LONG.events.sampled(LONG.samples[keep]))
        plain = KalmanDifferentiator().run(LONG.events)
        if hole_s < 0.04:
            assert LONG.off(motions, 6.0, 6.02) < 0.02
        else:
            inside = (LONG.t > 6.045) & (LONG.t < 6.0 + hole_s)
            assert motions.table[inside].tobytes() == plain.table[inside].tobytes()
            assert motions.table[LONG.t >= 6.31, 3].tolist() != plain.table[LONG.t >= 6.31, 3].tolist()
        assert LONG.off(motions, 6.6) < 0.002


def test_the_longer_the_hole_the_less_is_known() -> None:
    """The error of the force grows as the jerk's: q + jerk age^2 is the density of its noise."""
    spreads = []
    for hole_s in (0.001, 0.01, 0.02):
        bench = Bench(0.5, 0.3, 0.0, 0.05)
        differentiator = InertialDifferentiator()
        differentiator.run(bench.beside)
        differentiator.sense(0.5 + hole_s, *bench.samples[-1, 1:].tolist())
        spreads.append(differentiator._memory[VELOCITY_VARIANCE])
    assert spreads[0] < spreads[1] < spreads[2]
    assert spreads[2] - spreads[0] > 0.5 * 30.0 * 0.02**3


def test_samples_run_forwards() -> None:
    differentiator = InertialDifferentiator()
    differentiator.sense(0.5, 0.0, 0.0, 9.81)
    kept = differentiator.remembered()
    with pytest.raises(EventOrderError, match=r"received 0\.4 s after 0\.5 s"):
        differentiator.sense(0.4, 0.0, 0.0, 9.81)
    assert differentiator.remembered() == kept
    with pytest.raises(EventError, match="sample 2: t must not run backwards"):
        LONG.events.sampled(LONG.samples[[0, 2, 1]])


def test_one_stamp_far_ahead_is_no_sample_of_the_events() -> None:
    """A clock that jumps by a second: the filter without samples answers until the stamps fit again."""
    bench = Bench(2.0, 0.3, 0.0, 0.05)
    samples = bench.samples.copy()
    samples[bench.sample_t >= 1.0, 0] += 1.0
    before = bench.beside.accelerations.before
    motions = InertialDifferentiator().run(
        EventColumns(bench.events.table, None, Accelerations(samples, before))
    )
    plain = KalmanDifferentiator().run(bench.events)
    after = bench.t > 1.001
    assert motions.table[after].tobytes() == plain.table[after].tobytes()
