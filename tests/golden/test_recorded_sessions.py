"""Recorded sessions of version 1 get the answers that they got: docs/reference/compatibility.md."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.golden.exchanges import FOLDER, differences, play, read
from tests.server.running import PATIENCE_S, Running, running

SESSIONS = sorted(FOLDER.glob("*.jsonl"))


@pytest.fixture(scope="module")
def here() -> Iterator[Running]:
    with running() as service:
        yield service


@pytest.mark.parametrize("path", SESSIONS, ids=[path.stem for path in SESSIONS])
def test_a_recorded_session_gets_the_same_answers(path: Path, here: Running) -> None:
    exchange = read(path)
    with here.connect() as socket:
        assert socket.subprotocol == "pointpred.v1"
        for place, recorded, answer in play(exchange, socket, PATIENCE_S):
            assert differences(recorded, answer, exchange.version, numbers=exchange.numbers) == [], place


def test_the_recorded_sessions_hold_every_message_of_the_server() -> None:
    answers = [answer for path in SESSIONS for step in read(path).steps for answer in step.answers]
    assert any(isinstance(answer, bytes) for answer in answers)
    kinds = {json.loads(answer)["type"] for answer in answers if isinstance(answer, str)}
    assert kinds == {"welcome", "prediction", "cursor", "choice", "targets", "person", "score", "error"}
