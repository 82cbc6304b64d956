"""Before the sensor is known, and after it is contradicted, nothing is worse than without one."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns, PointerEvent
from pointpred.differentiators import (
    HomogeneousDifferentiator,
    InertialDifferentiator,
    KalmanDifferentiator,
)
from pointpred.records import FloatArray
from tests.reference.inertial_bench import Bench, path


@pytest.mark.parametrize("turn", [0.2, 1.6, 3.1])
@pytest.mark.parametrize("delay_s", [-0.006, 0.008])
def test_a_first_movement_at_full_acceleration_is_never_worse_than_without_a_sensor(
    turn: float, delay_s: float
) -> None:
    """The path begins at 3 m/s^2, so the first sample is none at rest; the sensor stands at any angle."""
    for seed in range(4):
        bench = Bench(3.0, turn, delay_s, 0.05, seed)
        motions = InertialDifferentiator().run(bench.beside)
        plain = KalmanDifferentiator().run(bench.events)
        homogeneous = HomogeneousDifferentiator().run(bench.events)
        for since in np.arange(0.1, 3.0, 0.1).tolist():
            best = max(bench.off(other, since, since + 0.1) for other in (plain, homogeneous))
            assert bench.off(motions, since, since + 0.1) <= 1.05 * best


def test_until_the_sensor_is_known_the_answer_is_that_of_the_kalman_filter() -> None:
    bench = Bench(3.0, 0.3, 0.004, 0.05)
    differentiator, plain = InertialDifferentiator(), KalmanDifferentiator().run(bench.events)
    known = []
    for i in range(len(bench.t)):
        motion = differentiator.run(bench.beside[i : i + 1])
        sensor = differentiator.sensor
        assert sensor is not None
        known.append(sensor.known)
        if not sensor.known:
            assert motion.table.tobytes() == plain.table[i : i + 1].tobytes()
    first = known.index(True)
    assert 50 < first < 2000
    assert all(known[first:])


def test_a_reach_along_one_axis_alone_does_not_make_a_sensor_known() -> None:
    t = np.arange(600) / 1000.0
    s = np.clip((t - 0.1) / 0.4, 0.0, 1.0)
    x = 400.0 * s**3 * (10.0 - 15.0 * s + 6.0 * s**2)
    force = np.column_stack([np.gradient(np.gradient(x * 0.0254 / 96.0, t), t), 0.0 * t, 0.0 * t + 9.81])
    events = EventColumns.of(t, x, 0.0 * t)
    differentiator = InertialDifferentiator()
    motions = differentiator.run(events.sampled(np.column_stack([t, force])))
    sensor = differentiator.sensor
    assert sensor is not None
    assert not sensor.known
    assert motions.table.tobytes() == KalmanDifferentiator().run(events).table.tobytes()


def learned(bench: Bench) -> InertialDifferentiator:
    differentiator = InertialDifferentiator()
    differentiator.run(bench.beside)
    sensor = differentiator.sensor
    assert sensor is not None
    assert sensor.known
    return differentiator


def test_a_position_that_contradicts_the_samples_makes_the_sensor_unknown() -> None:
    """5 mm in a millisecond, which no sample has felt: a mouse that was lifted and put down."""
    bench = Bench(6.0, 0.3, 0.004, 0.05)
    differentiator = learned(bench)
    last = bench.events[len(bench.t) - 1]
    differentiator.sense(6.0, *bench.samples[-1, 1:].tolist())
    moved = PointerEvent(6.0, last.x + 0.005 * 96.0 / 0.0254, last.y)
    plain = KalmanDifferentiator()
    plain.run(bench.events)
    assert differentiator.update(moved) == plain.update(moved)
    differentiator.reset()
    again = differentiator.run(bench.beside[:100])  # nothing is left of what was learned
    assert again.table.tobytes() == KalmanDifferentiator().run(bench.events[:100]).table.tobytes()


def acceleration(differentiator: InertialDifferentiator, force: FloatArray) -> FloatArray:
    """What a force says of the device, m/s^2."""
    sensor = differentiator.sensor
    assert sensor is not None
    return np.asarray(sensor.weights @ force + sensor.offset)


def at_rest(differentiator: InertialDifferentiator, since_s: float, force: FloatArray) -> None:
    for i in range(1000):
        differentiator.sense(since_s + i / 1000.0, *force.tolist())


def test_rest_corrects_the_offset_and_a_device_in_the_air_does_not() -> None:
    bench = Bench(6.0, 0.3, 0.004, 0.05)
    still = bench.zero
    for shift, moves in ((0.5, True), (8.0, False)):
        differentiator = learned(bench)
        before = acceleration(differentiator, still)
        at_rest(differentiator, 6.2, still + np.array([shift, 0.0, 0.0]))
        off = np.abs(acceleration(differentiator, still) - before).max()
        assert (off > 0.02) == moves
        assert off == 0.0 or moves


def test_the_bench_begins_at_full_acceleration() -> None:
    assert np.hypot(*path(np.zeros(1))[2][0]) > 3.0
