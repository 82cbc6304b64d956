"""The mass of a widened law in a rectangle, against scipy and against drawn endpoints."""

from __future__ import annotations

from math import exp, isfinite, nan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from pointpred.targets.rectangle_mass import EFFECTIVE, log_mass

CASES = [
    (0.0, 0.0, 40.0, 20.0, 900.0, 200.0, 400.0),
    (60.0, -25.0, 40.0, 20.0, 900.0, 200.0, 400.0),
    (10.0, 10.0, 8.0, 200.0, 2500.0, -2000.0, 1700.0),
    (-300.0, 150.0, 124.0, 124.0, 1e4, 0.0, 1e4),
    (3.0, 1.0, 30.0, 30.0, 1.0, 0.0, 1.0),
]


def widened(width: float, height: float, sxx: float, sxy: float, syy: float) -> np.ndarray:
    return np.array([[sxx + (width / EFFECTIVE) ** 2, sxy], [sxy, syy + (height / EFFECTIVE) ** 2]])


@pytest.mark.parametrize("case", CASES)
def test_a_normal_mass_is_scipys(case: tuple[float, ...]) -> None:
    dx, dy, width, height, sxx, sxy, syy = case
    law = stats.multivariate_normal([0.0, 0.0], widened(width, height, sxx, sxy, syy))
    low, high = np.array([dx - width / 2, dy - height / 2]), np.array([dx + width / 2, dy + height / 2])
    expected = float(law.cdf(high, lower_limit=low))
    assert exp(log_mass((dx, dy, width, height), (sxx, sxy, syy, nan))) == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize("tail", [1.5, 4.0, 30.0])
@pytest.mark.parametrize("case", CASES)
def test_a_student_mass_is_that_of_drawn_points(case: tuple[float, ...], tail: float) -> None:
    dx, dy, width, height, sxx, sxy, syy = case
    shape = widened(width, height, sxx, sxy, syy)
    law = stats.multivariate_t([0.0, 0.0], shape, df=tail)
    drawn = law.rvs(400_000, random_state=np.random.default_rng(5))
    inside = (np.abs(drawn - (dx, dy)) <= (width / 2, height / 2)).all(axis=1)
    share = inside.mean()
    spread = np.sqrt(share * (1 - share) / len(drawn))
    assert exp(log_mass((dx, dy, width, height), (sxx, sxy, syy, tail))) == pytest.approx(
        share, abs=4.5 * spread + 2e-3 * share
    )


def test_widening_is_the_law_of_people_who_aim_at_the_centre() -> None:
    """Endpoint predicted + scatter about what is aimed at, drawn apart, lie where the widened law says."""
    generator = np.random.default_rng(1)
    width, height, covariance = 50.0, 30.0, np.array([[300.0, 120.0], [120.0, 200.0]])
    predicted = generator.multivariate_normal([0.0, 0.0], covariance, 300_000)
    drawn = predicted + generator.standard_normal(predicted.shape) * (width / EFFECTIVE, height / EFFECTIVE)
    share = ((drawn[:, 0] > 0.0) & (drawn[:, 0] < 50.0) & (drawn[:, 1] > -10.0) & (drawn[:, 1] < 20.0)).mean()
    assert exp(log_mass((25.0, 5.0, width, height), (300.0, 120.0, 200.0, nan))) == pytest.approx(
        share, abs=4e-3
    )


sizes = st.floats(1.0, 500.0)
places = st.floats(-2000.0, 2000.0)


@given(places, places, sizes, sizes, sizes, sizes, st.floats(-0.95, 0.95), st.sampled_from([nan, 2.0, 8.0]))
def test_mirrors_and_quarter_turns_change_nothing(
    dx: float, dy: float, width: float, height: float, sx: float, sy: float, rho: float, tail: float
) -> None:
    sxx, sxy, syy = sx * sx, rho * sx * sy, sy * sy
    here = log_mass((dx, dy, width, height), (sxx, sxy, syy, tail))
    assert isfinite(here)
    assert log_mass((-dx, dy, width, height), (sxx, -sxy, syy, tail)) == pytest.approx(here, abs=1e-9)
    assert log_mass((-dy, dx, height, width), (syy, -sxy, sxx, tail)) == pytest.approx(here, abs=1e-9)


@given(places, places, sizes, sizes, sizes, st.floats(1.0, 3.0), st.sampled_from([nan, 2.0, 8.0]))
def test_a_wider_rectangle_is_never_less_likely(
    dx: float, dy: float, width: float, height: float, s: float, wider: float, tail: float
) -> None:
    narrow = log_mass((dx, dy, width, height), (s * s, 0.0, s * s, tail))
    assert log_mass((dx, dy, wider * width, height), (s * s, 0.0, s * s, tail)) >= narrow - 2e-3


def test_a_rectangle_out_of_all_reach_has_a_finite_logarithm() -> None:
    assert -1e13 < log_mass((1e6, 0.0, 10.0, 10.0), (1.0, 0.0, 1.0, nan)) < -1e8


@given(
    st.floats(-40.0, 40.0),
    st.floats(-40.0, 40.0),
    sizes,
    sizes,
    sizes,
    sizes,
    st.floats(-0.97, 0.97),
    st.sampled_from([nan, 1.01, 1.5, 3.0, 5.0, 8.0]),
)
def test_cheap_sums_are_within_the_stated_bound_of_the_whole_one(
    zx: float, zy: float, width: float, height: float, sx: float, sy: float, rho: float, tail: float
) -> None:
    """Against all 25 nodes, each with numpy's matrices."""
    shape = widened(width, height, sx * sx, rho * sx * sy, sy * sy)
    nodes, weights = np.polynomial.legendre.leggauss(5)
    u, v = (grid.ravel() for grid in np.meshgrid(nodes, nodes, indexing="ij"))
    points = np.stack([zx * sx + 0.5 * width * u, zy * sy + 0.5 * height * v])
    far = (points * np.linalg.solve(shape, points)).sum(axis=0)
    density = -0.5 * far if tail != tail else -0.5 * (tail + 2.0) * np.log1p(far / tail)
    scale = 0.25 * width * height / (2.0 * np.pi * np.sqrt(np.linalg.det(shape)))
    whole = np.log((np.outer(weights, weights).ravel() * scale * np.exp(density - density.max())).sum())
    found = log_mass((zx * sx, zy * sy, width, height), (sx * sx, rho * sx * sy, sy * sy, tail))
    bound = 3e-4 if tail == tail else 1e-9 * max(1.0, -density.max())
    assert found == pytest.approx(whole + density.max(), abs=bound)
