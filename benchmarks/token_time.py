"""Whether the time of a refusal tells how much of a guess is right: ``python -m benchmarks.token_time``.

Guesses that differ from the token in the first and in the last letter are checked in turns, in batches, by
the function that the service uses. The difference of their medians stands beside its 95 % interval,
resampled over the rounds. Beside it, one guess in both places shows what places in memory do, and a
comparison letter by letter what the method would see. Writes ``pages/attacks/tokens.json``.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

from benchmarks.machine import machine
from pages.arguments import parse
from pages.data import Table, keep
from pointpred_server.access import has_token

TOKEN = "a-token-of-24-characters"
FIRST, LAST = "x" + TOKEN[1:], TOKEN[:-1] + "x"
ROUNDS, BATCH, RESAMPLES = 4000, 50, 2000
COLUMNS = (
    "comparison",
    "first letter wrong, ns",
    "last letter wrong, ns",
    "difference, ns",
    "95 % interval, ns",
)


def check(token: str) -> Callable[[], bool]:
    """The check of the service, for a request with this token."""
    scope = {"query_string": b"", "headers": [(b"authorization", b"Bearer " + token.encode())]}
    return lambda: has_token(scope, TOKEN)


def letters(token: str) -> Callable[[], bool]:
    """A comparison that ends at the first wrong letter, for comparison."""

    def equal() -> bool:
        return all(one == other for one, other in zip(token, TOKEN, strict=True))

    return equal


def times(ways: list[Callable[[], bool]]) -> np.ndarray:
    """Nanoseconds of one call, a row a round: the ways in turns, the first one in turn as well."""
    result = np.empty((ROUNDS, len(ways)))
    for row in range(ROUNDS):
        for step in range(len(ways)):
            at = (row + step) % len(ways)
            way, begin = ways[at], time.perf_counter_ns()
            for _ in range(BATCH):
                way()
            result[row, at] = (time.perf_counter_ns() - begin) / BATCH
    return result


def row(name: str, first_way: Callable[[], bool], last_way: Callable[[], bool]) -> tuple[str, ...]:
    """One line of the table."""
    measured = times([first_way, last_way])
    generator = np.random.default_rng(17)
    differences = [
        np.subtract(*np.median(measured[generator.integers(0, ROUNDS, ROUNDS)], axis=0)[::-1])
        for _ in range(RESAMPLES)
    ]
    first, last = np.median(measured, axis=0)
    low, high = np.quantile(differences, [0.025, 0.975])
    return name, f"{first:.0f}", f"{last:.0f}", f"{last - first:.1f}", f"{low:.1f} to {high:.1f}"


def main() -> None:
    rows = [
        row("of the service", check(FIRST), check(LAST)),
        row("of the service, one guess as both", check(FIRST), check(FIRST)),
        row("letter by letter", letters(FIRST), letters(LAST)),
    ]
    for one in rows:
        print(*one, sep=", ")
    numbers = {"checks": ROUNDS * BATCH}
    keep("attacks", {"tokens": Table.of(COLUMNS, rows)}, part="tokens", machine=machine(), numbers=numbers)


if __name__ == "__main__":
    parse(__doc__)
    main()
