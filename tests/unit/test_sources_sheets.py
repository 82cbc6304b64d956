"""Workbooks with several sheets: those with the same columns are one table, of others one is chosen."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
from openpyxl import Workbook

from pointpred.errors import RecordingError
from pointpred.recordings import read_any

ROWS = [(10 * i, 3 * i, 100 - i) for i in range(20)]


def write(folder: Path, names: Mapping[str, list[str]] | None = None, **sheets: int) -> Path:
    """A workbook with as many rows in each sheet, and the names of the columns of some."""
    book = Workbook()
    book.active.append(["a study of hands"])
    for title, count in sheets.items():
        sheet = book.create_sheet(title)
        sheet.append((names or {}).get(title, ["time_ms", "x", "y"]))
        for row in ROWS[:count]:
            sheet.append(row)
    book.save(folder / "study.xlsx")
    return folder / "study.xlsx"


def test_sheets_with_other_columns_are_named(tmp_path: Path) -> None:
    names = {"P1": ["time_ms", "x", "y"], "P2": ["time_ms", "mouse_x", "mouse_y"]}
    path = write(tmp_path, names, P1=20, P2=11)
    with pytest.raises(RecordingError, match=r"'P1' \(20 rows: .*\); 'P2' \(11 rows: .*y\); save .*CSV, or"):
        read_any(path)
    [recording] = read_any(path, columns={"x": "mouse_x", "y": "mouse_y"})
    assert len(recording.events) == 11


def test_the_largest_of_sheets_with_other_columns_is_read_wherever_it_stands(tmp_path: Path) -> None:
    [recording] = read_any(write(tmp_path, {"practice": ["t_ms", "x", "y"]}, practice=10, test=20))
    assert len(recording.events) == 20
    assert any("'test'; other sheets left aside: Sheet, practice" in note for note in recording.notes)


def test_a_longer_sheet_without_usual_names_is_left_aside(tmp_path: Path) -> None:
    [recording] = read_any(write(tmp_path, {"keys": ["when", "what", "code"]}, keys=25, mouse=11))
    assert len(recording.events) == 11
    assert any("'mouse'; other sheets left aside: Sheet, keys" in note for note in recording.notes)


def test_sheets_with_the_same_columns_are_one_table_with_their_names(tmp_path: Path) -> None:
    path = write(tmp_path, P1=20, P2=11)
    [recording] = read_any(path, columns={"user": "sheet"})
    assert [trial.user for trial in recording.trials] == ["P1", "P2"]
    assert recording.events.x.tolist() == [x for _, x, _ in ROWS + ROWS[:11]]
    [recording] = read_any(path)
    assert recording.notes[0].startswith("records: 31 rows of the sheets 'P1', 'P2'; the column sheet names")
