"""The knee of a curve, and when a delay counts as growing, by the rules that the page states."""

from __future__ import annotations

import msgspec
import pytest

from evidence.costs.load.curves import Point, grows, knee, middle
from evidence.costs.load.generator import Counts

QUIET = {"count": 8, "p50_ms": 0.1, "p90_ms": 0.1, "p99_ms": 0.2, "p999_ms": 0.3, "max_ms": 0.3}


def counts(*medians: float, unanswered: int = 0) -> Counts:
    words = dict.fromkeys(("sent", "answered", "answers", "repeated", "measured"), 8)
    windows = [{"p50_ms": median, "p99_ms": median} for median in medians]
    return msgspec.convert(
        {
            **words,
            "name": "",
            "unanswered": unanswered,
            "texts": {},
            "closes": {},
            "server_s": [],
            "delay": QUIET,
            "late": QUIET,
            "windows": windows,
            "turns_us": [],
        },
        Counts,
    )


def point(clients: int, p99_ms: float, *, growing: bool = False) -> Point:
    delays = (0.1, p99_ms, p99_ms, growing)
    return Point("this build", "`hold`", 1, clients, *delays, 20.0, 1.0, 0.2, 0.01, {})


@pytest.mark.parametrize(
    ("medians", "unanswered", "expected"),
    [
        ((0.1, 0.1, 0.2, 9.0), 0, False),  # short of what counts
        ((10.0, 20.0, 30.0, 40.0), 0, True),
        ((30.0, 30.0, 30.0, 40.0), 0, False),  # long, and stays so
        ((0.1, 0.1, 0.1, 0.1), 1, True),
    ],
)
def test_when_a_delay_grows(medians: tuple[float, ...], unanswered: int, expected: bool) -> None:
    assert grows(counts(*medians, unanswered=unanswered)) is expected


def test_the_knee_ends_at_the_first_number_of_clients_beyond_the_bound() -> None:
    curve = [point(1, 0.3), point(10, 0.9), point(20, 1.2), point(30, 0.8), point(40, 90.0, growing=True)]
    assert knee(reversed(curve)) == (10, 40)
    assert knee(curve[:1]) == (1, None)
    assert knee([point(1, 3.0)]) == (0, None)


def test_the_run_that_is_shown_is_neither_the_best_nor_the_worst() -> None:
    assert middle([point(10, 0.9), point(10, 0.2), point(10, 7.0)]).p99_ms == 0.9
