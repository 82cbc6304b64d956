"""Tables in JSON, MATLAB files, workbooks and XDF: one known truth, whatever holds it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from openpyxl import Workbook

from pointpred import extras
from pointpred.errors import MissingExtraError, RecordingError
from pointpred.sources import Reading, read_any, workbook, xdf
from tests.unit.writing_containers import (
    ROWS,
    TRIALS,
    WRITERS,
    chunk,
    clock_offset,
    stream_header,
    stream_samples,
    write_workbook,
    write_xdf,
)

T, X, Y = (np.array([row[at] for row in ROWS]) for at in range(3))


@pytest.mark.parametrize("extension", ["json", "xlsx"])
def test_the_same_table_in_every_container(extension: str, tmp_path: Path) -> None:
    path = tmp_path / f"own.{extension}"
    WRITERS[extension](path)
    (recording,) = read_any(path)
    assert not recording.skipped
    assert [(trial.user, trial.trial) for trial in recording.trials] == [
        (user, str(trial)) for user, trial in TRIALS
    ]
    for index, samples in enumerate(TRIALS.values()):
        rows = recording.rows(index)
        np.testing.assert_allclose(rows.table[:, :3] * [1000, 1, 1], samples, atol=1e-9)


def test_a_mouse_stream_of_xdf_on_the_clock_of_the_recorder(tmp_path: Path) -> None:
    for offset in (None, 5.0):
        path = tmp_path / "own.xdf"
        write_xdf(path, offset)
        table = xdf.read(path)
        np.testing.assert_allclose(
            table.columns["time_stamps"], 100 + (offset or 0.0) + np.arange(48) * 0.008, atol=1e-9
        )
    (recording,) = read_any(path)
    assert [trial.trial for trial in recording.trials] == ["11", "12", "21", "22"]
    np.testing.assert_allclose(recording.events.table[:, 1], X)
    np.testing.assert_allclose(recording.events.table[:, 2], Y)
    np.testing.assert_allclose(recording.rows(0).t, np.arange(12) * 0.008, atol=1e-9)
    assert any("Amplifier" in note for note in recording.notes)


def test_other_libraries_read_the_same_cells(tmp_path: Path) -> None:
    write_workbook(tmp_path / "own.xlsx")
    frame = pd.read_excel(tmp_path / "own.xlsx", sheet_name="mouse")
    assert frame.to_dict("list") == workbook.read(tmp_path / "own.xlsx").columns


@pytest.mark.parametrize("extension", ["xlsx", "xdf"])
def test_without_the_library_the_command_that_installs_it(
    extension: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    WRITERS[extension](tmp_path / f"own.{extension}")
    WRITERS["json"](tmp_path / "own.json")
    monkeypatch.setattr(extras, "find_spec", lambda name: None)
    with pytest.raises(MissingExtraError) as caught:
        read_any(tmp_path / f"own.{extension}")
    assert extras.install_command("tables") in str(caught.value)
    (recording,) = read_any(tmp_path)  # the rest of a folder is read
    assert [skip.trial for skip in recording.skipped] == [f"own.{extension}"]


def test_sheets_are_named_and_titles_above_the_table_left_out(tmp_path: Path) -> None:
    path = tmp_path / "own.xlsx"
    book = Workbook()
    for title, rows in {
        "few": [["a", "b"], [1, 2]],
        "first": [["Our study"], [], ["t", "x", "y", "x"], [0, 1, 2, None], [], [8, 3, None, 4, "more"]],
        "bare": [[0, 1, 2], [8, 3, 4]],
    }.items():
        sheet = book.create_sheet(title)
        for row in rows:
            sheet.append(row)
    book.save(path)
    first = {"t": [0, 8], "x.1": [1, 3], "y": [2, None], "x.3": [None, 4], "4": [None, "more"]}
    assert workbook.read(path).columns == first
    assert workbook.read(path, Reading(records="bare")).columns == {"0": [0, 8], "1": [1, 3], "2": [2, 4]}
    for wanted in ("few", "none"):
        with pytest.raises(RecordingError, match=r"own\.xlsx"):
            workbook.read(path, Reading(records=wanted))


def test_a_sheet_that_claims_a_huge_size_costs_nothing(tmp_path: Path) -> None:
    path = tmp_path / "far.xlsx"
    book = Workbook()
    for column, name in enumerate(("t", "x", "y"), 1):
        book.active.cell(1, column, name)
    book.active.cell(100_000, 16_000, 7)
    book.save(path)
    table = workbook.read(path)
    assert table.columns == {"t": [None], "x": [None], "y": [None], "15999": [7]}


def streams(path: Path, *parts: bytes) -> Path:
    path.write_bytes(b"XDF:" + b"".join(parts))
    return path


def test_the_stream_of_xdf_is_chosen_by_name_type_or_labels(tmp_path: Path) -> None:
    rows = [(float(at), 2.0) for at in range(4)]
    parts = [
        stream_header(1, "Left", "Position", ["x", "y"]),
        stream_header(2, "Right", "Position", ["x", "y"]),
        stream_header(3, "Keys", "Markers", ["key"], "string"),
        *(stream_samples(number, [1.0, 1.1, 1.2, 1.3], rows) for number in (1, 2)),
    ]
    path = streams(tmp_path / "two.xdf", *parts)
    with pytest.raises(RecordingError, match=r"Left.*Right"):
        xdf.read(path)
    assert xdf.read(path, Reading(records="Right")).notes[0].startswith("stream Right")
    for wanted in ("Keys", "position", "Middle"):
        with pytest.raises(RecordingError, match="--records"):
            xdf.read(path, Reading(records=wanted))
    path = streams(tmp_path / "one.xdf", parts[0], parts[2], parts[3])
    assert xdf.read(path).columns["x"].tolist() == [0, 1, 2, 3]


def test_a_cut_xdf_keeps_its_whole_chunks(tmp_path: Path) -> None:
    path = tmp_path / "own.xdf"
    write_xdf(path)
    whole = path.read_bytes()
    path.write_bytes(whole[:-100])
    table = xdf.read(path)
    assert len(table.columns["x"]) == 36
    assert any("left aside from there" in note for note in table.notes)
    with pytest.raises(RecordingError, match="no samples"):
        xdf.read(streams(path, stream_header(1, "Mouse", "Mouse", ["x", "y"])))


def test_claims_of_size_in_xdf_are_not_believed(tmp_path: Path) -> None:
    huge = stream_header(1, "Mouse", "Mouse", ["x", "y"]).replace(b"count>2<", b"count>99999999<")
    with pytest.raises(RecordingError, match="channels"):
        xdf.read(streams(tmp_path / "a.xdf", chunk(2, huge[7:])))
    header = stream_header(1, "Mouse", "Mouse", ["x", "y"])
    samples = chunk(3, b"\x01\0\0\0" + b"\x08" + (1 << 60).to_bytes(8, "little"))
    with pytest.raises(RecordingError, match="no samples"):
        xdf.read(streams(tmp_path / "b.xdf", header, clock_offset(1, 1.0, 0.0), samples))


@pytest.mark.parametrize(
    ("head", "word"), [(b"RDX3\nX\n", "write.csv"), (b"$FL2@(#)", "CSV"), (b"PK\x03\x04", "")]
)
def test_files_of_other_programs_are_refused(head: bytes, word: str, tmp_path: Path) -> None:
    path = tmp_path / "own.data"
    path.write_bytes(head + bytes(200))
    with pytest.raises(RecordingError) as caught:
        read_any(path)
    assert word in str(caught.value)
