"""Decimal commas and thousands separators in numbers, and ambiguous columns."""

from __future__ import annotations

from typing import Any

import msgspec
import pyarrow.compute as pc

from pointpred.recordings import arrow_tables

BLANK = r"[ \x{A0}\x{202F}\x{2009}]"
SIGN = r"^\s*[+-]?"
COMMA_NUMBER = SIGN + r"(\d+,\d*|,\d+)([eE][+-]?\d+)?\s*$"
POINT_NUMBER = SIGN + r"(\d+\.\d*|\.\d+)([eE][+-]?\d+)?\s*$"
COMMA_GROUPS = SIGN + r"[1-9]\d{0,2}(,\d{3}){1,3}\s*$"
"""A single comma before three digits, which may be either mark."""
POINT_GROUPS = SIGN + r"[1-9]\d{0,2}(\.\d{3}){1,3}\s*$"
COMMA_THOUSANDS = SIGN + r"[1-9]\d{0,2}((,\d{3}){1,3}\.\d*|(,\d{3}){2,3})\s*$"
POINT_THOUSANDS = SIGN + r"[1-9]\d{0,2}((\.\d{3}){1,3},\d*|(\.\d{3}){2,3})\s*$"
BLANK_THOUSANDS = SIGN + r"[1-9]\d{0,2}(" + BLANK + r"\d{3}){1,2}([.,]\d*)?\s*$"
SMALL = SIGN + r"\d{1,3}\s*$"
NUMERIC = r"^[\s\d.,+\-eE\x{A0}\x{202F}\x{2009}]*$"
SEVERAL = r"^[^,]*,[^,]*,"
"""Two commas or more: a list of three items or more, unless the digits are in groups of three."""
SOME = 0.2
"""Largest share of other cells in a column of such numbers."""


class Marks(msgspec.Struct):
    """Columns with numbers in Python's notation, notes on changes, and the reasons for unsure columns."""

    columns: dict[str, Any]
    notes: list[str] = []
    unsure: dict[str, str] = {}


def plain_numbers(columns: dict[str, Any], separator: str) -> Marks:
    """The text columns with decimal points and without thousands separators.

    A comma or a point before three digits is ambiguous; the other cells of the table decide. If they do not,
    or contradict each other, the column is unchanged and unsure. Columns of lists are unchanged.
    """
    marks = Marks(dict(columns))
    if separator != " ":
        _blanks(marks)
    commas = [
        name for name, column in marks.columns.items() if _any(column, ",", plain=True) and _numeric(column)
    ]
    if any(_are_lists(marks.columns[name]) for name in commas) and separator == ",":
        return marks
    commas = [name for name in commas if not _are_lists(marks.columns[name])]
    some = {name: marks.columns[name] for name in commas}
    thousands = _first(some, COMMA_THOUSANDS)
    decimal = _first(some, COMMA_NUMBER, COMMA_GROUPS) or _first(some, POINT_THOUSANDS, POINT_GROUPS)
    for name, column in some.items():
        if not thousands and _any(column, POINT_NUMBER) and _any(column, COMMA_NUMBER):
            marks.unsure[name] = f"{_cell(column, COMMA_NUMBER)!r} has a comma where other cells have a point"
        elif thousands and decimal:
            marks.unsure[name] = f"{thousands!r} has a comma between thousands, {decimal!r} a decimal comma"
        elif decimal:
            _point_for_comma(marks, name)
        elif thousands:
            groups = _match(column, f"{COMMA_GROUPS}|{COMMA_THOUSANDS}")
            _change(marks, name, groups, pc.replace_substring(column, ",", ""))
        elif cell := _cell(column, COMMA_GROUPS):
            whole, point = cell.strip().replace(",", ""), cell.strip().replace(",", ".")
            marks.unsure[name] = f"{cell!r} may be {whole} or {point}"
    if separator in ";\t":
        _points(marks, set(commas))
    return marks


def _blanks(marks: Marks) -> None:
    """Remove the blanks from columns in which they can only separate thousands."""
    for name, column in list(marks.columns.items()):
        groups = _match(column, BLANK_THOUSANDS)
        if not pc.any(groups, min_count=0).as_py():
            continue
        others = pc.and_(pc.invert(groups), _match(column, r"\d" + BLANK + r"+[+-]?\d"))
        if pc.any(others, min_count=0).as_py():
            continue
        changed = pc.replace_substring_regex(column, BLANK, "")
        _change(marks, name, groups, changed)


def _points(marks: Marks, known: set[str]) -> None:
    """Mark columns as unsure in which points may separate thousands.

    That is, all cells of the table have three digits after the point, and some column has numbers below 1000
    without a point.
    """
    numbers = {name: column for name, column in marks.columns.items() if name not in known}
    if _first(numbers, POINT_NUMBER, POINT_GROUPS):
        return
    groups = {name: cell for name, column in numbers.items() if (cell := _cell(column, POINT_GROUPS))}
    if any(_any(numbers[name], SMALL) for name in groups):
        for name, cell in groups.items():
            whole = cell.strip().replace(".", "")
            marks.unsure[name] = f"{cell!r} may be {whole} or {cell.strip()}"


def _point_for_comma(marks: Marks, name: str) -> None:
    """Write decimal commas as points, after removing points that separate thousands."""
    column = marks.columns[name]
    grouped = _match(column, POINT_THOUSANDS)
    if pc.any(grouped, min_count=0).as_py():
        _change(marks, name, grouped, pc.replace_substring(column, ".", ""))
    column = marks.columns[name]
    commas = _match(column, COMMA_NUMBER)
    marks.columns[name] = pc.if_else(commas, pc.replace_substring(column, ",", "."), column)


def _change(marks: Marks, name: str, where: Any, changed: Any) -> None:
    """Replace a column by its cells without thousands separators; a note shows the first of them."""
    rows = arrow_tables.as_array(pc.indices_nonzero(where))
    if len(rows):
        first = str(marks.columns[name][int(rows[0])].as_py())
        marks.columns[name] = pc.if_else(where, changed, marks.columns[name])
        marks.notes.append(f"column {name}: thousands separators taken out, as in {first!r}")


def _are_lists(column: Any) -> bool:
    """Whether most cells with a comma hold three items or more."""
    commas = int(pc.sum(pc.match_substring(column, ","), min_count=0).as_py())
    groups = _match(column, COMMA_GROUPS + "|" + COMMA_THOUSANDS)
    several = pc.and_(_match(column, SEVERAL), pc.invert(groups))
    return int(pc.sum(several, min_count=0).as_py()) > SOME * commas


def _numeric(column: Any) -> bool:
    """Whether nearly all cells with a comma consist of digits and marks."""
    commas = pc.match_substring(column, ",")
    odd = pc.and_(commas, pc.invert(_match(column, NUMERIC)))
    return bool(pc.sum(odd, min_count=0).as_py() <= SOME * pc.sum(commas, min_count=0).as_py())


def _first(columns: dict[str, Any], pattern: str, unlike: str | None = None) -> str:
    """The first cell that matches one pattern and not another; empty if there is none."""
    return next((cell for column in columns.values() if (cell := _cell(column, pattern, unlike))), "")


def _cell(column: Any, pattern: str, unlike: str | None = None) -> str:
    fits = _match(column, pattern)
    if unlike is not None:
        fits = pc.and_(fits, pc.invert(_match(column, unlike)))
    rows = arrow_tables.as_array(pc.indices_nonzero(fits))
    return str(column[int(rows[0])].as_py()) if len(rows) else ""


def _any(column: Any, pattern: str, *, plain: bool = False) -> bool:
    matches = pc.match_substring(column, pattern) if plain else _match(column, pattern)
    return bool(pc.any(matches, min_count=0).as_py())


def _match(column: Any, pattern: str) -> Any:
    return pc.match_substring_regex(column, pattern)
