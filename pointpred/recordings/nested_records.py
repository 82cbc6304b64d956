"""Nested values, as JSON and MATLAB files and cells hold them, as one table of fields by records."""

from __future__ import annotations

import ast
import json
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import chain
from types import NoneType
from typing import Any

import msgspec

from pointpred.errors import RecordingError
from pointpred.recordings.arrow_tables import distinct_names

MOST_DEPTH = 32
MOST_CELLS = 40_000_000
"""Most cells of a table; Python needs 8 bytes for an empty one and 40 for a number."""
FEW = 16
"""An array of at most so many arrays, each longer than that, is a list of columns."""
POINT, TRACKS = range(2, 5), 3
"""Lists of at most so many numbers in all cells of a column are points."""
NUMBERS = {int, float, bool, NoneType}
SCALARS = NUMBERS | {str}
EACH = "*"
LEAST_COLUMNS = 3
"""A table of fewer columns cannot hold times and positions."""
MOST_FIELDS = 16
"""An object with more fields than this, all similar records, holds one record per name."""
TRACK = re.compile(r'\s*(\[\s*[\[{]|\{\s*"[^"]*"\s*:\s*\[)')
PROBE = 200
"""Rows among which the first nonempty cell decides the content of a column."""


class RecordTable:
    """Columns of one length that grow row by row; a missing field is ``None``.

    ``deep_fields`` are those that are too deep for a cell: the number of its row, its name and its value.
    Raises RecordingError above 4e7 cells.
    """

    def __init__(self, columns: dict[str, list[Any]] | None = None) -> None:
        self.columns = columns or {}
        self.rows = len(next(iter(self.columns.values()), ()))
        self.deep_fields: list[tuple[int, str, Any]] = []
        self._own = 0

    def add(self, row: dict[str, Any]) -> None:
        """Add a row of cells by name; ``finish`` after the last."""
        for name, cell in row.items():
            column = self.columns.get(name)
            if column is None:
                column = self.columns[name] = []
            if len(column) < self.rows:
                column += [None] * (self.rows - len(column))
            column.append(cell)
        self.rows += 1
        self._check()

    def finish(self) -> RecordTable:
        """The table, with all columns of one length."""
        for column in self.columns.values():
            column += [None] * (self.rows - len(column))
        return self

    def append(self, other: RecordTable, beside: dict[str, Any]) -> None:
        """Add the rows of another table, each with the cells ``beside``, which keep their names."""
        new = dict(other.columns)
        for name, cell in beside.items():
            while name in new:
                name = f"outer.{name}"
            new[name] = [cell] * other.rows
        for name, cells in new.items():
            if name not in self.columns:
                self.columns[name] = [None] * self.rows
            self.columns[name] += cells
        self._own = max(self._own, other.own)
        self.rows += other.rows
        self.deep_fields += other.deep_fields
        self._check()
        self.finish()

    def _check(self) -> None:
        if len(self.columns) * self.rows > MOST_CELLS:
            raise RecordingError(
                f"{len(self.columns)} fields in {self.rows} rows, at most {MOST_CELLS} cells are read"
            )

    @property
    def own(self) -> int:
        """The number of columns of its records, without those from beside them."""
        return self._own or len(self.columns)

    @property
    def samples(self) -> int:
        """The rows, or the items of the longest lists if cells hold lists."""
        return max(
            (
                sum(len(cell) if isinstance(cell, list) else 1 for cell in column)
                for column in self.columns.values()
            ),
            default=0,
        )


def table_of(value: Any) -> RecordTable | None:
    """A value as a table, ``None`` if it is not one: records, an array of arrays, an object of lists."""
    if isinstance(value, dict):
        return _of_split(value) or _of_lists(value) or _of_indexed(value)
    if not isinstance(value, list) or not value:
        return None
    kinds = set(map(type, value))
    if kinds <= {dict, NoneType}:
        return records(value)
    return by_position(value) if kinds == {list} else None


def records(rows: Sequence[dict[str, Any] | None]) -> RecordTable:
    """Objects as rows: an object inside one is flattened as ``a.b``, a list of points becomes lists.

    ``None`` in the place of an object is a row without cells.
    """
    table = RecordTable()
    for at, row in enumerate(rows):
        cells, deep = flatten(row or {})
        table.deep_fields += [(at, name, value) for name, value in deep.items()]
        table.add(cells)
    _spread(table.finish(), [at for at, row in enumerate(rows) if row is not None])
    return table


def _spread(table: RecordTable, rows: Sequence[int]) -> None:
    """Replace a column of points, as ``pos`` in ``{"t": 0, "pos": [3, 4]}``, by one column per number.

    ``rows``: those that have cells.
    """
    widths: dict[str, int] = {}
    for name, column in table.columns.items():
        cells = [column[row] for row in rows]
        if set(map(type, cells)) == {list} and len(set(map(len, cells))) == 1:
            widths[name] = len(cells[0])
    several = Counter(widths.values())
    for name, width in widths.items():
        if width in POINT and several[width] < TRACKS:
            nothing = [None] * width
            points = (cell or nothing for cell in table.columns.pop(name))
            for at, numbers in enumerate(zip(*points, strict=True)):
                table.columns[f"{name}.{at}"] = list(numbers)


def scalars(row: dict[str, Any]) -> dict[str, Any]:
    """The scalar fields of an object."""
    return {name: value for name, value in row.items() if type(value) in SCALARS}


def flatten(row: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """The cells of an object by name, and the fields that are too deep for a cell."""
    cells: dict[str, Any] = {}
    deep: dict[str, Any] = {}
    for name, value in row.items():
        if type(value) in SCALARS:
            cells[name] = value
        else:
            _put(cells, deep, name, value, 1)
    return cells, deep


def _put(cells: dict[str, Any], deep: dict[str, Any], name: str, value: Any, depth: int) -> None:
    """Add one field to the cells, or to the fields that are too deep."""
    check_depth(depth)
    if isinstance(value, dict):
        for key, inner in value.items():
            _put(cells, deep, f"{name}.{key}", inner, depth + 1)
    elif not isinstance(value, list):
        cells[name] = value
    elif set(map(type, value)) <= SCALARS:
        cells[name] = list_cell(value)
    else:
        points = _points(value)
        if points is None:
            deep[name] = value
        else:
            cells |= {f"{name}.{key}": list_cell(column) for key, column in points.columns.items()}


def check_depth(depth: int) -> None:
    """Raise RecordingError beyond the greatest depth."""
    if depth > MOST_DEPTH:
        raise RecordingError(f"values are nested deeper than {MOST_DEPTH} levels")


def list_cell(values: Sequence[Any]) -> Any:
    """A list as a cell: numbers if all its items are numbers or empty, else its JSON text."""
    if set(map(type, values)) <= NUMBERS:
        return list(values)
    try:
        return [None if value in (None, "") else float(value) for value in values]
    except (TypeError, ValueError):
        return json.dumps(list(values))


def _points(values: list[Any]) -> RecordTable | None:
    """A list of points, objects or arrays, as columns; ``None`` if an item is not a point."""
    table = table_of(values)
    if table is None or table.deep_fields:
        return None
    nested = any(type(cell) is list for cell in chain.from_iterable(table.columns.values()))
    return None if nested else table


def by_position(rows: list[list[Any]], names: Sequence[str] = ()) -> RecordTable | None:
    """Arrays as rows, their columns named by position from 0 on, or by a first array of text.

    At most 16 arrays that are longer than that are columns. ``None`` if an array contains more than scalars.
    """
    if not all(set(map(type, row)) <= SCALARS for row in rows):
        return None
    if not names and rows[0] and set(map(type, rows[0])) == {str}:
        names, rows = rows[0], rows[1:]
    width = max(map(len, rows), default=0)
    if len(rows) <= FEW < width and not names:
        alike = len(set(map(len, rows))) == 1
        return RecordTable({str(at): row for at, row in enumerate(rows)}) if alike else None
    table = RecordTable()
    titles = distinct_names([*names, *map(str, range(len(names), width))])
    for row in rows:
        table.add(dict(zip(titles, row, strict=False)))
    return table.finish()


def _of_split(value: dict[str, Any]) -> RecordTable | None:
    """``{"columns": [...], "data": [[...], ...]}``, as pandas writes it."""
    names, data = value.get("columns"), value.get("data")
    if not isinstance(names, list) or not isinstance(data, list) or not data:
        return None
    words = set(map(type, names)) == {str}
    return by_position(data, names) if words and set(map(type, data)) == {list} else None


def _of_lists(value: dict[str, Any]) -> RecordTable | None:
    """An object of lists of one length as columns, its scalars repeated; other lists are ignored."""
    lists = {name: cells for name, cells in value.items() if type(cells) is list and len(cells) > 1}
    columns = {name: cells for name, cells in lists.items() if _are_cells(cells)}
    if len(columns) < 2:
        return None
    rows, count = Counter(map(len, columns.values())).most_common(1)[0]
    if count < 2:
        return None
    table = RecordTable({name: inner for name, inner in columns.items() if len(inner) == rows})
    _spread(table, range(rows))
    cells, deep = flatten({name: inner for name, inner in value.items() if name not in columns})
    deep |= {name: inner for name, inner in columns.items() if len(inner) != rows}
    table.deep_fields = [(0, name, inner) for name, inner in deep.items()]
    answer = RecordTable()
    answer.append(table, scalars(cells))
    return answer


def _are_cells(values: list[Any]) -> bool:
    """Whether every item is a scalar, or every item a list of numbers."""
    kinds = set(map(type, values))
    if kinds <= SCALARS:
        return True
    return kinds <= {list, NoneType} and all(
        cell is None or set(map(type, cell)) <= NUMBERS for cell in values
    )


def _of_indexed(value: dict[str, Any]) -> RecordTable | None:
    """``{"x": {"0": 1, "1": 2}, "y": {...}}``, as pandas writes a table by default."""
    columns = list(value.values())
    if len(columns) < 2 or not all(type(column) is dict and column for column in columns):
        return None
    index = columns[0].keys()
    if not all(key.isdecimal() for key in index) or any(column.keys() != index for column in columns):
        return None
    if not all(type(cell) in SCALARS for column in columns for cell in column.values()):
        return None
    return RecordTable({name: list(column.values()) for name, column in value.items()})


Tables = dict[str, RecordTable]


class Branch(msgspec.Struct, frozen=True):
    """A value, the path that leads to it, and the scalars along that path as cells by name."""

    value: Any
    path: tuple[str, ...] = ()
    beside: dict[str, Any] = {}

    @property
    def label(self) -> str:
        """The path as text."""
        return ".".join(self.path)

    def child(self, name: str, value: Any) -> Branch:
        """The branch of a name or number."""
        return Branch(value, (*self.path, name), self._around())

    def item(self, key: str | int, value: Any) -> Branch:
        """The branch of one item of a list or object, with its key in a column named after the list.

        The column is ``trial`` if the item is a list of records itself, or if the list has no name.
        """
        names = [name for name in self.path if name != EACH]
        title = "trial" if isinstance(value, list) or not names else names[-1].removesuffix("s") or "trial"
        around = self._around()
        name = f"{around[title]}.{key}" if title in around else key
        return Branch(value, (*self.path, EACH), around | {title: name})

    def each(self) -> Iterator[Branch]:
        """Every list or object in a list or an object."""
        items = self.value.items() if isinstance(self.value, dict) else enumerate(self.value)
        for key, value in items:
            if isinstance(value, (list, dict)):
                yield self.item(key, value)

    def _around(self) -> dict[str, Any]:
        return self.beside | (scalars(self.value) if isinstance(self.value, dict) else {})


def survey(document: Any) -> Tables:
    """Every table in a document by its path; several of one path are one table.

    Raises RecordingError where values are nested too deeply.
    """
    tables: Tables = {}
    _collect(Branch(document), tables)
    return {label: table for label, table in tables.items() if table.own >= LEAST_COLUMNS}


def _table(branch: Branch) -> RecordTable | None:
    """A branch as a table; one of several objects is a table of one row."""
    table = table_of(branch.value)
    if table is None and isinstance(branch.value, dict) and EACH in branch.path[-1:]:
        return records([branch.value])
    return table


def _collect(branch: Branch, tables: Tables) -> None:
    check_depth(len(branch.path))
    value = branch.value
    table = _table(branch)
    if table is not None:
        tables.setdefault(branch.label, RecordTable()).append(table, branch.beside)
        for row, name, inner in table.deep_fields:
            within = branch.item(row, value[row]) if isinstance(value, list) else branch
            _collect(within.child(name, inner), tables)
    elif isinstance(value, list) or (isinstance(value, dict) and _are_alike(value)):
        for item in branch.each():
            _collect(item, tables)
    elif isinstance(value, dict):
        for name, below in value.items():
            _collect(branch.child(name, below), tables)


def _are_alike(value: dict[str, Any]) -> bool:
    """Whether an object maps numbers or identifiers to similar records, instead of having fields."""
    numbered = all(any(letter.isdigit() for letter in name) for name in value)
    if len(value) < 2 or not (numbered or len(value) > MOST_FIELDS):
        return False
    return bool(set.intersection(*map(_fields, value.values())))


def _fields(value: Any) -> set[str]:
    """The names of the fields of an object, or of the first record of a list."""
    first = value[0] if isinstance(value, list) and value else value
    if isinstance(first, dict):
        return set(first)
    return {str(at) for at in range(len(first))} if isinstance(first, list) else set()


def open_cells(columns: dict[str, Any]) -> tuple[dict[str, Any], list[str]]:
    """The columns, with tracks replaced by one column per field, as ``track.t``; notes on damaged cells."""
    opened: dict[str, Any] = {}
    notes: list[str] = []
    for name, column in columns.items():
        first = next((cell for cell in map(_text, column[:PROBE]) if cell), "")
        if not TRACK.match(first):
            opened[name] = column
            continue
        cells = [_text(cell) for cell in column]
        values = [_value(cell) for cell in cells]
        damaged = [row for row, cell in enumerate(cells) if cell and values[row] is None]
        if len(damaged) == sum(map(bool, cells)):
            opened[name] = column
            continue
        if damaged:
            notes.append(
                f"cells of {name} that are no JSON: {len(damaged)}, the first in data row {damaged[0]}"
            )
        opened |= records([{} if value is None else {name: value} for value in values]).columns
    return opened, notes


def _text(cell: Any) -> str:
    """A cell, or an Arrow scalar, as text; empty if it is not text."""
    value = cell.as_py() if hasattr(cell, "as_py") else cell
    return value.strip() if isinstance(value, str) else ""


def _value(cell: str) -> Any:
    """What JSON or, as pandas prints lists in a table, Python text says; ``None`` where it is neither."""
    for parse in (json.loads, ast.literal_eval):
        with suppress(ValueError, SyntaxError, RecursionError, MemoryError):
            return parse(cell)
    return None
