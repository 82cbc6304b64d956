"""What a service refuses, and what a session beside it notices: ``python -m evidence attacks attacked``.

A service runs with nginx before it, as in ``deploy/nginx.conf``, without TLS. A client sends an event each
10 ms, takes the time from when it was due to its prediction, and compares every prediction with an offline
run. Meanwhile another process does one of ``ATTACKS``, directly and then through nginx, from an address of
its own and with the token. All are done twice: the second time is shown, and what the service holds after
each time is compared. Needs Linux and nginx.
"""

from __future__ import annotations

import multiprocessing
import time
from collections import Counter
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from select import select
from tempfile import TemporaryDirectory

import msgspec
import numpy as np

from evidence.arguments import parse
from evidence.attacks.attackers import (
    ATTACKS,
    LONG,
    PREDICTOR,
    TOKEN,
    UPGRADE,
    Attack,
    Here,
    carry_out,
    hello,
)
from evidence.costs.load.servers import wait_until_ready
from evidence.costs.soak.sessions import BINARY, CPI, DPI, PING, PONG, events, frame, split
from evidence.costs.soak.verdicts import usage_of
from evidence.data import Table, keep
from evidence.machine import machine, processor_s
from pointpred import build
from pointpred.protocol.frames import pack_events, row_encoder
from tests.server.process import Served, served
from tests.server.reverse_proxies import proxy

SECONDS, LONG_S, BEFORE_S, EVERY_S = 3.0, 12.0, 1.0, 0.01
"""An attack lasts so long; one that waits for nginx's patience of 10 s to end, longer."""
FILES = 1024
"""Descriptors of the service; more connections than that are tried."""
WAYS = ("directly", "behind nginx")
MEASURED = ("p50 before", "p99 before", "p50", "p99", "processor", "MB before", "MB after")
"""Delays in ms, the share of a processor, memory."""
SETTLED_S = 12.0
"""By then a service has cut every connection that was left to it."""


class Attacker:
    """A process that attacks."""

    def __init__(self, attack: Attack, here: Here) -> None:
        context = multiprocessing.get_context("fork")
        self._name = attack.__name__
        self._result, theirs = context.Pipe(False)
        self._process = context.Process(target=carry_out, args=(attack, here, theirs))
        self._process.start()
        theirs.close()

    def finish(self) -> Counter[str]:
        """How often it was answered what; raises SystemExit where it failed, did not end or did nothing."""
        heard: Counter[str] = Counter()
        with suppress(EOFError):
            heard = self._result.recv() if self._result.poll(60) else heard
        self._process.join(60)
        self._process.kill()
        self._process.join()
        if self._process.exitcode != 0 or not heard:
            code = self._process.exitcode
            raise SystemExit(f"the attack '{self._name}' did nothing: exit code {code}, heard {dict(heard)}")
        return heard


class Innocent:
    """A session that keeps to the rules, and the offline run of its events."""

    def __init__(self, port: int) -> None:
        self.port, self._rest = port, b""
        self._pipeline, self._encode = build(PREDICTOR, cpi=CPI, dpi=DPI), row_encoder(binary=True)
        self._socket = Here(port, "127.0.0.2", 0.0).dial()
        greeting = hello(encoding="binary", device={"cpi": CPI}, screen={"dpi": DPI})
        self._socket.sendall(UPGRADE)
        assert self._socket.recv(2**16).startswith(b"HTTP/1.1 101")
        self._socket.sendall(greeting)
        assert b"welcome" in self._socket.recv(2**16)
        self.compared = self.different = 0

    def delays(self, seconds: float) -> np.ndarray:
        """Milliseconds from when each event was due to its prediction."""
        count = int(seconds / EVERY_S)
        tables = [events(0, 1 / EVERY_S, self.compared + number, 1) for number in range(count)]
        frames = [frame(BINARY, pack_events(table)) for table in tables]
        answers: list[bytes] = []
        result: list[float] = []
        sent, begin = 0, time.monotonic()
        while len(answers) < count:
            while sent < count and begin + sent * EVERY_S <= time.monotonic():
                self._socket.sendall(frames[sent])
                sent += 1
            pause = begin + sent * EVERY_S - time.monotonic() if sent < count else 60.0
            if select([self._socket], [], [], max(0.0, pause))[0]:
                answers += self._receive()
                at = time.monotonic()
                result += [1e3 * (at - begin - n * EVERY_S) for n in range(len(result), len(answers))]
        expected = [self._encode(self._pipeline.advance(tuple(table[0].tolist()))) for table in tables]
        self.compared += count
        self.different += sum(one != other for one, other in zip(answers, expected, strict=True))
        return np.array(result)

    def _receive(self) -> list[bytes]:
        part = self._socket.recv(2**16)
        if not part:
            raise SystemExit("the innocent session has ended")
        frames, self._rest = split(self._rest + part)
        if other := [payload for opcode, payload in frames if opcode not in (BINARY, PING)]:
            raise SystemExit(f"the innocent session was told {other}")
        for opcode, payload in frames:
            if opcode == PING:
                self._socket.sendall(frame(PONG, payload))
        return [payload for opcode, payload in frames if opcode == BINARY]


def shown(heard: Counter[str]) -> str:
    """The most frequent answers with their shares."""
    return ", ".join(
        f"{what} ({count / heard.total():.0%})" if count < heard.total() else what
        for what, count in heard.most_common(3)
        if count >= heard.total() / 100
    )


def attacked(attack: Attack, here: Here, innocent: Innocent, pid: int) -> tuple[Counter[str], list[str]]:
    """What an attack was answered; and delays before and meanwhile, share of a processor, memory."""
    memory = usage_of(pid, 0.0).memory_mb
    before = innocent.delays(BEFORE_S)
    seconds = LONG_S if attack in LONG else SECONDS
    here.until = time.monotonic() + seconds + 0.2
    attacker = Attacker(attack, here)
    used, began = processor_s(pid), time.monotonic()
    during = innocent.delays(seconds)
    share = (processor_s(pid) - used) / (time.monotonic() - began)
    heard = attacker.finish()
    delays = (np.quantile(part, at) for part in (before, during) for at in (0.5, 0.99))
    after = usage_of(pid, 0.0).memory_mb
    return heard, [*(f"{one:.1f}" for one in delays), f"{share:.2f}", f"{memory:.0f}", f"{after:.0f}"]


def held(pid: int) -> tuple[str, ...]:
    """Memory in MB, threads and descriptors of a service once whatever attacked it is gone."""
    time.sleep(SETTLED_S)
    usage = usage_of(pid, 0.0)
    return f"{usage.memory_mb:.1f}", str(usage.threads), str(usage.descriptors)


def attack_all(service: Served, port: int, attacks: Sequence[Attack]) -> None:
    """Attack a service twice, directly and behind the proxy at a port, and keep the tables."""
    where, pid = machine(load=True), service.process.pid
    learned = build(PREDICTOR, cpi=CPI, dpi=DPI)
    learned.push(events(0, 1 / EVERY_S, 0, 20_000))
    innocents = [Innocent(one) for one in (service.port, port)]
    usages = [("before", *held(pid))]
    for turn in ("once", "twice"):
        refused, beside = [], []
        for number, attack in enumerate(attacks):
            about, answers, numbers = " ".join((attack.__doc__ or "").split()).rstrip("."), [], []
            for way, innocent in zip(WAYS, innocents, strict=True):
                here = Here(innocent.port, f"127.0.{1 + WAYS.index(way)}.{1 + number}", 0.0, learned.person)
                heard, measured = attacked(attack, here, innocent, pid)
                answers += [str(heard.total()), shown(heard)]
                numbers += measured
            refused.append((about, *answers))
            beside.append((about, *numbers))
            print(*refused[-1], *numbers, sep=" | ", flush=True)
        usages.append((f"after all attacks, {turn}", *held(pid)))
    entries = [msgspec.json.decode(line) for line in service.log if line.startswith("{")]
    errors = [one for one in entries if one["level"] not in ("info", "warning")]
    print(*usages, *errors[:20], sep="\n")
    counts = {
        "seconds": SECONDS,
        "long_s": LONG_S,
        "files": FILES,
        "errors": len(errors),
        "compared": sum(one.compared for one in innocents),
        "different": sum(one.different for one in innocents),
    }
    tables = {
        "refused": Table.of(("attack", "times", WAYS[0], "times", WAYS[1]), refused),
        "beside": Table.of(("attack", *(f"{name} {way}" for way in WAYS for name in MEASURED)), beside),
        "held": Table.of(("", "memory, MB", "threads", "descriptors"), usages),
    }
    keep("attacks", tables, part="attacked", machine=where, numbers=counts)


def main(chosen: list[str]) -> None:
    attacks = [one for one in ATTACKS if one.__name__ in chosen or not chosen]
    words = ("--trust-proxy", "127.0.0.1", "--token", TOKEN)
    with TemporaryDirectory() as folder, served(*words, files=FILES) as service:
        wait_until_ready(f"{service.url}/")
        with proxy("nginx", Path(folder), [service.port] * 2, tls=False) as port:
            attack_all(service, port, attacks)


if __name__ == "__main__":
    main(parse(__doc__, metavar="ATTACK", choices=[one.__name__ for one in ATTACKS]))
