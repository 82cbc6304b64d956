"""The mapping of a table's columns to our fields: from ``Reading``, else by the usual names."""

from __future__ import annotations

import difflib
import shlex
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from pointpred.errors import ColumnsError
from pointpred.recordings.columns.clocks import (
    counts_frames,
    is_clock,
    is_numbers,
    units_of,
)
from pointpred.recordings.columns.list_cells import flat, holds_pairs
from pointpred.recordings.columns.names import (
    Guess,
    guess,
    similar_names,
    words_of,
)
from pointpred.recordings.reading import FIELDS, KEYS, NEEDED, Reading

JOIN = "+"
"""Separator of columns that together name a user or a trial, or are added up."""
UNITS = ("s", "ms", "us", "ns", "iso")
Cells = Callable[[str], Any]
"""The column of a name as an Arrow array."""
MOST_NAMES = 40
"""Most columns listed in a message."""


def mapping(
    path: Path,
    names: Sequence[str],
    reading: Reading,
    same: Callable[[Sequence[str]], bool],
    cells: Cells,
) -> tuple[dict[str, str], list[str]]:
    """Field -> column, and notes on possible columns that are ignored; raises ColumnsError.

    Fields not in ``reading`` are mapped by usual names. Of several columns for user or trial that are the
    ``same`` (group the rows equally), the first is used.
    """
    explicit = {
        field: _find_column(path, names, field, column) for field, column in (reading.columns or {}).items()
    }
    repeated = {name for name in explicit.values() if list(explicit.values()).count(name) > 1}
    if repeated:
        name = min(repeated)
        reason = f"the column {name!r} is named twice"
        raise ColumnsError(f"{path}: {reason}; name a column once", names, explicit, reason=reason)
    usual = _guess([name for name in names if name not in explicit.values()], names)
    mapped = usual.columns | explicit
    choices = {field: some for field, some in usual.choices.items() if field not in explicit}
    for field in KEYS:
        if field in choices and same(choices[field]):
            mapped[field] = choices.pop(field)[0]
    best = {field: name for field, name in usual.best.items() if field not in explicit} | explicit
    missing = [field for field in NEEDED if field not in mapped and field not in choices]
    if missing:
        raise _refusal(path, names, f"no column for {', '.join(missing)}", best, reading, cells)
    unclear = [
        f"{field} may be {' or '.join(choices[field])}" for field in (*NEEDED, *KEYS) if field in choices
    ]
    if unclear:
        raise _refusal(path, names, "; ".join(unclear), best, reading, cells)
    notes = [
        f"{field} is not read: {' or '.join(some)} may be meant; name one with --columns {field}=..."
        for field, some in choices.items()
    ]
    return {field: mapped[field] for field in FIELDS if field in mapped}, notes


def parts_of(path: Path, names: Sequence[str], reading: Reading) -> dict[str, list[str]]:
    """The columns that ``reading`` joins or adds up, by text such as ``block+trial``.

    A column with that very name is not a join. Raises ColumnsError for a part that is not a column.
    """
    explicit = {str(column): field for field, column in (reading.columns or {}).items()}
    return {
        name: [_find_column(path, names, field, part.strip()) for part in name.split(JOIN)]
        for name, field in explicit.items()
        if JOIN in name and name not in names
    }


def unit_refusal(
    path: Path,
    names: Sequence[str],
    columns: Mapping[str, str],
    units: Sequence[str],
    reading: Reading,
    frames: bool,
) -> ColumnsError:
    """The error for a table whose clock fits several ``units``, or none."""
    why = f"may be {' or '.join(units)}" if units else "is not known"
    explicit = columns if reading.columns else {}
    question = "; do its numbers count frames, not time?" if frames else ""
    reason = f"the unit of time (column {columns['t']!r}) {why}{question}"
    return ColumnsError(
        f"{path}: {reason}; say it: {_command(path, explicit, units)}", names, columns, reason=reason
    )


def command_for(path: Path, columns: Mapping[str, str], time_unit: str | None = None) -> str:
    """The command that reads a file by this mapping.

    >>> command_for(Path("a.csv"), {"t": "time", "x": "px", "y": "py"}, "ms")
    'pointpred score a.csv --columns t=time,x=px,y=py --time-unit ms'
    """
    pairs = ",".join(f"{field}={columns[field]}" for field in FIELDS if field in columns)
    parts = ["pointpred", "score", str(path)]
    parts += ["--columns", pairs] if pairs else []
    parts += ["--time-unit", time_unit] if time_unit else []
    return shlex.join(parts)


def _command(path: Path, columns: Mapping[str, str], units: Sequence[str]) -> str:
    """The command with the unit of time if it is certain, else with a placeholder."""
    if len(units) == 1:
        return command_for(path, columns, units[0])
    return f"{command_for(path, columns, 'UNIT')} (UNIT: {' or '.join(units or UNITS)})"


def _find_column(path: Path, names: Sequence[str], field: str, column: str | int) -> str:
    """The column by its name, by its name in other letter case, or by its place from 0."""
    wanted = str(column)
    if wanted in names:
        return wanted
    alike = [name for name in names if words_of(name) and words_of(name) == words_of(wanted)]
    if len(alike) == 1:
        return alike[0]
    if wanted.isdecimal() and int(wanted) < len(names):
        return names[int(wanted)]
    close = difflib.get_close_matches(wanted.lower(), [name.lower() for name in names], 1)
    nearest = [name for name in names if close and name.lower() == close[0]]
    hint = f"; did you mean {field}={nearest[0]}?" if nearest else ""
    reason = f"no column {wanted!r} for {field}"
    raise ColumnsError(f"{path}: {reason}; it {_has(names)}{hint}", names, reason=reason)


def _refusal(
    path: Path, names: Sequence[str], why: str, best: Mapping[str, str], reading: Reading, cells: Cells
) -> ColumnsError:
    free = [name for name in names if name not in best.values()]
    likely = {field: name for field, name in similar_names(free).items() if field not in best} | dict(best)
    pairs = [name for name in free if holds_pairs(cells(name))]
    if len(pairs) == 1 and not {"x", "y"} & likely.keys():
        likely |= {"x": f"{pairs[0]}.0", "y": f"{pairs[0]}.1"}
    if not likely and list(names[:3]) == ["0", "1", "2"]:  # no header
        likely = _by_place(names, cells)
    missing = {field: "COLUMN" for field in NEEDED if field not in likely}
    explicit = reading.time_unit
    fitting = (
        _possible_units(likely["t"], cells, explicit) if "t" in likely else [explicit] if explicit else None
    )
    unit = fitting[0] if fitting and len(fitting) == 1 else None
    known = likely | missing
    command = command_for(path, known) if fitting is None else _command(path, known, fitting)
    return ColumnsError(f"{path}: {why}; it {_has(names)}; try: {command}", names, likely, unit, why)


def _possible_units(name: str, cells: Cells, explicit: str | None) -> Sequence[str] | None:
    """The possible units of a column of times, empty if unknown, ``None`` for text."""
    column = flat(cells(name))
    units = units_of(name, column, explicit)[0]
    return units if units or is_numbers(column) else None


def _by_place(names: Sequence[str], cells: Cells) -> dict[str, str]:
    """A guess for a table without a header: the only column that is a clock, and the two after it."""
    columns = {name: flat(cells(name)) for name in names}
    clocks = [name for name, column in columns.items() if is_clock(column) and not counts_frames(column)]
    if len(clocks) != 1:
        return {}
    at = names.index(clocks[0])
    free = [name for name in names if name != clocks[0]]
    beside = free if len(free) == 2 else names[at + 1 : at + 3]
    likely = dict(zip(NEEDED, (clocks[0], *beside), strict=False))
    return (
        likely if len(likely) == 3 and all(is_numbers(columns[name]) for name in beside) else {"t": clocks[0]}
    )


def _guess(free: Sequence[str], names: Sequence[str]) -> Guess:
    """The usual names among ``free``; columns of the same name, numbered by place, are choices."""
    plain = {name: name.removesuffix(f".{place}") for place, name in enumerate(names)}
    often = Counter(plain[name] for name in free)
    several: dict[str, list[str]] = {}
    for name in free:
        several.setdefault(plain[name] if often[plain[name]] > 1 else name, []).append(name)
    usual = guess(list(several))
    every = {
        field: tuple(title for name in some for title in several[name])
        for field, some in (usual.choices | {field: (name,) for field, name in usual.columns.items()}).items()
    }
    return Guess(
        {field: some[0] for field, some in every.items() if len(some) == 1},
        {field: some for field, some in every.items() if len(some) > 1},
    )


def _has(names: Sequence[str]) -> str:
    shown = ", ".join(names[:MOST_NAMES]) + (", ..." if len(names) > MOST_NAMES else "")
    return f"has the columns {shown}"
