"""Clocks of other people's tables: dates that cannot be, units that are not certain, times too coarse."""

from __future__ import annotations

import datetime
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from pointpred.errors import ColumnsError
from pointpred.recordings import read_any
from tests.building import lines_file


def table(folder: Path, header: str, times: list[str], *more: str) -> Path:
    """A table of these times, with x and y and what ``more`` adds to each row."""
    rows = [",".join((time, str(3 * i), str(100 - i), *more)) for i, time in enumerate(times)]
    return lines_file(folder / "clock.csv", header, *rows)


STAMPS = [f"2024-03-01T10:00:00.{20 * i:03d}" for i in range(20)]


@pytest.mark.parametrize(
    "stamp",
    ["2024-02-30T10:00:00", "2024-03-01T10:00:60", "2024-03-01T24:00:00", "2924-03-01T10:00:00Z"],
)
def test_an_impossible_date_costs_its_row(tmp_path: Path, stamp: str) -> None:
    times = [*STAMPS[:7], stamp, *STAMPS[7:]]
    [recording] = read_any(table(tmp_path, "timestamp,x,y", times))
    assert len(recording.events) == 20
    assert any("data row 7" in note and stamp in note for note in recording.notes)
    [recording] = read_any(table(tmp_path, "timestamp,x,y,trial", [*times, *times], "a"))
    assert [(skip.trial, skip.row) for skip in recording.skipped] == [("a", 7)]
    assert stamp in recording.skipped[0].reason


def test_a_table_of_dates_that_cannot_be_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ColumnsError, match="20 of 20 cells") as refusal:
        read_any(table(tmp_path, "timestamp,x,y", [stamp.replace("03-01", "02-30") for stamp in STAMPS]))
    assert "date" in refusal.value.reason


def test_a_date_too_far_for_nanoseconds_costs_its_row(tmp_path: Path) -> None:
    start = datetime.datetime(2024, 3, 1)
    times = [start + datetime.timedelta(milliseconds=20 * i) for i in range(20)]
    times[4] = datetime.datetime(2924, 3, 1)
    path = tmp_path / "far.parquet"
    numbers = [float(i) for i in range(20)]
    pq.write_table(pa.table({"time": pa.array(times, pa.timestamp("us")), "x": numbers, "y": numbers}), path)
    [recording] = read_any(path)
    assert len(recording.events) == 19
    assert any("data row 4" in note and "2924" in note for note in recording.notes)


def counted(step: float, start: float = 0.0, count: int = 40) -> list[str]:
    """Times of equal steps."""
    return [f"{start + i * step:.17g}" for i in range(count)]


@pytest.mark.parametrize(
    ("times", "unit"),
    [
        (counted(16.67), "ms"),
        (counted(8), "ms"),
        (counted(2), "ms"),
        (counted(0.01667), "s"),
        (counted(8333), "us"),
        (counted(1, 1_700_000_000), "s"),
        ([str(1_700_000_000 + i // 10) for i in range(40)], "s"),
        (counted(0.02, 1_700_000_000), "s"),
        (counted(150, 1_700_000_000_000), "ms"),
        (counted(16, 1_214_935_989), "ms"),
        ([str(1_700_000_000_000_000_000 + 250_000_000 * i) for i in range(40)], "ns"),
    ],
)
def test_a_unit_that_is_certain_is_taken(tmp_path: Path, times: list[str], unit: str) -> None:
    [recording] = read_any(table(tmp_path, "time,x,y,trial", times, "a"))
    assert f"t = time in {unit} (by its" in recording.notes[0]


@pytest.mark.parametrize(
    ("times", "units"),
    [
        (counted(0.25), "s or ms"),
        (counted(1), "s or ms"),
        (counted(150), "ms or us"),
        (counted(0.02, 1_700_000_000_000), "ms or s"),
        (counted(5, 1_700_000_000), "s or ms"),
        (counted(1e-7), "s or ms or us or ns or iso"),
    ],
    ids=["4 Hz", "frames", "150", "steps that contradict the size", "slow", "days"],
)
def test_a_unit_that_is_not_certain_is_asked_for(tmp_path: Path, times: list[str], units: str) -> None:
    path = table(tmp_path, "time,x,y,trial", times, "a")
    with pytest.raises(ColumnsError) as refusal:
        read_any(path)
    assert f"--time-unit UNIT (UNIT: {units})" in str(refusal.value)
    assert refusal.value.time_unit is None
    assert ("frames" in refusal.value.reason) == (times[1] == "1")
    assert read_any(path, time_unit="s")


@pytest.mark.parametrize(
    ("times", "header", "command"),
    [
        (counted(0.02), "time", "--columns t=time,x=COLUMN,y=COLUMN --time-unit s"),
        (counted(20), "time", "--columns t=time,x=COLUMN,y=COLUMN --time-unit ms"),
        (counted(20), "time_us", "--columns t=time_us,x=COLUMN,y=COLUMN --time-unit us"),
        (STAMPS, "time", "--columns t=time,x=COLUMN,y=COLUMN --time-unit iso"),
        (counted(1), "time", "--columns t=time,x=COLUMN,y=COLUMN --time-unit UNIT (UNIT: s or ms)"),
        (counted(20), "when", "--columns t=COLUMN,x=COLUMN,y=COLUMN"),
    ],
)
def test_a_refusal_prints_a_unit_only_where_it_is_known(
    tmp_path: Path, times: list[str], header: str, command: str
) -> None:
    with pytest.raises(ColumnsError) as refusal:
        read_any(table(tmp_path, f"{header},across,up", times))
    assert str(refusal.value).endswith(command)
    unit = command.rpartition("--time-unit ")[2]
    assert refusal.value.time_unit == (unit if unit in ("s", "ms", "us", "iso") else None)


@pytest.mark.parametrize(
    ("times", "unit", "asked"),
    [
        (counted(0.02), "ms", "is it in s?"),
        (counted(20), "ns", "is it in ms?"),
        (counted(20), "s", "is it in ms?"),
        (counted(1e-9), "s", "is it a time?"),
        (counted(20), "ms", ""),
    ],
)
def test_a_rate_that_no_pointer_has_is_noticed(
    tmp_path: Path, times: list[str], unit: str, asked: str
) -> None:
    [recording] = read_any(table(tmp_path, f"time_{unit},x,y,trial", times, "a"))
    assert [note.endswith(asked) for note in recording.notes if "median interval" in note] == (
        [True] if asked else []
    )


def test_a_user_in_another_unit_is_noticed(tmp_path: Path) -> None:
    rows = [
        f"{user},{i * step},{i},{i},1" for user, step in (("a", 20), ("b", 0.02), ("c", 20)) for i in range(9)
    ]
    path = tmp_path / "users.csv"
    path.write_text("\n".join(["user,t_ms,x,y,trial", *rows]) + "\n")
    [recording] = read_any(path)
    assert [note for note in recording.notes if "median interval" in note and "'b'" in note]


def test_lists_in_another_unit_are_noticed(tmp_path: Path) -> None:
    path = tmp_path / "lists.csv"
    path.write_text('trial,t_ms,x,y\none,"0,0.02,0.04,0.06","1,2,3,4","1,2,3,4"\n')
    [recording] = read_any(path)
    assert any("median interval" in note for note in recording.notes)


def test_stamps_of_whole_seconds_are_called_so(tmp_path: Path) -> None:
    times = [f"2024-03-01T10:00:{i // 10:02d}" for i in range(60)]
    with pytest.raises(ColumnsError) as refusal:
        read_any(table(tmp_path, "timestamp,x,y", times))
    assert "whole seconds" in refusal.value.reason
    [recording] = read_any(table(tmp_path, "timestamp,x,y,trial", times, "a"))
    assert any("whole seconds" in note for note in recording.notes)
    [recording] = read_any(table(tmp_path, "timestamp,x,y", times[::10]))
    assert not any("whole seconds" in note for note in recording.notes)


@pytest.mark.parametrize("header", ["time_min", "Time (h)", "time_frames"])
def test_a_unit_that_is_not_read_is_not_taken_for_another(tmp_path: Path, header: str) -> None:
    with pytest.raises(ColumnsError) as refusal:
        read_any(table(tmp_path, f"{header},x,y", counted(0.01)), columns={"t": 0})
    assert "--time-unit UNIT" in str(refusal.value)


def test_words_are_no_clock_of_an_unknown_unit(tmp_path: Path) -> None:
    times = [f"01.03.2024 10:00:{i:02d}" for i in range(20)]
    with pytest.raises(ColumnsError) as refusal:
        read_any(table(tmp_path, "time,x,y", times))
    assert times[0] in str(refusal.value)
    assert "--time-unit" not in str(refusal.value)
    with pytest.raises(ColumnsError) as refusal:
        read_any(table(tmp_path, "time,across,up", times))
    assert "t=time" in str(refusal.value)
    assert "--time-unit" not in str(refusal.value)
