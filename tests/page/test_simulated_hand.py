"""The simulated hand of the page package: from a seed the movements of Python, which are those of people."""

from __future__ import annotations

from itertools import groupby
from typing import Any

import numpy as np
import pytest

from pointpred.simulation import hand
from tests.page import node

pytestmark = node.needed

Reports = list[list[float]]
START = {"x": 20.0, "y": 10.0}
HANDS = [{"seed": seed, "skill": seed % 11 / 10, "at": START} for seed in (*range(40), 2**31 - 3)]
BOXES = [
    {"box": {"x": 500.0, "y": 300.0, "width": 100.0, "height": 40.0}, "clicks": False},
    {"box": {"x": 100.0, "y": 80.0, "width": 20.0, "height": 24.0}, "clicks": True},
    {"box": {"x": 900.0, "y": 70.0, "width": 0.0, "height": 0.0}, "clicks": False},
    {"box": {"x": 905.0, "y": 75.0, "width": 30.0, "height": 12.0}, "clicks": True},
]
SMALLEST_PX = 6.0


@pytest.fixture(scope="module")
def moved() -> list[list[Reports]]:
    answer: list[list[Reports]] = node.run("reach.mjs", {"hands": HANDS, "boxes": BOXES})
    return answer


def reach(memory: np.ndarray, at: tuple[float, float], box: dict[str, float], clicks: bool) -> Reports:
    """What the mouse reports by the laws in Python: a row for each change, and the last."""
    x, y, width, height = box.values()
    hand.aim(memory, x + width / 2 - at[0], y + height / 2 - at[1], max(min(width, height), SMALLEST_PX))
    end = hand.RELEASED if clicks else hand.RESTING
    last, rows = [*at, False], []
    while True:
        report = hand.Report(*hand.report(memory))
        now = [at[0] + report.x, at[1] + report.y, report.pressed == 1.0]
        if now != last or report.phase >= end:
            rows.append([report.t, *now])
        if report.phase >= end:
            return rows
        last = now


def test_the_same_seed_is_the_same_movement_in_python(moved: list[list[Reports]]) -> None:
    for one, movements in zip(HANDS, moved, strict=True):
        memory, at = np.zeros(hand.LENGTH), (START["x"], START["y"])
        hand.begin(memory, float(one["seed"]), one["skill"])
        for given, found in zip(BOXES, movements, strict=True):
            assert found == reach(memory, at, given["box"], given["clicks"])
            at = (found[-1][1], found[-1][2])


def test_other_seeds_and_skills_are_other_movements(moved: list[list[Reports]]) -> None:
    assert len({str(movements[0]) for movements in moved}) == len(HANDS)
    expert, novice = ({"seed": 3, "skill": skill, "at": START} for skill in (1.0, 0.0))
    quick, slow = node.run("reach.mjs", {"hands": [expert, novice], "boxes": BOXES})
    assert sum(one[-1][0] for one in quick) < sum(one[-1][0] for one in slow)


def test_it_ends_in_the_target_and_clicks_there_once(moved: list[list[Reports]]) -> None:
    for movements in moved:
        for given, rows in zip(BOXES, movements, strict=True):
            x, y, width, height = given["box"].values()
            slack = SMALLEST_PX if width == 0.0 else 0.0
            inside = [row for row in rows if row[3]] or rows[-1:]
            assert all(abs(row[1] - x - width / 2) <= width / 2 + slack for row in inside)
            assert all(abs(row[2] - y - height / 2) <= height / 2 + slack for row in inside)
            pressed = [key for key, _ in groupby(row[3] for row in rows)]
            assert pressed == ([False, True, False] if given["clicks"] else [False])


def progress(rows: Reports) -> np.ndarray:
    """How far each report is on the straight way, as a share of it."""
    places = np.array([[START["x"], START["y"]], *[row[1:3] for row in rows]])
    box: Any = BOXES[0]["box"]
    way = np.array([box["x"] + box["width"] / 2, box["y"] + box["height"] / 2]) - places[0]
    return np.asarray((places - places[0]) @ way / (way @ way))


def test_it_moves_as_people_do(moved: list[list[Reports]]) -> None:
    first = [movements[0] for movements in moved]
    seconds = np.array([rows[-1][0] for rows in first])
    assert 0.7 < np.median(seconds) < 1.6
    assert max(seconds) < 3.0
    shares = [progress(rows) for rows in first]
    assert any(share.max() > 1.05 for share in shares), "some overshoot by more than the target's half"
    corrected = [np.any(np.diff(share) < 0.0) for share in shares]
    assert 0.2 < np.mean(corrected) < 1.0, "some turn back"
    speeds = [np.hypot(*np.diff([row[1:3] for row in rows], axis=0).T).max() for rows in first]
    assert 10.0 < np.median(speeds) < 80.0, "px in 8 ms, at the fastest"
