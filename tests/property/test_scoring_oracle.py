"""The compiled scorer against a second one, written in plain Python straight from the protocol."""

from __future__ import annotations

from math import cos, hypot, isnan, sin
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from pointpred import EventColumns
from pointpred.recording import Recording, Trial
from pointpred.records import BoolArray, FloatArray, MotionColumns
from pointpred.scoring import prepare, replay
from pointpred.scoring.results import AXIS_FRACTIONS, PATH_FRACTIONS, TIME_FRACTIONS, PredictorErrors
from tests.scripted import Scripted, pipeline_with

Row = tuple[float, float, float, int]


def opinion(t: float, x: float, y: float) -> tuple[float, float] | None:
    """What the predictor under test answers: any function of one sample that is at times silent."""
    if cos(311.0 * t + x) < -0.4:
        return None
    return x + 90.0 * sin(57.0 * t), y - 40.0 * cos(13.0 * t + y)


class Opinionated(Scripted):
    def answers(self, motions: MotionColumns, begin: BoolArray) -> FloatArray:
        table = np.full((len(motions), 10), np.nan)
        for i, (t, x, y) in enumerate(motions.table[:, :3].tolist()):
            answer = opinion(t, x, y)
            if answer is not None:
                table[i, 1:3] = answer
        return table


PIPELINE = pipeline_with("opinionated", Opinionated())


def dist(a: Row, b: Row) -> float:
    return hypot(a[1] - b[1], a[2] - b[2])


def oracle(rows: list[Row]) -> dict[str, Any] | None:
    """All measures of a trial by the words of the protocol; ``None`` when it cannot be scored."""
    if len(rows) < 2:
        return None
    presses = [
        i
        for i in range(1, len(rows))
        if rows[i][3] & 1 and not rows[i - 1][3] & 1 and dist(rows[i], rows[0]) > 3.0
    ]
    rows = rows[: presses[-1] + 1] if presses else rows
    rows = rows[max(i for i, row in enumerate(rows) if dist(row, rows[0]) <= 3.0) :]
    start, end = rows[0], rows[-1]
    distance = dist(start, end)
    near = max(8.0, 0.03 * distance)
    arrival = min(i for i in range(len(rows)) if all(dist(row, end) <= near for row in rows[i:]))
    if len(rows) < 2 or arrival == 0 or rows[arrival][0] == start[0]:
        return None
    points = [opinion(t, x, y) for t, x, y, _ in rows]
    scored = [(row[1], row[2]) if point is None else point for row, point in zip(rows, points, strict=True)]
    errors = [hypot(x - end[1], y - end[2]) for x, y in scored]
    weights = [min(rows[i + 1][0] - rows[i][0], 0.05) for i in range(arrival)]

    def in_force(fraction: float) -> float:
        moment = start[0] + fraction * (rows[arrival][0] - start[0])
        return [error for row, error in zip(rows, errors, strict=True) if row[0] <= moment][-1]

    def first(reached: list[bool], values: list[float]) -> float:
        return values[reached.index(True)]

    way = (end[1] - start[1], end[2] - start[2])
    dots = [(row[1] - start[1]) * way[0] + (row[2] - start[2]) * way[1] for row in rows]
    axis = 1 if abs(way[1]) > abs(way[0]) else 0
    sign = -1.0 if way[axis] < 0 else 1.0
    along = [sign * (row[1 + axis] - start[1 + axis]) for row in rows]
    off = [abs(point[axis] - end[1 + axis]) for point in scored]
    length2 = way[0] * way[0] + way[1] * way[1]
    return {
        "time_averaged": sum(w * e for w, e in zip(weights, errors, strict=False)) / sum(weights),
        "coverage": sum(point is not None for point in points) / len(rows),
        "by_time": [in_force(fraction) for fraction in TIME_FRACTIONS],
        "by_path": [first([d >= f * length2 for d in dots], errors) for f in PATH_FRACTIONS],
        "single_axis": [first([a >= f * abs(way[axis]) for a in along], off) for f in AXIS_FRACTIONS],
        "distance": distance,
        "arrival_s": rows[arrival][0] - start[0],
        "events": len(rows),
    }


@st.composite
def paths(draw: st.DrawFn) -> list[Row]:
    """Walks on whole pixels with equal stamps, long gaps, dwell and clicks."""
    steps = draw(
        st.lists(
            st.tuples(
                st.sampled_from([0.0, 0.004, 0.016, 0.07, 0.3]),
                st.integers(-30, 60),
                st.integers(-25, 50),
                st.sampled_from([0, 0, 0, 1, 2]),
            ),
            max_size=25,
        )
    )
    t, x, y = draw(st.sampled_from([(0.5, 10.0, -20.0), (0.0, 0.0, 0.0), (-3.0, 900.0, 2000.0)]))
    rows = [(t, x, y, 0)]
    turn = draw(st.sampled_from([(1, 1), (-1, 1), (1, -1), (-1, -1)]))
    for dt, dx, dy, buttons in steps:
        t, x, y = t + dt, x + turn[0] * dx, y + turn[1] * dy
        rows.append((t, x, y, buttons))
    return rows


def recording(trials: list[list[Row]]) -> Recording:
    parts = []
    for rows in trials:
        table = np.array(rows, dtype=float)
        parts.append(EventColumns.of(*table.T[:3], buttons=table[:, 3]))
    return Recording.of("set", parts, [Trial(f"u{i % 2}", str(i)) for i in range(len(trials))])


def scored(trials: list[list[Row]]) -> tuple[Any, PredictorErrors]:
    prepared = prepare(recording(trials), threads=1)
    return prepared, replay(prepared, PIPELINE, threads=1)


@settings(max_examples=300, deadline=None)
@given(st.lists(paths(), min_size=1, max_size=4))
def test_scorer_agrees_with_the_words_of_the_protocol(trials: list[list[Row]]) -> None:
    expected = {str(i): oracle(rows) for i, rows in enumerate(trials)}
    prepared, errors = scored(trials)
    assert {skip.trial for skip in prepared.skipped} == {k for k, v in expected.items() if v is None}
    assert len(prepared.trials) + len(prepared.skipped) == len(trials)
    for i, trial in enumerate(prepared.trials):
        wanted = expected[trial.trial.trial]
        assert wanted is not None
        assert trial.distance_px == pytest.approx(wanted["distance"], rel=1e-12)
        assert trial.arrival_s == wanted["arrival_s"]
        assert trial.events == wanted["events"]
        assert errors.time_averaged[i] == pytest.approx(wanted["time_averaged"], rel=1e-9)
        assert errors.coverage[i] == wanted["coverage"]
        for name in ("by_time", "by_path", "single_axis"):
            assert getattr(errors, name)[i].tolist() == pytest.approx(wanted[name], rel=1e-9), name


@settings(max_examples=40, deadline=None)
@given(st.lists(paths(), min_size=2, max_size=6), st.randoms(use_true_random=False))
def test_the_order_of_trials_changes_nothing(trials: list[list[Row]], random: Any) -> None:
    order = list(range(len(trials)))
    random.shuffle(order)
    prepared, errors = scored(trials)
    shuffled, again = scored([trials[k] for k in order])
    known = {str(k): errors.time_averaged[i] for i, k in enumerate(_numbers(prepared))}
    for i, k in enumerate(_numbers(shuffled)):
        assert again.time_averaged[i] == known[str(order[k])]
    assert len(shuffled.skipped) == len(prepared.skipped)


def _numbers(prepared: Any) -> list[int]:
    return [int(trial.trial.trial) for trial in prepared.trials]


@settings(max_examples=60, deadline=None)
@given(paths(), st.integers(1, 5))
def test_a_dwell_appended_at_the_endpoint_changes_no_error(rows: list[Row], count: int) -> None:
    rows = [(t, x, y, 0) for t, x, y, _ in rows]
    t, x, y, _ = rows[-1]
    longer = rows + [(t + 0.2 * (i + 1), x, y, 0) for i in range(count)]
    prepared, errors = scored([rows])
    after, again = scored([longer])
    assume(len(prepared.trials) == 1)
    assert after.trials[0].arrival_s == prepared.trials[0].arrival_s
    for name in ("time_averaged", "by_time", "by_path", "single_axis"):
        assert np.array_equal(getattr(errors, name), getattr(again, name)), name


def test_the_oracle_is_not_blind() -> None:
    rows = [(0.0, 0.0, 0.0, 0), (0.1, 50.0, 0.0, 0), (0.2, 100.0, 0.0, 0)]
    wanted = oracle(rows)
    assert wanted is not None
    assert not isnan(wanted["time_averaged"])
    assert oracle(rows[:1]) is None
