"""One image through the filter's law against the matrix formulas of the extended Kalman filter."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred_observers.camera import PointFilter, point_filter


@pytest.mark.parametrize("seed", range(5))
def test_an_image_is_the_matrix_update_of_both_coordinates_at_once(seed: int) -> None:
    random = np.random.default_rng(seed)
    root = 0.3 * random.normal(size=(6, 6))
    state = np.array([0.3, -0.2, 2.0, 0.1, 0.2, -0.4]) + 0.1 * random.normal(size=6)
    seen, noise = np.array([0.1, -0.3]), 1e-2
    memory = point_filter.Memory(np.zeros(point_filter.Memory.length))
    memory.settings.noise, memory.state.mode = noise, point_filter.RUNNING
    memory.state.state[:] = state
    memory.state.spread.m[:] = root @ root.T
    point_filter.look(memory.memory, *seen)

    x, y, z = state[:3]
    h = np.array([[1.0, 0.0, -x / z, 0.0, 0.0, 0.0], [0.0, 1.0, -y / z, 0.0, 0.0, 0.0]]) / z
    p = root @ root.T
    gain = p @ h.T @ np.linalg.inv(h @ p @ h.T + noise * np.eye(2))
    expected = state + gain @ (seen - state[:2] / z)
    np.testing.assert_allclose(memory.state.state, expected, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(memory.state.spread.m, (np.eye(6) - gain @ h) @ p, rtol=1e-8, atol=1e-12)


def test_the_memory_of_a_filter_without_samples_is_all_zero_after_its_parameters() -> None:
    memory = point_filter.Memory(PointFilter(focal_px=800.0).__dict__["_memory"])
    settings = memory.settings
    assert (memory.state.memory == 0.0).all()
    assert min(settings.focal_px, settings.noise, settings.share, settings.gap_s) > 0.0
