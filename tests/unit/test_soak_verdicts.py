"""What a soak takes for a leak in the service."""

from __future__ import annotations

import subprocess
import sys
from collections import Counter

import pytest
from msgspec.structs import replace

from evidence.costs.soak.verdicts import POOL_THREADS, Second, Usage, judge, usage_of

REST = Usage(0.0, 200.0, 10, 20, 0.0)
HELD = "held = bytearray(b'a' * 50_000_000); print(flush=True); input()"


def failed(seconds: list[Second], after: Usage) -> list[str]:
    """The conditions that do not hold."""
    verdicts = judge(seconds, [], Counter({"predictions compared": 1}), REST, after, 0)
    return [one.condition for one in verdicts if not one.holds]


def an_hour(**growth: float) -> list[Second]:
    """A look each 10 s; what grows has grown by so much at the end."""
    return [
        Second(
            replace(
                REST, at_s=at, **{name: getattr(REST, name) + by * at / 3600 for name, by in growth.items()}
            ),
            {100: 5},
        )
        for at in range(0, 3601, 10)
    ]


def test_nothing_grows() -> None:
    assert failed(an_hour(), replace(REST, threads=REST.threads + POOL_THREADS)) == []


def test_memory_that_grows_is_seen() -> None:
    (condition,) = failed(an_hour(memory_mb=10.0), REST)
    assert condition.startswith("memory")


@pytest.mark.parametrize(("name", "left"), [("threads", POOL_THREADS + 1), ("descriptors", 1)])
def test_what_is_left_without_clients_is_seen(name: str, left: int) -> None:
    (condition,) = failed(an_hour(), replace(REST, **{name: getattr(REST, name) + left}))
    assert condition.startswith(name)


def test_what_a_process_holds_is_measured() -> None:
    """One that holds 50 MB."""
    with subprocess.Popen(
        [sys.executable, "-c", HELD], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        process.stdout.readline()
        usage = usage_of(process.pid, 0.0)
        process.communicate(b"\n")
    assert 50.0 < usage.memory_mb < 100.0
    assert usage.threads == 1
