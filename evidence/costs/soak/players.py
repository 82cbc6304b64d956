"""The clients of the soak, a process a group: ``python -m evidence.costs.soak.players GROUP PLAN``."""

from __future__ import annotations

import asyncio
import http.client
import json
import random
import select
import socket
import threading
import time
from collections.abc import Awaitable, Callable
from contextlib import suppress
from pathlib import Path
from typing import cast

import msgspec
import uvloop

from evidence.arguments import parse
from evidence.costs.soak.sessions import (
    BINARY,
    BYE,
    PING,
    TEXT,
    Plan,
    Reporter,
    StreamClient,
    events,
    frame,
    upgrade,
)
from pointpred.protocol.frames import pack_events

KINDS = (
    ("kinematic-adaptive", 125.0, "json"),
    ("kinematic-adaptive", 125.0, "binary"),
    ("linear", 1000.0, "binary"),
    ("switched", 1000.0, "binary"),
)
"""Predictor, events a second, encoding."""
END_S = 20.0
"""So long the last answers may take."""


class Steady:
    """One client and its socket."""

    def __init__(self, plan: Plan, number: int) -> None:
        predictor, self.rate_hz, encoding = KINDS[number]
        self.client = StreamClient(
            Path(plan.scratch), number, self.rate_hz, predictor=predictor, encoding=encoding
        )
        self.socket = socket.create_connection(("127.0.0.1", plan.port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.socket.sendall(upgrade(plan.port))
        while not self.client.session:
            self.read()
        self.due = time.perf_counter() + number / 10_000

    def read(self) -> None:
        """Take in what came; raises ConnectionError where the service has left."""
        data = self.socket.recv(1 << 16)
        if not data:
            raise ConnectionError(f"a steady client was cut; close code {self.client.close_code}")
        if reply := self.client.receive(data, time.perf_counter()):
            self.socket.sendall(reply)

    def send_due(self, now: float) -> None:
        """Send every event whose time has come."""
        while self.due <= now:
            self.socket.sendall(self.client.frames(1, self.due))
            self.due += 1.0 / self.rate_hz


def play_steady(plan: Plan, reporter: Reporter) -> None:
    """Send until stdin is closed, then compare everything.

    They send an event a message, and keep to the clock whatever comes back; their delays are judged. The loop
    waits by ``select``, whose timeouts are exact; an event loop's are whole milliseconds.
    """
    steady = [Steady(plan, number) for number in range(len(KINDS))]
    by_socket = {one.socket: one for one in steady}
    reported_at = time.perf_counter()
    while not reporter.stopping.is_set():
        now = time.perf_counter()
        for one in steady:
            one.send_due(now)
        pause = min(one.due for one in steady) - time.perf_counter()
        for ready in select.select(by_socket, [], [], max(0.0, pause))[0]:
            by_socket[ready].read()
        if now - reported_at >= 1.0:
            reported_at = now
            tell(reporter, steady)
    until = time.perf_counter() + END_S
    while not all(one.client.answered for one in steady) and time.perf_counter() < until:
        for ready in select.select(by_socket, [], [], 0.1)[0]:
            by_socket[ready].read()
    for one in steady:
        one.socket.sendall(BYE)
        while not one.client.close_code:
            one.read()
        one.socket.close()
    tell(reporter, steady)
    for one in steady:
        reporter.conclude(one.client, whole=True)
    reporter.write()


def tell(reporter: Reporter, steady: list[Steady]) -> None:
    """Compare what came, and report."""
    for one in steady:
        one.client.run.compare()
        reporter.add_delays(one.client.take_delays())
        reporter.wrong += one.client.run.wrong
        one.client.run.wrong.clear()
    reporter.write()


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
    """Many events at once, in few frames or in many, then nothing for a moment."""
    until = time.monotonic() + LASTS_S
    while time.monotonic() < until:
        count = chance.choice((8, 64, 512))
        frames = link.client.frames(count, time.perf_counter(), a_frame=chance.choice((1, 8, 64)))
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


async def play_varied(plan: Plan, reporter: Reporter) -> None:
    """Clients that burst, pause, come and go, and that never read."""
    players = asyncio.gather(*(play(plan, reporter, number) for number in range(len(CLIENTS))))
    while not players.done():
        await asyncio.wait([players], timeout=1.0)
        reporter.write()
    await players
    reporter.write()


HELLO = frame(TEXT, b'{"type":"hello","version":1,"predictor":"switched","encoding":"binary"}')
ATTACKERS = 4
REST_S = 1.0
"""Between two attacks of one client."""


class Attack:
    """One connection and its chances."""

    def __init__(self, port: int, chance: random.Random) -> None:
        self.port, self.chance = port, chance

    async def open(self) -> None:
        """Connect, and say nothing."""
        self.reader, self.writer = await asyncio.open_connection("127.0.0.1", self.port)

    async def begin(self, first: bytes = HELLO) -> None:
        """A WebSocket whose first message has been sent."""
        await self.open()
        self.writer.write(upgrade(self.port))
        await self.reader.readuntil(b"\r\n\r\n")
        self.writer.write(first)

    async def read(self, seconds: float) -> None:
        """Read until the service closes, or for so long."""
        with suppress(TimeoutError):
            async with asyncio.timeout(seconds):
                while await self.reader.read(1 << 16):
                    pass

    async def text(self, message: object) -> None:
        """Send a message."""
        self.writer.write(frame(TEXT, json.dumps(message).encode()))
        await self.writer.drain()


async def half_a_handshake(attack: Attack) -> None:
    """An upgrade that never ends."""
    await attack.open()
    attack.writer.write(upgrade(attack.port)[: attack.chance.randint(1, 150)])
    await attack.read(15.0)


async def slow_header(attack: Attack) -> None:
    """A header a byte at a time."""
    await attack.open()
    for byte in upgrade(attack.port)[:60]:
        attack.writer.write(bytes([byte]))
        await attack.read(0.25)


async def broken_frames(attack: Attack) -> None:
    """Frames that break the rules of WebSocket."""
    await attack.begin()
    attack.writer.write(
        attack.chance.choice(
            (
                b"\xf2\x80\0\0\0\0",  # reserved bits
                b"\x83\x80\0\0\0\0",  # an opcode that does not exist
                b"\x82\x1e" + bytes(30),  # not masked
                b"\x82\xff" + (1 << 40).to_bytes(8, "big") + bytes(4),  # a terabyte is announced
                frame(TEXT, b"\xff\xfe\xfd"),  # no UTF-8
                b"\x89\xfe\x00\x80" + bytes(4 + 128),  # a ping that is too long
                b"\x01\x81\0\0\0\0a" * 2,  # a message within a message
                attack.chance.randbytes(200),
            )
        )
    )
    await attack.read(8.0)


async def wrong_messages(attack: Attack) -> None:
    """Messages that say nothing, or the wrong thing."""
    await attack.begin()
    for _ in range(100):
        await attack.text(
            attack.chance.choice(
                (
                    {"type": "events", "events": [["a", 1, 2, None, None, 0]]},
                    {"type": "events", "events": [[1e300, 1, 2, None, None, 0]]},
                    {"type": "hello", "version": 2},
                    {"type": "nothing"},
                    {"type": "configure", "predictor": "none"},
                    {"type": "targets", "targets": [{"id": ""}]},
                    {"type": "person", "person": "1." + "a" * 500},
                    [[[[]]]],
                )
            )
        )
        await attack.read(0.01)


async def too_long(attack: Attack) -> None:
    """A message above every bound."""
    await attack.begin()
    with suppress(OSError):
        attack.writer.write(frame(BINARY, bytes(1_100_000)))
        await attack.writer.drain()
    await attack.read(8.0)


async def fragments(attack: Attack) -> None:
    """A message that never ends."""
    await attack.begin()
    attack.writer.write(b"\x01\x81\0\0\0\0a" + b"\x00\x81\0\0\0\0a" * 100)
    await attack.read(8.0)


async def pings(attack: Attack) -> None:
    """More pings than are allowed."""
    await attack.begin()
    attack.writer.write(frame(PING, b"") * 200)
    await attack.read(8.0)


async def too_many_events(attack: Attack) -> None:
    """More events a second than are allowed."""
    await attack.begin()
    table = events(7, 8000.0, 0, 1000)
    for turn in range(40):
        attack.writer.write(frame(BINARY, pack_events(table)))
        table[:, 0] += 0.125 * (turn + 1)
        await attack.writer.drain()
    await attack.read(8.0)


async def many_connections(attack: Attack) -> None:
    """Connections that are opened and left."""
    opened = [await asyncio.open_connection("127.0.0.1", attack.port) for _ in range(50)]
    await asyncio.sleep(0.5)
    for _, writer in opened:
        writer.transport.abort()
    attack.writer = opened[0][1]


ATTACKS: tuple[Callable[[Attack], Awaitable[None]], ...] = (
    half_a_handshake,
    slow_header,
    broken_frames,
    wrong_messages,
    too_long,
    fragments,
    pings,
    too_many_events,
    many_connections,
)


async def attack_on(plan: Plan, reporter: Reporter, number: int) -> None:
    """One attacker: the attacks in an order of its own, again and again."""
    chance = random.Random(plan.seed * 1000 + 500 + number)
    turns: list[Callable[[Attack], Awaitable[None]]] = []
    while not reporter.stopping.is_set():
        turns = turns or chance.sample(ATTACKS, len(ATTACKS))
        attack, script = Attack(plan.port, chance), turns.pop()
        with suppress(OSError, TimeoutError, asyncio.IncompleteReadError, asyncio.LimitOverrunError):
            async with asyncio.timeout(30.0):
                await script(attack)
        if writer := getattr(attack, "writer", None):
            writer.transport.abort()
        reporter.counts["attacks"] += 1
        reporter.counts[f"attack: {script.__name__.replace('_', ' ')}"] += 1
        await asyncio.sleep(REST_S)


async def play_hostile(plan: Plan, reporter: Reporter) -> None:
    """Attack until the soak ends; what the attackers are answered is not judged.

    Each draws one attack after another from the same list, for the whole soak: what the others bear is the
    same in its first minutes as in its last.
    """
    attackers = [asyncio.create_task(attack_on(plan, reporter, number)) for number in range(ATTACKERS)]
    while not reporter.stopping.is_set():
        await asyncio.sleep(1.0)
        reporter.write()
    for attacker in attackers:
        attacker.cancel()
    await asyncio.gather(*attackers, return_exceptions=True)
    reporter.write()


PATHS = ("/", "/pointpred.js", "/v1/predictors", "/healthz", "/readyz", "/v1/samples")
VISITORS = 2
TIMEOUT_S = 60.0
REST_S = 0.5


def visit(plan: Plan, reporter: Reporter, number: int) -> None:
    """One visitor: a request after another, some on a connection of its own."""
    chance = random.Random(plan.seed * 1000 + 900 + number)
    connection = http.client.HTTPConnection("127.0.0.1", plan.port, timeout=TIMEOUT_S)
    while not reporter.stopping.is_set():
        try:
            connection.request("GET", chance.choice(PATHS))
            answer = connection.getresponse()
            answer.read()
            reporter.counts["requests"] += 1
            if answer.status != 200:
                reporter.wrong.append(f"a visitor was answered with {answer.status}")
        except (OSError, http.client.HTTPException) as error:
            reporter.wrong.append(f"a visitor was cut: {type(error).__name__}: {error}")
            connection.close()
        if chance.random() < 0.3:
            connection.close()
        reporter.stopping.wait(REST_S)
    connection.close()


def play_visitors(plan: Plan, reporter: Reporter) -> None:
    """People with a browser, until stdin is closed."""
    threads = [threading.Thread(target=visit, args=(plan, reporter, n)) for n in range(VISITORS)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        time.sleep(1.0)
        reporter.write()
    reporter.write()


def main(group: str, words: str) -> None:
    """Play a group until the soak closes stdin."""
    plan = msgspec.json.decode(words, type=Plan)
    reporter = Reporter(plan)
    if group == "steady":
        play_steady(plan, reporter)
    elif group == "visitors":
        play_visitors(plan, reporter)
    else:
        uvloop.run({"varied": play_varied, "hostile": play_hostile}[group](plan, reporter))


if __name__ == "__main__":
    main(*parse(__doc__, metavar="GROUP PLAN", most=2))
