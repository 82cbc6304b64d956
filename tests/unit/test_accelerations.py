"""Samples of an accelerometer stay beside their events, whatever is taken of these."""

from __future__ import annotations

import pickle
from itertools import chain, pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred import EventColumns
from pointpred.accelerations import Accelerations
from pointpred.errors import EventError
from pointpred.recording import Recording, Trial
from pointpred.records import FloatArray
from pointpred.scoring.trials import prepare


def events(count: int, start: float = 0.0) -> EventColumns:
    t = start + np.arange(count, dtype=np.float64)
    return EventColumns.of(t, 60.0 * t, 0.0 * t)


def samples(t: list[float]) -> FloatArray:
    table = np.zeros((len(t), 4))
    table[:, 0], table[:, 3] = t, 9.81
    return table


def beside(columns: EventColumns) -> list[list[float]]:
    """The times of the samples before each event since the one before."""
    ends = [0, *columns.accelerations.before.tolist()]
    times = columns.accelerations.table[:, 0].tolist()
    return [times[a:b] for a, b in pairwise(ends)]


def test_a_sample_stands_before_the_first_event_that_is_not_earlier() -> None:
    columns = events(3).sampled(samples([-1.0, 0.5, 1.0, 1.5, 2.5]))
    assert beside(columns) == [[-1.0], [0.5, 1.0], [1.5]]
    assert beside(events(2)) == [[], []]


@given(
    times=st.lists(st.integers(0, 12), max_size=30),
    cuts=st.lists(st.integers(0, 10), max_size=4),
    step=st.integers(1, 3),
)
def test_chunks_have_together_the_samples_of_the_whole(times: list[int], cuts: list[int], step: int) -> None:
    whole = events(10).sampled(samples([float(t) for t in sorted(times)]))
    ends = [0, *sorted(cuts), 10]
    chunks = [whole[a:b] for a, b in pairwise(ends)]
    assert [*chain.from_iterable(map(beside, chunks))] == beside(whole)
    thinned = whole[::step]
    last = range(0, 10, step)[-1]
    assert [*chain(*beside(thinned))] == [*chain(*beside(whole[: last + 1]))]
    joined = Accelerations.joined([chunk.accelerations for chunk in chunks])
    assert joined.before.tolist() == whole.accelerations.before.tolist()
    assert joined.table.tolist() == whole.accelerations.table.tolist()


def test_a_pickled_table_has_its_samples() -> None:
    whole = events(4).sampled(samples([0.5, 2.5]))
    assert beside(pickle.loads(pickle.dumps(whole))) == beside(whole) == [[], [0.5], [], [2.5]]


def test_trials_of_a_recording_have_their_own_samples() -> None:
    """The second trial's clock starts again, and the first one's last samples are not its own."""
    parts = [events(4).sampled(samples([-0.5, 0.5, 2.5])), events(5).sampled(samples([-0.25, 3.5]))]
    recording = Recording.of("two", parts, [Trial("ann", "1"), Trial("ann", "2")])
    assert [beside(recording.rows(k)) for k in (0, 1)] == [beside(part) for part in parts]
    assert beside(recording.part(1, 2).events) == beside(parts[1])
    columns = recording.events.chosen(np.array([1, 2, 6, 8]), np.array([True, False, True, False]))
    assert beside(columns) == [[-0.5, 0.5], [], [-0.25], [3.5]]


def test_the_scorer_keeps_the_samples_from_before_the_onset() -> None:
    t = np.arange(8) / 10.0
    path = EventColumns.of(t, [0, 1, 1, 40, 90, 130, 150, 150], 0.0 * t)
    part = path.sampled(samples([0.05, 0.15, 0.25, 0.45]))
    prepared = prepare(Recording.of("one", [part], [Trial("ann", "1")]))
    assert prepared.events.t.tolist()[0] == pytest.approx(0.2)
    assert beside(prepared.events)[:3] == [[0.05, 0.15], [0.25], []]


@pytest.mark.parametrize(
    ("table", "before", "words"),
    [
        (np.zeros((2, 3)), [0], r"samples need shape \(samples, 4\), received \(2, 3\)"),
        (np.zeros((2, 4)), [1, 0], r"before must rise from 0 to at most 2, received \[1, 0\]"),
        (np.zeros((2, 4)), [3], "before must rise from 0 to at most 2"),
        (np.zeros((2, 4)), [[1]], "one number an event"),
    ],
)
def test_what_does_not_fit_is_refused(table: Any, before: Any, words: str) -> None:
    with pytest.raises(EventError, match=words):
        Accelerations(table, before)


def test_another_number_of_events_and_a_slice_backwards_are_refused() -> None:
    with pytest.raises(EventError, match="accelerations need 10 events, received 2"):
        EventColumns(events(10).table, accelerations=Accelerations.none(2))
    whole = events(4).sampled(samples([0.5]))
    with pytest.raises(EventError, match="forwards, received a slice with step -1"):
        whole[::-1]
    assert len(events(4)[::-1]) == 4
