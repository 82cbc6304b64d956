"""Simulated desktops: seeded sessions, habits, windows that move, and ends that return to controls."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from pointpred.errors import DivergenceError, ParameterError
from pointpred.recordings import read, write
from pointpred.records import BoolArray, FloatArray
from pointpred.scoring import score
from pointpred.simulation import DesktopSession, people, simulate_desktop
from pointpred.simulation.desktop import SCENARIOS
from pointpred.simulation.desktop.habits import draw_habits
from pointpred.simulation.desktop.windows import Control
from pointpred.simulation.desktop.worker import Worker, aim_at

PEOPLE = people(3, 4)
MOVEMENTS = 80


@pytest.fixture(scope="module")
def sessions() -> dict[str, DesktopSession]:
    return {name: simulate_desktop(PEOPLE, name, seed=4, movements=MOVEMENTS) for name in SCENARIOS}


def ends(session: DesktopSession) -> FloatArray:
    recording = session.recording
    return np.array([recording.rows(k).table[-1, 1:3] for k in range(len(recording.trials))])


def controls(session: DesktopSession) -> list[str]:
    return [str(trial.condition["control"]) for trial in session.recording.trials]


def numbers(session: DesktopSession) -> NDArray[np.int64]:
    return np.array([int(trial.trial) for trial in session.recording.trials])


def after(session: DesktopSession) -> BoolArray:
    return np.array([trial.condition["changed"] == 1.0 for trial in session.recording.trials])


def named(session: DesktopSession, *starts: str) -> BoolArray:
    return np.array([name.startswith(starts) for name in controls(session)])


def of_each_user(session: DesktopSession) -> list[BoolArray]:
    users = np.array([trial.user for trial in session.recording.trials])
    return [users == user for user in np.unique(users)]


def test_same_seed_same_session_other_seed_another(sessions: dict[str, DesktopSession]) -> None:
    again = simulate_desktop(PEOPLE, "windows", seed=4, movements=MOVEMENTS)
    other = simulate_desktop(PEOPLE, "windows", seed=5, movements=MOVEMENTS)
    np.testing.assert_array_equal(again.recording.events.table, sessions["windows"].recording.events.table)
    assert controls(again) == controls(sessions["windows"]) != controls(other)


def test_a_persons_movements_do_not_depend_on_who_else_works(sessions: dict[str, DesktopSession]) -> None:
    alone = simulate_desktop(PEOPLE[1:2], "moved", seed=4, movements=MOVEMENTS)
    np.testing.assert_array_equal(ends(alone), ends(sessions["moved"])[MOVEMENTS : 2 * MOVEMENTS])


def test_each_movement_starts_where_the_last_one_ended(sessions: dict[str, DesktopSession]) -> None:
    for session in sessions.values():
        recording = session.recording
        starts = np.array([recording.rows(k).table[0, 1:3] for k in range(len(recording.trials))])
        later = numbers(session) > 0
        np.testing.assert_array_equal(starts[later], ends(session)[:-1][later[1:]])


@pytest.mark.parametrize("name", ["moved", "habits"])
def test_nothing_differs_from_a_steady_desktop_until_the_change(
    sessions: dict[str, DesktopSession], name: str
) -> None:
    steady, changed = sessions["steady"], sessions[name]
    assert (steady.change, changed.change) == (None, MOVEMENTS // 2)
    np.testing.assert_array_equal(after(changed), numbers(changed) >= MOVEMENTS // 2)
    before = ~after(changed)
    np.testing.assert_array_equal(ends(changed)[before], ends(steady)[before])
    assert (ends(changed)[~before] != ends(steady)[~before]).any(axis=1).mean() > 0.5


def test_a_window_moves_once_and_its_controls_move_with_it(sessions: dict[str, DesktopSession]) -> None:
    session = sessions["moved"]
    names, compared = np.array(controls(session)), 0
    for own in of_each_user(session):
        before, later = own & ~after(session), own & after(session)
        corners = [np.unique(session.origins[rows], axis=0) for rows in (before, later)]
        assert [len(one) for one in corners] == [1, 1]
        way = corners[1][0] - corners[0][0]
        assert 200.0 <= np.hypot(*way) <= 500.0
        for name in set(names[named(session, "tool", "entry", "menu", "dialog")]):
            there = [ends(session)[rows & (names == name)] for rows in (before, later)]
            if min(map(len, there)) >= 3:
                compared += 1
                shift = np.median(there[1], axis=0) - np.median(there[0], axis=0)
                assert np.hypot(*(shift - way)) < 80.0
    assert compared >= 6


def test_icons_stay_on_the_screen_when_a_window_moves(sessions: dict[str, DesktopSession]) -> None:
    session = sessions["moved"]
    icons = ends(session)[named(session, "icon")]
    assert len(icons) >= 4
    assert (np.abs(icons - (696.0, 1056.0)) < (140.0, 40.0)).all()


def test_new_habits_use_other_buttons_and_items(sessions: dict[str, DesktopSession]) -> None:
    session = sessions["habits"]
    names = np.array(controls(session))
    own_names = named(session, "tool", "entry", "icon") | np.array([" item " in name for name in names])
    for own in of_each_user(session):
        used = [set(names[own & own_names & rows]) for rows in (~after(session), after(session))]
        assert min(len(used[0]), len(used[1])) >= 3
        assert not used[0] & used[1]


def test_items_of_a_context_menu_lie_where_it_was_opened(sessions: dict[str, DesktopSession]) -> None:
    session = sessions["menus"]
    rows = np.flatnonzero(named(session, "context item"))
    names = np.array(controls(session))
    assert len(rows) >= 10
    assert set(names[rows - 1]) == {"text"}
    items = np.array([int(name.split()[-1]) for name in names[rows]])
    ways = ends(session)[rows] - ends(session)[rows - 1]
    assert np.abs(ways[:, 0] - 70.0).max() < 110.0
    assert np.abs(ways[:, 1] - 26.0 * (items + 0.5)).max() < 24.0
    assert ends(session)[rows].std(axis=0).min() > 60.0


def test_only_the_task_bar_switches_windows(sessions: dict[str, DesktopSession]) -> None:
    session = sessions["windows"]
    switches = 0
    for k in np.flatnonzero(numbers(session) > 0):
        clicked = controls(session)[k - 1]
        expected = f"window {clicked.split()[1]}" if clicked.startswith("task") else session.keys[k - 1]
        assert session.keys[k] == expected
        switches += session.keys[k] != session.keys[k - 1]
    assert switches >= 5
    corners = {(key, *origin) for key, origin in zip(session.keys, session.origins.tolist(), strict=True)}
    assert len(corners) <= 3 * len(PEOPLE)


def test_clicks_scatter_as_people_do_along_both_sides() -> None:
    """4.133 standard deviations make a side, the hand's own scatter included: 4 % of the clicks miss it."""
    session = simulate_desktop(people(8, 1), "steady", seed=1, movements=60)
    targets = np.array([[t.target_x, t.target_y, t.target_w] for t in session.recording.trials])
    off = ((ends(session) - targets[:, :2]) / targets[:, 2:])[
        :, 1
    ]  # every control is at least as wide as high
    off = off[np.isfinite(off)]
    assert len(off) > 250
    assert off.std() == pytest.approx(1 / 4.133, rel=0.12)
    assert 0.01 < (np.abs(off) > 0.5).mean() < 0.08
    wide, generator = Control("wide", 0.0, 0.0, 180.0, 28.0), np.random.default_rng(3)
    aims = np.array([aim_at(wide, generator)[:2] for _ in range(2000)])
    own = 0.19 * 28.0
    assert np.hypot(aims[:, 0].std(), own) == pytest.approx(180.0 / 4.133, rel=0.05)


def test_free_clicks_have_no_target_and_cover_the_text(sessions: dict[str, DesktopSession]) -> None:
    session = sessions["steady"]
    free = named(session, "text", "anywhere")
    unknown = np.array([np.isnan(trial.target_x) for trial in session.recording.trials])
    np.testing.assert_array_equal(free, unknown)
    text = named(session, "text")
    assert (ends(session)[text] - session.origins[text]).std(axis=0).min() > 100.0


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 2**32 - 1))
def test_a_fifth_to_two_fifths_of_the_movements_are_free(seed: int) -> None:
    generator = np.random.default_rng(seed)
    worker = Worker(SCENARIOS["steady"], generator)
    wanted = worker.habits[0].free
    names = Counter(worker.step(generator).control.name for _ in range(1500))
    assert 0.2 <= wanted <= 0.4
    assert (names["text"] + names["anywhere"]) / 1500 == pytest.approx(wanted, abs=0.06)


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 2**32 - 1), context_menus=st.booleans())
def test_the_kth_sequence_is_chosen_with_weight_one_over_k(seed: int, context_menus: bool) -> None:
    generator = np.random.default_rng(seed)
    for habit in draw_habits(0.3, generator, context_menus=context_menus):
        chosen = Counter(habit.choose("", generator) for _ in range(3000))
        shares = np.array([chosen[one] / 3000 for one in habit.sequences])
        expected = 1.0 / np.arange(1, len(shares) + 1)
        np.testing.assert_allclose(shares, expected / expected.sum(), atol=0.05)
        last = habit.sequences[0][0]
        assert all(habit.choose(last, generator)[0] != last for _ in range(50))


def test_a_file_keeps_windows_and_their_places(sessions: dict[str, DesktopSession], tmp_path: Path) -> None:
    session = sessions["windows"]
    samples, _ = write(session.recording, tmp_path / "desktop_samples.parquet")
    again = DesktopSession(read(samples), session.change)
    assert again.keys == session.keys
    np.testing.assert_array_equal(again.origins, session.origins)
    assert again.recording.provenance.simulated


def test_sessions_are_scored_as_recordings_are(sessions: dict[str, DesktopSession]) -> None:
    recording = sessions["moved"].recording
    scored = score([recording], ["minimum-jerk"], threads=1)[0]
    assert scored.simulated
    assert len(scored.trials) + len(scored.skipped) == len(recording.trials)
    assert len(scored.skipped) <= 0.03 * len(recording.trials)
    hold, predicted = (errors.time_averaged.mean() for errors in scored.predictors)
    assert predicted < hold


def test_nobody_leaves_the_screen_by_far(sessions: dict[str, DesktopSession]) -> None:
    for session in sessions.values():
        places = session.recording.events.table[:, 1:3]
        assert places.min() > -400.0
        assert (places.max(axis=0) < (2320.0, 1480.0)).all()


def test_a_hand_that_runs_away_is_an_error_and_no_recording() -> None:
    hasty = msgspec.structs.replace(PEOPLE[0], rate=90.0)
    with pytest.raises(DivergenceError, match=PEOPLE[0].name):
        simulate_desktop([hasty], movements=20)


@pytest.mark.parametrize(
    ("changed", "field"),
    [
        ({"scenario": "windy"}, "scenario"),
        ({"movements": 1}, "movements"),
        ({"movements": 2.5}, "movements"),
        ({"seed": -1}, "seed"),
        ({"scenario": "moved", "movements": 10, "change": 10}, "change"),
        ({"scenario": "moved", "movements": 10, "change": 0}, "change"),
    ],
)
def test_wrong_settings_are_refused(changed: dict[str, object], field: str) -> None:
    with pytest.raises(ParameterError) as caught:
        simulate_desktop(PEOPLE[:1], **changed)  # type: ignore[arg-type]
    assert caught.value.field == field
