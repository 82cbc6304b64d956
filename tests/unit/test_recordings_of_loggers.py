"""Logs of pynput, libinput, Android and rrweb, and tables with pairs, sums, or a column a sample."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from pointpred.errors import ColumnsError, RecordingError
from pointpred.recording import Recording
from pointpred.recordings import Reading, format_of, read_any
from tests.building import lines_file, text_file

FAULTS, SOURCES = (Path(__file__).parents[1] / "data" / name for name in ("faults", "sources"))


def one(path: Path, reading: Reading | None = None) -> Recording:
    (recording,) = read_any(path, reading or Reading())
    return recording


def test_the_log_of_pynput_s_manual_is_read() -> None:
    recording = one(FAULTS / "asctime_log.txt")
    assert np.diff(recording.offsets).tolist() == [61]
    assert recording.events.table[[0, 1, 60]][:, [0, 1, 2, 5]].tolist() == [
        [0, 100, 500, 0],
        [0.016, 100, 500, 0],
        [1.05, 900, 200, 1],
    ]


def test_a_log_with_releases_has_what_is_held(tmp_path: Path) -> None:
    lines = [
        "1700000000.10 Pointer moved to (1, 2)",
        "1700000000.12 - INFO - Pressed at (1, 2) Button.right",
        "1700000000.14 Pointer moved to (3, 4.5); it was not faked",
        "1700000000.16 Scrolled down at (3, 4)",
        "1700000000.18 Released at (-3, 4) Button.right",
        "1700000000.20 Key.esc pressed",
        "1700000000.22 Mouse moved to (5, 6)",
    ]
    recording = one(lines_file(tmp_path / "log.txt", *lines), Reading(cut="whole"))
    assert recording.events.buttons.tolist() == [0, 2, 2, 0, 0]
    np.testing.assert_allclose(recording.events.t, [0, 0.02, 0.04, 0.08, 0.12], atol=1e-6)
    assert recording.events.x.tolist() == [1, 1, 3, -3, 5]
    assert "scrolling left aside: 1" in recording.notes
    assert any(note.startswith("lines without a position, left aside: 1") for note in recording.notes)


def test_a_log_without_times_says_how_to_have_them(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match=r"line 1 has no time; log it, as by %\(asctime\)s"):
        one(lines_file(tmp_path / "log.txt", "Pointer moved to (1, 2)", "Pointer moved to (3, 4)"))


def test_libinput_debug_events_have_px_and_counts() -> None:
    recording = one(SOURCES / "debug-events.txt", Reading(cut="whole"))
    rows = [
        [0.0, 1, 0.5, 2, 1, 0],
        [0.008, 3, 0, 4, -1, 0],
        [0.016, 3, 0, 0, 0, 1],
        [0.024, 6, 0, 6, 0, 1],
        [0.032, 6, 0, 0, 0, 0],
    ]
    np.testing.assert_allclose(recording.events.table, rows, atol=1e-12)
    assert recording.trials[0].condition["device"] == "Some Mouse"
    assert recording.provenance.unit == "px"
    assert "device Power Button: no relative motion in 0 events, expected POINTER_MOTION" in recording.notes
    assert "events without motion or button left aside: 1" in recording.notes


def test_debug_events_of_a_device_that_comes_again_are_another_stream(tmp_path: Path) -> None:
    text = (SOURCES / "debug-events.txt").read_text(encoding="utf-8")
    recording = one(text_file(tmp_path / "twice.txt", text + text), Reading(cut="whole"))
    np.testing.assert_array_equal(recording.rows(0).table, recording.rows(1).table)


def test_debug_events_of_an_old_libinput_have_no_counts(tmp_path: Path) -> None:
    lines = [f" event5   POINTER_MOTION  +{at / 100:.2f}s\t  1.00/  2.00" for at in range(4)]
    recording = one(lines_file(tmp_path / "events.txt", *lines))
    assert recording.events.x.tolist() == [1, 2, 3, 4]
    assert np.isnan(recording.events.dx).all()


NAMED = (SOURCES / "getevent.txt").read_text(encoding="utf-8")
PLAIN = """\
[   12345.000000] 0002 0000 00000003
[   12345.000000] 0002 0001 ffffffff
[   12345.000000] 0000 0000 00000000
[   12345.008000] 0001 0110 00000001
[   12345.008000] 0000 0000 00000000
[   12345.016000] 0002 0000 fffffffe
[   12345.016000] 0000 0000 00000000
"""


@pytest.mark.parametrize("text", [NAMED, PLAIN, NAMED.replace("\n", "\r\n")])
def test_getevent_is_read_by_names_and_by_numbers(tmp_path: Path, text: str) -> None:
    path = text_file(tmp_path / "events.txt", text)
    form = format_of(path)
    assert form is not None
    assert form.key == "getevent"
    recording = one(path, Reading(cut="whole"))
    rows = [[0.0, 3, -1, 3, -1, 0], [0.008, 3, -1, 0, 0, 1], [0.016, 1, -1, -2, 0, 1]]
    np.testing.assert_allclose(recording.events.table, rows, atol=1e-9)
    assert recording.trials[0].condition["device"] == ("Some Mouse" if text != PLAIN else "events")


def test_getevent_without_times_says_how_to_have_them(tmp_path: Path) -> None:
    lines = ["/dev/input/event3: 0002 0000 00000003", "/dev/input/event3: 0000 0000 00000000"]
    with pytest.raises(RecordingError, match=r"without a time \(record with: getevent -lt\), left aside: 2"):
        one(lines_file(tmp_path / "events.txt", *lines))


def test_a_touch_screen_of_android_has_its_units_as_px_without_a_description(tmp_path: Path) -> None:
    lines = [
        f"[ 1.0{at:05d}] /dev/input/event3: {event}"
        for at in range(9)
        for event in (
            f"EV_ABS ABS_MT_TRACKING_ID {7:08x}",
            "EV_ABS ABS_MT_TOOL_TYPE MT_TOOL_FINGER",
            f"EV_ABS ABS_MT_POSITION_X {100 + at:08x}",
            f"EV_ABS ABS_MT_POSITION_Y {200:08x}",
            "EV_KEY BTN_TOUCH DOWN",
            "EV_SYN SYN_REPORT 00000000",
        )
    ]
    recording = one(lines_file(tmp_path / "events.txt", *lines))
    assert recording.events.x.tolist() == [100 + at for at in range(9)]
    assert set(recording.events.y) == {200.0}
    assert set(recording.events.buttons) == {1}
    said = (
        "positions: units of the device taken as px, for their range is not known; --px-per-unit says another"
    )
    assert said in recording.notes
    assert not any("no events" in note for note in recording.notes)
    with pytest.raises(RecordingError, match="no motion in 9 events, expected X and Y of a contact"):
        one(lines_file(tmp_path / "cut.txt", *lines[2::6]))


def test_the_positions_of_rrweb_have_times_of_their_own() -> None:
    recording = one(FAULTS / "session_replay.json")
    assert np.diff(recording.offsets).tolist() == [60]
    assert (np.diff(recording.events.t) > 0).all()
    assert recording.provenance.format == "rrweb JSON"


def rrweb(pages: int) -> list[object]:
    page = {"type": 4, "data": {"href": "http://x.example/"}, "timestamp": 1_700_000_000_000}
    snapshot = {"type": 2, "data": {"node": "x" * pages}, "timestamp": 1_700_000_000_000}
    down, up = (
        {
            "type": 3,
            "data": {"source": 2, "type": kind, "id": 1, "x": 5, "y": 6},
            "timestamp": 1_700_000_000_000 + at,
        }
        for kind, at in ((1, 250), (0, 450))
    )
    moves = [
        {
            "type": 3,
            "data": {
                "source": 1,
                "positions": [
                    {"x": at + i, "y": at, "id": 1, "timeOffset": -100 * (4 - i)} for i in range(5)
                ],
            },
            "timestamp": 1_700_000_000_400 + 500 * at,
        }
        for at in range(2)
    ]
    moves[1]["data"]["positions"].append({"x": None, "y": 1, "timeOffset": 0})  # type: ignore[index]
    return [page, snapshot, down, moves[0], up, moves[1]]


def test_rrweb_is_recognised_behind_a_long_snapshot_and_holds_buttons(tmp_path: Path) -> None:
    path = text_file(tmp_path / "long.json", json.dumps({"events": rrweb(1 << 17)}))
    recording = one(path, Reading(cut="whole"))
    np.testing.assert_allclose(recording.events.t[:6], [0, 0.1, 0.2, 0.25, 0.3, 0.4], atol=1e-9)
    assert recording.events.buttons.tolist() == [0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0]
    assert "positions that are no numbers left aside: 1" in recording.notes


def test_columns_are_added_up_where_it_is_told(tmp_path: Path) -> None:
    event = json.loads((FAULTS / "session_replay.json").read_text(encoding="utf-8"))[1]
    path = text_file(tmp_path / "move.json", json.dumps({"timestamp": event["timestamp"], **event["data"]}))
    columns: dict[str, str | int] = {"t": "timestamp+timeOffset", "x": "x", "y": "y"}
    recording = one(path, Reading(columns=columns))
    np.testing.assert_allclose(recording.events.t, 0.016 * np.arange(10), atol=1e-9)
    columns["t"] = "timestamp"
    recording = one(path, Reading(columns=columns))
    assert any(note.startswith("trials whose samples all have one time: 1") for note in recording.notes)


def test_a_sum_loses_no_digit_and_names_what_is_missing(tmp_path: Path) -> None:
    rows = [f"1700000000000000000,{at * 1_000_001},{at},{at}" for at in range(5)]
    path = lines_file(tmp_path / "sum.csv", "base,more_ns,x,y", *rows)
    recording = one(path, Reading(columns={"t": "base+more_ns"}))
    np.testing.assert_array_equal(recording.events.t, np.arange(5) * 1_000_001 / 1e9)
    with pytest.raises(ColumnsError, match="no column 'less' for t"):
        one(path, Reading(columns={"t": "base+less"}))


@pytest.mark.parametrize("cell", ['"({x}, {y})"', '"[{x},{y}]"', '"{x};{y}"', '"{x} {y}"'])
def test_pairs_in_a_cell_are_named_by_their_place(tmp_path: Path, cell: str) -> None:
    rows = [f"{16 * at}," + cell.format(x=at + 0.5, y=9 - at) for at in range(9)]
    path = lines_file(tmp_path / "pairs.csv", "t_ms,pos", *rows)
    recording = one(path, Reading(columns={"t": "t_ms", "x": "pos.0", "y": "pos.1"}))
    assert recording.events.x.tolist() == [at + 0.5 for at in range(9)]
    assert recording.events.y.tolist() == [9 - at for at in range(9)]


def test_the_pairs_of_the_field_are_read() -> None:
    recording = one(FAULTS / "pair_in_a_cell.csv", Reading(columns={"t": "t_ms", "x": "pos.0", "y": "pos.1"}))
    assert len(recording.events) == 60
    with pytest.raises(ColumnsError, match=r"no column for x, y; .* --columns t=t_ms,x=pos.0,y=pos.1"):
        one(FAULTS / "pair_in_a_cell.csv")


def wide(names: tuple[str, str, str], samples: int) -> list[str]:
    header = ["id", "cue", *[f"{name}{at + 1}" for name in names for at in range(samples)]]
    lines = [",".join(header)]
    for row in range(3):
        count = samples - row
        series = [
            [f"{value * (at + 1)}" if at < count else "" for at in range(samples)]
            for value in (16, row + 1, 2)
        ]
        lines.append(",".join([f"p{row}", "left", *[cell for one in series for cell in one]]))
    return lines


@pytest.mark.parametrize(
    "names", [("t", "x", "y"), ("time_", "xpos_", "ypos_"), ("T ", "X ", "Y "), ("ms.", "x.", "y.")]
)
def test_a_column_a_sample_is_a_trial_a_row(tmp_path: Path, names: tuple[str, str, str]) -> None:
    recording = one(lines_file(tmp_path / "wide.csv", *wide(names, 7)))
    assert np.diff(recording.offsets).tolist() == [7, 6, 5]
    assert recording.rows(1).x.tolist() == [2, 4, 6, 8, 10, 12]
    np.testing.assert_allclose(recording.rows(2).t, 0.016 * np.arange(5), atol=1e-12)
    assert recording.trials[0].condition["cue"] == "left"


def test_a_wrong_cell_of_a_wide_table_costs_its_trial(tmp_path: Path) -> None:
    lines = wide(("t", "x", "y"), 6)
    lines[1] = lines[1].replace("left,16", "left,soon", 1)
    recording = one(lines_file(tmp_path / "wide.csv", *lines), Reading(time_unit="ms"))
    assert [skip.reason for skip in recording.skipped] == ["t is 'soon', expected a number"]


def test_columns_given_by_their_places_stay_in_them(tmp_path: Path) -> None:
    lines = [",".join(["when", "across", "down", *[f"{name}{at}" for name in "abc" for at in range(5)]])]
    lines += [",".join([str(16 * at), str(at), "1", *["7"] * 15]) for at in range(9)]
    recording = one(lines_file(tmp_path / "places.csv", *lines), Reading(columns={"t": 0, "x": 1, "y": 2}))
    assert recording.events.x.tolist() == list(range(9))


def test_numbered_columns_beside_times_and_positions_stay_conditions(tmp_path: Path) -> None:
    answers = ",".join(f"{name}{at}" for name in "abc" for at in range(5))
    rows = [f"{16 * at},{at},{at},{','.join(['7'] * 15)}" for at in range(9)]
    recording = one(lines_file(tmp_path / "asked.csv", f"t_ms,x,y,{answers}", *rows))
    assert len(recording.events) == 9
    assert recording.trials[0].condition["b3"] == 7.0
