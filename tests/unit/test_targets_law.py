"""How much of a widened law falls to a rectangle: against scipy's densities and against drawn endpoints."""

from __future__ import annotations

from math import exp, isfinite, nan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from pointpred.targets.posterior import EFFECTIVE, Law, log_mass

CASES = [
    (0.0, 0.0, 40.0, 20.0, 900.0, 200.0, 400.0),
    (60.0, -25.0, 40.0, 20.0, 900.0, 200.0, 400.0),
    (10.0, 10.0, 8.0, 200.0, 2500.0, -2000.0, 1700.0),
    (-300.0, 150.0, 124.0, 124.0, 1e4, 0.0, 1e4),
    (3.0, 1.0, 30.0, 30.0, 1.0, 0.0, 1.0),
]


def found(dx: float, dy: float, width: float, height: float, spread: tuple[float, ...]) -> float:
    sxx, sxy, syy, tail = spread
    return log_mass(Law(0.0, 0.0, sxx, sxy, syy, tail), dx, dy, width, height)


@pytest.mark.parametrize("tail", [nan, 1.5, 4.0, 30.0])
@pytest.mark.parametrize("case", CASES)
def test_the_mass_is_scipys_density_at_the_centre_times_the_area(
    case: tuple[float, ...], tail: float
) -> None:
    dx, dy, width, height, sxx, sxy, syy = case
    shape = np.array([[sxx + (width / EFFECTIVE) ** 2, sxy], [sxy, syy + (height / EFFECTIVE) ** 2]])
    law = (
        stats.multivariate_normal([0.0, 0.0], shape)
        if tail != tail
        else stats.multivariate_t([0.0, 0.0], shape, df=tail)
    )
    expected = float(law.logpdf([dx, dy])) + np.log(width * height)
    assert found(dx, dy, width, height, (sxx, sxy, syy, tail)) == pytest.approx(expected, abs=1e-9)


def test_widening_is_the_law_of_people_who_aim_at_the_centre() -> None:
    """Endpoint predicted + scatter about what is aimed at, drawn apart, lie where the widened law says."""
    generator = np.random.default_rng(1)
    width, height, covariance = 15.0, 9.0, np.array([[300.0, 120.0], [120.0, 200.0]])
    predicted = generator.multivariate_normal([0.0, 0.0], covariance, 300_000)
    drawn = predicted + generator.standard_normal(predicted.shape) * (width / EFFECTIVE, height / EFFECTIVE)
    share = (np.abs(drawn - (25.0, 5.0)) < (7.5, 4.5)).all(axis=1).mean()
    mass = exp(found(25.0, 5.0, width, height, (300.0, 120.0, 200.0, nan)))
    assert mass == pytest.approx(share, rel=0.04)


sizes = st.floats(1.0, 500.0)
places = st.floats(-2000.0, 2000.0)


@given(places, places, sizes, sizes, sizes, sizes, st.floats(-0.95, 0.95), st.sampled_from([nan, 2.0, 8.0]))
def test_mirrors_and_quarter_turns_change_nothing(
    dx: float, dy: float, width: float, height: float, sx: float, sy: float, rho: float, tail: float
) -> None:
    sxx, sxy, syy = sx * sx, rho * sx * sy, sy * sy
    here = found(dx, dy, width, height, (sxx, sxy, syy, tail))
    assert isfinite(here)
    assert found(-dx, dy, width, height, (sxx, -sxy, syy, tail)) == pytest.approx(here, abs=1e-9)
    assert found(-dy, dx, height, width, (syy, -sxy, sxx, tail)) == pytest.approx(here, abs=1e-9)


@given(places, places, sizes, sizes, sizes, st.floats(1.0, 3.0), st.sampled_from([nan, 2.0, 8.0]))
def test_a_wider_rectangle_is_never_less_likely(
    dx: float, dy: float, width: float, height: float, s: float, wider: float, tail: float
) -> None:
    narrow = found(dx, dy, width, height, (s * s, 0.0, s * s, tail))
    assert found(dx, dy, wider * width, height, (s * s, 0.0, s * s, tail)) >= narrow - 1e-9


def test_a_rectangle_out_of_all_reach_has_a_finite_logarithm() -> None:
    assert -1e13 < found(1e6, 0.0, 10.0, 10.0, (1.0, 0.0, 1.0, nan)) < -1e8
