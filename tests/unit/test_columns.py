"""Tables of records: lists and arrays become numbers, and what cannot is named."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred import EventColumns, Motion, MotionColumns, PointerEvent, Prediction, PredictionColumns
from pointpred.errors import EventError

THREE = [0.0, 1.0, 2.0]


def test_a_list_of_rows_is_a_table() -> None:
    columns = EventColumns([[0, 1, 2, np.nan, np.nan, 0], [1, 3, 4, 5, 6, 1]])
    assert columns.table.dtype == np.float64
    assert columns.x.tolist() == [1.0, 3.0]
    assert columns.begin.tolist() == [False, False]
    assert [event.dx for event in columns.events()] == [None, 5.0]


SHAPE = r"EventColumns needs shape \(rows, 6\), received"
NO_NUMBERS = ([["a"] * 6], [[1.0] * 6, [1.0]], [[1j] * 6], np.zeros((1, 6), "M8[s]"), [[{}] * 6], None)


@pytest.mark.parametrize(
    ("table", "words"),
    [
        *((table, SHAPE) for table in ([], [1.0] * 6, [[1.0] * 5], np.zeros((2, 6, 1)))),
        *((table, None) for table in NO_NUMBERS),
    ],
)
def test_what_is_no_table_of_numbers_is_refused(table: Any, words: str | None) -> None:
    with pytest.raises(EventError, match=words):
        EventColumns(table)


LENGTHS = (([1.0], r"\(1,\)"), ([1.0, 2.0], r"\(2,\)"), (3.0, r"\(\)"))


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        *(
            ({name: values}, f"^{name} needs 3 rows as t has, received shape {shape}")
            for name in ("x", "y", "dx", "dy", "buttons")
            for values, shape in LENGTHS
        ),
        ({"t": 0.0}, r"t needs one number a row, received shape \(\)"),
        ({"x": ["left", "right", "left"]}, "x needs numbers"),
        ({"begin": np.array([True])}, "begin needs 3 rows"),
    ],
)
def test_a_field_that_does_not_fit_is_refused_and_not_stretched(fields: dict[str, Any], words: str) -> None:
    with pytest.raises(EventError, match=words):
        EventColumns.of(**{"t": THREE, "x": THREE, "y": THREE} | fields)


NONE = float("nan")
EVENTS = EventColumns(
    [[0.0, 1, 2, NONE, NONE, 0], [0.1, 3, 4, 5, 6, 1], [0.2, 5, 6, 7, 8, 0]], np.array([True, False, True])
)
MOTIONS = MotionColumns([[0.1 * i, i, 2, 3, 4, 5, 6, i == 1, False, True] for i in range(3)])
PREDICTIONS = PredictionColumns(
    [
        [0.0, *[NONE] * 6, 0, NONE, NONE],
        [0.1, 3, 4, NONE, NONE, NONE, NONE, 1, NONE, NONE],
        [0.2, 3, 4, 9, 0, 4, 0.3, 2, 1.5, 0.2],
    ]
)
REGIONS = PREDICTIONS.region(0.5)


@pytest.mark.parametrize("columns", [EVENTS, MOTIONS, PREDICTIONS, REGIONS])
def test_columns_are_sequences_of_records(columns: Any) -> None:
    records = list(columns)
    assert len(columns) == len(records) == 3
    assert [columns[i] for i in (0, 1, 2)] == records
    assert [columns[i] for i in (-3, -2, -1)] == records
    assert columns[np.int64(2)] == records[2]
    assert list(columns[1:]) == records[1:]
    assert list(columns[::-1]) == records[::-1]
    assert list(columns[5:]) == []
    assert type(columns[:1]) is type(columns)
    for beyond in (3, -4):
        with pytest.raises(IndexError):
            columns[beyond]
    for other in ("x", 1.0, None):
        with pytest.raises(TypeError):
            columns[other]


def test_records_are_those_of_the_rows() -> None:
    assert EVENTS[1] == PointerEvent(0.1, 3.0, 4.0, 5.0, 6.0, 1)
    assert MOTIONS[1] == Motion(0.1, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, settled=True, start=False, counts=True)
    assert PREDICTIONS[0] is None
    assert PREDICTIONS[1] == Prediction(0.1, 3.0, 4.0, None, "ballistic", None)
    assert PREDICTIONS[2] == Prediction(0.2, 3.0, 4.0, (9.0, 0.0, 4.0), "corrective", 0.3, 1.5, 0.2)


def test_a_slice_of_events_keeps_where_stages_begin() -> None:
    assert EVENTS[1:].begin.tolist() == [False, True]
    assert EVENTS[1:].begin.tolist() == EVENTS.rows(1, 3).begin.tolist()
