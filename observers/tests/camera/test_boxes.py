"""Boxes and the models over them: weights that make a convex sum, and matrices they reproduce."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.errors import ParameterError
from pointpred_observers.unknown_input.boxes import Box, at_vertices

number = st.floats(-100.0, 100.0)
axis = st.tuples(number, st.one_of(st.just(0.0), st.floats(0.01, 50.0)))


@given(st.lists(st.tuples(axis, st.floats(0.0, 1.0)), min_size=1, max_size=5))
def test_weights_are_a_convex_sum_that_gives_the_point(axes: list) -> None:
    box = Box({f"p{i}": (low, low + width) for i, ((low, width), _) in enumerate(axes)})
    point = {f"p{i}": low + share * width for i, ((low, width), share) in enumerate(axes)}
    weights = box.weights(point)
    assert len(weights) == len(box.vertices) == 2 ** sum(width > 0.0 for (_, width), _ in axes)
    assert weights.min() >= 0.0
    assert abs(weights.sum() - 1.0) < 1e-12
    np.testing.assert_allclose(weights @ box.vertices, list(point.values()), rtol=1e-9, atol=1e-9)


def test_a_vertex_has_all_the_weight() -> None:
    box = Box({"a": (0.0, 1.0), "b": (2.0, 2.0), "c": (-1.0, 3.0)})
    for i, vertex in enumerate(box.vertices):
        assert box.weights(box.named(vertex)).tolist() == np.eye(4)[i].tolist()


@pytest.mark.parametrize(
    ("bounds", "said"),
    [
        ({}, "at least one axis"),
        ({"a": (1.0, 0.0)}, "a needs low <= high"),
        ({"a": (0.0, float("inf"))}, "a needs two finite numbers"),
        ({"a": (0.0, float("nan"))}, "a needs two finite numbers"),
        ({"a": (0.0, 1j)}, "a needs two finite numbers"),
        ({"a": 3.0}, r"a needs \(low, high\), received 3.0"),
        ({f"p{i}": (0.0, 1.0) for i in range(13)}, "at most 12 axes with a width, received 13"),
    ],
)
def test_bounds_without_sense_are_refused(bounds: dict, said: str) -> None:
    with pytest.raises(ParameterError, match=said):
        Box(bounds)


def test_points_outside_have_no_weights() -> None:
    box = Box({"a": (0.0, 1.0), "b": (2.0, 2.0)})
    with pytest.raises(ParameterError, match=r"a must lie in \[0, 1\], received 1.5"):
        box.weights({"a": 1.5, "b": 2.0})
    with pytest.raises(ParameterError, match=r"b must lie in \[2, 2\]"):
        box.weights({"a": 0.5, "b": 2.1})
    with pytest.raises(ParameterError, match="a must lie"):
        box.weights({"a": float("nan"), "b": 2.0})
    with pytest.raises(ParameterError, match="a point needs a, b, received a"):
        box.weights({"a": 0.5})


def test_a_model_reproduces_a_multilinear_matrix_anywhere_in_the_box() -> None:
    random = np.random.default_rng(3)
    parts = random.normal(size=(8, 2, 3))
    box = Box({"a": (-1.0, 2.0), "b": (0.5, 0.5), "c": (3.0, 4.0)})

    def matrix(p: dict) -> np.ndarray:
        a, b, c = p["a"], p["b"], p["c"]
        return np.tensordot([1.0, a, b, c, a * b, a * c, b * c, a * b * c], parts, 1)

    model = at_vertices(matrix, box, "A")
    for share in random.uniform(size=(20, 2)):
        point = {"a": -1.0 + 3.0 * share[0], "b": 0.5, "c": 3.0 + share[1]}
        np.testing.assert_allclose(box.mixed(model, point), matrix(point), rtol=1e-12, atol=1e-12)


def test_what_is_not_multilinear_is_refused() -> None:
    with pytest.raises(ParameterError, match="Gamma must be affine in each variable"):
        at_vertices(lambda p: np.array([[np.sin(p["a"])]]), Box({"a": (0.0, 1.0)}), "Gamma")
