"""More clients than a core can serve, for a minute: whether the delay grows, and who is told."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec

from benchmarks.load.cores import LAST
from benchmarks.load.generator import Plan, run
from pages.load.curves import Series, group

CLIENTS, WINDOWS = 60, 6


class Overload(msgspec.Struct, frozen=True):
    """A minute of too many clients."""

    build: str
    p99_ms: list[float]
    """By part of the run."""
    answered: float
    """Share of the frames that an answer covered before the end of the drain."""
    answers: float
    """Answers for each frame answered."""
    server_us: float
    notices: dict[str, int]


def overload(series: Sequence[Series], seconds: float) -> list[Overload]:
    """``CLIENTS`` at 1 kHz, on each build."""
    rows = []
    for one in series:
        plan = Plan((group(one, CLIENTS, 1),), seconds, warm=0.5, drain=10.0, window=seconds / WINDOWS)
        (counts,) = run(plan, LAST).groups
        rows.append(
            Overload(
                one.build,
                [window.p99_ms for window in counts.windows[:WINDOWS]],
                counts.answered / (counts.answered + counts.unanswered),
                counts.answers / max(counts.answered, 1),
                counts.server_us,
                counts.texts | counts.closes,
            )
        )
        print(rows[-1], flush=True)
    return rows
