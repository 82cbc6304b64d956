"""Clients that attack: ``evidence.costs.soak.hostile PLAN``. What they are answered is not judged here.

Each draws one attack after another from the same list, for the whole soak: what the others bear is the same
in its first minutes as in its last.
"""

from __future__ import annotations

import asyncio
import json
import random
from collections.abc import Awaitable, Callable
from contextlib import suppress

import msgspec
import uvloop

from evidence.arguments import parse
from evidence.costs.soak.client import BINARY, PING, TEXT, events, frame, upgrade
from evidence.costs.soak.reports import Plan, Reporter
from pointpred.protocol.frames import pack_events

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


async def run(words: str) -> None:
    """Attack until the soak ends."""
    plan = msgspec.json.decode(words, type=Plan)
    reporter = Reporter(plan)
    attackers = [asyncio.create_task(attack_on(plan, reporter, number)) for number in range(ATTACKERS)]
    while not reporter.stopping.is_set():
        await asyncio.sleep(1.0)
        reporter.write()
    for attacker in attackers:
        attacker.cancel()
    await asyncio.gather(*attackers, return_exceptions=True)
    reporter.write()


if __name__ == "__main__":
    uvloop.run(run(parse(__doc__, metavar="PLAN", most=1)[0]))
