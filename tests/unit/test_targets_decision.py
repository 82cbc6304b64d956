"""When something is proposed: thresholds, hysteresis, what is too late."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.records import FloatArray
from pointpred.targets import around, cursor
from pointpred.targets.decision import NOBODY, decide, rank
from pointpred.targets.rectangles import table

TABLE = table([around("a", 100.0, 0.0, 20.0), around("b", 0.0, 100.0, 20.0)])
ASK, KEEP = 0.8, 0.32


def at(x: float, y: float, speed: float = 100.0) -> FloatArray:
    state = cursor.State(np.zeros(cursor.State.length))
    state.known, state.x, state.y, state.speed = 1.0, x, y, speed
    return state.memory


def walk(sequence: Sequence[tuple[float, float]]) -> list[int]:
    standing, found = NOBODY, []
    for a, b in sequence:
        shares = np.array([a, b, max(1.0 - a - b, 0.0)])
        standing = decide(at(0.0, 0.0), TABLE, shares, standing, np.nan, (ASK, KEEP, 0.05, 0.0))
        found.append(standing)
    return found


def test_asked_kept_and_withdrawn() -> None:
    assert walk([(0.79, 0.1), (0.8, 0.1), (0.4, 0.5), (0.33, 0.6), (0.31, 0.6), (0.31, 0.6)]) == [
        NOBODY, 0, 0, 0, NOBODY, NOBODY,
    ]  # fmt: skip


def test_another_that_is_sure_takes_its_place() -> None:
    assert walk([(0.9, 0.1), (0.1, 0.85)]) == [0, 1]


shares = st.lists(st.floats(0.0, 1.0).map(lambda a: (a, 0.0)), max_size=60)


@given(shares)
def test_it_changes_no_more_often_than_the_share_crosses_the_whole_band(
    sequence: list[tuple[float, float]],
) -> None:
    found = walk(sequence)
    changes = sum(a != b for a, b in zip([NOBODY, *found], found, strict=False))
    crossings, above = 0, False
    for a, _ in sequence:
        if (not above and a >= ASK) or (above and a < KEEP):
            crossings, above = crossings + 1, not above
    assert changes == crossings


@given(st.lists(st.floats(KEEP, ASK - 1e-9), min_size=1, max_size=60), st.booleans())
def test_a_share_that_trembles_within_the_band_changes_nothing(values: list[float], proposed: bool) -> None:
    found = walk([(ASK if proposed else 0.0, 0.0), *((value, 0.0) for value in values)])
    assert set(found) == {0 if proposed else NOBODY}


@pytest.mark.parametrize(
    ("x", "speed", "remaining_s", "proposed"),
    [
        (0.0, 100.0, np.nan, True),  # 90 px at 100 px/s
        (88.0, 100.0, np.nan, False),  # 2 px: 20 ms
        (88.0, 100.0, 0.5, True),  # but the predictor says that it takes longer
        (88.0, 100.0, 0.04, False),
        (0.0, 100.0, 0.0, True),  # a predictor that calls a slow hand arrived
        (95.0, 0.0, np.nan, False),  # inside
        (95.0, 0.0, 9.0, False),
    ],
)
def test_what_is_entered_at_once_is_not_proposed(
    x: float, speed: float, remaining_s: float, proposed: bool
) -> None:
    sure = np.array([0.95, 0.02, 0.03])
    found = decide(at(x, 0.0, speed), TABLE, sure, NOBODY, remaining_s, (ASK, KEEP, 0.05, 0.0))
    assert found == (0 if proposed else NOBODY)


@pytest.mark.parametrize(("x", "proposed"), [(0.0, False), (2.99, False), (3.0, True), (-3.0, True)])
def test_nothing_is_proposed_before_the_cursor_has_set_out(x: float, proposed: bool) -> None:
    sure = np.array([0.95, 0.02, 0.03])
    found = decide(at(x, 0.0), TABLE, sure, NOBODY, np.nan, (ASK, KEEP, 0.05, 3.0))
    assert found == (0 if proposed else NOBODY)
    assert decide(at(x, 0.0), TABLE, sure, 0, np.nan, (ASK, KEEP, 0.05, 3.0)) == 0  # what stands, stays


def test_of_equal_shares_the_first_come_first() -> None:
    generator = np.random.default_rng(4)
    for count in (1, 5, 40):
        shares = generator.integers(0, 6, count + 1) / 6.0
        order = np.empty(min(5, count))
        rank(shares, count, order)
        assert order.tolist() == np.argsort(-shares[:count], kind="stable")[:5].tolist()


def test_without_targets_nobody_is_proposed() -> None:
    assert (
        decide(at(0.0, 0.0), np.empty((0, 5)), np.ones(1), NOBODY, np.nan, (ASK, KEEP, 0.05, 0.0)) == NOBODY
    )
