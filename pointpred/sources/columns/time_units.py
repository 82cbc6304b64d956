"""A column of times as numbers in its unit, dates and times too, without losing digits of large times."""

from __future__ import annotations

from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.recordings import arrow_tables
from pointpred.records import FloatArray

PER_SECOND = {"s": 1.0, "ms": 1e3, "us": 1e6, "ns": 1e9, "iso": 1e9}
"""Units of the clock in a second; dates and times are read as ns."""
ISO = r"^\s*\d{4}-\d{2}-\d{2}[T ]\d{2}:\d{2}(:\d{2}([.,]\d{1,9})?)?(Z|[+-]\d{2}:?\d{2})?\s*$"
ZONE = r"(Z|[+-]\d{2}:?\d{2})\s*$"
WHOLE = r"^\s*[+-]?(\d{1,18}|[1-8]\d{18})\s*$"
LONG = 1e6
"""Larger times are read digit by digit, because a float would round them."""
DECIMAL = pa.decimal128(36, 12)


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
    whole = _whole(column)
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


def _whole(column: Any) -> Any:
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
