"""Workbooks with several sheets: all are read, one is chosen, or the sheets are named."""

from __future__ import annotations

from pathlib import Path

import pytest
from openpyxl import Workbook

from pointpred.errors import RecordingError
from pointpred.recordings import read_any

ROWS = [(10 * i, 3 * i, 100 - i) for i in range(20)]


def write(folder: Path, **sheets: int) -> Path:
    """A workbook with as many rows in each sheet."""
    book = Workbook()
    book.active.append(["a study of hands"])
    for title, count in sheets.items():
        sheet = book.create_sheet(title)
        sheet.append(["time_ms", "x", "y"])
        for row in ROWS[:count]:
            sheet.append(row)
    book.save(folder / "study.xlsx")
    return folder / "study.xlsx"


def test_sheets_of_like_size_are_named(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match=r"P1 \(20 rows\); P2 \(11 rows\).*--records P1.*--records '\*'"):
        read_any(write(tmp_path, P1=20, P2=11))


def test_the_largest_sheet_is_read_wherever_it_stands(tmp_path: Path) -> None:
    [recording] = read_any(write(tmp_path, practice=10, test=20))
    assert len(recording.events) == 20
    assert any("'test'; other sheets left aside: Sheet, practice" in note for note in recording.notes)


def test_all_sheets_are_read_with_their_names(tmp_path: Path) -> None:
    path = write(tmp_path, P1=20, P2=11)
    [recording] = read_any(path, records="*", columns={"user": "sheet"})
    assert [trial.user for trial in recording.trials] == ["P1", "P2"]
    assert recording.events.x.tolist() == [x for _, x, _ in ROWS + ROWS[:11]]
