"""Every measure on a trial small enough to score by hand."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred.scoring.measures import endpoint
from pointpred.scoring.results import AXIS_FRACTIONS, PATH_FRACTIONS, TIME_FRACTIONS

NAN = float("nan")

# t, x, y: 100 px to the right and 40 up, arrived at row 4; progress 0, 20, 60, 50, 94, 100 %.
ROWS = np.array(
    [
        [0.00, 0.0, 0.0, NAN, NAN, 0.0],
        [0.02, 20.0, 8.0, NAN, NAN, 0.0],
        [0.10, 60.0, 24.0, NAN, NAN, 0.0],
        [0.12, 50.0, 20.0, NAN, NAN, 0.0],
        [0.16, 94.0, 37.6, NAN, NAN, 0.0],
        [0.50, 100.0, 40.0, NAN, NAN, 0.0],
    ]
)
POINTS = np.array([[103.0, 44.0], [100.0, 30.0], [NAN, NAN], [100.0, 43.0], [101.0, 40.0], [100.0, 47.0]])
ERRORS = [5.0, 10.0, np.hypot(40.0, 16.0), 3.0, 1.0, 7.0]


def measured(rows: np.ndarray, points: np.ndarray, arrival: int) -> dict[str, object]:
    answers = np.full((len(rows), 8), NAN)
    answers[:, 1:3] = points
    out = np.empty(endpoint.MEASURES)
    verdict = endpoint.measure_trial(rows, answers, endpoint.FRACTIONS, arrival, out)
    return {
        "verdict": verdict,
        "time_averaged": out[endpoint.TIME_AVERAGED],
        "coverage": out[endpoint.COVERAGE],
        "by_time": dict(zip(TIME_FRACTIONS, out[endpoint.BY_TIME : endpoint.BY_PATH], strict=True)),
        "by_path": dict(zip(PATH_FRACTIONS, out[endpoint.BY_PATH : endpoint.SINGLE_AXIS], strict=True)),
        "single_axis": dict(zip(AXIS_FRACTIONS, out[endpoint.SINGLE_AXIS :], strict=True)),
    }


def test_time_averaged_error_weights_each_sample_by_the_time_until_the_next_up_to_fifty_ms() -> None:
    weights = [0.02, 0.05, 0.02, 0.04]
    expected = sum(w * e for w, e in zip(weights, ERRORS, strict=False)) / sum(weights)
    assert measured(ROWS, POINTS, 4)["time_averaged"] == pytest.approx(expected, rel=1e-12)


def test_error_at_a_time_fraction_is_that_of_the_last_sample_at_or_before() -> None:
    by_time = measured(ROWS, POINTS, 4)["by_time"]
    rows = {0.2: 1, 0.3: 1, 0.4: 1, 0.5: 1, 0.6: 1, 0.7: 2, 0.8: 3, 0.9: 3}
    assert by_time == {fraction: pytest.approx(ERRORS[row]) for fraction, row in rows.items()}


def test_of_samples_with_equal_times_the_last_is_in_force() -> None:
    rows = ROWS.copy()
    rows[2, 0] = rows[1, 0]
    assert measured(rows, POINTS, 4)["by_time"][0.3] == pytest.approx(ERRORS[2])


def test_error_at_a_path_fraction_is_that_of_the_first_sample_so_far_along() -> None:
    by_path = measured(ROWS, POINTS, 4)["by_path"]
    rows = {0.1: 1, 0.25: 2, 0.5: 2, 0.75: 4, 0.9: 4, 0.95: 5, 1.0: 5}
    assert by_path == {fraction: pytest.approx(ERRORS[row]) for fraction, row in rows.items()}


def test_single_axis_reads_the_longer_axis_only() -> None:
    single = measured(ROWS, POINTS, 4)["single_axis"]
    assert (single[0.05], single[0.2]) == (0.0, 0.0)
    assert (single[0.25], single[0.6]) == (40.0, 40.0)
    assert (single[0.65], single[0.9], single[0.95], single[1.0]) == (1.0, 1.0, 0.0, 0.0)


def test_single_axis_follows_the_vertical_when_it_is_longer_and_runs_upwards() -> None:
    turned = ROWS.copy()
    turned[:, 1], turned[:, 2] = ROWS[:, 2], -ROWS[:, 1]
    points = np.column_stack([POINTS[:, 1], -POINTS[:, 0]])
    here, there = measured(ROWS, POINTS, 4), measured(turned, points, 4)
    assert here == there


def test_coverage_is_the_share_of_events_with_an_answer() -> None:
    assert measured(ROWS, POINTS, 4)["coverage"] == pytest.approx(5 / 6)


def test_where_nothing_is_answered_the_cursor_is_scored() -> None:
    silent = measured(ROWS, np.full((6, 2), NAN), 4)
    held = measured(ROWS, ROWS[:, 1:3], 4)
    assert silent["coverage"] == 0.0
    assert held["coverage"] == 1.0
    assert {**silent, "coverage": 1.0} == held


@pytest.mark.parametrize("point", [[np.inf, 0.0], [-np.inf, 0.0], [0.0, np.inf], [0.0, NAN]])
def test_an_answer_that_is_not_finite_is_named(point: list[float]) -> None:
    points = POINTS.copy()
    points[3] = point
    assert measured(ROWS, points, 4)["verdict"] == 3


def test_several_trials_are_measured_each_on_its_own_wherever_the_chunk_begins() -> None:
    answers = np.full((12, 8), NAN)
    answers[:, 1:3] = np.concatenate([POINTS, ROWS[:, 1:3]])
    out, faults = np.empty((2, endpoint.MEASURES)), np.empty(2, dtype=np.int64)
    rows, offsets = np.concatenate([ROWS, ROWS]), np.array([100, 106, 112])
    endpoint.measure(rows, answers, endpoint.FRACTIONS, offsets, offsets[:-1] + 4, out, faults)
    assert faults.tolist() == [endpoint.SOUND, endpoint.SOUND]
    assert out[0, endpoint.TIME_AVERAGED] == measured(ROWS, POINTS, 4)["time_averaged"]
    assert out[1, endpoint.TIME_AVERAGED] == measured(ROWS, ROWS[:, 1:3], 4)["time_averaged"]
