"""The Python clients with places: proposed, kept for each window, forgotten."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest

from pointpred.client import connect, connect_async
from pointpred.errors import ParameterError
from tests.server.listener import Listener
from tests.unit.test_server_places import NAME, way


def rows(number: int) -> list[list[Any]]:
    return [list(row[:3]) for row in way(number)]


def test_places_are_proposed_until_the_person_is_forgotten() -> None:
    with Listener() as listener, connect(listener.url, predictor=NAME, places=True) as connection:
        for number in range(9):
            connection.send(rows(number))
            assert len(connection.columns()) > 0
            connection.reset()
        made = [one for one in connection.choices() if one.reason == "predicted"]
        assert made[-1].place.x == pytest.approx(400.0, abs=5.0)
        connection.enter("editor", 10.0)
        connection.send(rows(9))
        connection.columns()
        assert [one for one in connection.choices() if one.action == "propose"] == []
        connection.enter("")
        assert connection.person() != ""
        assert connection.forget() == ""
        assert connection.person() == ""
        with pytest.raises(ParameterError, match="enter"):
            connection.enter(3)  # type: ignore[arg-type]


def test_asyncio_enters_and_forgets() -> None:
    async def talk(url: str) -> None:
        async with await connect_async(url, predictor=NAME, places=True) as connection:
            await connection.enter("editor", 10.0, 20.0)
            await connection.send(rows(0))
            assert len(await connection.columns()) > 0
            await connection.reset()
            assert await connection.person() != ""
            assert await connection.forget() == ""
            await connection.configure(places=False)

    with Listener() as listener:
        asyncio.run(talk(listener.url))
