"""Properties of every differentiator under any sequence of usable events."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred import EventColumns
from pointpred.differentiators import DIFFERENTIATORS, sampling
from pointpred.records import event_row

NAMES = list(DIFFERENTIATORS)
INTERVALS = st.sampled_from([0.0, 1e-9, 1e-6, 2.0**-13, 0.001, 0.008, 1 / 60, 0.09, 0.11, 0.31, 5.0])
POSITIONS = st.sampled_from([0.0, 1.0, -1.0, 40.0, 1e6, -1e9, 1e9]) | st.floats(-2000.0, 2000.0)


@st.composite
def tables(draw: st.DrawFn) -> EventColumns:
    """Events of any spacing, some with counts, some with buttons, time never backwards."""
    count = draw(st.integers(1, 60))
    intervals = draw(st.lists(INTERVALS, min_size=count, max_size=count))
    table = np.full((count, 6), np.nan)
    table[:, 0] = np.cumsum(intervals) + draw(st.sampled_from([0.0, -3.0, 1e6]))
    for column in (1, 2):
        table[:, column] = draw(st.lists(POSITIONS, min_size=count, max_size=count))
    for row in draw(st.sets(st.integers(0, count - 1))):
        table[row, 3:5] = draw(st.integers(-3000, 3000)), draw(st.integers(-3000, 3000))
    table[:, 5] = draw(st.lists(st.integers(0, 3), min_size=count, max_size=count))
    begin = np.array(draw(st.lists(st.booleans(), min_size=count, max_size=count))) & draw(st.booleans())
    return EventColumns(table, begin)


@pytest.mark.parametrize("name", NAMES)
@settings(deadline=None, max_examples=60, derandomize=True)
@given(events=tables(), cut=st.integers(0, 60))
def test_chunks_equal_the_whole_streaming_equals_columns_and_nothing_is_nan(
    name: str, events: EventColumns, cut: int
) -> None:
    whole = DIFFERENTIATORS[name](cpi=1600.0).run(events).table
    assert np.isfinite(whole).all()
    split = DIFFERENTIATORS[name](cpi=1600.0)
    parts = [split.run(events.rows(0, cut)).table, split.run(events.rows(cut, len(events))).table]
    assert np.array_equal(np.concatenate(parts), whole)
    streamed = DIFFERENTIATORS[name](cpi=1600.0)
    for row, begins, event in zip(whole, events.begin, events.events(), strict=True):
        if begins:
            streamed.reset()
        assert np.array_equal(row, np.array(streamed.advance(event_row(event)), dtype=np.float64))


@pytest.mark.parametrize("name", NAMES)
@settings(deadline=None, max_examples=40, derandomize=True)
@given(events=tables())
def test_start_and_restart_follow_the_rules(name: str, events: EventColumns) -> None:
    """The flags from the table alone, by rules written out a second time."""
    motions = DIFFERENTIATORS[name]().run(events)
    for row in range(len(events)):
        new = row == 0 or bool(events.begin[row])
        waited = 0.0 if new else events.t[row] - events.t[row - 1]
        released = not new and bool(int(events.buttons[row - 1]) & ~int(events.buttons[row]))
        assert motions.start[row] == float(new or waited > 0.3 or released)
        if new or waited > 0.1:
            assert not motions.table[row, 3:8].any()
        assert motions.counts[row] == 0.0


@pytest.mark.parametrize("name", NAMES)
@settings(deadline=None, max_examples=40, derandomize=True)
@given(events=tables())
def test_mirroring_and_exchanging_the_axes_does_the_same_to_the_motion(
    name: str, events: EventColumns
) -> None:
    one = DIFFERENTIATORS[name]().run(events)
    table = events.table.copy()
    table[:, 1], table[:, 2] = -events.y, events.x
    turned = DIFFERENTIATORS[name]().run(EventColumns(table, events.begin))
    assert np.array_equal(turned.vx, -one.vy)
    assert np.array_equal(turned.ay, one.ax)


@settings(deadline=None, max_examples=100, derandomize=True)
@given(events=tables())
def test_motor_position_is_the_sum_of_what_was_moved_since_the_restart(events: EventColumns) -> None:
    rules = np.array([0.0254 / 800.0, 0.0254 / 96.0, 0.1, 0.3])
    state = sampling.State(np.zeros(sampling.State.length))
    sums: list[float] = []
    seen = 0.0
    for t, x, y, dx, dy, buttons in events.table:
        before_x = state.x
        verdict, _, before, _, _ = sampling.accept(rules, state.memory, (t, x, y, dx, dy, buttons))
        moved = dx * 0.0254 / 800.0 if dx == dx else (x - before_x) * 0.0254 / 96.0
        if verdict == sampling.RESTARTED:
            sums, seen = [], 0.0
            continue
        sums.append(moved)
        if verdict == sampling.MOVED:
            assert before == seen
            seen = state.u
        assert state.u == pytest.approx(sum(sums), rel=1e-9, abs=1e-6)
