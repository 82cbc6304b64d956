"""Peaks of the speed, found in one pass, against the definition tried on every pair of samples."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from pointpred.scoring.trials import divide, divided


def by_pairs(speeds: list[float]) -> bool:
    """Are there two samples, each above a fifth of the highest speed, with a fall by half between them?"""
    count = len(speeds)
    lower = [
        min(speeds[i], speeds[j])
        for i in range(count)
        for j in range(i + 2, count)
        if 2.0 * min(speeds[i : j + 1]) < min(speeds[i], speeds[j])
    ]
    return 5.0 * max(lower, default=0.0) > max(speeds, default=0.0)


def motions(speeds: list[float]) -> np.ndarray:
    table = np.zeros((len(speeds), 10))
    table[:, 3] = np.array(speeds) * 0.6
    table[:, 4] = np.array(speeds) * -0.8
    return table


@settings(max_examples=400, deadline=None)
@given(st.lists(st.integers(0, 12).map(float), max_size=14))
@example([0.0, 10.0, 4.0, 9.0])
@example([0.0, 10.0, 0.0, 2.0])
@example([0.0, 2.0, 0.0, 3.0, 1.0, 10.0])
def test_one_pass_finds_what_the_definition_says(speeds: list[float]) -> None:
    table = np.zeros((len(speeds), 10))
    table[:, 3] = speeds
    assert divided(table, 0, len(speeds)) == by_pairs(speeds)


@pytest.mark.parametrize(
    ("speeds", "expected"),
    [
        ([0, 50, 100, 50, 0], False),
        ([0, 100, 90, 100, 0], False),
        ([0, 100, 45, 95, 0], True),
        ([0, 50, 40, 100, 0], False),
        ([0, 50, 24, 100, 0], True),
        ([0, 100, 0, 19, 0], False),
        ([0, 100, 0, 21, 0], True),
        ([0, 19, 0, 100, 0], False),
        ([0, 30, 10, 100, 0], True),
        ([0, 100, 10, 60], True),
        ([], False),
    ],
)
def test_speeds_to_judge_by_eye(speeds: list[float], expected: bool) -> None:
    assert divided(motions(speeds), 0, len(speeds)) is expected


def test_each_trial_is_judged_on_its_own() -> None:
    table = motions([0, 100, 0, 0, 90, 0, 80, 0])
    out = np.zeros(2, dtype=np.bool_)
    divide(table, np.array([0, 4, 8]), out)
    assert out.tolist() == [False, True]
