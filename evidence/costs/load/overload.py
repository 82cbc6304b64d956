"""As many clients as are wanted, and more than a core can serve: whether the delay grows, and who is told."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec

from benchmarks.load.cores import LAST
from benchmarks.load.generator import Plan, run
from pages.load.curves import LOADS, Series, group

CROWDS = (("switched", 60, 1), ("kinematic-adaptive", 50, 8))
"""Predictor, clients, events a frame: the wanted number, and one beyond what a core can serve."""
WINDOWS = 6


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
