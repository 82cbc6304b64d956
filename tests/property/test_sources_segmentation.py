"""Cutting streams: pieces are in order, disjoint and hold every row; trials are as defined."""

from itertools import pairwise

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from pointpred.recording import IN_MEMORY
from pointpred.recordings.reading import Cut, Reading
from pointpred.recordings.samples import Samples, recording_of
from pointpred.recordings.segmentation import (
    cut,
    cut_at_clicks,
    cut_at_pauses,
)
from pointpred.records import EventColumns

HOWS: tuple[Cut, ...] = ("clicks", "bursts", "whole")
rows = st.lists(
    st.tuples(
        st.sampled_from([0.0, 0.01, 0.1, 0.3, 0.31, 2.0]),  # time step
        st.sampled_from([0, 0, 1, -2]),  # dx
        st.sampled_from([0, 0, 3]),  # dy
        st.sampled_from([0, 0, 0, 1, 2, 3]),  # buttons
        st.booleans(),  # whether the counts are known
    ),
    max_size=60,
)
streams = rows.map(lambda cells: stream_of(cells))


def stream_of(cells: list[tuple[float, int, int, int, bool]]) -> EventColumns:
    table = np.array(cells, dtype=float).reshape(-1, 5)
    counts = np.where(table[:, 4] > 0, table[:, 1:3].T, np.nan)
    x, y = np.cumsum(table[:, 1]), np.cumsum(table[:, 2])
    return EventColumns.of(np.cumsum(table[:, 0]), x, y, counts[0], counts[1], table[:, 3])


@given(streams, st.sampled_from(HOWS), st.integers(2, 5), st.sampled_from([0.0, 0.2]))
def test_pieces_hold_every_row_once_and_in_order(
    stream: EventColumns, how: Cut, least_samples: int, least_s: float
) -> None:
    pieces = cut(stream, how, Reading(least_samples=least_samples, least_s=least_s))
    assert [row for piece in pieces for row in range(piece.start, piece.stop)] == list(range(len(stream)))
    assert all(piece.stop > piece.start for piece in pieces)
    for piece in pieces:
        if not piece.reason:
            assert piece.stop - piece.start >= least_samples
            assert stream.t[piece.stop - 1] - stream.t[piece.start] >= least_s


@given(streams)
def test_a_trial_between_clicks_ends_with_its_only_press(stream: EventColumns) -> None:
    trials = [piece for piece in cut_at_clicks(stream) if not piece.reason] if len(stream) else []
    held = stream.buttons > 0
    presses = int(np.count_nonzero(held & ~np.concatenate([[False], held[:-1]])))
    for piece in trials:
        assert held[piece.stop - 1]
        assert not held[piece.start : piece.stop - 1].any()
    at_once = bool(len(stream)) and bool(held[0])
    assert len(trials) == presses - at_once  # a stream that begins pressed has a press before its first row


@given(streams, st.sampled_from([0.05, 0.3, 1.0]))
def test_bursts_move_at_both_ends_and_pause_between(stream: EventColumns, pause_s: float) -> None:
    trials = cut_at_pauses(stream, pause_s) if len(stream) else []
    trials = [piece for piece in trials if not piece.reason]
    table = np.nan_to_num(stream.table)
    moves = [
        row == 0 or (table[row, 1:3] != table[row - 1, 1:3]).any() or (table[row, 3:5] != 0).any()
        for row in range(len(stream))
    ]
    for piece in trials:
        inside = [row for row in range(piece.start, piece.stop) if moves[row]]
        assert (inside[0], inside[-1]) == (piece.start, piece.stop - 1)
        assert all(stream.t[b] - stream.t[a] <= pause_s for a, b in pairwise(inside))
    for before, after in pairwise(trials):
        assert stream.t[after.start] - stream.t[before.stop - 1] > pause_s
    assert sum(moves) == sum(moves[row] for piece in trials for row in range(piece.start, piece.stop))


@given(streams, st.sampled_from(HOWS))
def test_a_stream_is_read_or_reported_whole(stream: EventColumns, how: Cut) -> None:
    samples = Samples(
        name="s",
        table=stream.table,
        row_of=np.arange(len(stream)),
        provenance=IN_MEMORY,
        one_user="u",
        cut=how,
    )
    recording = recording_of(samples, Reading())
    pieces = cut(stream, how, Reading())
    assert len(recording.trials) + len(recording.skipped) == len(pieces)
    begins = [float(trial.condition["begins_s"]) for trial in recording.trials]
    assert begins == sorted(begins)
    for index, start in enumerate(begins):
        part = recording.rows(index)
        assert part.t[0] == 0.0
        assert np.isin(np.round(part.t + start, 9), np.round(stream.t, 9)).all()
