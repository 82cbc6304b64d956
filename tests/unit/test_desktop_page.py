"""What docs/evidence/desktop.md counts: blocks of ten movements, and movements until recovery."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec import structs

from pages.desktop import measure, recovery, tables
from pages.desktop.repeats import SCREEN, WINDOW, repeated
from pages.desktop.tables import FLOOR, Measured
from pointpred import build
from pointpred.recording import Recording, Trial
from pointpred.records import EventColumns, FloatArray
from pointpred.scoring import prepare, replay
from pointpred.simulation import people, simulate_desktop

CHANGE = 30


def session(bad: int, people: int = 5) -> FloatArray:
    """Errors of 60 movements: 50 px, but 80 px in the first ``bad`` movements after the change."""
    errors = np.full((people, 60), 50.0)
    errors[:, CHANGE : CHANGE + bad] = 80.0
    return errors


FLOOR_ERRORS = np.full((5, 60), 100.0)
CALM = recovery.shares(session(0), FLOOR_ERRORS)


@pytest.mark.parametrize("bad", [1, 6, 20])
def test_movements_until_the_next_ten_are_as_without_the_change(bad: int) -> None:
    """A movement of 80 px among ten raises the share by 0.03, so all ten have to be good."""
    changed = recovery.shares(session(bad), FLOOR_ERRORS)
    assert recovery.movements_until(changed, CALM, CHANGE) == bad
    assert recovery.interval(changed, CALM, CHANGE) == (bad, bad)


def test_no_recovery_within_the_session_is_said() -> None:
    changed = recovery.shares(session(30), FLOOR_ERRORS)
    assert recovery.movements_until(changed, CALM, CHANGE) is None
    assert recovery.interval(changed, CALM, CHANGE) == (None, None)


def test_the_interval_covers_people_who_recover_at_different_times() -> None:
    errors = np.concatenate([session(bad, 1) for bad in (0, 5, 10, 15, 20)])
    changed = recovery.shares(errors, FLOOR_ERRORS)
    assert recovery.movements_until(changed, CALM, CHANGE) == 10
    low, high = recovery.interval(changed, CALM, CHANGE)
    assert low is not None
    assert high is not None
    assert low < 10 < high


def test_a_share_is_of_sums_and_leaves_out_what_was_not_scored() -> None:
    errors, floor = session(0), FLOOR_ERRORS.copy()
    errors[0, 3], floor[0, 3] = np.nan, np.nan
    errors[1, 5], floor[1, 5] = 500.0, 900.0
    shares = recovery.shares(errors, floor)
    assert shares.shape == (5, 51)
    assert shares[0, 0] == pytest.approx(0.5)
    assert shares[1, 0] == pytest.approx((9 * 50 + 500) / (9 * 100 + 900))


def test_errors_are_those_of_the_scorer() -> None:
    recording = simulate_desktop(people(2), movements=6).recording
    prepared, pattern = prepare(recording), build("kinematic-adaptive")
    np.testing.assert_array_equal(
        measure.errors_of(prepared, pattern), replay(prepared, pattern, threads=1).time_averaged
    )


def test_who_is_told_the_window_expects_the_places_where_it_now_stands() -> None:
    """Six movements to one place of a window; then the window stands 250 px to the right."""
    share, parts, trials = np.linspace(0.0, 1.0, 40), [], []
    share = 10 * share**3 - 15 * share**4 + 6 * share**5
    for k in range(8):
        x = 0.0 if k < 7 else 250.0
        parts.append(EventColumns.of(0.015 * np.arange(40), x + 600.0 * share, 900.0 - 700.0 * share))
        trials.append(Trial("p", str(k), condition={"window": "w", "window_x": x, "window_y": 0.0}))
    prepared = prepare(Recording.of("moved", parts, trials))
    pattern = build("kinematic-adaptive", distances=0)
    by_window, by_screen = (measure.errors_of(prepared, pattern, named=named) for named in (True, False))
    assert by_window[-1] < 0.8 * by_screen[-1]
    np.testing.assert_array_equal(by_window[:-1], by_screen[:-1])


def test_ends_near_an_earlier_one_are_counted_on_the_screen_and_in_the_window() -> None:
    """The second window stands 300 px to the right, the third movement returns to its first place in it."""
    share = np.linspace(0.0, 1.0, 30) ** 2
    ends = {"a": (100.0, 0.0), "b": (130.0, 0.0), "c": (400.0, 300.0), "d": (430.0, 500.0)}
    parts = [
        EventColumns.of(0.02 * np.arange(30), 1000.0 + (x - 1000.0) * share, 0.0 * share)
        for x, _ in ends.values()
    ]
    trials = [
        Trial("p", name, condition={"window": "w", "window_x": x, "window_y": 0.0})
        for name, (_, x) in ends.items()
    ]
    near = repeated(prepare(Recording.of("four", parts, trials)))
    assert near[SCREEN].tolist() == [0.0, 1.0, 0.0, 1.0]
    assert near[WINDOW].tolist() == [0.0, 1.0, 1.0, 0.0]
    others = [structs.replace(one, user=one.trial) for one in trials]
    assert not repeated(prepare(Recording.of("four", parts, others)))[SCREEN].any()


def test_the_tables_state_before_after_and_the_movements_between() -> None:
    name = "`kinematic`"
    made = [
        Measured(scenario, change, {FLOOR: FLOOR_ERRORS, name: session(bad)}, 0, {})
        for scenario, change, bad in (("steady", None, 0), ("moved", CHANGE, 20), ("habits", CHANGE, 30))
    ]
    moved, habits = tables.recoveries(made).texts()
    assert moved == ["moved", name, "0.50", "0.80 (0.50)", "0.50 (0.50)", "20", "20 to 20"]
    assert habits[-2:] == ["over 20", "over 20 to over 20"]
    blocks = tables.by_block(made)
    assert blocks.columns[2:] == ["1-10", "11-20", "21-30", "31-40", "41-50", "51-60"]
    assert blocks.texts()[1][2:] == ["0.50", "0.50", "0.50", "0.80", "0.80", "0.50"]
