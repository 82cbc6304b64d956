"""The conditions of trials: columns that have one value in all rows of a trial."""

from __future__ import annotations

from typing import Any

import numpy as np
import pyarrow as pa

from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import IntArray
from pointpred.recordings.trials import codes_of
from pointpred.records import FloatArray

TARGET = ("target_x", "target_y", "target_w")
TRIAL_COLUMNS = ("dataset", "user", "trial", *TARGET, "n_samples", "clean")
"""The columns of our own tables of trials; every other column is a condition."""
PROBE = 1000
"""Rows compared first: most varying columns differ within them."""
MOST = 64
"""Most columns that become conditions; the others are skipped."""


def one_value(values: FloatArray, group: IntArray, count: int) -> FloatArray:
    """The value of each trial, NaN if its rows differ or one is empty.

    >>> one_value(np.array([1.0, 1.0, 2.0, 3.0]), np.array([0, 0, 1, 1]), 2)
    array([ 1., nan])
    """
    last = np.full(count, np.nan)
    last[group] = values
    differs = np.zeros(count, dtype=bool)
    differs[group[values != last[group]]] = True
    return np.where(differs, np.nan, last)


def conditions_of(
    columns: dict[str, tuple[Any, IntArray]], group: IntArray, count: int
) -> tuple[list[dict[str, str | float]], list[str]]:
    """The conditions of each trial, and the columns that are not, because they vary within a trial.

    ``columns``: the cells and the rows of them that belong to ``group``. Numbers stay numbers if every cell
    is one; an empty cell is not a condition.
    """
    conditions: list[dict[str, str | float]] = [{} for _ in range(count)]
    varying = list(columns)[MOST:]
    for name, (column, rows) in list(columns.items())[:MOST]:
        if pa.types.is_nested(column.type):
            varying.append(name)
            continue
        of_trial, cells = _codes(column.take(pa.array(rows[:PROBE])), group[:PROBE], count)
        if not np.isnan(of_trial[np.unique(group[:PROBE])]).any():
            of_trial, cells = _codes(column.take(pa.array(rows)), group, count)
        if np.isnan(of_trial).any():
            varying.append(name)
            continue
        numbers, faults = arrow_tables.finite_numbers(pa.chunked_array([pa.array(cells, pa.string())]))
        for index, code in enumerate(of_trial.astype(np.int64).tolist()):
            if cells[code].strip():
                conditions[index][condition_name(name)] = cells[code] if faults else float(numbers[code])
    return conditions, varying


def _codes(column: Any, group: IntArray, count: int) -> tuple[FloatArray, list[str]]:
    """The index of each trial's only distinct cell, NaN if it has several; and the distinct cells."""
    codes, cells = codes_of(arrow_tables.words(column).fill_null(""))
    return one_value(codes.astype(np.float64), group, count), cells


def condition_name(column: str) -> str:
    """A column's name as a condition, valid in our own files.

    >>> condition_name("trial"), condition_name("size, px")
    ('trial_column', 'size px')
    """
    name = " ".join(column.replace(",", " ").replace('"', " ").split())
    return f"{name}_column" if name in ("", *TRIAL_COLUMNS) else name
