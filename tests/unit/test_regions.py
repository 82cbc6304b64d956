"""Regions of predictions against scipy's laws, numpy's eigenvectors and drawn points."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy import stats

from pointpred import Prediction, PredictionColumns, Region
from pointpred.errors import ParameterError
from pointpred.protocol.server_messages import EndpointLaw as Sent
from pointpred.protocol.server_messages import PredictionMessage as Told
from pointpred.regions import as_normal, reach
from pointpred.scoring.measures import regions
from pointpred.training import calibration

NONE = float("nan")
LEVELS = (0.1, 0.5, 0.8, 0.95, 0.999)
MATRICES = [(400.0, 0.0, 100.0), (100.0, 0.0, 400.0), (400.0, 120.0, 90.0), (1.0, -0.9, 1.0), (9.0, 0.0, 9.0)]
tails = st.floats(0.05, 1e4)
levels = st.floats(0.001, 0.999)


def predicted(scale: Any, tail: float | None = None, x: float = 300.0, y: float = -20.0) -> Prediction:
    return Prediction(0.5, x, y, scale, "ballistic", None, tail)


def region(scale: Any, level: float, tail: float | None = None, **place: float) -> Region:
    found = predicted(scale, tail, **place).region(level)
    assert found is not None
    return found


def inside(one: Region, points: np.ndarray) -> np.ndarray:
    """Which points lie in the ellipse as it would be drawn."""
    off = points - (one.x, one.y)
    along = off @ (math.cos(one.angle), math.sin(one.angle))
    across = off @ (-math.sin(one.angle), math.cos(one.angle))
    held: np.ndarray = (along / one.major) ** 2 + (across / one.minor) ** 2 <= 1.0
    return held


@pytest.mark.parametrize("level", LEVELS)
def test_a_normal_region_goes_as_far_as_chi_squared_says(level: float) -> None:
    assert reach(level, NONE) == pytest.approx(stats.chi2.ppf(level, 2), rel=1e-12)


@pytest.mark.parametrize("tail", [0.3, 0.6, 1.0, 1.4, 3.0, 30.0, 1e4])
@pytest.mark.parametrize("level", LEVELS)
def test_a_student_region_goes_as_far_as_twice_the_f_distribution_says(level: float, tail: float) -> None:
    """The squared Mahalanobis distance of a p-variate Student law over p has an F distribution (p, tail)."""
    assert reach(level, tail) == pytest.approx(2.0 * stats.f.ppf(level, 2, tail), rel=1e-8)


@pytest.mark.parametrize("tail", [None, 0.6, 1.4, 5.0])
@pytest.mark.parametrize("scale", MATRICES)
def test_the_ellipse_holds_its_share_of_points_drawn_from_the_law(
    scale: tuple[float, float, float], tail: float | None
) -> None:
    sxx, sxy, syy = scale
    law = stats.multivariate_t([300.0, -20.0], [[sxx, sxy], [sxy, syy]], df=np.inf if tail is None else tail)
    points = law.rvs(200_000, random_state=np.random.default_rng(7))
    for level in (0.5, 0.8):
        share = inside(region(scale, level, tail), points).mean()
        assert share == pytest.approx(level, abs=0.005)


@pytest.mark.parametrize("scale", MATRICES)
def test_axes_are_those_of_the_matrix(scale: tuple[float, float, float]) -> None:
    sxx, sxy, syy = scale
    values, vectors = np.linalg.eigh([[sxx, sxy], [sxy, syy]])
    found = region(scale, 0.8)
    factor = math.sqrt(stats.chi2.ppf(0.8, 2))
    assert [found.minor, found.major] == pytest.approx((factor * np.sqrt(values)).tolist(), rel=1e-12)
    assert (found.x, found.y) == (300.0, -20.0)
    if values[0] < values[1]:
        direction = (math.cos(found.angle), math.sin(found.angle))
        assert abs(vectors[:, 1] @ direction) == pytest.approx(1.0)
    assert -math.pi / 2 < found.angle <= math.pi / 2


def test_a_thin_region_keeps_its_breadth() -> None:
    """Its eigenvalues differ by 1e12; the product of the half axes follows from the determinant."""
    turn = 0.3
    c, s = math.cos(turn), math.sin(turn)
    sxx, sxy, syy = 1e8 * c * c + 1e-4 * s * s, (1e8 - 1e-4) * c * s, 1e8 * s * s + 1e-4 * c * c
    found = region((sxx, sxy, syy), 0.5)
    area = 2.0 * math.log(2.0) * math.sqrt(sxx * syy - sxy * sxy)
    assert found.major * found.minor == pytest.approx(area, rel=1e-9)
    assert found.angle == pytest.approx(turn)


@given(levels, levels, tails)
def test_a_higher_level_goes_further_and_a_heavier_tail_too(one: float, other: float, tail: float) -> None:
    assume(one < other)
    assert 0.0 < reach(one, tail) < reach(other, tail)
    assert reach(one, tail) > reach(one, 2.0 * tail) > reach(one, NONE)


@given(st.floats(0.0, 2.0 * math.pi), st.floats(1.0, 100.0), st.floats(1.01, 10.0), tails, levels)
def test_a_turned_law_has_a_turned_region(
    turn: float, breadth: float, longer: float, tail: float, level: float
) -> None:
    wide, broad = (breadth * longer) ** 2, breadth**2
    c, s = math.cos(turn), math.sin(turn)
    scale = (wide * c * c + broad * s * s, (wide - broad) * c * s, wide * s * s + broad * c * c)
    straight, turned = (region(one, level, tail) for one in ((wide, 0.0, broad), scale))
    assert (turned.major, turned.minor) == pytest.approx((straight.major, straight.minor), rel=1e-6)
    assert math.sin(turned.angle - turn) == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("tail", [1e15, 1e17, 1e300, math.inf])
def test_a_student_law_with_a_huge_tail_is_normal(tail: float) -> None:
    for level in (1e-9, 0.5, 1.0 - 1e-12):
        assert reach(level, tail) == pytest.approx(reach(level, NONE), rel=1e-9)


def test_a_tiny_tail_reaches_far() -> None:
    assert reach(0.5, 0.01) == pytest.approx(0.01 * (2.0 ** (2.0 / 0.01) - 1.0), rel=1e-12)


@pytest.mark.parametrize(
    ("scale", "tail"),
    [
        ((400.0, 0.0, 100.0), 1e-3),
        ((1.0, 0.0, 1.0), 1e-9),
        ((1.0, 0.0, 1.0), 5e-324),
        ((1e300, 0.0, 1.0), 0.01),
    ],
)
def test_an_ellipse_too_large_for_a_number_is_none(scale: tuple[float, float, float], tail: float) -> None:
    one = Prediction(0.5, 3.0, 4.0, scale, "ballistic", None, tail)
    assert one.region(0.8) is None
    columns = PredictionColumns(np.array([[0.5, 3.0, 4.0, *scale, NONE, 1.0, tail, NONE]]))
    assert list(columns.region(0.8)) == [None]
    sent = Told(0.5, 3.0, 4.0, Sent(*scale, tail))
    assert sent.region(0.8) is None


def test_a_thin_region_of_a_tiny_tail_keeps_its_breadth() -> None:
    """The square of its reach times the determinant is no number; the half axes are."""
    found = region((1e3, 0.0, 1e2), 0.8, 0.0047)  # reaches 1e297
    assert found.major / found.minor == pytest.approx(math.sqrt(10.0))


@pytest.mark.parametrize("level", [np.float32(0.5), np.float64(0.5), np.float16(0.5), Fraction(1, 2)])
def test_any_real_number_is_a_level(level: Any) -> None:
    assert predicted((400.0, 0.0, 100.0)).region(level) == region((400.0, 0.0, 100.0), 0.5)


def test_a_small_level_is_not_lost_to_rounding() -> None:
    assert reach(1e-12, NONE) == pytest.approx(2e-12, rel=1e-9)
    assert reach(1e-12, 1.5) == pytest.approx(2e-12, rel=1e-9)


@pytest.mark.parametrize(
    "level",
    [
        0.0,
        1.0,
        -0.1,
        1.5,
        NONE,
        math.inf,
        "0.5",
        None,
        True,
        np.float32(1.0),
        np.True_,
        1,
        Fraction(10**30 - 1, 10**30),
    ],
)
def test_a_level_outside_0_and_1_is_refused(level: Any) -> None:
    table = np.zeros((1, 10))
    for one in (predicted((400.0, 0.0, 100.0)), predicted(None), PredictionColumns(table)):
        with pytest.raises(ParameterError, match="level"):
            one.region(level)


@pytest.mark.parametrize(
    "scale",
    [None, (0.0, 0.0, 1.0), (1.0, 1.0, 1.0), (4.0, 6.0, 9.0), (1.0, 2.0, 1.0), (-1.0, 0.0, -1.0),
     (NONE, 0.0, 1.0), (math.inf, 0.0, 1.0)],
)  # fmt: skip
def test_no_region_without_an_inside(scale: Any) -> None:
    assert predicted(scale).region(0.5) is None
    assert predicted(scale, 1.5).region(0.5) is None


@pytest.mark.parametrize("tail", [0.0, -1.0, -math.inf])
def test_no_region_of_a_tail_that_no_law_has(tail: float) -> None:
    assert predicted((400.0, 0.0, 100.0), tail).region(0.5) is None


def test_the_covariance_is_that_of_the_law() -> None:
    scale = (400.0, 120.0, 90.0)
    assert predicted(None).covariance is None
    assert predicted(scale).covariance == scale
    assert predicted(scale, math.inf).covariance == scale
    for tail in (0.5, 2.0):
        assert predicted(scale, tail).covariance is None
    drawn = stats.multivariate_t([0.0, 0.0], [[400.0, 120.0], [120.0, 90.0]], df=9.0).rvs(
        400_000, random_state=np.random.default_rng(3)
    )
    found = predicted(scale, 9.0).covariance
    assert found is not None
    assert np.cov(drawn.T)[[0, 0, 1], [0, 1, 1]] == pytest.approx(found, rel=0.03)


def test_columns_give_the_regions_of_their_rows() -> None:
    rows = [(0.1 * i, 5.0 * i, -i, *scale, NONE, 1.0) for i, scale in enumerate(MATRICES)]
    table = np.array([(*row, tail, NONE) for row in rows for tail in (NONE, 0.7, 4.0)])
    table = np.concatenate(
        [table, [[9.0, *[NONE] * 6, 0.0, NONE, NONE], [9.1, 1, 2, *[NONE] * 4, 1.0, NONE, NONE]]]
    )
    columns = PredictionColumns(table)
    regions = columns.region(0.8)
    wanted = [None if one is None else one.region(0.8) for one in columns]
    assert list(regions) == wanted
    assert wanted[-2:] == [None, None]
    assert None not in wanted[:-2]
    assert np.isnan(regions.major).tolist() == [one is None for one in wanted]
    assert len(PredictionColumns(np.empty((0, 10))).region(0.5)) == 0


def test_scoring_and_training_have_the_same_law() -> None:
    heavy = np.geomspace(0.05, 1e17, 40)
    for level in LEVELS:
        wanted = [reach(level, tail) for tail in heavy.tolist()]
        assert calibration.reaches(level, heavy) == pytest.approx(wanted, rel=1e-14)
        assert [regions.reach(level, tail) for tail in heavy] == pytest.approx(wanted, rel=1e-14)
        assert regions.reach(level, NONE) == pytest.approx(reach(level, NONE), rel=1e-14)


@pytest.mark.parametrize("tail", [0.3, 0.73, 1.0, 4.0, 1e9])
def test_the_normal_law_of_a_student_law_has_its_middle_region(tail: float) -> None:
    scale = (900.0, 120.0, 400.0)
    student = Prediction(0.0, 5.0, 7.0, scale, "ballistic", None, tail)
    normal = Prediction(0.0, 5.0, 7.0, as_normal(*scale, tail), "ballistic", None)
    one, other = student.region(0.5), normal.region(0.5)
    assert one is not None
    assert other is not None
    assert (one.major, one.minor, one.angle) == pytest.approx((other.major, other.minor, other.angle))


def test_a_normal_law_is_its_own() -> None:
    assert as_normal(900.0, 120.0, 400.0, math.nan) == (900.0, 120.0, 400.0)
    assert all(map(math.isnan, as_normal(math.nan, math.nan, math.nan, math.nan)))
