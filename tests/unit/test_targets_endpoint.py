"""The law of the endpoint given targets: against products of densities, a minimiser and linear algebra."""

from __future__ import annotations

from math import nan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import minimize

from pointpred.predictors.mixture import PartRow
from pointpred.records import FloatArray
from pointpred.targets import around, cursor, endpoint
from pointpred.targets.posterior import EFFECTIVE, Law
from pointpred.targets.rectangles import table

ROWS = table([around("near", 300.0, -120.0, 60.0, 20.0), around("far", -200.0, 400.0, 9.0, 300.0)])
CLAIM = Law(280.0, -100.0, 1600.0, -500.0, 900.0, nan)
LAWS = [
    CLAIM,
    CLAIM._replace(x=900.0, y=50.0),
    CLAIM._replace(sxx=4.0, sxy=1.0, syy=9.0),
    CLAIM._replace(sxx=1e6, sxy=0.0, syy=1e5),
]


def part_of(row: FloatArray, predicted: Law, share: float = 0.4) -> tuple[float, FloatArray, FloatArray]:
    """The tail, the mean and the covariance of what is written for a target."""
    part = PartRow(np.full(PartRow.length, nan))
    endpoint.write_target(row, predicted, share, part)
    assert part.share == share
    return part.tail, np.array([part.x, part.y]), np.array([[part.sxx, part.sxy], [part.sxy, part.syy]])


def product(row: FloatArray, predicted: Law, wide: float) -> tuple[FloatArray, FloatArray]:
    """The mean and covariance of the product of the densities of a target and a wider predicted law."""
    own = np.diag((row[2:4] / EFFECTIVE) ** 2)
    other = wide * matrix(predicted) + endpoint.NARROWEST * own
    covariance = np.linalg.inv(np.linalg.inv(own) + np.linalg.inv(other))
    mean = covariance @ (np.linalg.solve(own, row[:2]) + np.linalg.solve(other, [predicted.x, predicted.y]))
    return mean, covariance


def matrix(predicted: Law) -> FloatArray:
    return np.array([[predicted.sxx, predicted.sxy], [predicted.sxy, predicted.syy]])


@pytest.mark.parametrize("row", ROWS)
@pytest.mark.parametrize("predicted", LAWS)
def test_in_a_target_it_is_the_product_of_two_normal_densities(row: FloatArray, predicted: Law) -> None:
    tail, mean, covariance = part_of(row, predicted)
    expected, spread = product(row, predicted, endpoint.WIDER)
    assert tail == 0.0
    assert mean == pytest.approx(expected, rel=1e-9)
    assert covariance == pytest.approx(spread, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("row", ROWS)
@pytest.mark.parametrize("predicted", LAWS)
@pytest.mark.parametrize("freedom", [1.5, 5.0, 1e9])
def test_a_student_law_is_wider_the_farther_the_target_is(
    row: FloatArray, predicted: Law, freedom: float
) -> None:
    """A Student law is a normal one of unknown width: far off, it is likely to be a wide one."""
    off = row[:2] - (predicted.x, predicted.y)
    own = np.diag((row[2:4] / EFFECTIVE) ** 2)
    about = endpoint.WIDER * matrix(predicted) + (1.0 + endpoint.NARROWEST) * own
    wide = endpoint.WIDER * (freedom + off @ np.linalg.solve(about, off)) / (freedom + 2.0)
    _, mean, covariance = part_of(row, predicted._replace(tail=freedom))
    expected, spread = product(row, predicted, wide)
    assert mean == pytest.approx(expected, rel=1e-9)
    assert covariance == pytest.approx(spread, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("tail", [nan, 3.0])
def test_what_is_predicted_surely_tells_no_more_than_the_target_is_wide(tail: float) -> None:
    for row in ROWS:
        for off in (0.0, 1e3, 1e6):
            _, mean, covariance = part_of(row, Law(row[0] + off, row[1], 1e-6, 0.0, 1e-6, tail))
            assert (np.linalg.eigvalsh(covariance) > 0.0).all()
            assert (np.diag(covariance) <= (row[2:4] / EFFECTIVE) ** 2).all()
            assert row[0] <= mean[0] <= row[0] + off
            assert mean[1] == pytest.approx(row[1])


def parts_of(shares: FloatArray, predicted: Law, least: float) -> FloatArray:
    out = np.full((len(ROWS) + 1, PartRow.length), nan)
    return out[: endpoint.mixture(ROWS, shares, predicted, least, out)]


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0), st.sampled_from([0.0, 1e-3, 0.2]))
def test_the_shares_of_the_parts_sum_to_one_and_unlikely_targets_count_for_elsewhere(
    some: float, of: float, least: float
) -> None:
    shares = np.array([some * of, some * (1.0 - of), 1.0 - some])
    parts = parts_of(shares, CLAIM, least)
    kept = shares[:2][shares[:2] >= least]
    assert parts[:, 0].sum() == pytest.approx(1.0)
    assert parts[1:, 0].tolist() == kept.tolist()
    assert parts[0, 1:].tolist() == [*CLAIM[:5], 0.0]
    assert parts_of(shares, CLAIM._replace(tail=4.0), least)[0, 6] == 4.0


def anything(seed: int) -> FloatArray:
    """Parts somewhere, one of them far away and unlikely."""
    random = np.random.default_rng(seed)
    count = int(random.integers(1, 7))
    parts = np.zeros((count, PartRow.length))
    parts[:, 0] = random.dirichlet(np.ones(count))
    parts[:, 1:3] = random.normal(0.0, 300.0, (count, 2))
    parts[-1, 1:3] *= 10.0
    for part in parts:
        half = random.normal(0.0, 20.0, (2, 2))
        part[3], part[4], part[5] = (half @ half.T)[[0, 0, 1], [0, 1, 1]]
    return parts


@pytest.mark.parametrize("seed", range(12))
def test_the_endpoint_is_where_the_expected_distance_is_least(seed: int) -> None:
    parts = anything(seed)

    def cost(point: FloatArray) -> float:
        soft = np.maximum(0.5 * (parts[:, 3] + parts[:, 5]), endpoint.LEAST_PX2)
        return float(parts[:, 0] @ np.sqrt(((parts[:, 1:3] - point) ** 2).sum(axis=1) + soft))

    found = np.array(endpoint.geometric_median(parts, len(parts)))
    start = parts[:, 0] @ parts[:, 1:3]
    best = minimize(cost, start, tol=1e-10).fun
    assert cost(found) == pytest.approx(best, rel=0.01)
    assert cost(found) <= cost(start) * (1.0 + 1e-9)


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("way", [(0.0, 0.0), (5.0, 0.0), (-30.0, 40.0)])
def test_the_ellipse_has_the_mean_distances_along_and_across_the_way(
    seed: int, way: tuple[float, float]
) -> None:
    parts, centre = anything(seed), np.array([10.0, -20.0])
    far = np.hypot(*way)
    u = np.array(way) / far if far else np.array([1.0, 0.0])
    turn = np.array([u, (-u[1], u[0])])
    squares = np.zeros(2)
    for share, x, y, sxx, sxy, syy, _ in parts:
        second = np.outer((x, y) - centre, (x, y) - centre) + np.array([[sxx, sxy], [sxy, syy]])
        squares += share * np.sqrt(np.diag(turn @ second @ turn.T))
    expected = turn.T @ np.diag(endpoint.RADII2 * squares**2) @ turn
    x, y, *scale, tail = endpoint.ellipse(parts, len(parts), (10.0, -20.0), way)
    assert (x, y, tail) == (10.0, -20.0, endpoint.TAIL)
    assert scale == pytest.approx(expected[[0, 0, 1], [0, 1, 1]].tolist(), rel=1e-9, abs=1e-6)


def test_elsewhere_is_what_is_predicted_or_a_law_that_stands_in() -> None:
    state = cursor.State(np.zeros(cursor.State.length))
    cursor.follow(state.memory, 0.0, 0.0, 0.0, 0.0)
    cursor.follow(state.memory, 0.1, 100.0, 0.0, 0.0)
    answer = (0.1, 280.0, -100.0, 1600.0, -500.0, 900.0, 0.2, 1.0, 5.0, nan)
    assert endpoint.elsewhere(state.memory, answer) == (280.0, -100.0, 1600.0, -500.0, 900.0, 5.0)
    for no_law in ((nan, nan, nan), (1.0, 1.0, 1.0), (-1.0, 0.0, 1.0)):
        stands_in = Law(*endpoint.elsewhere(state.memory, (*answer[:3], *no_law, *answer[6:])))
        assert (stands_in.x, stands_in.y) == (280.0, -100.0)
        assert (np.linalg.eigvalsh(matrix(stands_in)) > 0.0).all()
        assert np.isnan(stands_in.tail)
