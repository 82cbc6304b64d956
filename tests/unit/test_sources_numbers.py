"""Columns of files become float64 as Arrow itself would make them, however they are cut and wherever null."""

from __future__ import annotations

import numpy as np
import pyarrow as pa
from hypothesis import given
from hypothesis import strategies as st

from pointpred.recordings.arrow_tables import numbers

CELLS = st.lists(st.none() | st.floats(allow_nan=False) | st.integers(-9, 9).map(float), max_size=30)


@given(st.lists(CELLS, max_size=4), st.integers(0, 20), st.integers(0, 60))
def test_numbers_agree_with_arrow(parts: list[list[float | None]], start: int, length: int) -> None:
    column = pa.chunked_array([pa.array(part, pa.float64()) for part in parts], pa.float64())
    column = column.slice(min(start, len(column)), length)
    values, faults = numbers(column)
    assert not faults
    np.testing.assert_array_equal(values, column.to_numpy(zero_copy_only=False))


@given(st.lists(st.none() | st.integers(-(2**40), 2**40), max_size=30))
def test_whole_numbers_and_empty_cells(cells: list[int | None]) -> None:
    values, _ = numbers(pa.chunked_array([pa.array(cells, pa.int64())]))
    assert [None if value != value else int(value) for value in values.tolist()] == cells
