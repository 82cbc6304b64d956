"""Clocks of other people's tables: dates that cannot be, units that are not certain, times too coarse."""

from __future__ import annotations

import datetime
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from pointpred.sources import read_any


def table(folder: Path, header: str, times: list[str], *more: str) -> Path:
    """A table of these times, with x and y and what ``more`` adds to each row."""
    path = folder / "clock.csv"
    rows = [",".join((time, str(3 * i), str(100 - i), *more)) for i, time in enumerate(times)]
    path.write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
    return path


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
