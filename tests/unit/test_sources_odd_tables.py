"""Tables as other people's programs leave them: padded by a spreadsheet, of two lengths, without a clock."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from pointpred.errors import ColumnsError, ParameterError, RecordingError
from pointpred.recordings import Reading, read_any
from pointpred.recordings.columns.names import similar_names
from pointpred.recordings.formats.delimited import layout_of
from tests.building import lines_file

MOVES = [f"{10 * i};{3 * i};{100 - i}" for i in range(30)]


def write(folder: Path, *lines: str) -> Path:
    """A file of these lines."""
    return lines_file(folder / "odd.csv", *lines)


def test_names_below_lines_that_a_spreadsheet_has_padded_are_found(tmp_path: Path) -> None:
    settings = ["width 1104;centre 552;task round;a 1;b 2;c 3", "26/03/2021;17:38:25;;;;", ";;;;;"]
    path = write(tmp_path, *settings, "time_ms;x;y;;;", *(f"{move};;;" for move in MOVES), "300;1")
    [recording] = read_any(path)
    assert len(recording.events) == 30
    assert "lines above the table left aside: 3" in recording.notes
    assert [skip.row for skip in recording.skipped] == [30], "the last row is cut"


@pytest.mark.parametrize(
    "lines",
    [
        ["t;x;y;note", *(f"{move};" for move in MOVES)],
        ["t;x;y;note", *(f"{move};" for move in MOVES[:5]), "50;1;2;late", "60;1;3;"],
        ["t;x;y", *MOVES[:3], "t;x;y", *MOVES[:3]],
    ],
    ids=["a column that is empty", "a cell that is filled once", "names once more"],
)
def test_the_first_line_stays_the_names_where_nothing_is_padded(lines: list[str]) -> None:
    layout = layout_of("\n".join(lines))
    assert layout is not None
    assert (layout.first, layout.columns[:3]) == (1, ["t", "x", "y"])


def test_rows_of_two_lengths_are_filled_up(tmp_path: Path) -> None:
    lines = [f"{10 * i};{3 * i};{100 - i}" + (";inside" if i >= 60 and i % 2 else "") for i in range(140)]
    [recording] = read_any(write(tmp_path, *lines), Reading(columns={"t": 0, "x": 1, "y": 2}, time_unit="ms"))
    assert recording.events.x.tolist() == [3 * i for i in range(140)]
    assert any("filled up to 4" in note and note.endswith(": 100") for note in recording.notes)


def test_samples_before_the_first_position_of_a_list_are_left_out(tmp_path: Path) -> None:
    rows = ['one,"0,10,20,30",",,5,6",",,7,8"', 'two,"0,10,20","1,,3","1,,3"']
    path = write(tmp_path, "trial,t_ms,x,y", *rows)
    [recording] = read_any(path)
    assert recording.events.table[:, :3].tolist() == [[0.0, 5.0, 7.0], [0.01, 6.0, 8.0]]
    assert [skip.trial for skip in recording.skipped] == ["two"], "a hole within a movement"
    assert "samples before the first position left out: 2" in recording.notes


def test_intervals_are_no_clock(tmp_path: Path) -> None:
    steps = [8, 9, 7] * 10
    lines = [f"{step};{i};{i};{sum(steps[: i + 1])}" for i, step in enumerate(steps)]
    path = write(tmp_path, "time;x;y;rel_time", *lines)
    with pytest.raises(ColumnsError, match=r"10 of 29 steps.*--columns t=rel_time,x=x,y=y"):
        read_any(path, Reading(columns={"t": "time"}, time_unit="ms"))
    assert similar_names(["time_interval_s", "dt", "stamp"])["t"] == "stamp"


def test_a_clock_of_each_user_may_start_anew(tmp_path: Path) -> None:
    lines = [f"{name};{10 * i};{i};{i}" for i in range(8) for name in "dcba"]
    lines += [f"{name};{10 * i};{i};{i}" for i in range(8) for name in "ab"]
    [recording] = read_any(write(tmp_path, "user;t;x;y", *lines), Reading(time_unit="ms"))
    assert (len(recording.trials), len(recording.events)) == (6, 48)


def test_positions_that_overflow_are_left_out(tmp_path: Path) -> None:
    path = write(tmp_path, "t;x;y", *MOVES, "300;1e305;3")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        [recording] = read_any(path, Reading(px_per_unit=1e6, time_unit="ms", cut="whole"))
    assert len(recording.events) == 30
    assert any("rows left out: 1, the first is data row 30" in note for note in recording.notes)
    with pytest.raises(ParameterError, match="px_per_unit"):
        Reading(px_per_unit=1e12)


@pytest.mark.parametrize("header", [["trial,t_ms,x,y"], ['"a;b",t_ms,x,y'], []])
def test_separators_inside_quotes_do_not_count(header: list[str], tmp_path: Path) -> None:
    lists = ",".join(('"0;10;20"', '"1,5;2,5;3"', '"4;5;6"'))
    path = write(tmp_path, *header, f"1,{lists}", f"2,{lists}")
    [recording] = read_any(path, columns={"trial": 0, "t": 1, "x": 2, "y": 3}, time_unit="ms")
    assert recording.events.x.tolist() == [1.5, 2.5, 3.0] * 2
    assert recording.events.t.tolist() == [0.0, 0.01, 0.02] * 2


def test_quotes_that_mean_inches_hide_no_separator(tmp_path: Path) -> None:
    path = write(
        tmp_path,
        "screen;t;x;y",
        *(f'"15""";{move}' for move in MOVES),
        *(f'15";{move}' for move in MOVES[:1]),
    )
    layout = layout_of(path.read_text(encoding="utf-8"))
    assert layout is not None
    assert layout.separator == ";"


def test_runs_of_tabs_separate_like_blanks() -> None:
    lines = ["\t" * (1 + i % 3) + f"{10 * i}\t{3 * i}\t{100 - i}" for i in range(9)]
    layout = layout_of("\n".join(["t_ms\tx\ty", *lines]))
    assert layout is not None
    assert (layout.separator, layout.columns) == (" ", ["t_ms", "x", "y"])


@pytest.mark.parametrize(
    ("x", "y", "options", "doubt"),
    [
        (lambda i: 0.1 + 0.01 * i, lambda i: 0.2, {}, "--px-per-unit"),
        (lambda i: 0.1 + 0.01 * i, lambda i: 0.2, {"px_per_unit": 1920.0}, None),
        (lambda i: 10.0 + i, lambda i: -3.0 - i, {}, "--y-up"),
        (lambda i: 10.0 + i, lambda i: -3.0 - i, {"y_up": True}, None),
        (lambda i: 10.0 + i, lambda i: 3.0 + i, {}, None),
    ],
)
def test_positions_that_are_hardly_px_from_the_top_are_doubted(
    tmp_path: Path, x: Callable[[int], float], y: Callable[[int], float], options: Any, doubt: str | None
) -> None:
    path = tmp_path / "odd.csv"
    path.write_text("t,x,y\n" + "".join(f"{i / 100},{x(i)},{y(i)}\n" for i in range(30)))
    notes = " ".join(read_any(path, **options)[0].notes)
    assert [one for one in ("--px-per-unit", "--y-up") if one in notes] == ([doubt] if doubt else [])


def test_a_row_of_very_many_cells_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "wide.csv"
    path.write_text(",".join(f"c{i}" for i in range(5000)) + "\n" + ("1," * 4999 + "2\n") * 3)
    with pytest.raises(RecordingError, match="4096 columns"):
        read_any(path)
