"""Find the records in nested values: at a named path, or at the only one that fits."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec

from pointpred.errors import RecordingError
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.nested_records import (
    MOST_DEPTH,
    RecordTable,
    check_depth,
    records,
    scalars,
    table_of,
)

EACH = "*"
LEAST_COLUMNS = 3
"""A table of fewer columns cannot hold times and positions."""
CLEAR = 2
"""The largest list of records is chosen if it has at least so many times the samples of the next."""
MOST_FIELDS = 16
"""An object with more fields than this, all similar records, holds one record per name."""
MOST_SHOWN = 8

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


def table_at(path: Path, document: Any, wanted: str | None, title: str) -> ColumnTable:
    """The records at ``wanted`` in a document of the format ``title``, else the only ones that fit.

    ``wanted`` is names, and numbers from 0, joined by dots; ``*`` stands for each value of a list or an
    object. Scalars beside the path become columns of equal cells. Notes name what was read and what was left
    out.
    Raises RecordingError, which names the paths that hold records.
    """
    try:
        return _table_at(document, wanted, title)
    except RecordingError as error:
        raise RecordingError(f"{path}: {error}") from error


def _table_at(document: Any, wanted: str | None, title: str) -> ColumnTable:
    root = Branch(document)
    branches = [root] if wanted is None else list(_follow(root, wanted.split(".")))
    if not branches:
        raise RecordingError(f"nothing lies at {wanted!r}; {_explain(_survey([root]))}")
    others: Tables = {}
    label, table = wanted or "", _join(branches) if wanted else None
    if table is None:
        label, others = _choose(_survey(branches))
        table = others.pop(label)
    notes = [f"records: {_rows(table)} {f'at {label}' if label else 'of the whole file'}"]
    if others:
        notes.append(f"other lists of records left aside: {_list_paths(others)}")
    if table.deep_fields:
        names = list(dict.fromkeys(field.name for field in table.deep_fields))
        notes.append(f"fields too deep for a cell left aside: {', '.join(names[:MOST_SHOWN])}")
    return ColumnTable(dict(table.columns), title, tuple(notes))


def _follow(branch: Branch, names: list[str]) -> Iterator[Branch]:
    """Every branch at a path; names may contain dots."""
    value = branch.value
    check_depth(len(branch.path))
    if not names:
        yield branch
    elif names[0] == EACH and isinstance(value, (list, dict)):
        for item in branch.each():
            yield from _follow(item, names[1:])
    elif isinstance(value, dict):
        for count in range(min(len(names), MOST_DEPTH), 0, -1):
            name = ".".join(names[:count])
            if name in value:
                yield from _follow(branch.child(name, value[name]), names[count:])
                return
    elif isinstance(value, list):
        at = int(names[0]) if names[0].isdecimal() and len(names[0]) < 10 else len(value)
        if at < len(value):
            yield from _follow(branch.child(names[0], value[at]), names[1:])


def _table(branch: Branch) -> RecordTable | None:
    """A branch as a table; one of several objects is a table of one row."""
    table = table_of(branch.value)
    if table is None and isinstance(branch.value, dict) and EACH in branch.path[-1:]:
        return records([branch.value])
    return table


def _join(branches: list[Branch]) -> RecordTable | None:
    """The branches of one path as one table; ``None`` if none of them is a table."""
    whole = RecordTable()
    for branch in branches:
        table = _table(branch)
        if table is not None:
            whole.append(table, branch.beside)
    return whole if whole.columns else None


def _survey(branches: list[Branch]) -> Tables:
    """Every table in some branches and below them, by its path; several of one path are one table."""
    tables: Tables = {}
    for branch in branches:
        _collect(branch, tables)
    return {label: table for label, table in tables.items() if table.own >= LEAST_COLUMNS}


def _collect(branch: Branch, tables: Tables) -> None:
    check_depth(len(branch.path))
    value = branch.value
    table = _table(branch)
    if table is not None:
        tables.setdefault(branch.label, RecordTable()).append(table, branch.beside)
        for field in table.deep_fields:
            row = branch.item(field.row, field.whole) if isinstance(value, list) else branch
            _collect(row.child(field.name, field.value), tables)
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


def _choose(tables: Tables) -> tuple[str, Tables]:
    """The path of the only or by far the largest table, and all tables."""
    if not tables:
        raise RecordingError(_explain(tables))
    sizes = sorted(((table.samples, label) for label, table in tables.items()), reverse=True)
    if len(sizes) > 1 and sizes[0][0] < CLEAR * sizes[1][0]:
        raise RecordingError(_explain(tables))
    return sizes[0][1], dict(tables)


def _explain(tables: Tables) -> str:
    """The error message: the paths of records, and the option that selects one."""
    if not tables:
        return (
            f"no list of records with at least {LEAST_COLUMNS} fields, expected one with times and positions"
        )
    first = next(iter(tables))
    return f"records lie at {_list_paths(tables)}; choose one, as in: --records {first or EACH}"


def _list_paths(tables: Tables) -> str:
    """Paths with the number of their rows and their columns."""
    shown = [
        f"{label or 'the top'} ({_rows(table)}: {', '.join(list(table.columns)[:MOST_SHOWN])})"
        for label, table in list(tables.items())[:MOST_SHOWN]
    ]
    return "; ".join(shown) + (f"; and {len(tables) - MOST_SHOWN} more" if len(tables) > MOST_SHOWN else "")


def _rows(table: RecordTable) -> str:
    return f"{table.rows} row{'s' * (table.rows != 1)}"
