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
    memory = np.zeros(point_filter.END)
    memory[point_filter.NOISE], memory[point_filter.MODE] = noise, point_filter.RUNNING
    memory[point_filter.STATE : point_filter.STATE + 6] = state
    memory[point_filter.SPREAD : point_filter.SPREAD + 36] = (root @ root.T).ravel()
    point_filter.look(memory, *seen)

    x, y, z = state[:3]
    h = np.array([[1.0, 0.0, -x / z, 0.0, 0.0, 0.0], [0.0, 1.0, -y / z, 0.0, 0.0, 0.0]]) / z
    p = root @ root.T
    gain = p @ h.T @ np.linalg.inv(h @ p @ h.T + noise * np.eye(2))
    expected = state + gain @ (seen - state[:2] / z)
    np.testing.assert_allclose(
        memory[point_filter.STATE : point_filter.STATE + 6], expected, rtol=1e-10, atol=1e-12
    )
    after = memory[point_filter.SPREAD : point_filter.SPREAD + 36].reshape(6, 6)
    np.testing.assert_allclose(after, (np.eye(6) - gain @ h) @ p, rtol=1e-8, atol=1e-12)


def test_the_memory_of_a_filter_without_samples_is_all_zero_after_its_parameters() -> None:
    memory = PointFilter(focal_px=800.0).__dict__["_memory"]
    assert (memory[point_filter.STARTED :] == 0.0).all()
    assert (memory[[0, 1, 4, 5]] > 0.0).all()
