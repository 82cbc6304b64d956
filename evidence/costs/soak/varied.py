"""Clients that burst, pause, come and go, and that never read: ``evidence.costs.soak.varied PLAN``."""

from __future__ import annotations

import asyncio
import random
import time
from collections.abc import Awaitable, Callable
from contextlib import suppress
from pathlib import Path
from typing import cast

import msgspec
import uvloop

from evidence.arguments import parse
from evidence.costs.soak.client import BYE, StreamClient, upgrade
from evidence.costs.soak.reports import Plan, Reporter

LASTS_S = 60.0
"""A session of a client that bursts or pauses; then another begins."""
PREDICTORS = ("switched", "linear", "kinematic", "kinematic-adaptive", "kep-quadratic", "hold")
UNREAD_S = 30.0
"""The service has cut a client that reads nothing after 20 s."""


class Link:
    """A connection of an innocent client."""

    def __init__(self, client: StreamClient) -> None:
        self.client = client

    async def open(self, port: int) -> None:
        """Connect, and wait for the welcome."""
        self.reader, self.writer = await asyncio.open_connection("127.0.0.1", port)
        self.writer.write(upgrade(port))
        while not self.client.session:
            await self.read()

    async def read(self) -> None:
        """Take in what comes next; raises ConnectionError where the service has left."""
        data = await self.reader.read(1 << 16)
        if not data:
            raise ConnectionError(f"cut; close code {self.client.close_code}")
        self.writer.write(self.client.receive(data, time.perf_counter()))

    async def read_for(self, seconds: float) -> None:
        """Take in what comes for a while."""
        with suppress(TimeoutError):
            async with asyncio.timeout(seconds):
                while True:
                    await self.read()

    async def leave(self) -> None:
        """Wait for the last answers, say bye, and read until the service has closed."""
        async with asyncio.timeout(60.0):
            while not self.client.answered:
                await self.read()
            self.writer.write(BYE)
            while not self.client.close_code:
                await self.read()


Script = Callable[[Link, random.Random], Awaitable[bool]]
"""What a client does in one session; returns whether it left as it should, so that nothing may be missing."""


async def burst(link: Link, chance: random.Random) -> bool:
    """Many events at once, in one frame or in many, then nothing for a moment."""
    until = time.monotonic() + LASTS_S
    while time.monotonic() < until:
        count = chance.choice((8, 64, 512))
        frames = link.client.frames(count, time.perf_counter(), a_frame=chance.choice((1, 8, count)))
        link.writer.write(frames)
        await link.read_for(chance.uniform(0.2, 1.0))
    await link.leave()
    return True


async def pause(link: Link, chance: random.Random) -> bool:
    """Some seconds of movement, then nothing for many."""
    until = time.monotonic() + LASTS_S
    while time.monotonic() < until:
        for _ in range(chance.randint(100, 500)):
            link.writer.write(link.client.frames(1, time.perf_counter()))
            await link.read_for(0.004)
        still_s = chance.uniform(1.0, 15.0)
        link.client.skip(still_s)
        await link.read_for(still_s)
    await link.leave()
    return True


async def come_and_go(link: Link, chance: random.Random) -> bool:
    """A short session, which ends with a bye, or with the connection cut in the middle."""
    for _ in range(chance.randint(0, 40)):
        link.writer.write(link.client.frames(chance.randint(1, 20), time.perf_counter()))
        await link.read_for(chance.uniform(0.0, 0.05))
    if chance.random() < 0.5:
        await link.leave()
        return True
    link.writer.transport.abort()
    return False


async def never_read(link: Link, chance: random.Random) -> bool:
    """Sends, and reads nothing, until it is cut."""
    transport, until = cast(asyncio.Transport, link.writer.transport), time.monotonic() + UNREAD_S
    transport.pause_reading()
    while time.monotonic() < until and not transport.is_closing():
        link.writer.write(link.client.frames(50, time.perf_counter(), a_frame=1))
        await asyncio.sleep(0.05)
    transport.abort()
    return False


CLIENTS: tuple[tuple[Script, float, str], ...] = (
    (burst, 1000.0, "event"),
    (burst, 1000.0, "frame"),
    (pause, 250.0, "frame"),
    (pause, 250.0, "frame"),
    (come_and_go, 200.0, "frame"),
    (come_and_go, 200.0, "event"),
    (come_and_go, 200.0, "frame"),
    (never_read, 1000.0, "frame"),
    (never_read, 1000.0, "event"),
)
"""What each client does, its events a second, and how it is answered."""


async def play(plan: Plan, reporter: Reporter, number: int) -> None:
    """One client: a session after another until the soak ends."""
    script, rate_hz, reply = CLIENTS[number]
    chance = random.Random(plan.seed * 1000 + number)
    later: list[asyncio.Task[None]] = []
    while not reporter.stopping.is_set():
        later = [one for one in later if not one.done()]
        predictor, encoding = chance.choice(PREDICTORS), chance.choice(("json", "binary"))
        client = StreamClient(
            Path(plan.scratch),
            1000 * number,
            rate_hz,
            predictor=predictor,
            encoding=encoding,
            reply=reply,
        )
        link, whole = Link(client), False
        try:
            async with asyncio.timeout(3 * LASTS_S):
                await link.open(plan.port)
                whole = await stoppable(script(link, chance), reporter)
        except (OSError, TimeoutError, asyncio.IncompleteReadError) as error:
            if script is not never_read:
                reporter.wrong.append(f"{script.__name__}: {type(error).__name__}: {error}")
        if link_writer := getattr(link, "writer", None):
            link_writer.transport.abort()
        reporter.counts[script.__name__.replace("_", " ")] += 1
        if script is never_read:
            client.errors.clear()
        later.append(asyncio.create_task(asyncio.to_thread(reporter.conclude, client, whole=whole)))
    await asyncio.gather(*later)


async def stoppable(session: Awaitable[bool], reporter: Reporter) -> bool:
    """A session until it ends or the soak does; then it was not left as it should."""
    task = asyncio.ensure_future(session)
    while not task.done():
        if reporter.stopping.is_set():
            task.cancel()
            with suppress(asyncio.CancelledError):
                await task
            return False
        await asyncio.wait([task], timeout=0.5)
    return task.result()


async def run(words: str) -> None:
    """Play every client, and report."""
    plan = msgspec.json.decode(words, type=Plan)
    reporter = Reporter(plan)
    players = asyncio.gather(*(play(plan, reporter, number) for number in range(len(CLIENTS))))
    while not players.done():
        await asyncio.wait([players], timeout=1.0)
        reporter.write()
    await players
    reporter.write()


if __name__ == "__main__":
    uvloop.run(run(parse(__doc__, metavar="PLAN", most=1)[0]))
