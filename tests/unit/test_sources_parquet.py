"""Parquet files under foreign names: mapped or refused like any table; pointpred's own stay its own."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from pointpred.errors import ColumnsError, RecordingError
from pointpred.recordings import read_any, write
from pointpred.recordings.known_formats import format_of

COUNT = 20
X = [1.5 * i for i in range(COUNT)]
Y = [300 - i for i in range(COUNT)]


def parquet(folder: Path, **columns: Any) -> Path:
    """A Parquet file of these columns."""
    path = folder / "study.parquet"
    pq.write_table(pa.table(columns), path)
    return path


def test_usual_names_need_no_word(tmp_path: Path) -> None:
    who = pa.array(["ann", "bob"] * 10).dictionary_encode()
    path = parquet(tmp_path, subject=who, time_ms=[10 * i for i in range(COUNT)], xpos=X, ypos=Y)
    [recording] = read_any(path, y_up=True, px_per_unit=2.0)
    assert [trial.user for trial in recording.trials] == ["ann", "bob"]
    assert recording.events.table[1, :3].tolist() == [0.02, 6.0, -2.0 * 298]
    assert recording.provenance.y_axis == "up"


def test_rows_that_no_column_holds_are_not_believed(tmp_path: Path) -> None:
    """Arrow makes room for the rows that are claimed before it reads one."""
    path = parquet(tmp_path, t_ms=[10 * i for i in range(COUNT)], x=X, y=Y)
    data = path.read_bytes()
    footer = len(data) - 8 - int.from_bytes(data[-8:-4], "little")
    count, more = bytes([0x16, 2 * COUNT]), bytes([0x16, 2 * COUNT + 2])  # as Thrift writes it
    for place in (data.index(count, footer), data.rindex(count)):  # of the file, of its row group
        path.write_bytes(data[:place] + more + data[place + 2 :])
        with pytest.raises(RecordingError, match=r"study\.parquet: damaged"):
            read_any(path)


def test_other_names_are_refused_with_a_mapping_to_try_and_read_by_it(tmp_path: Path) -> None:
    path = parquet(tmp_path, clock=[16 * i for i in range(COUNT)], across=X, up=Y, picture=[b"\0"] * COUNT)
    with pytest.raises(ColumnsError, match=r"pointpred score .*study\.parquet --columns") as refusal:
        read_any(path)
    assert refusal.value.columns == ("clock", "across", "up")
    [recording] = read_any(path, columns={"t": "clock", "x": "across", "y": "up"})
    assert recording.events.x.tolist() == X
    assert any("picture" in note for note in recording.notes)


BEGIN = datetime(2024, 5, 1, 9, 30, tzinfo=UTC)
STEPS = [timedelta(milliseconds=8 * i) for i in range(COUNT)]


@pytest.mark.parametrize(
    "times",
    [
        pa.array([BEGIN + step for step in STEPS]),
        pa.array([(BEGIN + step).replace(tzinfo=None) for step in STEPS], pa.timestamp("ms")),
        pa.array([(BEGIN + step).time() for step in STEPS]),
        pa.array(STEPS),
    ],
    ids=["with a zone", "without a zone", "time of day", "duration"],
)
@pytest.mark.parametrize("told", [None, "iso", "ms"])
def test_types_of_dates_and_times_say_their_unit(times: Any, told: Any, tmp_path: Path) -> None:
    [recording] = read_any(parquet(tmp_path, time_ms=times, x=X, y=Y), time_unit=told)
    assert recording.events.t.tolist() == [8 * i / 1e3 for i in range(COUNT)]


def test_a_date_is_no_position(tmp_path: Path) -> None:
    path = parquet(tmp_path, t_ms=[8 * i for i in range(COUNT)], x=[BEGIN + step for step in STEPS], y=Y)
    with pytest.raises(ColumnsError, match="no number"):
        read_any(path)


def test_a_row_may_be_a_trial_and_a_field_a_column(tmp_path: Path) -> None:
    lists = {"t_ms": [[0, 10, 20]] * 2, "x": [[1, 2, 3]] * 2, "y": [[4.0, 5.0, 6.0]] * 2}
    [recording] = read_any(parquet(tmp_path, trial=[1, 2], **lists))
    assert [trial.trial for trial in recording.trials] == ["1", "2"]
    place = [{"x": x, "y": y} for x, y in zip(X, Y, strict=True)]
    [recording] = read_any(parquet(tmp_path, t_ms=[8 * i for i in range(COUNT)], pos=place))
    assert recording.events.x.tolist() == X


def test_own_files_stay_own_with_and_without_their_mark(tmp_path: Path) -> None:
    path = parquet(
        tmp_path, user=["a"] * 20, trial=[1] * 20, t_s=[i / 100 for i in range(20)], x_px=X, y_px=Y
    )
    form = format_of(path)
    assert form is not None
    assert form.key == "own"
    [recording] = read_any(path)
    for file in write(recording, tmp_path / "again.parquet"):
        assert (form := format_of(file)) is not None
        assert form.key == "own"


def test_a_damaged_file_is_an_error_that_names_it(tmp_path: Path) -> None:
    path = parquet(tmp_path, t_ms=range(COUNT), x=X, y=Y)
    path.write_bytes(path.read_bytes()[:-9])
    with pytest.raises(RecordingError, match=r"study\.parquet"):
        read_any(path)


@pytest.mark.parametrize("kind", [pa.timestamp("us"), pa.timestamp("s"), pa.date32(), pa.duration("s")])
def test_a_time_that_no_calendar_has_is_refused(tmp_path: Path, kind: Any) -> None:
    far = {pa.date32(): 2**31 - 1, pa.timestamp("s"): 2**42}.get(kind, 2**62)
    counts = pa.array([0] * (COUNT - 1) + [far], pa.int32() if kind == pa.date32() else pa.int64())
    path = parquet(tmp_path, time=counts.cast(kind), x=X, y=Y)
    with pytest.raises(RecordingError, match=r"study\.parquet.*'time'.*out of range"):
        read_any(path)
