"""When something is proposed: thresholds, hysteresis, what is too late; and the account of it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.records import FloatArray
from pointpred.targets import Ledger, around, cursor
from pointpred.targets.decision import NOBODY, decide, rank
from pointpred.targets.rectangles import table

TABLE = table([around("a", 100.0, 0.0, 20.0), around("b", 0.0, 100.0, 20.0)])
ASK, KEEP = 0.8, 0.32


def at(x: float, y: float, speed: float = 100.0) -> FloatArray:
    memory = np.zeros(cursor.STATES)
    memory[cursor.KNOWN], memory[cursor.X], memory[cursor.Y], memory[cursor.SPEED] = 1.0, x, y, speed
    return memory


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


def test_a_ledger_by_hand() -> None:
    ledger = Ledger()
    ledger.propose(0.1, "wrong")
    ledger.retract(0.2, "wrong")
    ledger.propose(0.2, "right")
    ledger.enter(0.5, "right")
    ledger.enter(0.7, "right")  # came back after an overshoot: the first time counts
    first = ledger.finish(0.9, "right")
    assert (first.proposed, first.hit, first.wasted, first.retracted) == (2, True, 1, 1)
    assert first.lead_entry_s == pytest.approx(0.3)
    assert first.lead_click_s == pytest.approx(0.7)
    ledger.enter(0.3, "right")
    ledger.propose(0.4, "right")  # too late to lead
    late = ledger.finish(0.6, "right")
    assert (late.proposed, late.hit, late.wasted) == (1, False, 0)
    ledger.propose(0.1, "right")
    assert ledger.finish(0.5, None).wasted == 1
    assert ledger.finish(0.5, "right").proposed == 0
    assert ledger.precision == pytest.approx(2 / 4)
    assert ledger.coverage == pytest.approx(1 / 4)
    assert ledger.proposals_a_movement == pytest.approx(1.0)
    told = ledger.summary()
    assert (told["movements"], told["hit"], told["wasted"], told["retracted"]) == (4, 1, 2, 1)
    assert told["median_lead_entry_s"] == pytest.approx(0.3)


def test_a_click_beside_the_target_ends_its_lead() -> None:
    ledger = Ledger()
    ledger.propose(0.2, "a")
    done = ledger.finish(0.6, "a")
    assert done.hit
    assert (done.lead_entry_s, done.lead_click_s) == (pytest.approx(0.4), pytest.approx(0.4))


def test_a_ledger_that_is_never_closed_stays_bounded() -> None:
    ledger = Ledger()
    for i in range(5000):
        ledger.propose(i, i)
        ledger.enter(i, i)
    assert len(ledger._made) == len(ledger._entered) == 1000
    ledger.drop()
    assert ledger.finish(0.0, 1).proposed == 0


def test_nothing_yet() -> None:
    ledger = Ledger()
    assert ledger.precision is ledger.coverage is ledger.proposals_a_movement is None
    assert ledger.summary()["median_lead_click_s"] is None
