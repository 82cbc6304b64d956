"""The unit of a clock, from its column's name, or from the size and steps of its numbers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pointpred.recordings import arrow_tables
from pointpred.recordings.columns.clocks import PER_SECOND, clock, is_stamps
from pointpred.recordings.columns.list_rows import holds_lists, steps_of
from pointpred.recordings.columns.names import has_other_unit, unit_in
from pointpred.records import FloatArray

SHORTEST_S, LONGEST_S = 1e-4, 1.5
"""Bounds on the median interval between samples: a fast mouse, and a slow protocol."""
NEVER_S = 10.0
"""An interval longer than the median of any pointer recording, s."""
FIRST_S, LAST_S = 1e9, 4e9
"""The years 2001 to 2096 in seconds since 1970."""
HEAD = 1000
"""Rows that determine the size of a clock."""


def units_of(name: str, column: Any, time_unit: str | None) -> tuple[list[str], str]:
    """The units that a column of times may have, only one if it is certain, and the text for notes."""
    if is_stamps(column, time_unit):
        return ["iso"], " as date and time"
    named = time_unit or unit_in(name)
    if named is not None:
        return [named], f" in {named}"
    if has_other_unit(name):
        return [], ""
    if holds_lists(column):
        times = steps_of(column)
        return likely_units(times, times)
    return likely_units(clock(column)[0], arrow_tables.finite_numbers(column.slice(0, HEAD))[0])


def likely_units(times: FloatArray, numbers: FloatArray) -> tuple[list[str], str]:
    """The units that fit the steps of ``times`` and the size of ``numbers``, the first of them unshifted.

    The size of a time since 1970 determines its unit if that fits its steps; else both are possible. With
    steps longer than any device's it is not such a time: the ms since a computer started may be as large.

    >>> likely_units(np.arange(9) * 0.25, np.arange(9) * 0.25)[0]
    ['s', 'ms']
    >>> epoch = 1.7e9 + np.arange(9.0)
    >>> likely_units(epoch, epoch)
    (['s'], ' in s (by its size: a time since 1970)')
    """
    units, size = units_by_rate(times), unit_by_size(numbers)
    if units and size and middle_step(times) > NEVER_S * PER_SECOND[size]:
        size = None
    if size is not None and (size in units or not units):
        return [size], f" in {size} (by its size: a time since 1970)"
    units = units if size is None else [size, *units]
    return units, f" in {' or '.join(units)} (by its rate)"


def units_by_rate(times: FloatArray) -> list[str]:
    """The units under which the median step forwards lies between 0.1 ms and 1.5 s.

    >>> units_by_rate(np.arange(9) * 16.67), units_by_rate(np.arange(9) * 150.0)
    (['ms'], ['ms', 'us'])
    """
    middle = middle_step(times)
    return [unit for unit in _UNITS if SHORTEST_S <= middle / PER_SECOND[unit] <= LONGEST_S]


def unit_by_size(numbers: FloatArray) -> str | None:
    """The unit under which times since 1970 lie between 2001 and 2096."""
    finite = numbers[np.isfinite(numbers)]
    middle = float(np.median(finite)) if len(finite) else 0.0
    return next((unit for unit in _UNITS if FIRST_S <= middle / PER_SECOND[unit] < LAST_S), None)


def counts_frames(column: Any) -> bool:
    """Whether a column of times increases by whole ones only, like a frame or row number."""
    steps = forwards(steps_of(column) if holds_lists(column) else clock(column)[0])
    return bool(len(steps)) and bool(np.all(steps == 1))


def is_clock(column: Any) -> bool:
    """Whether the first cells of a column are times that never decrease and mostly increase."""
    head = column.slice(0, HEAD)
    if holds_lists(head):
        return False
    times = clock(head, is_stamps(head, None))[0]
    steps = np.diff(times[np.isfinite(times)])
    return bool(np.all(steps >= 0)) and 2 * int(np.count_nonzero(steps)) > max(len(steps), len(head) // 2)


def is_numbers(column: Any) -> bool:
    """Whether most of the first cells of a column are numbers, not lists."""
    head = column.slice(0, HEAD)
    return not holds_lists(head) and 2 * int(np.isfinite(arrow_tables.finite_numbers(head)[0]).sum()) > len(
        head
    )


def middle_step(times: FloatArray) -> float:
    """The median forward step of a clock, 0 if there is none."""
    steps = forwards(times)
    return float(np.median(steps)) if len(steps) else 0.0


def forwards(times: FloatArray) -> FloatArray:
    """The forward steps of a clock."""
    steps: FloatArray = np.diff(times[np.isfinite(times)])
    return steps[steps > 0]


_UNITS: Sequence[str] = [unit for unit in PER_SECOND if unit != "iso"]
