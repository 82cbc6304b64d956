"""Counts and cursor joined by time, against a cursor whose whole way is known."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.devices.cursor_paths import Pairing
from pointpred.devices.source import Report
from pointpred.errors import ParameterError
from pointpred.records import EventColumns, PointerEvent
from pointpred.reproduction.transfer_functions import CPI, DPI, gain_error, simulate_trials
from pointpred.transfer import SigmoidGain, TransferFunction, TransferLearner


class Scripted:
    """A cursor and a clock that a test moves; each look takes 0.2 ms."""

    def __init__(self) -> None:
        self.now, self.place = 0.0, (0.0, 0.0)

    def clock(self) -> float:
        return self.now

    def position(self) -> tuple[float, float]:
        self.now += 0.0002
        return self.place


def test_every_report_gets_the_place_the_cursor_had_after_it() -> None:
    cursor = Scripted()
    pairing = Pairing(cursor, clock=cursor.clock)
    pairing.events([])
    got, wanted = [], []
    for i in range(1, 200):
        x, y = 100.0 + 3.0 * i, 50.0 - i * i
        cursor.now, cursor.place = 0.001 * i, (x, y)
        got += pairing.events([Report(0.001 * i, 6, -i, buttons=i % 2)])
        wanted.append(PointerEvent(0.001 * i, x, y, 6.0, -float(i), i % 2))
    assert got == wanted
    assert (pairing.unpaired, pairing.corrections) == (0, 0)


def test_reports_that_waited_share_the_way_by_their_counts() -> None:
    cursor = Scripted()
    pairing = Pairing(cursor, clock=cursor.clock)
    pairing.events([])
    cursor.now, cursor.place = 1.0, (40.0, -20.0)
    events = pairing.events(
        [Report(0.2, 3, 4), Report(0.9, 0, 0, 1), Report(0.95, 15, 0), Report(0.99, 0, 0)]
    )
    assert [(e.x, e.y) for e in events] == [(10.0, -5.0), (10.0, -5.0), (40.0, -20.0), (40.0, -20.0)]
    cursor.now, cursor.place = 2.0, (41.0, -20.0)
    still = pairing.events([Report(1.5, 0, 0, 1), Report(1.6, 0, 0, 0)])  # something else moved the cursor
    assert [(e.x, e.dx, e.buttons) for e in still] == [(41.0, 0.0, 1), (41.0, 0.0, 0)]


def test_a_report_after_the_look_waits_for_the_next() -> None:
    cursor = Scripted()
    pairing = Pairing(cursor, delay_s=0.01, clock=cursor.clock)
    cursor.now, cursor.place = 1.0, (5.0, 0.0)
    assert [e.t for e in pairing.events([Report(0.98, 1, 0), Report(0.995, 1, 0), Report(0.996, 2, 0)])] == [
        0.98
    ]
    cursor.now, cursor.place = 1.01, (8.0, 0.0)
    assert [(e.t, e.x) for e in pairing.events([])] == [(0.995, 6.0), (0.996, 8.0)]


def test_a_cursor_that_comes_late_corrects_the_last_place_once() -> None:
    cursor = Scripted()
    pairing = Pairing(cursor, clock=cursor.clock)
    pairing.events([])
    cursor.now = 1.0
    first = pairing.events([Report(0.999, 7, 0, 1)])
    cursor.now, cursor.place = 1.1, (3.0, 0.0)
    assert pairing.events([]) == [PointerEvent(0.999, 3.0, 0.0, 0.0, 0.0, 1)]
    assert pairing.events([]) == []
    assert first == [PointerEvent(0.999, 0.0, 0.0, 7.0, 0.0, 1)]
    assert pairing.corrections == 1


def test_reports_of_another_clock_do_not_pile_up() -> None:
    cursor = Scripted()
    pairing = Pairing(cursor, most=2, clock=cursor.clock)
    events = pairing.events([Report(1e9 + i, 1, 0) for i in range(5)])
    assert [e.t - 1e9 for e in events] == [0.0, 1.0, 2.0]
    assert pairing.unpaired == 3


def test_a_delay_without_sense_is_refused() -> None:
    for delay_s in (-0.1, 1.1, float("nan")):
        with pytest.raises(ParameterError, match=r"delay_s must lie in \[0, 1\] s"):
            Pairing(Scripted(), delay_s=delay_s)
    with pytest.raises(ParameterError, match="most"):
        Pairing(Scripted(), most=0)


steps = st.lists(
    st.tuples(st.floats(0.0, 0.01), st.integers(-9, 9), st.integers(-9, 9), st.booleans()),
    min_size=1,
    max_size=40,
)


@given(steps, st.sampled_from([0.0, 0.004]))
def test_whatever_comes_when_no_count_is_lost_and_order_stays(
    made: list[tuple[float, int, int, bool]], delay_s: float
) -> None:
    cursor, waiting, got, t = Scripted(), [], [], 0.0
    pairing = Pairing(cursor, delay_s=delay_s, clock=cursor.clock)
    for dt, dx, dy, look in made:
        t += dt
        waiting.append(Report(t, dx, dy))
        cursor.now, cursor.place = max(cursor.now, t), (cursor.place[0] + 2 * dx, cursor.place[1] + 2 * dy)
        if look:
            got += pairing.events(waiting)
            waiting = []
    cursor.now = t + 1.0
    got += pairing.events(waiting)
    table = EventColumns.of_events(got).table
    assert (np.diff(table[:, 0]) >= 0.0).all()
    assert table[:, 3:5].sum(axis=0).tolist() == [sum(m[1] for m in made), sum(m[2] for m in made)]
    assert tuple(table[-1, 1:3]) == cursor.place


LATE_S = 0.008


def paired(function: TransferFunction, delay_s: float) -> EventColumns:
    """Trials through a function on a screen that is 8 ms late, looked at after every report."""
    cursor = Scripted()
    pairing, got, begin = Pairing(cursor, delay_s=delay_s, clock=cursor.clock), [], 0.0
    for trial in simulate_trials(function, 31, 32):
        table = trial.table
        cursor.now, cursor.place = begin, tuple(table[0, 1:3])
        got += pairing.events([])
        for t, _, _, dx, dy, _ in table.tolist():
            cursor.now = begin + t
            shown = max(int(np.searchsorted(table[:, 0], t - LATE_S, side="right")) - 1, 0)
            cursor.place = tuple(table[shown, 1:3])
            got += pairing.events([Report(begin + t, dx, dy)])
        cursor.now, cursor.place, begin = begin + t + LATE_S, tuple(table[-1, 1:3]), begin + t + 0.5
        got += pairing.events([])
    return EventColumns.of_events(got)


def learnt_error(events: EventColumns, truth: TransferFunction) -> float:
    learner = TransferLearner(cpi=CPI, dpi=DPI)
    for event in events.events():
        learner.update(event)
    found = learner.identify().function
    assert found is not None
    return gain_error(found, truth).largest


def test_a_late_screen_is_allowed_for() -> None:
    late, allowed = (learnt_error(paired(SigmoidGain(), d), SigmoidGain()) for d in (0.0, LATE_S + 0.0005))
    assert allowed < 0.8 * late
