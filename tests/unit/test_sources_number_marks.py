"""Decimal commas and thousands separators: read where they are certain, otherwise refused; never lists."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from pointpred.errors import ColumnsError
from pointpred.recordings import Reading, read_any
from tests.building import lines_file

COUNT = 40
TIMES = [10 * i for i in range(COUNT)]
XS = [850.25 + 12.5 * i for i in range(COUNT)]
"""Some of them below 1000, some above."""


def table(folder: Path, separator: str, *columns: list[str]) -> Path:
    """A file with the columns t_ms, x and y."""
    quote = '"' if separator == "," else ""
    rows = [separator.join(f"{quote}{cell}{quote}" for cell in row) for row in zip(*columns, strict=True)]
    return lines_file(folder / "numbers.csv", separator.join(("t_ms", "x", "y")), *rows)


def german(value: float) -> str:
    return f"{value:,.2f}".translate(str.maketrans(",.", ".,"))


@pytest.mark.parametrize("separator", [",", ";"])
@pytest.mark.parametrize(
    "written",
    [
        lambda value: f"{value:.2f}".replace(".", ","),
        german,
        lambda value: f"{value:,.2f}",
        lambda value: f"{value:,.2f}".replace(",", " "),
        lambda value: f"{value:,.2f}".replace(",", "\u00a0").replace(".", ","),
    ],
    ids=["1234,50", "1.234,50", "1,234.50", "1 234.50", "1 234,50"],
)
def test_numbers_that_can_be_read_in_one_way_are_read(
    written: Callable[[float], str], separator: str, tmp_path: Path
) -> None:
    cells = [written(x) for x in XS]
    [recording] = read_any(table(tmp_path, separator, [str(t) for t in TIMES], cells, cells))
    assert recording.events.x.tolist() == XS
    assert len(recording.trials) == 1
    grouped = any(len(cell) > len("1234,50") for cell in cells)
    assert grouped == any("thousands separators" in note for note in recording.notes)


@pytest.mark.parametrize(
    ("separator", "mark"),
    [(",", ","), (";", ","), ("\t", ","), (";", ".")],
    ids=[", ,", "; ,", "tab ,", "; ."],
)
def test_a_mark_before_three_digits_alone_is_refused(separator: str, mark: str, tmp_path: Path) -> None:
    cells = [f"{round(x):,}".replace(",", mark) for x in XS]
    path = table(tmp_path, separator, [str(t) for t in TIMES], cells, cells)
    with pytest.raises(ColumnsError, match=r"may be 1000 or 1\.000"):
        read_any(path)


def test_a_leading_zero_shows_a_decimal_comma_before_three_digits(tmp_path: Path) -> None:
    times = [f"{t / 1000:.3f}".replace(".", ",") for t in TIMES]
    cells = [f"{x:.3f}".replace(".", ",") for x in XS]
    path = table(tmp_path, ",", times, cells, cells)
    [recording] = read_any(path, Reading(time_unit="s"))
    assert recording.events.table[:, :2].tolist() == [[t / 1000, x] for t, x in zip(TIMES, XS, strict=True)]


def test_points_before_three_digits_stay_decimal_where_all_numbers_have_them(tmp_path: Path) -> None:
    cells = [f"{x:.3f}" for x in XS]
    [recording] = read_any(table(tmp_path, ";", [str(t) for t in TIMES], cells, cells))
    assert recording.events.x.tolist() == XS


def test_two_numbers_in_each_cell_are_no_trial_a_row(tmp_path: Path) -> None:
    cells = [f"{x:g} {x:g}" for x in XS]
    with pytest.raises(ColumnsError, match="no number"):
        read_any(table(tmp_path, ",", cells, cells, cells))


def test_lists_of_numbers_of_three_digits_stay_lists(tmp_path: Path) -> None:
    times, places = ",".join(map(str, TIMES)), ",".join(str(200 + t) for t in TIMES)
    [recording] = read_any(table(tmp_path, ",", [times] * 2, [places] * 2, [places] * 2))
    assert recording.events.x.tolist() == [200 + t for t in TIMES] * 2
