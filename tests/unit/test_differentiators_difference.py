"""The backward difference against numpy.diff."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns, PointerEvent
from pointpred.differentiators import BackwardDifferentiator


def test_agrees_with_numpy_diff() -> None:
    random = np.random.default_rng(8)
    t = np.cumsum(random.choice([0.0005, 0.001, 0.008], 500))
    x, y = np.round(np.cumsum(random.standard_normal((2, 500)), axis=1) * 10)
    motions = BackwardDifferentiator(dpi=25.4).run(EventColumns.of(t, x, y))
    for path, velocity, acceleration in ((x, motions.vx, motions.ax), (y, motions.vy, motions.ay)):
        v = np.diff(path * 1e-3) / np.diff(t)
        a = np.diff(v) / np.diff(0.5 * (t[1:] + t[:-1]))
        np.testing.assert_allclose(velocity[1:], v, rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(acceleration[2:], a, rtol=1e-9, atol=1e-6)
    assert motions.vx[0] == motions.ax[0] == motions.ax[1] == 0.0
    assert motions.settled.tolist()[:4] == [0.0, 0.0, 1.0, 1.0]


def test_reports_closer_than_the_shortest_interval_wait_and_nothing_is_lost() -> None:
    differentiator = BackwardDifferentiator(shortest_s=1e-3, dpi=25.4)
    differentiator.update(PointerEvent(0.0, 0.0, 0.0))
    differentiator.update(PointerEvent(0.01, 1.0, 0.0))
    waiting = differentiator.update(PointerEvent(0.0105, 6.0, 0.0))
    assert waiting.vx == pytest.approx(0.1)
    assert waiting.x == 6.0
    assert differentiator.update(PointerEvent(0.02, 6.0, 0.0)).vx == pytest.approx(0.5)


def test_velocity_adds_up_to_the_displacement_with_equal_stamps_and_counts() -> None:
    random = np.random.default_rng(2)
    t = np.cumsum(random.choice([0.0, 0.0, 0.001, 0.002], 400))
    t[0] = t[1] = 0.0
    t[2:] += 0.001
    dx = random.integers(-20, 20, 400)
    zero = np.zeros(400)
    motions = BackwardDifferentiator(cpi=25.4).run(EventColumns.of(t, zero, zero, dx, zero))
    last_of_stamp = np.append(np.diff(t) > 0, True)
    first_of_stamp = np.append(True, np.diff(t) > 0)
    way = np.sum(motions.vx[first_of_stamp][1:] * np.diff(t[last_of_stamp]))
    last_group = t == t[-1]
    counted = dx[2:].sum() - dx[last_group][1:].sum()  # what came beside the last event has not entered yet
    assert way == pytest.approx(counted * 1e-3, rel=1e-9)
