"""Attacks on a service, each a short function: what is sent, and how each connection was answered.

The attackers know the token, have an address of their own for each attack, and read what they are sent.
"""

from __future__ import annotations

import multiprocessing
import os
import re
import resource
import signal
import socket
import time
from collections import Counter
from collections.abc import Callable, Sequence
from contextlib import ExitStack, suppress
from functools import partial
from random import Random
from select import select
from typing import Any, Self

import msgspec
import numpy as np
from websockets.frames import Frame, Opcode

from evidence.costs.soak.sessions import BINARY, CLOSE, PING, TEXT, events, frame, split, upgrade
from pointpred.protocol.frames import pack_events

MANY = 1200
"""More connections than a service has descriptors."""
TOKEN = "known-to-attackers"
PREDICTOR = "kinematic-adaptive"
UPGRADE = upgrade(0, f"/v1/stream?token={TOKEN}")
LARGEST = "/web/page/vendor/uPlot.esm.js"


class Here:
    """Where an attack takes place: the port, its own address, until when, and what it was answered."""

    def __init__(self, port: int, source: str, until: float, person: str = "") -> None:
        self.port, self.source, self.until, self.person = port, source, until, person
        self.heard: Counter[str] = Counter()

    @property
    def going(self) -> bool:
        """Whether there is time left."""
        return time.monotonic() < self.until

    def dial(self) -> socket.socket:
        """A connection; raises OSError."""
        return socket.create_connection(("127.0.0.1", self.port), 10, source_address=(self.source, 0))

    def opened(self, most: int, first: bytes = b"") -> list[socket.socket]:
        """So many connections, or as many as can be had, each of which has sent something."""
        connections: list[socket.socket] = []
        with suppress(OSError):
            while len(connections) < most and self.going:
                connections.append(self.dial())
                connections[-1].sendall(first)
                connections[-1].setblocking(False)
        return connections

    def keep_open(self, connections: list[socket.socket]) -> None:
        """Hold connections to the end; then see what has become of each."""
        time.sleep(max(0.0, self.until - time.monotonic()))
        for one in connections:
            with one:
                self.heard[_fate(one)] += 1


def _fate(one: socket.socket) -> str:
    try:
        first = one.recv(12)
    except BlockingIOError:
        return "kept open"
    except OSError:
        return "ended"
    return first[9:12].decode() or "ended"


class Talk:
    """One connection of an attacker that reads all it is sent; how it ended is counted."""

    def __init__(self, here: Here, *parts: bytes) -> None:
        """``parts``: what it sends, each once the one before is answered."""
        self._here, self._parts = here, parts
        self._socket = here.dial()
        self._socket.setblocking(False)
        self._status = self._close = self._error = self._last_error = ""
        self._rest = b""

    def __enter__(self) -> Self:
        with suppress(OSError):
            for place, part in enumerate(self._parts):
                while place and not self._status and self._here.going:
                    self.read(0.01)
                self.send(part)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: object, trace: object) -> bool:
        with suppress(OSError):
            while True:
                self._take()
        self._socket.close()
        heard = (self._close, self._last_error) if self._close else (self._status, self._error)
        self._here.heard[" ".join(filter(None, heard)) or "ended"] += 1
        return kind is not None and issubclass(kind, OSError)

    def send(self, data: bytes) -> None:
        """Send all; raises OSError once the connection has ended, or was no WebSocket."""
        left = memoryview(data)
        while left and self._here.going:
            ready, free, _ = select([self._socket], [self._socket], [], 0.2)
            if ready:
                self._take()
                if self._status not in ("", "101"):
                    raise ConnectionError("no WebSocket")
            if free:
                left = left[self._socket.send(left) :]

    def read(self, seconds: float = 1.0) -> None:
        """Read for so long; raises OSError once the connection has ended."""
        until = min(time.monotonic() + seconds, self._here.until)
        while select([self._socket], [], [], max(0.0, until - time.monotonic()))[0]:
            self._take()

    def _take(self) -> None:
        part = self._socket.recv(2**16)
        if not part:
            raise ConnectionError("ended")
        self._rest += part
        if not self._status and b"\r\n\r\n" in self._rest:
            head, _, self._rest = self._rest.partition(b"\r\n\r\n")
            self._status = head[9:12].decode()
        if self._status != "101":
            self._rest = self._rest if not self._status else b""
            return
        frames, self._rest = split(self._rest)
        for opcode, payload in frames:
            if found := re.match(rb'\{"type":"error","code":"(\w+)"', payload):
                self._last_error = found[1].decode()
                self._error = self._error or self._last_error
            if opcode == CLOSE:
                self._close = str(int.from_bytes(payload[:2], "big"))
                raise ConnectionError("closed")


def hello(person: str = "", **fields: Any) -> bytes:
    """The first frame of a session."""
    message = {"type": "hello", "version": 2, "predictor": PREDICTOR, "person": person, **fields}
    return frame(TEXT, msgspec.json.encode(message))


def request(path: str, method: str = "GET", headers: str = "", body: bytes = b"") -> bytes:
    """A request that leaves nothing open."""
    head = f"{method} {path} HTTP/1.1\r\nHost: 127.0.0.1\r\nAuthorization: Bearer {TOKEN}\r\n{headers}"
    return f"{head}Connection: close\r\n\r\n".encode() + body


def again(here: Here, *choices: Sequence[bytes], seconds: float = 1.0) -> None:
    """One connection after another, each of which sends the parts of a choice and reads for so long."""
    count = 0
    while here.going:
        with suppress(OSError), Talk(here, *choices[count % len(choices)]) as talk:
            count += 1
            talk.read(seconds)


def flood(here: Here, *frames: bytes) -> None:
    """Frames as fast as they are taken, in another session where one is ended."""
    while here.going:
        with suppress(OSError), Talk(here, UPGRADE, hello()) as talk:
            count = 0
            while here.going:
                talk.send(frames[count % len(frames)])
                talk.read(0.0)
                count += 1


def in_step(here: Here, sessions: int, first: bytes, frames: Sequence[bytes], every_s: float) -> None:
    """Sessions that each send one frame after another at a pace."""
    with ExitStack() as stack:
        talks = [stack.enter_context(Talk(here, UPGRADE, first)) for _ in range(sessions)]
        due, count = time.monotonic(), 0
        while here.going and talks:
            for talk in list(talks):
                try:
                    talk.send(frames[count % len(frames)])
                    talk.read(0.0)
                except OSError:
                    talks.remove(talk)
            due, count = due + every_s, count + 1
            time.sleep(max(0.0, due - time.monotonic()))


def moving(frames: int) -> list[bytes]:
    """The sample's events, 64 in a frame."""
    return [frame(BINARY, pack_events(events(0, 1000.0, 64 * number, 64))) for number in range(frames)]


CONFIGURE = frame(TEXT, b'{"type":"configure","parameters":{"gap_s":0.2}}')


def text(words: bytes) -> bytes:
    return frame(TEXT, words)


def targets(count: int) -> bytes:
    one = {"width": 30, "height": 30}
    many = [{"id": str(i), "x": 40 * (i % 40), "y": 40 * (i // 40), **one} for i in range(count)]
    return text(msgspec.json.encode({"type": "targets", "targets": many}))


def silent(here: Here) -> None:
    """More connections than descriptors, which say nothing."""
    here.keep_open(here.opened(MANY))


def slow_headers(here: Here) -> None:
    """Five hundred requests that go on by one byte each half second."""
    connections = here.opened(500, b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX: ")
    while here.going:
        for one in connections:
            with suppress(OSError):
                one.send(b"X")
        time.sleep(0.5)
    here.keep_open(connections)


def unread(here: Here) -> None:
    """Five hundred connections that ask for the largest file sixteen times and read nothing."""
    many = request(LARGEST).replace(b"Connection: close\r\n", b"") * 16
    here.keep_open(here.opened(500, many))


def requests(here: Here) -> None:
    """The largest file again and again."""
    again(here, [request(LARGEST)])


def long_queries(here: Here) -> None:
    """Requests with 30,000 empty parameters."""
    again(here, [request("/readyz?" + "&" * 30_000)])


def cross_site(here: Here) -> None:
    """A sample that another site's page asks for."""
    foreign = "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors\r\n"
    again(here, [request("/v1/samples/p01-0", headers=foreign)])


def metrics(here: Here) -> None:
    """Spellings of `/metrics`."""
    again(here, *([request(path)] for path in ("/metrics", "/metrics%0a", "/%6detrics")))


def bodies(here: Here) -> None:
    """POST with a body of 100 kB."""
    paths = ("/", "/v1/samples", "/v1/stream", "/v1/score", "/healthz")
    again(here, *([request(path, "POST", "Content-Length: 100000\r\n", b"x" * 100_000)] for path in paths))


def handshakes(here: Here) -> None:
    """One upgrade after another, each left once it is answered."""
    again(here, [UPGRADE], seconds=0.02)


def garbage(here: Here) -> None:
    """Upgrades with garbage behind them, every other one of another site's page."""
    foreign = UPGRADE.replace(b"\r\n\r\n", b"\r\nOrigin: http://evil.example\r\n\r\n")
    again(here, [foreign + b"\xff garbage" * 500], [UPGRADE + b"\xff garbage" * 500], seconds=0.1)


def closing(here: Here) -> None:
    """A close frame in the packet of the upgrade."""
    again(here, [UPGRADE + frame(CLOSE, (1000).to_bytes(2, "big"))], seconds=0.1)


def reconnecting(here: Here) -> None:
    """Clients that say hello with a known person, and connect again."""
    again(here, [UPGRADE, hello(here.person)], seconds=0.01)


def leaving(here: Here) -> None:
    """16 clients at a time that send 111 kB of events and leave."""
    frames = b"".join(moving(57))
    while here.going:
        with ExitStack() as stack:
            for _ in range(16):
                with suppress(OSError):
                    stack.enter_context(Talk(here, UPGRADE, hello(), frames))


def configured(here: Here) -> None:
    """16 sessions that know their person and send the most `configure` that is allowed, 25 a second."""
    in_step(here, 16, hello(here.person), [CONFIGURE], 0.12)


def configured_at_once(here: Here) -> None:
    """The same, 9 together each second."""
    in_step(here, 16, hello(here.person), [9 * CONFIGURE], 1.1)


def configured_faster(here: Here) -> None:
    """`configure` as fast as it is taken."""
    flood(here, CONFIGURE)


def targeted(here: Here) -> None:
    """A session with 256 targets that sends the most events that are allowed."""
    in_step(here, 1, hello() + targets(256), moving(200), 64 / 1176 * 1.02)


def targeted_16(here: Here) -> None:
    """16 such sessions."""
    in_step(here, 16, hello() + targets(256), moving(200), 64 / 1176 * 1.02)


def eventful(here: Here) -> None:
    """Events as fast as they are taken."""
    flood(here, *moving(1000))


def refused_targets(here: Here) -> None:
    """More targets than a session may have."""
    flood(here, targets(1100))


def odd_events(here: Here) -> None:
    """Packed events of random bits, NaN, huge numbers, and times that run backwards."""
    random = Random(31)
    odd = [random.randbytes(30 * random.randint(1, 64)) for _ in range(100)]
    for t, x in ((np.nan, 1.0), (1.0, np.nan), (np.inf, 1.0), (1e300, 1.0), (1.0, -1e308), (-1.0, 5.0)):
        odd.append(pack_events(np.array([[2.0, 1.0, 1.0, 1.0, 1.0, 0.0], [t, x, 1.0, 1.0, 1.0, 0.0]])))
    flood(here, *(frame(BINARY, one) for one in odd))


def mutated_persons(here: Here) -> None:
    """What is known of a person, with some letters replaced."""
    random, known = Random(31), here.person
    persons = []
    for _ in range(100):
        letters = list(known)
        for _ in range(random.randint(1, 4)):
            letters[random.randrange(len(letters))] = chr(random.randint(32, 126))
        persons.append(hello("".join(letters)) + moving(1)[0])
    again(here, *([UPGRADE, one] for one in persons), seconds=0.02)


def pings(here: Here) -> None:
    """Pings of the most bytes."""
    flood(here, frame(PING, b"x" * 125) * 200)


def odd_frames(here: Here) -> None:
    """Compressed frames, reserved bits, long pings, pings in pieces, no mask."""
    pieces = [bytes([Opcode.PING, 0x80]) + bytes(4)]
    reserved = [bytes([0x81 | bits]) + text(b"{}")[1:] for bits in (0x40, 0x20, 0x10)]
    flood(here, *reserved, *pieces, frame(PING, b"x" * 126), b"\x81\x02{}", b"\x82\xff" + b"\xff" * 8)


def fragments(here: Here) -> None:
    """Messages in 64 fragments."""
    middle = [Frame(Opcode.CONT, b"", fin=False)] * 62
    pieces = [Frame(Opcode.TEXT, b"{", fin=False), *middle, Frame(Opcode.CONT, b"")]
    flood(here, b"".join(one.serialize(mask=True) for one in pieces) * 4)


def bad_text(here: Here) -> None:
    """Text that is no UTF-8."""
    flood(here, text(b"\xed\xa0\x80"))


def nested(here: Here) -> None:
    """JSON of the most bytes, as deep as it is long."""
    flood(here, text(b"[" * 65_000))


def unknown(here: Here) -> None:
    """Messages of the most bytes with thousands of unknown parameters."""
    names = b",".join(b'"p%d":1' % number for number in range(5000))
    flood(here, text(b'{"type":"configure","parameters":{' + names + b"}}"))


def stopped(here: Here) -> None:
    """A client that sends frames of events, asks for every prediction, and stands still again and again."""
    context = multiprocessing.get_context("fork")
    ours, theirs = context.Pipe(False)
    eager = hello(reply="event") + targets(100)
    steady = partial(in_step, sessions=1, first=eager, frames=moving(800), every_s=64 / 5000)
    child = context.Process(target=carry_out, args=(steady, here, theirs))
    child.start()
    while here.going:
        for number, seconds in ((signal.SIGSTOP, 1.0), (signal.SIGCONT, 0.2)):
            time.sleep(seconds)
            os.kill(child.pid or 0, number)
    here.heard += ours.recv()
    child.join()


Attack = Callable[[Here], None]
ATTACKS: tuple[Attack, ...] = (
    *(silent, slow_headers, unread, requests, long_queries, cross_site, metrics, bodies),
    *(handshakes, garbage, closing, reconnecting, leaving, configured, configured_at_once, configured_faster),
    *(targeted, targeted_16, eventful, refused_targets, odd_events, mutated_persons),
    *(pings, odd_frames, fragments, bad_text, nested, unknown, stopped),
)
LONG = (slow_headers, unread)


def carry_out(attack: Attack, here: Here, result: Any) -> None:
    """In a process of its own, with as many descriptors as it may have."""
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))
    attack(here)
    result.send(here.heard)
