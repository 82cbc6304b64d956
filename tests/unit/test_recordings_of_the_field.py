"""Files as people have them, each with a fault that was once read wrongly: what each kind gives now."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from pointpred.devices.evdev import EVENT, FrameDecoder
from pointpred.errors import ColumnsError, ParameterError, RecordingError
from pointpred.recording import Recording, Skip, kinds_of
from pointpred.recordings import Reading, convert, read_any
from pointpred.recordings.columns.buttons import pressed
from pointpred.records import EventColumns
from tests.building import lines_file, text_file

FAULTS = Path(__file__).parents[1] / "data" / "faults"


def one(name: str | Path, reading: Reading | None = None) -> Recording:
    (recording,) = read_any(FAULTS / name, reading or Reading())
    return recording


def test_the_device_of_each_report_is_known_however_its_line_is_written() -> None:
    recording = one("two_devices.hid")
    assert [trial.condition["device"] for trial in recording.trials] == ["A Touch Screen"]
    assert "device A Mouse: no motion in 4 reports, expected a mouse that moves" in recording.notes
    np.testing.assert_allclose(recording.events.x[:2], np.array([1000, 1010]) / 4095 * 1920)
    assert np.isnan(recording.events.dx).all()


def test_a_line_that_names_no_device_refuses_the_file(tmp_path: Path) -> None:
    text = (FAULTS / "two_devices.hid").read_text(encoding="utf-8").replace("D:1\n", "D: one\n", 1)
    with pytest.raises(RecordingError, match=r"line 7 is 'D: one', expected D: and a number"):
        one(text_file(tmp_path / "named.hid", text))


def test_a_second_descriptor_in_hid_recorder_begins_another_device(tmp_path: Path) -> None:
    text = (FAULTS.parent / "sources" / "hid-recorder.txt").read_text(encoding="utf-8")
    recording = one(text_file(tmp_path / "twice.txt", text + text))
    assert [trial.trial for trial in recording.trials] == ["0 0", "1 0"]
    np.testing.assert_array_equal(recording.rows(0).table, recording.rows(1).table)


MOVES = [
    f"E: {at // 10}.{at % 10}00000 0002 0000 {at + 1}\nE: {at // 10}.{at % 10}00000 0000 0000 0"
    for at in range(4)
]


def test_a_second_name_in_evemu_begins_another_device(tmp_path: Path) -> None:
    recording = one(lines_file(tmp_path / "two.evemu", "N: Left", *MOVES[:2], "N: Right", *MOVES[2:]))
    assert [trial.condition["device"] for trial in recording.trials] == ["Left", "Right"]
    assert recording.events.dx.tolist() == [1, 2, 3, 4]
    assert recording.events.t.tolist() == [0.0, 0.1, 0.0, 0.1]


def test_a_second_header_in_evtest_begins_another_device(tmp_path: Path) -> None:
    lines = []
    for name in ("Left", "Right"):
        lines.append(f'Input device name: "{name}"')
        for at in range(2):
            lines.append(f"Event: time 1.{at}00000, type 2 (EV_REL), code 0 (REL_X), value {at + 1}")
            lines.append(f"Event: time 1.{at}00000, -------------- SYN_REPORT ------------")
    recording = one(lines_file(tmp_path / "two.txt", *lines))
    assert [trial.condition["device"] for trial in recording.trials] == ["Left", "Right"]


def test_what_was_pressed_is_released_after_events_were_lost(tmp_path: Path) -> None:
    whole = one("dropped_release.evemu", Reading(cut="whole"))
    assert whole.skipped[0].reason == "the kernel dropped events (SYN_DROPPED)"
    bursts = one("dropped_release.evemu")
    assert len(bursts.trials) == 3
    assert not np.any(bursts.events.buttons)
    assert "buttons taken as released after SYN_DROPPED: 1" in bursts.notes
    text = (FAULTS / "dropped_release.evemu").read_text(encoding="utf-8")
    click = "E: 4.100000 0001 0110 1\nE: 4.100000 0000 0000 0\n"
    clicks = one(text_file(tmp_path / "clicked.evemu", text + click), Reading(cut="clicks"))
    assert np.diff(clicks.offsets).tolist() == [41, 81]
    assert [skip.reason for skip in clicks.skipped] == ["a button is held"]


def test_each_frame_and_axis_of_a_wheel_has_its_own_resolution() -> None:
    rows = [
        (1, 2, 11, 120),
        (1, 2, 8, 1),
        (1, 0, 0, 0),
        (2, 2, 6, 1),
        (2, 0, 0, 0),
        (3, 2, 8, 1),
        (3, 0, 0, 0),
    ]
    told = FrameDecoder().feed(b"".join(EVENT.pack(0, *row) for row in rows))
    assert [(frame.wheel, frame.pan) for frame in told] == [(1.0, 0.0), (0.0, 1.0), (1.0, 0.0)]


def test_a_stream_slightly_out_of_order_is_sorted_and_stays_one() -> None:
    recording = one("swapped_stream.csv")
    assert np.diff(recording.offsets).tolist() == [60]
    assert (np.diff(recording.events.t) > 0).all()
    assert "rows out of order, sorted by time: 2, the first is row 21" in recording.notes


def test_a_trial_slightly_out_of_order_is_sorted_and_kept() -> None:
    recording = one("swapped_trial.csv")
    assert [trial.trial for trial in recording.trials] == ["1", "2"]
    assert recording.skipped == ()
    assert (np.diff(recording.rows(0).t) > 0).all()
    assert "rows out of order, sorted by time: 2, the first is row 21" in recording.notes


def test_a_log_of_counts_slightly_out_of_order_is_sorted(tmp_path: Path) -> None:
    times = [*range(20), 21, 20, *range(22, 40)]
    lines = [f"E: 1.{at:02d}0000 0002 0000 {at}\nE: 1.{at:02d}0000 0000 0000 0" for at in times]
    recording = one(lines_file(tmp_path / "late.evemu", *lines))
    assert recording.events.dx.tolist() == sorted(times)
    assert any(note.startswith("rows out of order, sorted by time: 1") for note in recording.notes)


ROWS = [f"{trial},{16 * at},{at + trial},{at}" for trial in range(3) for at in range(20)]


def test_what_is_far_out_of_order_is_sorted_where_it_is_told(tmp_path: Path) -> None:
    mixed = [ROWS[at] for at in np.random.default_rng(5).permutation(len(ROWS))]
    path = lines_file(tmp_path / "mixed.csv", "trial,t_ms,x,y", *mixed)
    plain = one(lines_file(tmp_path / "plain.csv", "trial,t_ms,x,y", *ROWS))
    recording = one(path, Reading(sort=True))
    order = np.argsort([int(trial.trial) for trial in recording.trials])
    found = np.concatenate([recording.rows(int(at)).table for at in order])
    np.testing.assert_allclose(found, plain.events.table, atol=1e-12)
    assert recording.skipped == ()
    stream = one(
        lines_file(tmp_path / "one.csv", "t_ms,x,y", *[row[2:] for row in mixed if row[0] == "0"]),
        Reading(sort=True),
    )
    np.testing.assert_allclose(stream.events.table, plain.rows(0).table, atol=1e-12)


def test_a_clock_that_starts_anew_still_cuts_a_stream(tmp_path: Path) -> None:
    rows = [f"{16 * at},{at},{at}" for _ in range(3) for at in [*range(14), 15, 14, *range(16, 30)]]
    recording = one(lines_file(tmp_path / "anew.csv", "t_ms,x,y", *rows))
    assert np.diff(recording.offsets).tolist() == [30, 30, 30]
    assert "time starts anew in 2 rows: cut there" in recording.notes
    assert any(note.startswith("rows out of order, sorted by time: 3") for note in recording.notes)


def test_reasons_of_one_kind_are_one_line_with_the_first(tmp_path: Path) -> None:
    rows = [
        row for trial in range(3) for row in (f"{trial},0,0,0", f"{trial},{50 + trial},1,1", f"{trial},9,2,2")
    ]
    path = lines_file(tmp_path / "back.csv", "trial,t_ms,x,y", *rows, *[f"8,{row[2:]}" for row in ROWS[:20]])
    summary = convert(path, tmp_path / "out.csv")
    kind = "time goes backwards, from ... s to ... s (first: trial 0 of back, data row 2 (counted from 0))"
    assert summary.skipped == {kind: 3}
    same = [Skip("1", "no movement"), Skip("2", "no movement")]
    assert [(reason, len(skips)) for reason, skips in kinds_of(same)] == [("no movement", 2)]


def test_the_command_says_how_to_keep_trials_that_are_out_of_order(
    command: Callable[..., Any], tmp_path: Path
) -> None:
    rows = ["1,0,0,0", "1,50,1,1", "1,9,2,2", *[f"8,{row[2:]}" for row in ROWS[:20]]]
    path, out = lines_file(tmp_path / "back.csv", "trial,t_ms,x,y", *rows), tmp_path / "out.csv"
    left = command("convert", path, "--out", out)
    assert "skipped 1: time goes backwards, from 0.05 s to 0.009 s" in left.err
    assert "--sort keeps such trials" in left.err
    left = command("convert", path, "--out", out, "--force", "--sort")
    assert "kept 2 trials" in left.err
    assert "--sort" not in left.err


def test_a_trial_that_has_one_time_only_is_a_note(tmp_path: Path) -> None:
    rows = [f"{trial},{100 * trial},{at},0" for trial in range(3) for at in range(5)]
    recording = one(lines_file(tmp_path / "still.csv", "trial,t_ms,x,y", *rows), Reading(time_unit="ms"))
    words = "trials whose samples all have one time: 3, the first is '0' of 'still': is it their time?"
    assert words in recording.notes


@pytest.mark.parametrize("turned", [-1, 1])
def test_targets_that_are_mirrored_are_a_note(tmp_path: Path, turned: int) -> None:
    rows = []
    for trial in range(10):
        goal = 97 * (trial * 7 % 10)
        rows += [f"{trial},{20 * at},{50 * at},{goal * at / 10},500,{turned * goal + 3}" for at in range(11)]
    recording = one(lines_file(tmp_path / "mirror.csv", "trial,t_ms,x,y,target_x,target_y", *rows))
    asked = [note for note in recording.notes if "opposite sides" in note]
    assert len(asked) == (turned < 0)
    assert not asked or asked[0].startswith("the larger target_y is, the smaller is y where movements end")


@pytest.mark.parametrize("name", ["words_click_pressed.csv", "words_button_left.csv"])
def test_words_for_buttons_are_read_by_rule(name: str) -> None:
    recording = one(name, Reading(columns={"buttons": "event_type"}, cut="whole"))
    assert recording.events.buttons.sum() == 1


@pytest.mark.parametrize(
    ("cell", "value"),
    [
        *[
            (word, 1)
            for word in (
                "click_pressed",
                "Button.left",
                "BTN_LEFT",
                "pointerdown",
                "touchstart",
                "Left Click",
            )
        ],
        *[
            (word, 0)
            for word in (
                "click_released",
                "unclicked",
                "pointermove",
                "touch-end",
                "left up",
                "scroll down",
                "mouseleave",
                "",
            )
        ],
        *[("Button.right", 2), ("BTN_MIDDLE", 4), ("Pressed Button.x1", 8), ("3", 3), ("1.0", 1)],
        *[(word, None) for word in ("mouse", "target", "-1", "2.5", "keydown", "70000")],
    ],
)
def test_a_word_for_a_button_is_a_device_a_button_and_what_happened(cell: str, value: int | None) -> None:
    found = pressed(cell)
    assert found == value if value is not None else found != found


def test_a_column_that_names_buttons_is_not_guessed_beside_one_that_tells_their_release(
    tmp_path: Path,
) -> None:
    lines = ["t_ms,x,y,button,action"]
    for at in range(40):
        action = {10: "clicked", 14: "unclicked"}.get(at, "moved")
        lines.append(f"{16 * at},{at},{at},{'' if action == 'moved' else 'Button.left'},{action}")
    path = lines_file(tmp_path / "logger.csv", *lines)
    recording = one(path)
    said = "buttons is not read: button or action may be meant; name one with --columns buttons=..."
    assert said in recording.notes
    assert not any("for they hold lists: button" in note for note in recording.notes)
    assert not recording.events.buttons.any()
    told = one(path, Reading(columns={"buttons": "action"}, cut="whole"))
    assert np.flatnonzero(told.events.buttons).tolist() == [10, 11, 12, 13]


DRAG = ("move", "down", "move", "move", "up", "move", "click", "move")


@pytest.mark.parametrize("words", [DRAG, tuple(f"mouse{word}" if word != "click" else word for word in DRAG)])
def test_a_press_told_by_a_word_lasts_until_its_release(tmp_path: Path, words: tuple[str, ...]) -> None:
    rows = [f"{16 * at},{at},{at},{word}" for at, word in enumerate((*words, *["move"] * 12))]
    reading = Reading(columns={"buttons": "event"}, cut="whole")
    recording = one(lines_file(tmp_path / "page.csv", "t_ms,x,y,event", *rows), reading)
    assert np.flatnonzero(recording.events.buttons).tolist() == [1, 2, 3]
    rows[3], rows[4] = rows[4], rows[3]  # the release is logged before a move that was before it
    recording = one(lines_file(tmp_path / "late.csv", "t_ms,x,y,event", *rows), reading)
    assert np.flatnonzero(recording.events.buttons).tolist() == [1, 2, 3]


def test_a_press_lasts_no_longer_than_its_user_trial_and_clock(tmp_path: Path) -> None:
    rows = [
        f"{user},{trial},{16 * at},{at},{at},{word}"
        for user in "ab"
        for trial in (1, 2)
        for at, word in enumerate(("move", "left down", "right down", "right up", "move"))
    ]
    path = lines_file(tmp_path / "page.csv", "user,trial,t_ms,x,y,event", *rows)
    recording = one(path, Reading(columns={"buttons": "event"}))
    assert recording.events.buttons.tolist() == [0, 1, 3, 1, 1] * 4
    stream = lines_file(tmp_path / "stream.csv", "t_ms,x,y,event", *[row[4:] for row in rows[:10]])
    recording = one(stream, Reading(columns={"buttons": "event"}, cut="whole"))
    assert recording.events.buttons.tolist() == [0, 1, 3, 1, 1] * 2
    words = {0: "down", 13: "up"}
    runs = [
        f"{trial},{16 * at},{at},{at},{words.get(at, 'move')}"
        for at, trial in enumerate("1" * 9 + "2" * 9 + "1" * 9)
    ]
    path = lines_file(tmp_path / "runs.csv", "trial,t_ms,x,y,event", *runs)
    recording = one(path, Reading(columns={"buttons": "event"}))
    assert recording.events.buttons.tolist() == [1] * 9 + [0] * 18


@pytest.mark.parametrize("cells", [("true", "false"), ("1", "0"), ("True", "False"), ("2", "0")])
def test_an_empty_cell_of_buttons_says_no_change_where_releases_are_told(
    tmp_path: Path, cells: tuple[str, str]
) -> None:
    told = {2: cells[0], 5: cells[1]}
    rows = [f"{16 * at},{at},{at},{told.get(at, '')}" for at in range(9)]
    path = lines_file(tmp_path / "logger.csv", "t_ms,x,y,pressed", *rows)
    recording = one(path, Reading(cut="whole"))
    assert np.flatnonzero(recording.events.buttons).tolist() == [2, 3, 4]
    rows = [
        f'{{"t_ms": {16 * at}, "x": {at}, "y": {at}, "pressed": {told.get(at, "null").lower()}}}'
        for at in range(9)
    ]
    recording = one(lines_file(tmp_path / "logger.jsonl", *rows), Reading(cut="whole"))
    assert np.flatnonzero(recording.events.buttons).tolist() == [2, 3, 4]
    rows[5] = rows[4].replace("64", "80")
    recording = one(lines_file(tmp_path / "presses.jsonl", *rows), Reading(cut="whole"))
    assert np.flatnonzero(recording.events.buttons).tolist() == [2]


def test_a_press_ends_at_the_next_row_where_no_release_is_told(tmp_path: Path) -> None:
    words = ("mousemove", "mousedown", "mousemove", "mouseleave", "mousemove")
    path = lines_file(
        tmp_path / "page.csv", "t_ms,x,y,event", *[f"{16 * at},{at},{at},{w}" for at, w in enumerate(words)]
    )
    recording = one(path, Reading(columns={"buttons": "event"}, cut="whole"))
    assert recording.events.buttons.tolist() == [0, 1, 0, 0, 0]


def test_words_that_tell_of_drags_hold_for_their_row(tmp_path: Path) -> None:
    rows = [
        f"{16 * at},{at},{at},{word}"
        for at, word in enumerate(("Move", "Pressed", "Drag", "Move", "Released"))
    ]
    path = lines_file(tmp_path / "state.csv", "t_ms,x,y,state", *rows)
    assert one(path, Reading(cut="whole")).events.buttons.tolist() == [0, 1, 1, 0, 0]


def test_words_of_a_row_without_a_position_need_be_no_button(tmp_path: Path) -> None:
    rows = [f"mouse move;{16 * at};({at}, {at})" for at in range(12)]
    rows[5], rows[8] = "mouse left down;80;(5, 5)", "mouse left up;128;(8, 8)"
    rows.insert(7, "key down;104;A")
    fields: dict[str, str | int] = {"t": "1", "x": "2.0", "y": "2.1", "buttons": "0"}
    recording = one(lines_file(tmp_path / "hook.txt", *rows), Reading(columns=fields, cut="whole"))
    assert recording.events.x.tolist() == list(range(12))
    assert np.flatnonzero(recording.events.buttons).tolist() == [5, 6, 7]
    assert any("rows left out: 1, the first is data row 7" in note for note in recording.notes)
    rows[7] = "key down;104;(7, 7)"
    with pytest.raises(RecordingError, match="data row 7: 0 is 'key down', expected buttons"):
        one(lines_file(tmp_path / "hook.txt", *rows), Reading(columns=fields, cut="whole"))


def test_words_in_lists_of_buttons_are_read_alike(tmp_path: Path) -> None:
    row = '"[0, 10, 20]","[0, 5, 9]","[0, 1, 2]","[mousedown, mousemove, Button.left]"'
    recording = one(lines_file(tmp_path / "lists.csv", "t_ms,x,y,buttons", row))
    assert recording.events.buttons.tolist() == [1, 0, 1]


def test_a_trial_is_named_by_any_usual_counter() -> None:
    recording = one("trial_idx.csv")
    assert "columns: t = time_elapsed in s (by its rate), x = x, y = y, trial = trial_idx" in recording.notes
    assert [trial.trial for trial in recording.trials] == ["1", "2", "3"]


def test_blocks_are_joined_to_such_trials(tmp_path: Path) -> None:
    rows = [f"{block},{trial},{16 * at},{at},{at}" for block in (1, 2) for trial in (1, 2) for at in range(9)]
    recording = one(lines_file(tmp_path / "blocks.csv", "block_idx,trialIdx,t_ms,x,y", *rows))
    assert [trial.trial for trial in recording.trials] == ["1+1", "1+2", "2+1", "2+2"]


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("at", [0, 1, 7])
def test_empty_cells_behind_the_last_column_cost_no_row(tmp_path: Path, separator: str, at: int) -> None:
    lines = ["t_ms,x,y,word", *[f'{16 * row},{row},{row}.5,"a, b"' for row in range(12)]]
    lines[at] += ",,"
    lines = [line.replace(",", separator).replace(f'"a{separator} b"', '"a, b"') for line in lines]
    recording = one(lines_file(tmp_path / "further.csv", *lines))
    assert recording.events.x.tolist() == list(range(12))
    assert recording.skipped == ()
    assert recording.trials[0].condition["word"] == "a, b"


def test_a_first_row_with_an_empty_further_cell_is_read() -> None:
    assert len(one("trailing_first_row.csv").events) == 60


CHINESE = Reading(columns={"t": "时间(ms)", "x": "横坐标", "y": "纵坐标", "user": "被试"})


def test_an_encoding_that_cannot_be_found_out_is_named() -> None:
    with pytest.raises(
        ColumnsError, match=r"byte 2 is not UTF-8: the file is read as Windows-1252; --encoding"
    ):
        one("gbk.csv", CHINESE)
    recording = one("gbk.csv", msgspec.structs.replace(CHINESE, encoding="gb18030"))
    assert len(recording.events) == 60
    assert not any("Windows-1252" in note for note in recording.notes)
    assert recording.trials[0].user.isalpha()


def test_a_wrong_encoding_is_refused_with_its_byte() -> None:
    with pytest.raises(RecordingError, match=r"gbk\.csv: byte 2 is not utf-8"):
        one("gbk.csv", msgspec.structs.replace(CHINESE, encoding="utf-8"))
    with pytest.raises(ParameterError, match=r"encoding must be the name of an encoding, .* received 'hex'"):
        Reading(encoding="hex")


def test_the_guess_is_named_in_every_refusal(tmp_path: Path) -> None:
    path = tmp_path / "letter.txt"
    path.write_bytes("Grüße,\n".encode("cp1252"))
    with pytest.raises(RecordingError, match=r"no known recording format.*read as Windows-1252"):
        one(path)


def test_utf_16_without_its_mark_is_read_where_it_is_named(tmp_path: Path) -> None:
    path = tmp_path / "wide.csv"
    path.write_bytes((FAULTS / "trailing_first_row.csv").read_text(encoding="utf-8").encode("utf-16-le"))
    assert len(one(path, Reading(encoding="utf-16-le")).events) == 60


def test_an_encoding_has_no_effect_on_what_is_no_text() -> None:
    recording = one(FAULTS.parent / "sources" / "table.parquet", Reading(encoding="gb18030"))
    assert "encoding has no effect: a table of samples (Parquet) is no text" in recording.notes


def test_columns_of_events_in_milliseconds_are_warned_of() -> None:
    with pytest.warns(
        UserWarning, match=r"median interval of t is 16 s: t is in seconds, are these millisec"
    ):
        EventColumns.of(16.0 * np.arange(5), np.arange(5), np.zeros(5))
