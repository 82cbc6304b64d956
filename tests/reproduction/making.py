"""A figure or table made once, and what is asked of each."""

from __future__ import annotations

from functools import cache
from math import isfinite

import numpy as np
import pytest

from evidence.data import stored
from evidence.reproduce.measure import DRAWN, rows_of
from pointpred.reproduction.catalogue import ENTRIES
from pointpred.reproduction.figure import Entry, Reproduction


@cache
def made(number: str) -> Reproduction:
    make = ENTRIES[number].make
    assert make is not None
    return make(None)


def check(entry: Entry, different: set[str]) -> None:
    """It is made and drawn, and exactly these values differ from the print."""
    one = made(entry.number)
    assert all(isfinite(value.ours) for value in one.values)
    assert {value.name for value in one.values if value.agrees is False} == different
    assert len({value.name for value in one.values}) == len(one.values)
    if one.draw is None:
        assert entry.is_table
    else:
        assert one.draw().svg.rstrip().endswith("</svg>")
        assert (DRAWN / entry.file_name).is_file()


def compare_with_the_page(entry: Entry) -> None:
    """The page has these numbers; on another machine the last digits may differ."""
    one = made(entry.number)
    rows = stored("reproduce", "figures").tables[entry.number].rows
    fresh = rows_of(entry, one)
    assert [[*row[:3], *row[4:]] for row in rows] == [[*row[:3], *row[4:]] for row in fresh]
    kept = np.array([float(row[3]) for row in rows])
    assert kept == pytest.approx(np.array([value.ours for value in one.values]), rel=0.02, abs=1e-4)
