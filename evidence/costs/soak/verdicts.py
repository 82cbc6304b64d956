"""What a service holds, from /proc; and what a soak must show, judged from its measurements."""

from __future__ import annotations

import os
from collections import Counter
from pathlib import Path

import msgspec
import numpy as np

from evidence.costs.soak.players import VISITORS
from evidence.costs.soak.sessions import delay_of
from evidence.machine import processor_s

MEMORY_MB, DELAY_SHARE = 2.0, 0.2
WARM_S, WINDOW_S = 300.0, 300.0
POOL_THREADS = min(32, (os.cpu_count() or 1) + 4) + 2 + VISITORS
"""Threads that stay once they were needed: asyncio's, two for costly frames and trials, one a file sent."""


class Usage(msgspec.Struct):
    """What a service holds at a moment; ``at_s`` since the soak began."""

    at_s: float
    memory_mb: float
    threads: int
    descriptors: int
    processor_s: float


def usage_of(pid: int, at_s: float) -> Usage:
    """Look now; raises OSError where the process has ended."""
    folder = Path("/proc") / str(pid)
    lines = (folder / "status").read_text().splitlines()
    status = dict(line.split(":", 1) for line in lines if ":" in line)
    return Usage(
        at_s,
        int(status["RssAnon"].split()[0]) / 1024,
        int(status["Threads"]),
        sum(1 for _ in (folder / "fd").iterdir()),
        processor_s(pid),
    )


class Second(msgspec.Struct):
    """One look at the service, and the delays since the one before."""

    usage: Usage
    delays: dict[int, int]


class Verdict(msgspec.Struct):
    """One condition, and whether the run meets it."""

    condition: str
    wanted: str
    result: str
    holds: bool


def windows(seconds: list[Second]) -> tuple[list[Second], list[Second]]:
    """The first and the last minutes that are compared: five each after five of warm-up, or a third each."""
    lasted = seconds[-1].usage.at_s
    warm, window = min(WARM_S, lasted / 3), min(WINDOW_S, lasted / 3)
    first = [one for one in seconds if warm <= one.usage.at_s < warm + window]
    last = [one for one in seconds if one.usage.at_s >= lasted - window]
    return first, last


def percentile_ms(seconds: list[Second], percent: float) -> float:
    """A percentile of the delays, to 1 %; NaN where there are none."""
    delays: Counter[int] = Counter()
    for one in seconds:
        delays.update(one.delays)
    if not delays:
        return float("nan")
    bins = sorted(delays)
    reached = np.cumsum([delays[number] for number in bins])
    return 1e3 * delay_of(bins[int(np.searchsorted(reached, percent / 100 * reached[-1]))])


def judge(
    seconds: list[Second], wrong: list[str], counts: Counter[str], before: Usage, after: Usage, lost: int
) -> list[Verdict]:
    """Every verdict. ``before`` and ``after``: without clients; ``lost``: events that the recorder lost."""
    first, last = windows(seconds)

    def middle(part: list[Second], name: str) -> float:
        return float(np.median([getattr(one.usage, name) for one in part]))

    memory = [middle(part, "memory_mb") for part in (first, last)]
    verdicts = [
        Verdict(
            "memory after warm-up",
            f"at most {MEMORY_MB:+g} MB",
            f"{memory[0]:.1f} MB, then {memory[1]:.1f} MB: {memory[1] - memory[0]:+.1f} MB",
            memory[1] - memory[0] <= MEMORY_MB,
        )
    ]
    for name, left in (("threads", POOL_THREADS), ("descriptors", 0)):
        now, then = middle(first, name), middle(last, name)
        rest, end = getattr(before, name), getattr(after, name)
        most = max(1.0, 0.05 * now)  # how many connections there are at a moment is chance
        result = (
            f"{now:g}, then {then:g}: {then - now:+g}; without clients {rest}, then {end}: {end - rest:+d}"
        )
        verdicts.append(
            Verdict(
                f"{name} are constant",
                f"at most {most:+g}; without clients at most {left:+d}",
                result,
                abs(then - now) <= most and end <= rest + left,
            )
        )
    delay = [percentile_ms(part, 99) for part in (first, last)]
    verdicts.append(
        Verdict(
            "p99 of the last minutes, against the first",
            f"at most {DELAY_SHARE:+.0%}",
            f"{delay[0]:.2f} ms, then {delay[1]:.2f} ms: {delay[1] / delay[0] - 1:+.0%}",
            delay[1] <= (1 + DELAY_SHARE) * delay[0],
        )
    )
    compared = counts["predictions compared"]
    verdicts.append(
        Verdict(
            "every prediction and every recorded row is that of an offline run",
            "no complaint",
            f"{compared} predictions and {counts['events sent']} events compared, {len(wrong)} complaints",
            not wrong and compared > 0,
        )
    )
    verdicts.append(Verdict("the recorder loses nothing", "0 events", f"{lost} events lost", lost == 0))
    return verdicts
