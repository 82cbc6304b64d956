"""The accelerometer of a simulated person measures the movement that it is part of."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred.errors import ParameterError
from pointpred.simulation import Aim, Condition, Setup, people, simulate_circle
from pointpred.simulation.accelerometer import GRAVITY_M_S2, Accelerometer, felt
from pointpred.simulation.movement import Movement, move
from pointpred.transfer import ConstantGain

SENSOR = Accelerometer(bias=(0.1, -0.2, 0.3), tilt=(0.05, -0.04), turn=0.3, scale=1.05)


@pytest.fixture(scope="module")
def movement() -> Movement:
    return move(people(1)[0], Setup(ConstantGain(2.0)), Aim(500.0, 200.0, 30.0), np.random.default_rng(3))


def samples(movement: Movement, sensor: Accelerometer) -> np.ndarray:
    t = movement.table[:, 0]
    return felt(movement, sensor, np.random.default_rng(5), t).table


def test_the_sensor_feels_gravity_and_its_bias_at_rest_and_twice_integrated_the_path(
    movement: Movement,
) -> None:
    table = samples(movement, SENSOR)
    rest = SENSOR.matrix @ [0.0, 0.0, GRAVITY_M_S2] + SENSOR.bias
    np.testing.assert_allclose(table[:50, 1:].mean(axis=0), rest, atol=0.2)  # tremor
    push = (table[:, 1:] - rest) @ np.linalg.inv(SENSOR.matrix).T
    np.testing.assert_allclose(push[:, 2], 0.0, atol=1e-9)
    place = np.cumsum(np.cumsum(push[:, :2], axis=0), axis=0) / SENSOR.rate_hz**2
    ends = movement.table[-1, 6:8]
    np.testing.assert_allclose(place[-1], ends, atol=0.03 * np.hypot(*ends))


def test_a_mouse_that_turns_feels_a_push_across(movement: Movement) -> None:
    straight, turning = (samples(movement, Accelerometer(yaw_rad_m=yaw)) for yaw in (0.0, 4.0))
    speed = np.interp(straight[:, 0], movement.table[:, 0], movement.column("vx"))
    across = (turning - straight)[:, 2]
    np.testing.assert_allclose(across, 4.0 * speed**2, atol=0.1 * (4.0 * speed**2).max())


def test_noise_grows_with_the_speed_and_the_seed_gives_the_same(movement: Movement) -> None:
    noisy, again, clean = (
        samples(movement, Accelerometer(noise=noise, vibration=20.0 * noise)) for noise in (0.05, 0.05, 0.0)
    )
    assert noisy.tobytes() == again.tobytes()
    speed = np.interp(
        clean[:, 0], movement.table[:, 0], np.hypot(movement.column("vx"), movement.column("vy"))
    )
    size = (noisy - clean)[:, 3] / (0.05 + speed)
    assert np.std(size) == pytest.approx(1.0, rel=0.1)


def test_samples_stand_in_the_order_of_truth_and_are_stamped_by_their_own_clock(movement: Movement) -> None:
    t = movement.table[:, 0]
    plain, behind = (
        felt(movement, Accelerometer(offset_s=d), np.random.default_rng(5), t) for d in (0.0, 0.004)
    )
    assert plain.before.tolist() == behind.before.tolist()
    np.testing.assert_allclose(plain.table[:, 0] - behind.table[:, 0], 0.004)
    with pytest.raises(ParameterError, match=r"rate_hz must lie in \[50, 20000\] Hz, received 10"):
        samples(movement, Accelerometer(rate_hz=10.0))


def test_samples_that_come_late_stand_before_later_events(movement: Movement) -> None:
    t = movement.table[:, 0]
    plain, late = (
        felt(movement, Accelerometer(late_s=late_s), np.random.default_rng(5), t) for late_s in (0.0, 0.01)
    )
    count = len(late.table)
    assert late.table.tobytes() == plain.table[:count].tobytes()
    for i in (300, 500):
        assert late.table[late.before[i] - 1, 0] <= t[i] - 0.01 < late.table[late.before[i], 0]


def test_a_recording_has_the_same_events_with_and_without_a_sensor() -> None:
    chosen: dict[str, Any] = {
        "persons": people(2),
        "conditions": [Condition(150.0, 7.0, "constant")],
        "seed": 4,
        "trials": 2,
    }
    plain = simulate_circle(**chosen)
    fitted = simulate_circle(**chosen, accelerometer=Accelerometer.drawn)
    assert fitted.events.table.tobytes() == plain.events.table.tobytes()
    assert len(plain.events.accelerations) == 0
    assert [len(fitted.rows(k).accelerations) > 500 for k in range(4)] == [True] * 4
