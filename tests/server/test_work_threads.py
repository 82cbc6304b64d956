"""What takes one session long is done in slices, between which other sessions have theirs."""

from __future__ import annotations

import asyncio
import json
import threading
from collections.abc import Generator
from concurrent.futures import Future
from typing import Any

import pytest

from benchmarks.longest_messages import packed, targets
from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import Limits
from pointpred_server.arrivals import Arrivals
from pointpred_server.connection import Connection
from pointpred_server.sessions.costs import SLICE_S
from pointpred_server.sessions.pointing import PointingSession
from pointpred_server.sessions.work import Completion, Work
from pointpred_server.work_threads import WorkThreads
from tests.server.fake_socket import FakeSocket
from tests.server.running import PATIENCE_S
from tests.unit.talking import Talk, hello
from tests.unit.talking import packed as packed_rows


class Slices:
    """Work that notes its slices, and waits before the first one until it may go on."""

    def __init__(self) -> None:
        self.done: list[str] = []
        self.go = threading.Event()

    def work(self, name: str, count: int) -> Work:
        def slices() -> Generator[None, None, Completion]:
            assert self.go.wait(PATIENCE_S)
            for place in range(count):
                if place:
                    yield
                self.done.append(name)
            return lambda: self.done.append(f"{name} ends")

        return Work(slices())


PLACES = {"predictor": "kinematic-adaptive", "places": True}
ASSIST = {"assist": {}, "device": {"cpi": 800}}


def finish(done: Future[Completion]) -> None:
    done.result(PATIENCE_S)()


def test_sessions_have_one_slice_each_in_turn() -> None:
    threads, noted = WorkThreads(), Slices()
    long, short = threads.submit(noted.work("long", 4)), threads.submit(noted.work("short", 2))
    noted.go.set()
    finish(short)
    finish(long)
    threads.shut_down()
    assert [one for one in noted.done if " " not in one] == ["long", "short"] * 2 + ["long"] * 2


def test_a_trial_that_is_scored_holds_up_no_frames() -> None:
    threads, noted, other = WorkThreads(), Slices(), Slices()
    trial = noted.work("trial", 1)
    trial.divided = False
    scored = threads.submit(trial)
    other.go.set()
    finish(threads.submit(other.work("frame", 3)))
    assert not scored.done()
    noted.go.set()
    finish(scored)
    threads.shut_down()


def test_work_that_fails_says_so_and_the_next_goes_on() -> None:
    def failing() -> Generator[None, None, Completion]:
        yield
        raise RuntimeError("broken")

    threads, noted = WorkThreads(), Slices()
    noted.go.set()
    with pytest.raises(RuntimeError, match="broken"):
        finish(threads.submit(Work(failing())))
    finish(threads.submit(noted.work("next", 1)))
    threads.shut_down()
    assert threads.submit(noted.work("too late", 1)).cancelled()


@pytest.mark.parametrize(
    ("many", "more"),
    [
        (50, {"reply": "event"}),
        (50, {"encoding": "binary"}),
        (50, PLACES),
        (0, PLACES),
        (0, ASSIST),
        (50, ASSIST),
    ],
)
def test_slices_change_no_answer(many: int, more: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred_server.sessions.pointing.AT_ONCE_S", 0.0)
    heard = []
    for slice_s in (1e-4, 1e3):
        monkeypatch.setattr("pointpred_server.sessions.costs.SLICE_S", slice_s)
        talk = Talk(greet=hello(**{"predictor": "kinematic", **more}))
        talk.say(targets(many, width=30, height=30))
        answers, slices = [], 0
        for place, frame in enumerate(frames_of_a_way()):
            talk.session.receive(frame, 10.0 * place)
            assert talk.session.work is not None
            while (completion := talk.session.work.advance()) is None:
                slices += 1
            talk.session.finish(completion)
            answers += [*talk.hear(), *talk.say({"type": "reset"}, 10.0 * place)]
        heard.append(answers)
        assert (slices > 5) == (slice_s < 1.0)
    assert heard[0] == heard[1]
    assert any(isinstance(one, dict) and one["type"] == "choice" for one in heard[0]) == (
        many > 0 or more == PLACES
    )


def frames_of_a_way() -> list[bytes]:
    """Movements there and back, each a frame, with counts."""
    rows = []
    for i in range(1500):
        s = min(i % 150 / 60, 1.0)
        far = 400.0 * (10 * s**3 - 15 * s**4 + 6 * s**5)
        counts = (1.0 if i // 150 % 2 == 0 else -1.0) if s < 1.0 else 0.0
        rows.append((0.01 * i, far if i // 150 % 2 == 0 else 400.0 - far, 0.5, counts, 0.0, 0))
    return [packed_rows(*rows[first : first + 150]) for first in range(0, len(rows), 150)]


def test_a_frame_is_divided_into_slices_by_what_it_costs() -> None:
    talk = Talk(greet=hello("kinematic"))
    talk.say(targets(1000))
    talk.session.receive(packed(1024), 10.0)
    assert talk.session.work is not None
    slices = 1
    while talk.session.work.advance() is None:
        slices += 1
    assert talk.session.stream is not None
    assert slices >= talk.session.stream.costs.of(1024) / SLICE_S > 50


def test_a_frame_that_is_being_worked_on_when_its_client_leaves_is_taken_in() -> None:
    async def leaving() -> PointingSession:
        session, socket = PointingSession("leaving", Limits(), 0.0), FakeSocket()
        threads, noted = WorkThreads(), Slices()
        threads.submit(noted.work("another", 1))

        def come() -> None:
            frames: list[Frame] = [json.dumps(hello("kinematic")), targets(1000), packed(100)]
            socket.there.receive(frames)

        async def leave() -> None:
            while session.work is None:
                await asyncio.sleep(0.0)
            socket.can_write = False
            socket.there.disconnect(None)
            noted.go.set()

        socket.on_attach = come
        running = asyncio.create_task(Connection(session, socket, Arrivals(), threads=threads).run())
        await asyncio.wait_for(leave(), PATIENCE_S)
        assert await asyncio.wait_for(running, PATIENCE_S) is None
        threads.shut_down()
        return session

    assert asyncio.run(leaving()).events == 100
