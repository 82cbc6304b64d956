"""Tables of which something could get lost or be ignored: it is read, refused or said in a note."""

from __future__ import annotations

import json
from pathlib import Path
from time import perf_counter

import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from pointpred.errors import ColumnsError, ParameterError
from pointpred.recording import Recording
from pointpred.recordings import Reading, read_any
from tests.building import lines_file

ROWS = [(10 * i, 3 * i, 100 - i) for i in range(30)]


def read(folder: Path, names: str, rows: list[str], reading: Reading | None = None) -> Recording:
    """The recording in a table with these names of columns."""
    [recording] = read_any(lines_file(folder / "study.csv", names, *rows), reading or Reading())
    return recording


def rows(*more: str) -> list[str]:
    """The rows of one movement with further cells, one after another in turn."""
    return [
        ",".join([*map(str, row), *([more[at % len(more)]] if more else [])]) for at, row in enumerate(ROWS)
    ]


@pytest.mark.parametrize("first", ["#1", "P1"])
def test_a_participant_whose_name_begins_with_a_hash_is_read(first: str, tmp_path: Path) -> None:
    lines = [f"{user},{line}" for user in (first, "#2", "P3") for line in rows()]
    lines.insert(40, "# a pause, of a minute")
    recording = read(tmp_path, "participant,t_ms,x,y", lines)
    assert [trial.user for trial in recording.trials] == [first, "#2", "P3"]
    assert recording.events.x.tolist() == [x for _, x, _ in ROWS] * 3
    assert "comment lines between the rows left out: 1" in recording.notes


def test_positions_are_converted_by_the_pixels_in_a_unit_across_and_down(tmp_path: Path) -> None:
    recording = read(tmp_path, "t_ms,x,y", rows(), Reading(px_per_unit=(960.0, 540.0)))
    assert recording.events.x.tolist() == pytest.approx([960 * x for _, x, _ in ROWS])
    assert recording.events.y.tolist() == pytest.approx([540 * y for _, _, y in ROWS])
    assert recording.provenance.unit == "units of 960 and 540 px"


def test_an_option_without_effect_is_said(tmp_path: Path) -> None:
    recording = read(tmp_path, "t_ms,x,y,trial", rows("1"), Reading(cut="bursts"))
    assert any("has no effect" in note for note in recording.notes)
    assert not any("has no effect" in note for note in read(tmp_path, "t_ms,x,y,trial", rows("1")).notes)


def test_a_target_that_varies_within_a_trial_is_said(tmp_path: Path) -> None:
    recording = read(tmp_path, "t_ms,x,y,trial,target_x", rows("1,5", "1,6"))
    assert any("vary within a trial" in note and "target_x" in note for note in recording.notes)


def test_the_trials_file_that_columns_leave_aside_is_said(tmp_path: Path) -> None:
    path = tmp_path / "study_samples.csv"
    path.write_text("\n".join(["user,trial,t_s,x_px,y_px", *(f"u,1,{line}" for line in rows())]) + "\n")
    path.with_name("study_trials.csv").write_text("user,trial,target_x\nu,1,30\n")
    [recording] = read_any(path, columns={"t": "t_s"})
    assert any("study_trials.csv is not read" in note for note in recording.notes)


def test_a_state_of_0_and_1_is_no_button(tmp_path: Path) -> None:
    assert not read(tmp_path, "t_ms,x,y,state", rows("0", "1")).events.table[:, 5].any()
    assert read(tmp_path, "t_ms,x,y,state", rows("Move", "Drag")).events.table[:2, 5].tolist() == [0.0, 1.0]
    assert read(tmp_path, "t_ms,x,y,trial,button", rows("1,1")).events.table[0, 5] == 1.0


def test_a_missing_number_is_no_name_and_no_condition(tmp_path: Path) -> None:
    lines = [
        f"{row},{'NA' if at > 19 else at // 10},{'NA' if at < 10 else 3}" for at, row in enumerate(rows())
    ]
    recording = read(tmp_path, "t_ms,x,y,trial,difficulty", lines)
    assert [(trial.trial, trial.condition) for trial in recording.trials] == [
        ("0", {}),
        ("1", {"difficulty": 3}),
    ]
    assert "rows without user or trial left out: 10, the first is data row 20" in recording.notes


def test_a_name_of_two_letters_stays_a_name(tmp_path: Path) -> None:
    recording = read(tmp_path, "t_ms,x,y,user", rows("NA", "BO"))
    assert [trial.user for trial in recording.trials] == ["NA", "BO"]


def test_a_target_that_is_no_number_is_said(tmp_path: Path) -> None:
    recording = read(tmp_path, "t_ms,x,y,trial,target_x,target_w", rows("1,30,20 px"))
    assert recording.trials[0].target_x == 30
    assert "cells of target_w that are no numbers: 30, the first is '20 px' in data row 0" in recording.notes


def test_rows_of_a_stream_without_a_user_are_nobodys(tmp_path: Path) -> None:
    lines = [f"{user},{line}" for user in ("ann", "", "study") for line in rows()]
    recording = read(tmp_path, "user,t_ms,x,y", lines)
    assert [(trial.user, trial.trial) for trial in recording.trials] == [("ann", "0"), ("study", "0")]
    assert "rows without user left out: 30, the first is data row 30" in recording.notes


@pytest.mark.parametrize("lines", [False, True])
@pytest.mark.parametrize("points", [False, True])
def test_a_null_in_the_place_of_a_record_is_counted(lines: bool, points: bool, tmp_path: Path) -> None:
    records = [{"t_ms": t, **({"pos": [x, y]} if points else {"x": x, "y": y})} for t, x, y in ROWS]
    given = [records[0], None, *records[1:4], None, *records[4:]]
    path = tmp_path / "study.json"
    path.write_text("\n".join(map(json.dumps, given)) if lines else json.dumps(given))
    [recording] = read_any(path, columns={"x": "pos.0", "y": "pos.1"} if points else None)
    assert recording.events.x.tolist() == [x for _, x, _ in ROWS]
    assert "rows left out: 2, the first is data row 1: t, x or y is empty or too large" in recording.notes


def test_a_long_word_beside_buttons_takes_no_long_time(tmp_path: Path) -> None:
    recording = read(tmp_path, "t_ms,x,y,button,page", rows(f"left,{'mouse' * 10_000}!"))
    assert len(recording.skipped) == 1


def test_a_column_named_by_very_many_digits_is_a_column(tmp_path: Path) -> None:
    with pytest.raises(ColumnsError, match="no column for x"):
        read(tmp_path, f"t_ms,a,y,q{'1' * 5000}", rows("0"))


def test_buttons_that_are_not_as_many_as_the_samples_are_said(tmp_path: Path) -> None:
    lines = [
        f'{k},"[0,8,16]","[1,2,9]","[4,5,6]","[{buttons}]"' for k, buttons in enumerate(("0,1", "0,0,1", ""))
    ]
    recording = read(tmp_path, "trial,t_ms,x,y,buttons", lines)
    assert recording.events.buttons.tolist() == [0, 0, 0, 0, 0, 1, 0, 0, 0]
    assert "rows whose buttons are not as many as their samples, left aside: 1" in recording.notes


@pytest.mark.parametrize("px", [(1.0,), (1.0, 2.0, 3.0)])
def test_pixels_in_a_unit_are_one_number_or_two(px: tuple[float, ...]) -> None:
    with pytest.raises(ParameterError, match="px_per_unit"):
        Reading(px_per_unit=px)  # type: ignore[arg-type]


def test_many_users_out_of_order_are_sorted_in_one_go(tmp_path: Path) -> None:
    users = range(2000)
    lines = [f"u{user},{8 * at},{at},{user}" for at in reversed(range(20)) for user in users]
    begin = perf_counter()
    recording = read(tmp_path, "user,t_ms,x,y", lines, Reading(sort=True))
    assert perf_counter() - begin < 5, "a copy of all samples for each user takes 15 s"
    assert recording.events.x.tolist() == [*range(20)] * 2000
    assert recording.events.y.tolist() == [user for user in users for _ in range(20)]


def test_a_table_without_rows_is_a_recording_without_trials(tmp_path: Path) -> None:
    columns = {"user": pa.array([], pa.string())} | {
        name: pa.array([], pa.float64()) for name in ("t_ms", "x", "y")
    }
    pq.write_table(pa.table(columns), tmp_path / "none.parquet")
    assert not read_any(tmp_path / "none.parquet")[0].trials
