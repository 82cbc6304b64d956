"""Since when what is read can have waited: by how long the event loop was busy before."""

from __future__ import annotations

from pointpred_server.arrivals import Arrivals


def test_a_loop_that_waited_reads_at_once() -> None:
    arrivals = Arrivals()
    assert arrivals.since(1.0, 1) == 1.0
    arrivals.busy_until = 1.0001
    assert arrivals.since(2.0, 2) == 2.0


def test_what_a_busy_loop_reads_can_have_come_since_it_read_before() -> None:
    arrivals = Arrivals()
    for turn in range(3):  # each turn reads twice and takes 0.2 s
        begun = 1.0 + 0.2 * turn
        for now in (begun, begun + 0.1):
            expected = begun if turn == 0 else begun - 0.2
            assert abs(arrivals.since(now, turn) - expected) < 1e-9
            arrivals.busy_until = now + 0.1
