"""Over real sockets: one service stops, another goes on with what it knew of the person."""

from __future__ import annotations

import asyncio
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from pointpred import EventColumns, build, client, run
from pointpred.client import ServiceError
from pointpred.records import FloatArray
from tests.server.listener import Listener
from tests.server.running import PATIENCE_S, running

connect = partial(client.connect, timeout_s=PATIENCE_S)
connect_async = partial(client.connect_async, timeout_s=PATIENCE_S)
NAME = "kinematic-adaptive"


def reach(px: float) -> EventColumns:
    t = np.arange(60) / 100.0
    share = np.minimum(t / 0.5, 1.0)
    return EventColumns.of(t, px * (10 * share**3 - 15 * share**4 + 6 * share**5), np.zeros(60))


WAYS = [300.0, 420.0, 360.0, 500.0, 390.0, 310.0]


def wanted() -> list[FloatArray]:
    """What one pipeline says that nobody interrupts."""
    pipeline, tables = build(NAME), []
    for px in WAYS:
        tables.append(run(pipeline, reach(px)).table)
        pipeline.reset()
    return tables


def same(heard: FloatArray, table: FloatArray) -> bool:
    """The columns that a packed prediction holds."""
    return np.array_equal(heard[:, :8], table[:, :8], equal_nan=True)


def test_a_second_service_goes_on_where_the_first_stopped() -> None:
    tables, known = wanted(), ""
    for first in (0, 3):
        with (
            running() as service,
            connect(service.url, predictor=NAME, reply="event", person=known) as connection,
        ):
            assert connection.person() == known
            for px, table in zip(WAYS[first : first + 3], tables[first : first + 3], strict=True):
                connection.send(reach(px))
                assert same(connection.columns().table, table)
                connection.reset()
            known = connection.person()
    pipeline = build(NAME, person=known)
    assert pipeline.person == known != ""


def test_the_asynchronous_client_says_the_same() -> None:
    async def learn(url: str) -> str:
        async with await connect_async(url, predictor=NAME, reply="event") as connection:
            for px in WAYS:
                await connection.send(reach(px))
                await connection.columns()
                await connection.reset()
            known = await connection.person()
            assert await connection.person("") == ""
            assert await connection.person(known) == known
            return known

    with Listener() as service:
        known = asyncio.run(learn(service.url))
    pipeline = build(NAME)
    for px in WAYS:
        run(pipeline, reach(px))
        pipeline.reset()
    assert known == pipeline.person


def test_a_person_that_is_refused_names_the_field_and_breaks_nothing() -> None:
    with Listener() as service:
        with pytest.raises(ServiceError) as refused:
            connect(service.url, predictor=NAME, person="1.nobody")
        assert (refused.value.code, refused.value.path) == ("bad_field", "$.person")
        with connect(service.url, predictor=NAME, reply="event") as connection:
            with pytest.raises(ServiceError):
                connection.person("1.nobody")
            connection.send(reach(300.0))
            assert same(connection.columns().table, wanted()[0])


def test_nothing_of_the_person_is_recorded(tmp_path: Path) -> None:
    pipeline = build(NAME)
    for px in WAYS:
        run(pipeline, reach(px))
        pipeline.reset()
    with (
        running(record=tmp_path) as service,
        connect(service.url, predictor=NAME, person=pipeline.person) as connection,
    ):
        connection.send(reach(300.0))
        connection.columns()
        assert connection.person(pipeline.person) == pipeline.person
    written = [path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()]
    assert written
    assert not any(pipeline.person[30:60].encode() in one for one in written)
