"""Cut a stream of events into trials: from click to click, or into bursts of movement."""

from __future__ import annotations

import msgspec
import numpy as np

from pointpred.recordings.reading import Cut, Reading
from pointpred.recordings.trials import BUTTONS, DX, DY, T, X, Y
from pointpred.records import EventColumns

PAUSE_S = 0.3
"""A longer standstill separates two movements."""


class Piece(msgspec.Struct, frozen=True):
    """Rows ``start`` up to ``stop``: a trial if ``reason`` is empty, otherwise why it is not one."""

    start: int
    stop: int
    reason: str = ""


def cut(events: EventColumns, how: Cut, reading: Reading) -> list[Piece]:
    """Cut a stream by the method named ``how`` with the parameters of ``reading``.

    The pieces are in order, do not overlap and together contain every row.

    >>> events = EventColumns.of([0.0, 0.1, 0.9, 1.0], [0, 5, 9, 12], [0, 0, 0, 0])
    >>> [(piece.start, piece.stop) for piece in cut(events, "bursts", Reading())]
    [(0, 2), (2, 4)]
    """
    if not len(events):
        return []
    if how == "clicks":
        pieces = cut_at_clicks(events)
    elif how == "bursts":
        pieces = cut_at_pauses(events)
    else:
        pieces = [Piece(0, len(events))]
    return [_check(piece, events, reading) for piece in pieces]


def cut_at_clicks(events: EventColumns) -> list[Piece]:
    """Trials that end at a button's press and begin at the release of all buttons (or with the stream).

    Assumes that every click ends a movement. Limitation: double clicks give trials of a few samples (see
    ``least_samples``), pauses stay inside the trial. The press is the last row of its trial, the release the
    first row of the next; rows while a button is held, and rows after the last click, belong to no trial.

    >>> stream = EventColumns.of(range(6), range(6), [0] * 6, buttons=[0, 0, 1, 1, 0, 1])
    >>> [(piece.start, piece.stop, piece.reason) for piece in cut_at_clicks(stream)]
    [(0, 3, ''), (3, 4, 'a button is held'), (4, 6, '')]
    """
    pressed = events.table[:, BUTTONS] > 0
    before = np.concatenate([[False], pressed[:-1]])
    presses, releases = np.flatnonzero(pressed & ~before), np.flatnonzero(before & ~pressed)
    begins = releases if pressed[0] else np.concatenate([[0], releases])
    ends = presses + 1
    if pressed[0]:
        ends = ends[1:]
    pieces: list[Piece] = []
    reached = 0
    for index, begin in enumerate(begins.tolist()):
        if begin > reached:
            pieces.append(Piece(reached, begin, "a button is held"))
        reached = int(ends[index]) if index < len(ends) else len(events)
        pieces.append(Piece(begin, reached, "" if index < len(ends) else "no click ends it"))
    if reached < len(events):
        pieces.append(Piece(reached, len(events), "a button is held"))
    return pieces


def cut_at_pauses(events: EventColumns, pause_s: float = PAUSE_S) -> list[Piece]:
    """Bursts: runs of movement with no standstill longer than ``pause_s``.

    Assumes that a pause separates two movements. Limitation: hesitations are cut apart, movements without a
    pause stay together. A row moves when its position differs from the row before it or a count is not zero;
    the first row moves with the burst that follows it at once. Rows of a pause belong to no trial.

    >>> stream = EventColumns.of([0.0, 0.1, 0.2, 0.8, 0.9], [0, 1, 1, 1, 2], [0] * 5)
    >>> [(piece.start, piece.stop, piece.reason) for piece in cut_at_pauses(stream)]
    [(0, 2, ''), (2, 4, 'no movement'), (4, 5, '')]
    """
    table = events.table
    moves = np.ones(len(table), dtype=bool)
    moves[1:] = (np.diff(table[:, X]) != 0) | (np.diff(table[:, Y]) != 0)
    moves |= (np.nan_to_num(table[:, DX]) != 0) | (np.nan_to_num(table[:, DY]) != 0)
    moving = np.flatnonzero(moves)
    apart = np.flatnonzero(np.diff(table[moving, T]) > pause_s)
    pieces: list[Piece] = []
    reached = 0
    firsts = moving[np.concatenate([[0], apart + 1])]
    lasts = moving[np.concatenate([apart, [len(moving) - 1]])]
    for first, last in zip(firsts.tolist(), lasts.tolist(), strict=True):
        if first > reached:
            pieces.append(Piece(reached, first, "no movement"))
        pieces.append(Piece(first, last + 1))
        reached = last + 1
    if reached < len(table):
        pieces.append(Piece(reached, len(table), "no movement"))
    return pieces


def _check(piece: Piece, events: EventColumns, reading: Reading) -> Piece:
    """The piece, with a reason if it is too short to be a trial."""
    if piece.reason:
        return piece
    samples = piece.stop - piece.start
    if samples < reading.least_samples:
        return Piece(
            piece.start, piece.stop, f"samples: {samples}, expected at least {reading.least_samples}"
        )
    lasts = float(events.table[piece.stop - 1, T] - events.table[piece.start, T])
    if lasts < reading.least_s:
        return Piece(piece.start, piece.stop, f"lasts {lasts:.6g} s, expected at least {reading.least_s:g} s")
    return piece
