"""Level sets of mixtures against scipy's laws, drawn points, fine grids and the ellipse of one law."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats

from pointpred.errors import ParameterError
from pointpred.predictors import mixture
from pointpred.predictors.mixture import LevelSet, Mixture, Part
from pointpred.records import FloatArray
from pointpred.regions import reach, region_of

ELSEWHERE = Part(0.4, 500.0, 300.0, (9000.0, 2000.0, 4000.0), 1.2)
NEAR = Part(0.3, 800.0, 300.0, (100.0, 0.0, 100.0), None)
BESIDE = Part(0.2, 822.0, 330.0, (400.0, 0.0, 400.0), None)
FAR = Part(0.1, -100.0, 0.0, (25.0, 0.0, 25.0), None)
MIXTURE = Mixture((ELSEWHERE, NEAR, BESIDE, FAR))
LEVELS = (0.2, 0.5, 0.8, 0.9)


def drawn(mixture: Mixture, count: int, random: np.random.Generator) -> FloatArray:
    """Points drawn from a mixture."""
    points = []
    for part, own in zip(
        mixture.parts, random.multinomial(count, [p.share for p in mixture.parts]), strict=True
    ):
        sxx, sxy, syy = part.scale
        chi = random.chisquare(part.tail, own) / part.tail if part.tail else np.ones(own)
        off = random.multivariate_normal((0.0, 0.0), [[sxx, sxy], [sxy, syy]], own) / np.sqrt(chi)[:, None]
        points.append(off + np.array([part.x, part.y]))
    return np.concatenate(points)


def scipy_density(mixture: Mixture, points: FloatArray) -> FloatArray:
    """The density by scipy."""
    total = np.zeros(len(points))
    for part in mixture.parts:
        sxx, sxy, syy = part.scale
        law = stats.multivariate_t((part.x, part.y), [[sxx, sxy], [sxy, syy]], df=part.tail or np.inf)
        total += part.share * law.pdf(points)
    return total


def winding(outlines: tuple[FloatArray, ...], x: float, y: float) -> bool:
    """Whether a point lies within the outlines: an odd number of edges is right of it."""
    odd = False
    for one in outlines:
        other = np.roll(one, -1, axis=0)
        crossing = (one[:, 1] > y) != (other[:, 1] > y)
        a, b = one[crossing], other[crossing]
        odd ^= bool(np.sum(a[:, 0] + (y - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0]) > x) % 2)
    return odd


def test_the_density_is_scipys() -> None:
    points = drawn(MIXTURE, 300, np.random.default_rng(1))
    own = [MIXTURE.density(x, y) for x, y in points]
    np.testing.assert_allclose(own, scipy_density(MIXTURE, points), rtol=1e-9)


@pytest.mark.parametrize("level", LEVELS)
def test_a_region_holds_its_share_of_drawn_points(level: float) -> None:
    points = drawn(MIXTURE, 400_000, np.random.default_rng(2))
    region = MIXTURE.region(level)
    held = float((scipy_density(MIXTURE, points) >= region.threshold).mean())
    assert held == pytest.approx(level, abs=0.002 + 4.0 * math.sqrt(level * (1.0 - level) / len(points)))
    some = points[:200]
    inside = [region.contains(x, y) for x, y in some]
    assert inside == (scipy_density(MIXTURE, some) >= region.threshold).tolist()


@pytest.mark.parametrize("level", LEVELS)
def test_the_area_is_that_of_a_fine_grid(level: float) -> None:
    """Each piece is counted on a grid of its own."""
    region, area = MIXTURE.region(level), 0.0
    for outline in region.outlines:
        low, high = outline.min(axis=0) - 1e-6, outline.max(axis=0) + 1e-6
        x, y = (np.linspace(low[k], high[k], 801)[:-1] + (high[k] - low[k]) / 1600 for k in range(2))
        points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
        mine = scipy_density(MIXTURE, points) >= region.threshold
        others = [one for one in region.outlines if one is not outline]
        assert not any(winding((one,), *points[mine][0]) for one in others)
        area += float(mine.mean() * np.prod(high - low))
    assert region.area == pytest.approx(area, rel=0.01)


@pytest.mark.parametrize("level", LEVELS)
def test_outlines_lie_where_the_density_is_the_threshold_and_bound_what_is_denser(level: float) -> None:
    region = MIXTURE.region(level)
    for outline in region.outlines:
        np.testing.assert_allclose(scipy_density(MIXTURE, outline), region.threshold, rtol=0.01)
    points = drawn(MIXTURE, 2000, np.random.default_rng(3))
    ratio = scipy_density(MIXTURE, points) / region.threshold
    clear = (ratio < 0.95) | (ratio > 1.05)
    inside = [winding(region.outlines, x, y) for x, y in points[clear]]
    assert (np.array(inside) == (ratio[clear] > 1.0)).mean() > 0.999


def test_places_apart_are_pieces_apart() -> None:
    """Three pieces: the far place, both near ones together, and the middle of elsewhere."""
    assert len(Mixture((ELSEWHERE, NEAR, BESIDE, FAR)).region(0.8).outlines) == 3
    assert len(Mixture((Part(1.0, 0.0, 0.0, (4.0, 0.0, 9.0), 2.0),)).region(0.8).outlines) == 1


@given(
    level=st.floats(0.05, 0.95),
    scale=st.sampled_from([(400.0, 0.0, 100.0), (400.0, 120.0, 90.0), (9.0, 0.0, 9.0)]),
    tail=st.none() | st.floats(0.6, 50.0),
)
@settings(max_examples=40, deadline=None)
def test_of_one_part_it_is_the_ellipse(level: float, scale: tuple[float, ...], tail: float | None) -> None:
    sxx, sxy, syy = scale
    region = Mixture((Part(1.0, 30.0, -20.0, (sxx, sxy, syy), tail),)).region(level)
    ellipse = region_of(level, 30.0, -20.0, sxx, sxy, syy, tail or math.nan)
    assert ellipse is not None
    assert region.content == pytest.approx(level, abs=1e-9)
    assert region.area == pytest.approx(math.pi * ellipse.major * ellipse.minor, rel=1e-6)
    far = ellipse.major * np.array([math.cos(ellipse.angle), math.sin(ellipse.angle)])
    assert region.contains(30.0 + 0.9999 * far[0], -20.0 + 0.9999 * far[1])
    assert not region.contains(30.0 + 1.0001 * far[0], -20.0 + 1.0001 * far[1])
    (outline,) = region.outlines
    off = outline - (30.0, -20.0)
    inverse = np.linalg.inv([[sxx, sxy], [sxy, syy]])
    np.testing.assert_allclose(
        np.einsum("ni,ij,nj->n", off, inverse, off), reach(level, tail or math.nan), rtol=0.02
    )


def test_regions_of_higher_levels_hold_those_of_lower_ones() -> None:
    """However the levels are corrected, also where the correction would turn them round."""
    for offsets in ((0.0, 0.0), (2.0, -3.0), (-1.0, 1.0), (6.0, 6.0)):
        mixture = Mixture(MIXTURE.parts, offsets)
        contents = [mixture.region(level).content for level in (0.05, 0.3, 0.5, 0.6, 0.8, 0.95)]
        assert contents == sorted(contents)
        assert contents[-1] < 1.0


@pytest.mark.parametrize("tail", [0.7, 3.0])
@pytest.mark.parametrize("offset", [-1.2, 0.0, 0.9])
def test_a_corrected_level_has_the_radius_that_it_should(tail: float, offset: float) -> None:
    """By scipy's F law: a growing squared radius is multiplied, a shrinking one is that of a lower level."""
    own = mixture.corrected_probability(0.8, tail, offset, offset)
    lower = 1.0 - 0.2 ** math.exp(min(offset, 0.0))
    radius = stats.f.ppf(lower, 2.0, tail) * math.exp(max(offset, 0.0))
    assert own == pytest.approx(stats.f.cdf(radius, 2.0, tail), abs=1e-9)


def test_the_share_of_denser_places_by_few_points_is_near_that_by_many() -> None:
    """What judges a movement counts 32 points a part."""
    for x, y in drawn(MIXTURE, 60, np.random.default_rng(4)):
        few, many = (mixture.content(MIXTURE.table, 4, x, y, points) for points in (32, 20_000))
        assert few == pytest.approx(many, abs=0.04)


@pytest.mark.parametrize("level", [0.0, 1.0, -1.0, "0.5", True])
def test_a_level_that_is_none_is_refused(level: object) -> None:
    with pytest.raises(ParameterError):
        MIXTURE.region(level)  # type: ignore[arg-type]


def test_a_region_is_a_record() -> None:
    assert isinstance(MIXTURE.region(0.5), LevelSet)
    assert MIXTURE.region(0.5).area < MIXTURE.region(0.8).area


@pytest.mark.parametrize(("middle", "right"), [(1.0, True), (-1.0, False)])
def test_of_four_crossings_of_a_cell_those_are_joined_that_the_middle_says(
    middle: float, right: bool
) -> None:
    """Two opposite corners are denser: the contour from below goes on to the right, or else to the left."""
    heights = np.array([[1.0, -1.0], [-1.0, 1.0]])
    following = np.empty(8)
    mixture.follow_cells(heights, np.full((2, 2), middle), 2, 2, following)
    below, right_side, left_side = (mixture.edge_of(side, 0, 0, 2, 2) for side in (0, 1, 3))
    assert following[below] == (right_side if right else left_side)
