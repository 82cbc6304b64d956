"""The guarded transfer function: what it may add to the hand's motion, for any hand and any prediction."""

from __future__ import annotations

from math import atan, expm1, hypot, inf, nan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred import Prediction
from pointpred.transfer import ConstantGain, GuardedTransfer, PixelTransfer, SigmoidGain, assistance

CPI, DPI, H = 2000.0, 96.0, 2.0**-10
COUNT = st.integers(-60, 60)
PLACE = st.floats(-3000.0, 3000.0)
SHARE = st.floats(0.0, 1.0)
PREDICTIONS = st.none() | st.tuples(
    PLACE, PLACE, st.none() | st.tuples(st.floats(0.0, 1e6), st.floats(0.0, 1e6))
)
REPORTS = st.lists(st.tuples(COUNT, COUNT, PREDICTIONS), min_size=1, max_size=80)


def prediction(x: float, y: float, sd: tuple[float, float] | float | None = None) -> Prediction:
    """An endpoint, and the standard deviations of its axes where a region is claimed."""
    spread = (sd, sd) if isinstance(sd, float) else sd
    covariance = None if spread is None else (spread[0] ** 2, 0.0, spread[1] ** 2)
    return Prediction(0.0, x, y, covariance, "ballistic", None)


def made(strength: float = 0.5, **others: float) -> GuardedTransfer:
    return GuardedTransfer(ConstantGain(4.0), cpi=CPI, dpi=DPI, strength=strength, period_s=H, **others)


def played(
    stage: GuardedTransfer, reports: list[tuple[int, int, tuple | None]]
) -> list[tuple[float, float, float, float]]:
    """The whole pixels of each report and those of them that were added; the cursor starts at 0."""
    x = y = 0.0
    out = []
    for i, (dx, dy, told) in enumerate(reports):
        guess = None if told is None else prediction(told[0], told[1], told[2])
        off = (nan,) * 5 if guess is None else (guess.x - x, guess.y - y, *(guess.scale or (nan,) * 3))
        _, moved_x, moved_y, added_x, added_y = stage.advance((i * H, float(dx), float(dy), *off))
        x, y = x + moved_x, y + moved_y
        out.append((moved_x, moved_y, added_x, added_y))
    return out


@settings(deadline=None)
@given(REPORTS, SHARE, SHARE, st.floats(0.1, 300.0))
def test_nothing_is_ever_added_against_the_hand(
    reports: list[tuple[int, int, tuple | None]], strength: float, sideways: float, rho: float
) -> None:
    stage = made(strength, sideways=sideways, rho=rho)
    for (dx, dy, told), (moved_x, moved_y, added_x, added_y) in zip(
        reports, played(stage, reports), strict=True
    ):
        assert added_x * dx + added_y * dy >= 0.0
        assert moved_x * dx + moved_y * dy >= 0.0
        if (dx, dy) == (0, 0):
            assert (moved_x, moved_y) == (0.0, 0.0)
        assert (added_x, added_y) == (np.trunc(added_x), np.trunc(added_y))
        if told is None:
            assert hypot(added_x, added_y) == 0.0


@settings(deadline=None)
@given(REPORTS, st.sampled_from([ConstantGain(4.0), SigmoidGain()]))
def test_without_strength_it_is_the_plain_function_bit_for_bit(
    reports: list[tuple[int, int, tuple | None]], function: ConstantGain
) -> None:
    stage = GuardedTransfer(function, cpi=CPI, dpi=DPI, strength=0.0, period_s=H)
    plain = PixelTransfer(function, cpi=CPI, dpi=DPI, period_s=H)
    found = [row[:2] for row in played(stage, reports)]
    assert found == [plain.update((i * H, float(r[0]), float(r[1]))) for i, r in enumerate(reports)]


def test_no_single_pixel_goes_against_a_wavering_hand_whose_axes_round_at_different_times() -> None:
    random = np.random.default_rng(1)
    opposing = 0
    for _ in range(60):
        heading = random.uniform(0.0, 2.0 * np.pi)
        angles, sizes = heading + 0.3 * random.normal(size=200), random.uniform(0.0, 30.0, 200)
        told = (2e4 * float(np.cos(heading + 0.7)), 2e4 * float(np.sin(heading + 0.7)), (0.0, 0.0))
        counts = [(round(m * np.cos(a)), round(m * np.sin(a))) for m, a in zip(sizes, angles, strict=True)]
        rows = played(made(0.9, sideways=1.0, rho=300.0), [(dx, dy, told) for dx, dy in counts])
        for (dx, dy), (_, _, added_x, added_y) in zip(counts, rows, strict=True):
            assert added_x * dx + added_y * dy >= 0.0
            opposing += added_x * dx < 0.0 or added_y * dy < 0.0
    assert opposing > 10  # one axis alone may oppose the hand


def test_bending_fades_towards_a_right_angle() -> None:
    guard = np.array([50.0, 1.0, 1.0, 0.5, 0.25])
    bent = [
        assistance.guide(guard, 0.001, (9.0, 0.0), (90.0 * np.cos(a), 90.0 * np.sin(a), 0.0, 0.0, 0.0))[1]
        for a in np.deg2rad([0.0, 45.0, 80.0, 89.0, 89.99, 91.0])
    ]
    share = -expm1(-0.05) * 90.0
    expected = [0.0, share / 2.0, *(share * np.sin(a) * np.cos(a) for a in np.deg2rad([80.0, 89.0]))]
    assert bent[:4] == pytest.approx(expected, rel=1e-9, abs=1e-12)
    assert 0.0 <= bent[4] < 0.001
    assert bent[5] == 0.0


GUARD = st.tuples(st.floats(0.0, 300.0), SHARE, SHARE, st.floats(1e-3, 10.0), st.floats(0.0, 2.0))


@settings(deadline=None)
@given(GUARD, st.floats(0.0, 0.1), *(st.floats(-50.0, 50.0),) * 2, PLACE, PLACE, *(st.floats(0.0, 1e6),) * 2)
def test_what_is_added_is_bounded_before_it_is_rounded(
    guard: tuple[float, ...],
    dt: float,
    own_x: float,
    own_y: float,
    off_x: float,
    off_y: float,
    sxx: float,
    syy: float,
) -> None:
    x, y = assistance.guide(np.array(guard), dt, (own_x, own_y), (off_x, off_y, sxx, 0.0, syy))
    own, way = hypot(own_x, own_y), hypot(off_x, off_y)
    if own < 1e-6 or way < 1e-6:
        assert hypot(x, y) <= own
        return
    along, across = (x * own_x + y * own_y) / own, (y * own_x - x * own_y) / own
    tiny = 1e-9 * (own + 1.0)
    _, strength, sideways, uncertain, _ = guard
    assert -tiny <= along <= strength * own + tiny
    assert abs(across) <= strength * sideways * own + tiny
    ahead = (off_x * own_x + off_y * own_y) / own
    if ahead <= 0.0 or max(sxx, syy) ** 0.5 >= uncertain * way:
        assert (x, y) == (0.0, 0.0)
    assert own + along <= max(own, ahead) + tiny  # never past the endpoint by assistance
    if abs(across) > tiny:  # towards the endpoint, not away from it
        assert across * (off_y * own_x - off_x * own_y) > 0.0


def test_it_is_the_remark_where_nothing_bounds_it() -> None:
    """Straight at a sure endpoint: -rho (x - T) integrated over the report, in real numbers."""
    guard = np.array([5.0, 1.0, 1.0, 0.5, 0.25])
    x, y = assistance.guide(guard, 0.01, (30.0, 0.0), (400.0, 0.0, 0.0, 0.0, 0.0))
    assert x == pytest.approx(-expm1(-5.0 * 0.01) * 400.0, rel=1e-12)
    assert y == 0.0


def test_a_sure_endpoint_is_reached_sooner_and_never_passed_by_help() -> None:
    stage, x, added = made(1.0, rho=1e4), 0.0, []
    for i in range(400):
        _, moved, _, more, _ = stage.advance((i * H, 10.0, 0.0, 300.0 - x, 0.0, 1.0, 0.0, 1.0))
        added.append((x, more))
        x += moved
    assert max(before for before, more in added if more) < 300.0
    assert sum(more for _, more in added) == pytest.approx(150.0, abs=4.0)  # half of the way, at strength 1


def test_help_fades_with_the_region_and_ends_where_it_is_as_wide_as_half_the_way() -> None:
    totals = []
    for sd in (0.0, 50.0, 100.0, 150.0, 199.0, 200.0, 500.0):
        stage, x = made(), 0.0
        for i in range(20):
            step = stage.update((i * H, 20.0, 0.0), prediction(x + 400.0, 0.0, sd), (x, 0.0))
            x += step[0]
        totals.append(x)
    own = 20 * 20.0 * 4.0 * DPI / CPI
    expected = [own * (1.0 + 0.5 * max(0.0, 1.0 - sd / 200.0)) for sd in (0.0, 50.0, 100.0, 150.0)]
    assert totals[:4] == pytest.approx(expected, abs=2.0)
    assert totals[4] - own < 2.0
    assert totals[5:] == pytest.approx([own] * 2, abs=1.0)


def test_the_longest_axis_of_the_region_counts() -> None:
    """Against numpy's eigenvalues."""
    random = np.random.default_rng(3)
    for _ in range(50):
        a = random.normal(size=(2, 2)) * random.uniform(0.1, 300.0)
        s = a @ a.T
        found = assistance.spread(250.0, s[0, 0], s[0, 1], s[1, 1], 0.25)
        assert found == pytest.approx(np.sqrt(np.linalg.eigvalsh(s)[-1]) / 250.0, rel=1e-9)
    assert assistance.spread(250.0, nan, nan, nan, 0.25) == 0.25
    assert assistance.spread(250.0, 1.0, inf, 1.0, 0.25) == inf


def test_the_cursor_is_turned_by_no_more_than_the_bound_says() -> None:
    stage, x, y, turned = made(1.0, sideways=0.5, rho=300.0), 0.0, 0.0, []
    for i in range(300):
        _, dx, dy, _, _ = stage.advance((i * H, 30.0, 0.0, 2000.0 - x, 2000.0 - y, 0.0, 0.0, 0.0))
        x, y = x + dx, y + dy
        turned.append(np.arctan2(y, x))
    assert 0.1 < max(turned[20:]) <= atan(0.5) + 0.02
    left, _ = made(1.0), 0.0
    assert left.advance((0.0, 30.0, 0.0, -500.0, 1.0, 0.0, 0.0, 0.0))[3:] == (0.0, 0.0)


def test_a_predictor_without_a_region_is_trusted_as_far_as_said() -> None:
    def added(**settings: float) -> float:
        stage = made(1.0, rho=1000.0, **settings)
        return sum(stage.advance((i * H, 30.0, 0.0, 2000.0, 0.0, nan, nan, nan))[3] for i in range(50))

    full, half, none = added(unclaimed=0.0), added(), added(unclaimed=0.5)
    assert half == pytest.approx(full / 2.0, abs=2.0)
    assert none == 0.0
    assert full > 200.0
