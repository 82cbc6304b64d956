"""The switched predictor along the direction against movements whose end is known."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred import EventColumns, build, run
from pointpred.predictors import SwitchedDirectionPredictor
from pointpred.records import FloatArray, MotionColumns

PX_M = 2500.0
ALONE = {"rise": 0.35, "typical_s": 0.05, "own": 1.0, "turn": 0.5, "watched": 1.0, "stopping": 1.0}
"""Nothing but the movement's own peak, speed and place."""


def motions(t: FloatArray, place: FloatArray, v: FloatArray, a: FloatArray) -> MotionColumns:
    """Exact motions of a hand that makes ``PX_M`` px a metre; ``v`` and ``a`` in px."""
    table = np.zeros((len(t), 10))
    table[:, 0], table[:, 1:3] = t, place
    table[:, 3:5], table[:, 5:7] = v / PX_M, a / PX_M
    table[:, 7] = 1.0
    table[0, 8] = 1.0
    return MotionColumns(table)


def ends(columns: MotionColumns, **parameters: float) -> FloatArray:
    predictor = SwitchedDirectionPredictor(**parameters)
    return predictor.run(columns, np.zeros(len(columns), np.bool_)).table[:, 1:3]


def along(t: FloatArray, x: FloatArray, v: FloatArray, a: FloatArray, way: FloatArray) -> MotionColumns:
    """A straight movement from (300, 200); x, v, a as shares of the way."""
    return motions(t, np.outer(x, way) + np.array([300.0, 200.0]), np.outer(v, way), np.outer(a, way))


def approach(way: FloatArray, rate: float = 9.0) -> MotionColumns:
    """Half the way at a constant acceleration, then V = k (T - x): the law's own model."""
    top = 0.5 * rate  # speed at the switch, where half the way is done
    rising = np.linspace(0.0, 1.0 / top, 1001)
    falling = np.linspace(0.0, 8.0 / rate, 2001)[1:]
    t = np.concatenate([rising, rising[-1] + falling])
    left = 0.5 * np.exp(-rate * falling)
    x = np.concatenate([0.5 * top**2 * rising**2, 1.0 - left])
    v = np.concatenate([top**2 * rising, rate * left])
    a = np.concatenate([np.full(1001, top**2), -(rate**2) * left])
    return along(t, x, v, a, way)


PLACE = st.floats(-3000.0, 3000.0)


@given(dx=PLACE, dy=PLACE, rate=st.floats(1.0, 40.0))
@settings(max_examples=30, deadline=None, derandomize=True)
def test_an_exponential_approach_is_known_from_its_switch_to_its_end(
    dx: float, dy: float, rate: float
) -> None:
    """The switch and the slope since agree on the rate, so any weights find the end."""
    way = np.array([dx, dy]) + 100.0 * np.sign([dx or 1.0, dy or 1.0])
    columns = approach(way, rate)
    late = np.hypot(columns.vx, columns.vy) > 0.002  # slower, the hand counts as still
    late[:1001] = False
    for weights in ({"turn": 0.5}, {"turn": 0.0}, {"turn": 1.0}):
        found = ends(columns, **{**ALONE, **weights})[late]
        np.testing.assert_allclose(
            found - [300.0, 200.0], np.tile(way, (len(found), 1)), atol=2e-3 * np.hypot(*way)
        )


def test_doubling_is_exact_at_the_peak_of_minimum_jerk_and_what_is_left_then_shrinks_to_nothing() -> None:
    s = np.linspace(0.0, 1.0, 2001)
    x, v = 10 * s**3 - 15 * s**4 + 6 * s**5, 30 * s**2 - 60 * s**3 + 30 * s**4
    columns = along(s, x, v, 60 * s - 180 * s**2 + 120 * s**3, np.array([400.0, -300.0]))
    found = ends(columns, **{**ALONE, "stopping": 0.5})
    assert found[1000] == pytest.approx([700.0, -100.0], abs=1.0)
    ahead = np.hypot(*(found - columns.table[:, 1:3]).T)
    assert (np.diff(ahead[1000:]) <= 0.0).all()
    assert ahead[-1] == 0.0
    error = np.hypot(*(found - [700.0, -100.0]).T)
    left = 500.0 * (1.0 - x)
    assert (error[1001:1900] < left[1001:1900]).all()


@pytest.mark.parametrize("share", [0.2, 0.6, 0.9])
def test_an_even_braking_ends_where_its_stopping_distance_says(share: float) -> None:
    """A rate that foretells far too much is bounded by v^2 / 2b, which is then the way left."""
    way = np.array([-300.0, 400.0])
    rising, falling = np.linspace(0.0, 0.1, 101), np.linspace(0.0, 0.9, 901)[1:]
    t = np.concatenate([rising, 0.1 + falling])
    x = np.concatenate([10.0 * rising**2, 1.0 - (0.9 - falling) ** 2 / 0.9])
    v = np.concatenate([20.0 * rising, 2.0 * (0.9 - falling) / 0.9])
    a = np.concatenate([np.full(101, 20.0), np.full(900, -2.0 / 0.9)])
    lazy = {**ALONE, "own": 0.0, "typical_s": 10.0, "turn": 0.0, "stopping": 0.5}
    found = ends(along(t, x, v, a, way), **lazy)
    assert found[int(1000 * share)] - [300.0, 200.0] == pytest.approx(way, abs=2.0)
    without = ends(along(t, x, v, a, way), **{**lazy, "stopping": 1e6})
    assert np.hypot(*(without[int(1000 * share)] - [300.0, 200.0] - way)) > 50.0


def jagged(seed: int) -> FloatArray:
    """Two overlapping reaches that turn, unevenly sampled: t, x, y."""
    random = np.random.default_rng(seed)
    t = np.cumsum(random.uniform(0.004, 0.016, 120))
    first, second = (np.clip((t - begin) / 0.6, 0.0, 1.0) for begin in (0.02, 0.45))
    reach = [s**2 * (3 - 2 * s) for s in (first, second)]
    x = 600 * reach[0] - 50 * reach[1] + random.normal(0.0, 0.4, 120)
    y = 80 * reach[0] + 140 * reach[1] + random.normal(0.0, 0.4, 120)
    return np.array([t, x, y])


@pytest.mark.parametrize("degrees", [30.0, 90.0, 211.0])
def test_a_turned_movement_turns_the_answer(degrees: float) -> None:
    t, *place = jagged(3)
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    turn = np.array([[c, -s], [s, c]])
    straight = run(build("switched-direction"), EventColumns.of(t, *place)).table
    turned = run(build("switched-direction"), EventColumns.of(t, *(turn @ place))).table
    np.testing.assert_allclose(turned[:, 1:3], straight[:, 1:3] @ turn.T, rtol=1e-9, atol=1e-7)


@pytest.mark.parametrize("factor", [0.25, 4.0])
def test_another_screen_scales_the_answer(factor: float) -> None:
    """The hand's motion stays, the cursor's is scaled: nothing in the law is in px."""
    columns = build("hold").differentiator.run(EventColumns.of(*jagged(5)))
    scaled = columns.table.copy()
    scaled[:, 1:3] *= factor
    np.testing.assert_allclose(ends(MotionColumns(scaled)), factor * ends(columns), rtol=1e-12)


def test_alone_it_knows_no_time_either() -> None:
    """own = 1: the same path walked three times as fast has the same endpoints."""
    columns = build("hold").differentiator.run(EventColumns.of(*jagged(7)))
    fast = columns.table.copy()
    fast[:, 0] /= 3.0
    fast[:, 3:5] *= 3.0
    fast[:, 5:7] *= 9.0
    both = [ends(MotionColumns(table), **ALONE) for table in (columns.table, fast)]
    moving = np.hypot(*columns.table[:, 3:5].T) > 0.004  # below 2 mm/s the hand counts as still
    np.testing.assert_allclose(both[1][moving], both[0][moving], rtol=1e-9)


def test_a_second_sub_movement_is_doubled_from_its_own_start() -> None:
    """Two minimum-jerk reaches with a standstill between them: at the second peak only the second doubles."""
    s = np.linspace(0.0, 1.0, 1001)
    x, v = 10 * s**3 - 15 * s**4 + 6 * s**5, 30 * s**2 - 60 * s**3 + 30 * s**4
    a = 60 * s - 180 * s**2 + 120 * s**3
    first, second = np.array([500.0, 0.0]), np.array([0.0, 250.0])
    place = np.concatenate([np.outer(x, first), first + np.outer(x[1:], second)])
    columns = motions(
        np.concatenate([s, 1.0 + s[1:]]),
        place,
        np.concatenate([np.outer(v, first), np.outer(v[1:], second)]),
        np.concatenate([np.outer(a, first), np.outer(a[1:], second)]),
    )
    assert ends(columns, **ALONE)[1500] == pytest.approx([500.0, 250.0], abs=0.5)
    never = ends(columns, **{**ALONE, "rise": 10.0})[1500]
    assert np.hypot(*(never - [500.0, 250.0])) > 5.0


def test_a_resting_cursor_has_arrived() -> None:
    """After 60 ms at rest nothing is left, whatever came before."""
    t = np.arange(0.0, 0.5, 0.001)
    events = EventColumns.of(t, np.round(400 * np.clip(t / 0.3, 0, 1) ** 2), np.zeros(len(t)))
    found = run(build("switched-direction"), events).table
    assert np.hypot(found[-1, 1] - 400.0, found[-1, 2]) < 1.0
