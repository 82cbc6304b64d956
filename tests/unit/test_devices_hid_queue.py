"""The queue between a reader thread and whoever takes: nothing blocks, and what is dropped is counted."""

from __future__ import annotations

import signal
import sys
import threading
from contextlib import suppress
from types import FrameType

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.devices.source import BoundedQueue, Report
from pointpred.errors import ParameterError


def report(number: int) -> Report:
    return Report(float(number), number, -number)


@given(st.integers(1, 6), st.lists(st.integers(0, 12), max_size=12))
def test_it_keeps_the_newest_in_order_and_counts_the_rest(most: int, bursts: list[int]) -> None:
    queue, number, taken, dropped = BoundedQueue(most), 0, [], 0
    expected = []
    for burst in bursts:
        sent = list(range(number, number + burst))
        number += burst
        for each in sent:
            queue.put(report(each))
        expected += sent[-most:]
        dropped += max(0, burst - most)
        taken += [int(each.t) for each in queue.take(0.0)]
    assert taken == expected
    assert queue.lost == dropped
    assert len(taken) + queue.lost == number


def test_take_wakes_when_something_comes_and_when_it_is_closed() -> None:
    queue, got = BoundedQueue(4), []
    for act in (lambda: queue.put(report(1)), queue.close):
        taker = threading.Thread(target=lambda: got.append(queue.take(60.0)))
        taker.start()
        act()
        taker.join(30.0)
        assert not taker.is_alive()
    assert [[each.t for each in taken] for taken in got] == [[1.0], []]
    queue.put(report(2))
    assert [each.t for each in queue.take(60.0)] == [2.0], "what is held can be taken after the end"


def test_two_threads_lose_nothing_between_them() -> None:
    queue, many, got = BoundedQueue(1 << 20), 20_000, []

    def put() -> None:
        for number in range(many):
            queue.put(report(number))
        queue.close()

    writer = threading.Thread(target=put)
    writer.start()
    while len(got) < many:
        got += [int(each.t) for each in queue.take(10.0)]
    writer.join()
    assert got == list(range(many))
    assert queue.lost == 0


def interrupt(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt


@pytest.mark.skipif(sys.platform == "win32", reason="it has no interval timers")
def test_an_interrupted_consumer_never_blocks_the_reader() -> None:
    """Ctrl-C arrives at any point of ``take``; the reader thread must be able to end afterwards."""
    queue, stopping = BoundedQueue(), threading.Event()

    def put() -> None:
        while not stopping.wait(2e-4):
            queue.put(report(0))

    reader = threading.Thread(target=put, daemon=True)
    reader.start()
    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        for number in range(3000):
            with suppress(KeyboardInterrupt):
                signal.setitimer(signal.ITIMER_REAL, 1e-5 * (1 + number % 60))
                while True:
                    queue.take(2e-4)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    stopping.set()
    reader.join(30.0)
    assert not reader.is_alive()


def test_a_queue_of_nothing_is_refused() -> None:
    with pytest.raises(ParameterError, match="at most 0 reports, expected at least 1"):
        BoundedQueue(0)
