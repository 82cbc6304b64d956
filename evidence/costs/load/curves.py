"""Delay against the number of clients, every series in turns; and more clients than a core can serve."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import msgspec

from evidence.costs.load.generator import Counts, Group, Plan, hello, run
from evidence.costs.load.servers import Server
from evidence.machine import LAST

RATE_HZ = 1000.0
LOADS = {1: "1 kHz", 8: "8 kHz in frames of 8"}
"""Events a frame, at 1000 frames a second and client."""
CLIENTS = {1: (1, 5, 10, 20, 30, 40, 50, 60, 80), 8: (1, 5, 10, 15, 20, 30)}
BOUND_MS = 1.0
"""The knee is the largest number of clients with 99 % of the answers within this, as with any fewer."""
HOPELESS_MS = 200.0
"""A series ends where its p99 is beyond this: more clients only wait longer."""
GROWTH, GROWN_MS = 2.0, 10.0
"""The delay grows where its median in the last quarter is twice that of the first or more, and above this."""
PARTS = 4
CROWDS = (("switched", 60, 1), ("kinematic-adaptive", 50, 8))
"""Predictor, clients, events a frame: the wanted number, and one beyond what a core can serve."""
WINDOWS = 6


class Series(msgspec.Struct, frozen=True):
    """What answers: a build, with a predictor; ``""`` is an echo."""

    build: str
    server: Server
    predictor: str

    @property
    def name(self) -> str:
        """What answers, without the build."""
        return f"`{self.predictor}`" if self.predictor else "ASGI echo"


class Point(msgspec.Struct, frozen=True):
    """One number of clients of a series."""

    build: str
    name: str
    size: int
    clients: int
    p50_ms: float
    p99_ms: float
    p999_ms: float
    grows: bool
    server_us: float
    answers: float
    """Answers for each frame: below 1 where one answer was for several."""
    own_share: float
    late_ms: float
    notices: dict[str, int]


def group(series: Series, clients: int, size: int) -> Group:
    """The clients of a point."""
    greeting = (hello(series.predictor),) if series.predictor else ()
    kind = "stream" if series.predictor else "echo"
    where = series.server
    return Group(
        series.name, where.port, where.pids, kind, clients=clients, rate=RATE_HZ, size=size, greeting=greeting
    )


def grows(counts: Counts) -> bool:
    """Whether the delay grew during a run."""
    if counts.unanswered or len(counts.windows) < PARTS:
        return True
    first, last = counts.windows[0].p50_ms, counts.windows[PARTS - 1].p50_ms
    return last > GROWN_MS and last > GROWTH * first


def measured(series: Series, clients: int, size: int, seconds: float) -> Point:
    """One run."""
    plan = Plan((group(series, clients, size),), seconds, warm=0.3, drain=2.0, window=seconds / PARTS)
    result = run(plan, LAST)
    (counts,) = result.groups
    delay = counts.delay
    return Point(
        series.build,
        series.name,
        size,
        clients,
        delay.p50_ms,
        delay.p99_ms,
        delay.p999_ms,
        grows(counts),
        counts.server_us,
        counts.answers / max(counts.answered, 1),
        result.own_share,
        counts.late.p99_ms,
        counts.texts | counts.closes,
    )


def curves(series: Sequence[Series], rounds: int, seconds: float) -> list[Point]:
    """Every series by the number of clients; of an odd number of rounds the one with the median p99."""
    points: list[Point] = []
    for size, numbers in CLIENTS.items():
        remaining = list(series)
        for clients in numbers:
            if not remaining:
                break
            runs = [[measured(one, clients, size, seconds) for one in remaining] for _ in range(rounds)]
            middles = [middle(some) for some in zip(*runs, strict=True)]
            points += middles
            remaining = [
                one for one, point in zip(remaining, middles, strict=True) if point.p99_ms < HOPELESS_MS
            ]
            print(
                f"{LOADS[size]}, {clients} clients: p99 " + ", ".join(f"{p.p99_ms:.2f}" for p in middles),
                flush=True,
            )
    return points


def middle(runs: Sequence[Point]) -> Point:
    """The run with the median p99; of an even number the longer one of the two."""
    return sorted(runs, key=lambda point: point.p99_ms)[len(runs) // 2]


def knee(points: Iterable[Point]) -> tuple[int, int | None]:
    """The largest number of clients within the bound, 0 for none; the first with which the delay grows."""
    ordered = sorted(points, key=lambda point: point.clients)
    within = 0
    for point in ordered:
        if point.p99_ms > BOUND_MS:
            break
        within = point.clients
    return within, next((point.clients for point in ordered if point.grows), None)


class Overload(msgspec.Struct, frozen=True):
    """Some time of too many clients."""

    clients: str
    build: str
    p99_ms: list[float]
    """By part of the run."""
    answered: float
    """Share of the frames that an answer covered before the end of the drain."""
    answers: float
    """Answers for each frame answered."""
    server_us: float
    own_share: float
    """The generator's share of its core."""
    notices: dict[str, int]


def overload(series: Sequence[Series], seconds: float) -> list[Overload]:
    """Every crowd, on each build that is measured with its predictor."""
    rows = []
    for predictor, clients, size in CROWDS:
        for one in (some for some in series if some.predictor == predictor):
            plan = Plan((group(one, clients, size),), seconds, warm=0.5, drain=10.0, window=seconds / WINDOWS)
            result = run(plan, LAST)
            (counts,) = result.groups
            rows.append(
                Overload(
                    f"{clients} of {one.name}, {LOADS[size]}",
                    one.build,
                    [window.p99_ms for window in counts.windows[:WINDOWS]],
                    counts.answered / (counts.answered + counts.unanswered),
                    counts.answers / max(counts.answered, 1),
                    counts.server_us,
                    result.own_share,
                    counts.texts | counts.closes,
                )
            )
            print(rows[-1], flush=True)
    return rows
