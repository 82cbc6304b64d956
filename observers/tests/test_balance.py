"""Balanced coordinates: the same entries whatever units were given, also of reducible systems."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import block_diag

from pointpred_observers.numerics.balance import balanced, inward, outward


def system(seed: int, sparse: float) -> dict[str, Any]:
    random = np.random.default_rng(seed)
    n, p, k = int(random.integers(1, 7)), 1, int(random.integers(0, 3))
    shapes = {"drift": (n, n), "seen": (p, n), "driven": (n, k), "shown": (p, k), "inner": (k, n)}
    return {
        name: random.standard_normal(shape) * (random.uniform(size=shape) > sparse)
        for name, shape in shapes.items()
    }


def moved(parts: dict[str, Any], one: Any) -> dict[str, Any]:
    x, y, v, s, t = one.states, one.outputs, one.values, one.arguments, one.seconds
    return {
        "drift": inward(parts["drift"], x, x, t),
        "seen": inward(parts["seen"], y, x),
        "driven": inward(parts["driven"], x, v, t),
        "shown": inward(parts["shown"], y, v),
        "inner": inward(parts["inner"], s, x),
    }


@given(st.integers(0, 2**32 - 1), st.sampled_from([0.0, 0.3, 0.6]))
@settings(max_examples=40, deadline=None)
def test_balanced_entries_do_not_depend_on_the_units(seed: int, sparse: float) -> None:
    """Reducible and disconnected systems too: every unit up to 1e6 larger or smaller, time up to 1e5."""
    parts, random = system(seed, sparse), np.random.default_rng(seed)
    n, p, k = len(parts["drift"]), len(parts["seen"]), len(parts["inner"])
    slopes = tuple((-0.5, 2.0) for _ in range(k))
    x, y, v, s = (10.0 ** random.uniform(-6.0, 6.0, size) for size in (n, p, k, k))
    t = 10.0 ** random.uniform(-5.0, 5.0)
    other = {
        "drift": inward(parts["drift"], x, x, t),
        "seen": inward(parts["seen"], y, x),
        "driven": inward(parts["driven"], x, v, t),
        "shown": inward(parts["shown"], y, v),
        "inner": inward(parts["inner"], s, x),
    }
    one = balanced(**parts, slopes=slopes, rates=(1.5,))
    two = balanced(
        **other,
        slopes=tuple((a * b / c, d * b / c) for (a, d), b, c in zip(slopes, s, v, strict=True)),
        rates=(1.5 * t,),
    )
    first, second = moved(parts, one), moved(other, two)
    for name in first:
        assert second[name] == pytest.approx(first[name], rel=1e-6, abs=1e-12), name
    assert 1.5 * t * two.seconds == pytest.approx(1.5 * one.seconds, rel=1e-6)


def test_a_cascade_is_balanced_although_it_is_reducible() -> None:
    """A chain of integrators, for which the sum of squares has no minimum."""
    chain = np.diag([1e-6, 1e3], 1)
    one = balanced(chain, seen=[[50.0, 0.0, 0.0]], rates=(0.1,))
    assert inward(chain, one.states, one.states, one.seconds)[[0, 1], [1, 2]] == pytest.approx([1.0, 1.0])
    assert inward([[50.0, 0.0, 0.0]], one.outputs, one.states)[0, 0] == pytest.approx(1.0)


def test_tiny_entries_hardly_count() -> None:
    """An entry of rounding beside one of 1 moves the units by less than a factor of two."""
    one = balanced([[0.0, 1.0], [1.0, 0.0]], seen=[[1.0, 1e-17]], rates=(1.0,))
    assert 0.5 < one.states[0] / one.states[1] < 2.0


def test_parts_without_a_connection_are_balanced_each_on_its_own() -> None:
    a, b = np.array([[0.0, 1e4], [-1.0, -1.0]]), np.array([[-1.0, 1e-5], [1e5, -3.0]])
    both, first = balanced(block_diag(a, b), rates=(1.0,)), balanced(a, rates=(1.0,))
    ratio = both.states[0] / both.states[1]
    assert ratio == pytest.approx(first.states[0] / first.states[1], rel=0.5)


def test_inward_and_outward_are_inverse() -> None:
    random = np.random.default_rng(3)
    m, rows, columns = random.standard_normal((2, 3)), np.array([2.0, 5.0]), np.array([0.1, 3.0, 1e6])
    assert outward(inward(m, rows, columns, 7.0), rows, columns, 7.0) == pytest.approx(m)
    e, units = random.standard_normal(3), columns
    p = np.diag([1.0, 2.0, 3.0])
    assert (e * units) @ (p / np.outer(units, units)) @ (e * units) == pytest.approx(e @ p @ e)


def test_one_state_in_discrete_time_has_no_unit_to_choose() -> None:
    one = balanced([[0.5]], time="discrete", rates=(0.3,))
    assert (one.states.tolist(), one.seconds) == ([1.0], 1.0)
