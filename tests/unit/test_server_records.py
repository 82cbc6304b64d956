from __future__ import annotations

import json
import math
import struct
from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from pointpred.protocol.frames import (
    EVENT,
    PREDICTION,
    Likeliest,
    aimed_text,
    message_of,
    pack_prediction,
    pack_predictions,
    prediction_text,
    row_encoder,
    row_of_prediction,
    unpack_events,
)
from pointpred.protocol.server_messages import Likely
from tests.unit import talking

real = st.floats(allow_nan=True, allow_infinity=True)
count = st.integers(-32768, 32767)
record = st.tuples(real, real, real, count, count, st.integers(0, 65535))
phase = st.sampled_from([0.0, 1.0, 2.0])


def same(one: Any, other: Any) -> bool:
    return np.array(one, np.float64).tobytes() == np.array(other, np.float64).tobytes()


def plain(values: tuple[float, ...]) -> list[float]:
    """An event's numbers as the table has them."""
    *place, dx, dy, buttons = values
    none = talking.NO_COUNTS in (dx, dy)
    return [*place, *((math.nan, math.nan) if none else (dx, dy)), buttons]


@given(st.lists(record, max_size=6))
def test_events_are_unpacked_as_struct_says(records: list[tuple[Any, ...]]) -> None:
    frame = b"".join(talking.EVENT.pack(*one) for one in records)
    assert same(unpack_events(frame), [plain(one) for one in records])


@given(st.lists(st.tuples(*[real] * 7, phase, real, real), max_size=6))
def test_predictions_are_packed_as_struct_says(rows: list[tuple[float, ...]]) -> None:
    table = np.array(rows, np.float64).reshape(-1, 10)
    nothing = [math.nan] * 6
    first = [
        talking.PREDICTION.pack(row[0], *nothing, 0, math.nan)
        if math.isnan(row[1])
        else talking.PREDICTION.pack(*row[:7], int(row[7]), math.nan if math.isnan(row[3]) else row[8])
        for row in table.tolist()
    ]
    later = [struct.pack("<dh", math.nan if math.isnan(row[1]) else row[9], 7) for row in table.tolist()]
    wanted = b"".join(map(bytes.__add__, first, later))
    assert pack_predictions(table, [Likeliest(7, [])] * len(table)) == wanted
    assert b"".join(pack_prediction(row, 7) for row in table.tolist()) == wanted
    assert pack_predictions(table, version=1) == b"".join(first)
    encode = row_encoder(binary=True, version=1)
    assert [encode(row) for row in table.tolist()] == first


def test_the_records_have_the_sizes_of_the_contract() -> None:
    assert (EVENT.itemsize, PREDICTION[1].itemsize, PREDICTION[2].itemsize) == (30, 65, 75)
    assert (talking.EVENT.size, talking.PREDICTION.size) == (30, 65)


def test_numbers_of_laws_that_run_as_plain_python_are_said_in_json() -> None:
    row = (np.float64(0.1), *(np.float64(k) for k in range(1, 7)), 1.0, np.float64("nan"), np.float64("nan"))
    said = json.loads(prediction_text(row))
    assert (said["t"], said["x"], said["region"]["sxx"], said["remaining_s"]) == (0.1, 1.0, 3.0, 6.0)


@given(st.tuples(*[st.floats(allow_nan=False)] * 7, phase, *[st.floats(allow_nan=False)] * 2))
def test_a_message_has_every_number_of_its_row(row: tuple[float, ...]) -> None:
    assert same(row_of_prediction(message_of(row)), row)
    text = json.loads(aimed_text(row, Likeliest(0, [Likely("a", 0.5)])))
    assert (text["target"], text["targets"]) == ("a", [{"id": "a", "p": 0.5}])
    assert json.loads(aimed_text(row, Likeliest(-1, [Likely("a", 0.5)])))["target"] is None
