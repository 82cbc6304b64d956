"""Columns made of others: tracks and pairs in cells, sums, and a column for each sample of a trial."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.errors import RecordingError
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable, as_arrow, join_columns
from pointpred.recordings.columns.clocks import whole_numbers
from pointpred.recordings.columns.list_cells import items_of
from pointpred.recordings.columns.mapping import parts_of
from pointpred.recordings.columns.names import guess
from pointpred.recordings.nested_records import open_cells
from pointpred.recordings.reading import KEYS, NEEDED, Reading
from pointpred.records import BoolTable

NUMBERED = re.compile(r"(.*?\D)[\s_.-]?(\d{1,9})")
"""The name of a column for one sample: of what, and which."""
LEAST_SAMPLES, LEAST_SERIES = 4, len(NEEDED)


def expand(path: Path, table: ColumnTable, reading: Reading) -> ColumnTable:
    """The table with every column that ``reading`` names or a usual layout has; raises RecordingError."""
    columns, damage = open_cells(table.columns)
    sizes = {len(column) for column in columns.values()}
    if len(sizes) > 1:
        raise RecordingError(
            f"{path}: columns of {min(sizes)} to {max(sizes)} rows, expected as many of each"
        )
    explicit = {field: str(column) for field, column in (reading.columns or {}).items()}
    columns = _of_pairs(columns, [part for text in explicit.values() for part in (text, *text.split("+"))])
    for name, parts in parts_of(path, list(columns), reading).items():
        some = [as_arrow(columns[part]) for part in parts]
        columns[name] = (join_columns if name in (explicit.get(key) for key in KEYS) else _sum)(some)
    named = [explicit.get(field, "") for field in NEEDED]
    if not all(name in columns or name.isdecimal() for name in named):
        columns = _of_samples(columns)
    return msgspec.structs.replace(table, columns=columns, notes=(*table.notes, *damage))


def _of_pairs(columns: dict[str, Any], wanted: Sequence[str]) -> dict[str, Any]:
    """The columns, those ``wanted`` of a list in a cell, as ``pos.0``, in place of the column ``pos``."""
    opened: dict[str, Any] = {}
    for name in wanted:
        whole, _, place = name.rpartition(".")
        if name not in columns and whole in columns and place.isdecimal():
            cells = map(items_of, as_arrow(columns[whole]).to_pylist())
            items = (items[int(place)] if int(place) < len(items) else None for items in cells)
            opened[name] = pa.chunked_array(
                [pa.array([None if item is None else str(item) for item in items], pa.string())]
            )
    rest = {name: column for name, column in columns.items() if f"{name}.0" not in opened}
    return rest | opened


def _sum(columns: Sequence[Any]) -> Any:
    """The sum of columns, whole numbers exactly; null where a cell of one is no number."""
    whole = [whole_numbers(column) for column in columns]
    if any(column is None for column in whole):
        whole = [pa.array(arrow_tables.numbers(column)[0]) for column in columns]
    total = whole[0]
    for column in whole[1:]:
        total = pc.add(total, column)
    return as_arrow(total)


def _of_samples(columns: dict[str, Any]) -> dict[str, Any]:
    """The columns with ``x1`` to ``xn`` and the like joined to one of lists, a row a trial.

    That is, where three series or more have the same numbers, one after another, and no other columns are
    named as times and positions are. Empty samples at the end of a row are left out.
    """
    if set(NEEDED) <= guess(list(columns)).columns.keys():
        return columns
    series: dict[str, dict[int, str]] = {}
    for name in columns:
        if match := NUMBERED.fullmatch(name):
            series.setdefault(match[1].rstrip(" _.-"), {})[int(match[2])] = name
    places = {title: tuple(sorted(some)) for title, some in series.items() if title not in columns}
    often = [places_of for places_of in places.values() if _is_run(places_of)]
    alike = [title for title, some in places.items() if often.count(some) >= LEAST_SERIES]
    if not alike:
        return columns
    cells = {
        title: [arrow_tables.words(as_arrow(columns[series[title][at]])).to_pylist() for at in places[title]]
        for title in alike
    }
    joined: dict[str, Any] = {}
    for some in {places[title] for title in alike}:
        group = [title for title in alike if places[title] == some]
        filled = [[[bool(cell and cell.strip()) for cell in one] for one in cells[title]] for title in group]
        samples: BoolTable = np.logical_or.reduce(np.array(filled)).T
        ends = [int(np.flatnonzero(row).max(initial=-1)) + 1 for row in samples]
        for title in group:
            rows = zip(*cells[title], strict=True)
            joined[title] = [list(row[:end]) for row, end in zip(rows, ends, strict=True)]
    used = {name for title in alike for name in series[title].values()}
    return {name: column for name, column in columns.items() if name not in used} | joined


def _is_run(places: tuple[int, ...]) -> bool:
    """Whether numbers follow one another, and are enough for a movement."""
    return len(places) >= LEAST_SAMPLES and places[-1] - places[0] == len(places) - 1
