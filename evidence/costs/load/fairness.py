"""What clients notice of another one that costs as much as it may."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import msgspec

from benchmarks.load.cores import LAST
from benchmarks.load.costly import CostlyClient, costly_clients, person, targets, upload
from benchmarks.load.generator import Group, Plan, run
from benchmarks.load.movements import hello
from benchmarks.load.servers import Server

FRAMES_HZ = 25.0
"""Costly frames a second of a client that is measured, few enough to leave the core to the others."""
TRIAL_S, LEAST_RATE = 1.5, 0.1
"""A client whose session is ended in this time uses half the rate next, down to this one."""


class Beside(msgspec.Struct, frozen=True):
    """What one kind of client did to the others; delays by the name of the other client."""

    name: str
    sent_per_s: float
    delays: dict[str, tuple[float, float, float]]
    """p50, p99 and the largest, ms."""
    server_share: float
    answers: dict[str, int]
    ended: bool
    """Whether the service ended a session of that kind."""


def group(server: Server, client: CostlyClient, rate: float) -> Group:
    """A client of a kind."""
    words = {"greeting": client.greeting, "messages": client.messages}
    return Group(client.name, server.port, kind="script", rate=rate, **words)


class Innocent(msgspec.Struct, frozen=True):
    """A client that is measured."""

    name: str
    rate: float
    size: int
    greeting: tuple[str | bytes, ...]


@cache
def innocents() -> tuple[Innocent, ...]:
    """Two clients with one event a frame, and two whose frames go to the thread of the costly ones."""
    plain, adaptive = hello("switched"), hello("kinematic-adaptive", person=person(), places=True)
    return (
        Innocent("125 Hz", 125.0, 1, (plain,)),
        Innocent("1000 Hz", 1000.0, 1, (plain,)),
        Innocent("8 events with 1,000 targets", FRAMES_HZ, 8, (plain, targets(0))),
        Innocent("16 events with places", FRAMES_HZ, 16, (adaptive,)),
    )


def measured(server: Server) -> tuple[Group, ...]:
    """The clients that are measured."""
    return tuple(
        Group(one.name, server.port, server.pids, rate=one.rate, size=one.size, greeting=one.greeting)
        for one in innocents()
    )


def beside(server: Server, others: tuple[Group, ...], name: str, seconds: float) -> Beside:
    """The innocent clients beside others."""
    plan = Plan((*measured(server), *others), seconds, warm=1.0, drain=2.0)
    counts = run(plan, LAST).groups
    ours, theirs = counts[: len(innocents())], counts[len(innocents()) :]
    return Beside(
        name,
        sum(one.sent for one in theirs) / (plan.seconds + plan.warm),
        {one.name: (one.delay.p50_ms, one.delay.p99_ms, one.delay.max_ms) for one in ours},
        sum(ours[0].server_s) / seconds,
        {kind: count for one in theirs for kind, count in one.texts.items()},
        any(one.closes for one in theirs),
    )


def beside_costly(server: Server, client: CostlyClient, seconds: float) -> Beside:
    """Beside a client at the largest of ``client.rate``, half of it, ... at which its session goes on."""
    rate = client.rate
    while True:
        others = (group(server, client, rate),)
        trial = run(Plan(others, TRIAL_S, warm=0.1, drain=0.0), LAST).groups[0]
        if not trial.closes and not (result := beside(server, others, client.name, seconds)).ended:
            return result
        rate /= 2
        if rate < LEAST_RATE:
            raise SystemExit(f"{client.name}: the service ends the session at any rate: {trial}")


@contextmanager
def uploads(server: Server) -> Iterator[None]:
    """Somebody has recordings scored, one after another."""
    over, body = threading.Event(), upload()
    url = f"http://127.0.0.1:{server.port}/v1/score?predictors=switched,kinematic"

    def post() -> None:
        while not over.is_set():
            try:
                with urlopen(Request(url, body)) as answer:
                    answer.read()
            except HTTPError as error:
                error.read()

    thread = threading.Thread(target=post)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


def fairness(server: Server, seconds: float) -> list[Beside]:
    """Every kind of client, after nobody; all on one server."""
    rows = [beside(server, (), "nobody", seconds)]
    for client in costly_clients():
        rows.append(beside_costly(server, client, seconds))
        print(f"beside {client.name}: {rows[-1].delays}", flush=True)
    with uploads(server):
        rows.append(beside(server, (), "recordings sent to `/v1/score`", seconds))
    rows.append(beside(server, (), "nobody, afterwards", seconds))
    return rows
