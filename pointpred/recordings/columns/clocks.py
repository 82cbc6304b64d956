"""A column of times: as numbers without losing digits, its unit, and whether its steps are plausible."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.recordings import arrow_tables
from pointpred.recordings.columns.names import has_other_unit, unit_in
from pointpred.recordings.trials import Codes
from pointpred.records import FloatArray

PER_SECOND = {"s": 1.0, "ms": 1e3, "us": 1e6, "ns": 1e9, "iso": 1e9}
"""Units of the clock in a second; dates and times are read as ns."""
ISO = r"^\s*\d{4}-\d{2}-\d{2}[T ]\d{2}:\d{2}(:\d{2}([.,]\d{1,9})?)?(Z|[+-]\d{2}:?\d{2})?\s*$"
ZONE = r"(Z|[+-]\d{2}:?\d{2})\s*$"
WHOLE = r"^\s*[+-]?(\d{1,18}|[1-8]\d{18})\s*$"
LONG = 1e6
"""Larger times are read digit by digit, because a float would round them."""
DECIMAL = pa.decimal128(36, 12)
SHORTEST_S, LONGEST_S = 1e-4, 1.5
"""Bounds on the median interval between samples: a fast mouse, and a slow protocol."""
NEVER_S = 10.0
"""An interval longer than the median of any pointer recording, s."""
FIRST_S, LAST_S = 1e9, 4e9
"""The years 2001 to 2096 in seconds since 1970."""
HEAD = 1000
"""Rows that determine the size of a clock."""
_UNITS: Sequence[str] = [unit for unit in PER_SECOND if unit != "iso"]
FEW = 3
"""Fewest steps that are checked."""
MOSTLY = 0.5


def is_stamps(column: Any, unit: str | None) -> bool:
    """Whether a column holds dates and times: by its type, else by ``unit``, else by its first cell."""
    if pa.types.is_temporal(column.type):
        return True
    if unit is not None or not arrow_tables.is_words(column):
        return unit == "iso"
    first = next((cell for cell in column.slice(0, 1000).to_pylist() if (cell or "").strip()), "")
    return bool(pc.match_substring_regex(pa.array([first]), ISO)[0].as_py())


def clock(column: Any, iso: bool = False) -> tuple[FloatArray, dict[int, str]]:
    """The times of a column in its unit (ns of stamps), NaN if empty, and the bad cells by row.

    Large times, such as the ns since 1970, are relative to the first cell: differences are exact up to 2^53
    units.
    """
    if iso:
        return _stamps(column)
    whole = whole_numbers(column)
    if whole is not None:
        return _from_first(whole), {}
    numbers, faults = arrow_tables.finite_numbers(column)
    if arrow_tables.is_words(column) and np.nanmax(np.abs(numbers), initial=0.0) > LONG:
        exact = _decimals(column, np.isfinite(numbers))
        numbers = numbers if exact is None else exact
    return numbers, faults


def _from_first(whole: Any) -> FloatArray:
    """Whole numbers as floats, relative to the first if they are large."""
    valid = pc.drop_null(whole)
    if not len(valid):
        return np.full(len(whole), np.nan)
    first = valid[0].as_py()
    if abs(first) > LONG:
        whole = pc.subtract(whole, pa.scalar(first, pa.int64()))
    return arrow_tables.float64(pc.cast(whole, pa.float64(), safe=False))


def whole_numbers(column: Any) -> Any:
    """A column of whole numbers as int64, nulls for empty cells; ``None`` if it contains others."""
    if pa.types.is_integer(column.type):
        return pc.cast(column, pa.int64())
    if not arrow_tables.is_words(column):
        return None
    filled = pc.if_else(pc.equal(pc.utf8_trim_whitespace(column), ""), None, column)
    valid = pc.match_substring_regex(filled, WHOLE)
    if not pc.all(valid, min_count=0).as_py():
        return None
    return pc.cast(pc.replace_substring_regex(filled, r"[\s+]", ""), pa.int64())


def _decimals(column: Any, good: Any) -> FloatArray | None:
    """Text as decimal numbers relative to the first; ``None`` if they have too many digits."""
    words = pc.if_else(pa.array(good), pc.utf8_trim_whitespace(column), None)
    try:
        exact = pc.cast(words, DECIMAL)
        first = pc.drop_null(exact)[0]
        return arrow_tables.float64(pc.cast(pc.subtract(exact, first), pa.float64(), safe=False))
    except MemoryError:  # one of Arrow's, too: not a matter of digits
        raise
    except (pa.ArrowException, IndexError):
        return None


def _stamps(column: Any) -> tuple[FloatArray, dict[int, str]]:
    """Dates and times as ns relative to the first; those without a zone are taken as they are."""
    faults: dict[int, str] = {}
    if not pa.types.is_temporal(column.type):
        words = pc.utf8_trim_whitespace(arrow_tables.words(column))
        good = pc.fill_null(pc.match_substring_regex(words, ISO), False)
        wrong = pc.and_(pc.invert(good), pc.not_equal(pc.fill_null(words, ""), ""))
        faults = {
            int(row): arrow_tables.short(str(words[int(row)].as_py()))
            for row in arrow_tables.as_array(pc.indices_nonzero(wrong))
        }
        zoned = pc.match_substring_regex(words, ZONE)
        words = pc.replace_substring(pc.if_else(good, words, None), ",", ".")
        plain, aware = pc.if_else(zoned, None, words), pc.if_else(zoned, words, None)
        column = pc.coalesce(_in_ns(plain, pa.timestamp("ns")), _in_ns(aware, pa.timestamp("ns", "UTC")))
    else:
        words = column
        column = _in_ns(column, _kind_in_ns(column.type))
    impossible = pc.and_(pc.is_valid(words), pc.is_null(column))
    for row in arrow_tables.as_array(pc.indices_nonzero(impossible)):
        faults.setdefault(int(row), arrow_tables.short(str(words[int(row)].as_py())))
    return _from_first(column), faults


def _in_ns(column: Any, kind: Any) -> Any:
    """A column as int64 of a type in ns, nulls for impossible dates and dates too far from 1970."""
    try:
        return pc.cast(pc.cast(column, kind), pa.int64())
    except pa.ArrowInvalid:
        if len(column) == 1:
            return pa.chunked_array([pa.nulls(1, pa.int64())])
    middle = len(column) // 2
    halves = (_in_ns(column.slice(0, middle), kind), _in_ns(column.slice(middle), kind))
    return pa.chunked_array([chunk for half in halves for chunk in half.chunks])


def _kind_in_ns(kind: Any) -> Any:
    """The type in ns that corresponds to a type of dates and times, times of day or durations."""
    if pa.types.is_time(kind):
        return pa.time64("ns")
    return pa.duration("ns") if pa.types.is_duration(kind) else pa.timestamp("ns", getattr(kind, "tz", None))


def units_of(name: str, column: Any, time_unit: str | None) -> tuple[list[str], str]:
    """The units that a column of times may have, only one if it is certain, and the text for notes."""
    if is_stamps(column, time_unit):
        return ["iso"], " as date and time"
    named = time_unit or unit_in(name)
    if named is not None:
        return [named], f" in {named}"
    if has_other_unit(name):
        return [], ""
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
    steps = forwards(clock(column)[0])
    return bool(len(steps)) and bool(np.all(steps == 1))


def is_clock(column: Any) -> bool:
    """Whether the first cells of a column are times that never decrease and mostly increase."""
    head = column.slice(0, HEAD)
    times = clock(head, is_stamps(head, None))[0]
    steps = np.diff(times[np.isfinite(times)])
    return bool(np.all(steps >= 0)) and 2 * int(np.count_nonzero(steps)) > max(len(steps), len(head) // 2)


def is_numbers(column: Any) -> bool:
    """Whether most of the first cells of a column are numbers."""
    head = column.slice(0, HEAD)
    return 2 * int(np.isfinite(arrow_tables.finite_numbers(head)[0]).sum()) > len(head)


def middle_step(times: FloatArray) -> float:
    """The median forward step of a clock, 0 if there is none."""
    steps = forwards(times)
    return float(np.median(steps)) if len(steps) else 0.0


def forwards(times: FloatArray) -> FloatArray:
    """The forward steps of a clock."""
    steps: FloatArray = np.diff(times[np.isfinite(times)])
    return steps[steps > 0]


def clock_notes(name: str, per_second: float, times: FloatArray, users: Codes | None = None) -> list[str]:
    """Notes on a clock whose median interval, or that of a user, is implausible for a pointer.

    ``name`` of its column; ``per_second``: its units in a second; ``users``: each row's, ``None`` for one.
    """
    question = _odd(times, per_second) if users is None else ""
    if question:
        return [f"the median interval of {name} is {question}"]
    odd = [(user, question) for user, mine in _by_user(times, users) if (question := _odd(mine, per_second))]
    if not odd:
        return []
    rest = f" (and {len(odd) - 1} more users)" if len(odd) > 1 else ""
    return [f"the median interval of {name} for user {odd[0][0]!r}{rest} is {odd[0][1]}"]


def only_whole_seconds(times: FloatArray, per_second: float, users: Codes | None = None) -> bool:
    """Whether a clock is constant in most steps and otherwise advances by whole seconds.

    >>> only_whole_seconds(np.repeat([0.0, 1000.0, 2000.0], 4), 1e3)
    True
    """
    if users is not None:
        times = np.concatenate([times[:0], *(mine for _, mine in _by_user(times, users))])
    steps = np.diff(times[np.isfinite(times)])
    ahead = forwards(times) / per_second
    still = int(np.count_nonzero(steps == 0))
    return bool(len(ahead)) and bool(np.all(ahead % 1 == 0)) and still > max(FEW, MOSTLY * len(steps))


def _odd(times: FloatArray, per_second: float) -> str:
    """A median interval out of bounds, with a question about its unit; empty if it is within."""
    steps = forwards(times)
    middle = float(np.median(steps)) / per_second if len(steps) >= FEW else SHORTEST_S
    if SHORTEST_S <= middle <= LONGEST_S:
        return ""
    fitting = " or ".join(units_by_rate(times))
    return f"{middle:g} s: " + (f"is it in {fitting}?" if fitting else "is it a time?")


def _by_user(times: FloatArray, users: Codes | None) -> Iterator[tuple[str, FloatArray]]:
    """The times of each user."""
    if users is None or not len(times):
        return
    codes, names = users
    order = np.argsort(codes, kind="stable")
    ends = np.searchsorted(codes[order], np.arange(1, len(names)))
    yield from zip(names, np.split(times[order], ends), strict=True)
