"""When targets fire over recorded movements: by ForesightJS's rule, by the prefetch policy, by Chrome's.

ForesightJS's rule for a mouse is a port of npm's js.foresight 4.2.1 with its defaults: a straight line
through the last 8 positions, 120 ms ahead, meets an element's rectangle; no hit slop, each element once
(``MousePredictor``, ``predictNextMousePosition`` and ``lineSegmentIntersectsRect`` of its source). The
positions are not forgotten while the mouse rests, so each movement starts with those of its start. The policy
runs as a page runs it: every event, a decision a frame. Chrome's Speculation Rules fetch a link after a hover
or at the press: ``moderate`` after 200 ms, ``eager`` (since Chrome 141 on desktops) after 10 ms. Every
movement ends with a press.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, inf

import msgspec
import numpy as np

from evidence.intent.movements import Movement, inside
from pointpred.compiled import law
from pointpred.records import FloatArray, row_at
from pointpred.targets import cursor, heading, posterior, prefetch
from pointpred.targets.prefetch import contact

POSITIONS, AHEAD_S = 8, 0.12
RESTED_S = 0.45
"""How long the mouse has rested before a movement, as in the browser."""
FRAME_S = 1.0 / 60.0
"""It looks at the last position once a frame."""


@law
def frame_end(events: FloatArray, i: int, frame_s: float) -> float:
    """When the frame ends whose last event this is, s; infinite where another event of it follows.

    Frames are counted from the first event; without any (``frame_s`` 0) every event ends its own.
    """
    if frame_s == 0.0:
        return float(events[i, 0])
    begin = events[0, 0]
    number = max(ceil((events[i, 0] - begin) / frame_s - 1e-9), 1)
    due = begin + number * frame_s
    return due if i + 1 == len(events) or events[i + 1, 0] > due + 1e-9 * frame_s else inf


@law
def fire_by_rule(events: FloatArray, table: FloatArray, frame_s: float, fired_at: FloatArray) -> None:
    """When each target first fires, s, into ``fired_at``; infinite where it never does.

    ``frame_s``: the last event of each frame is looked at, when the frame ends; 0 for every event.
    """
    kept = np.zeros((POSITIONS, 3))
    for k in range(POSITIONS):
        kept[k, 0] = events[0, 0] - RESTED_S
        kept[k, 1] = events[0, 1]
        kept[k, 2] = events[0, 2]
    count = 0
    fired_at[:] = inf
    for i in range(len(events)):
        now, x, y = frame_end(events, i, frame_s), events[i, 1], events[i, 2]
        if now == inf:
            continue
        kept[count % POSITIONS, 0] = now
        kept[count % POSITIONS, 1] = x
        kept[count % POSITIONS, 2] = y
        count += 1
        first = count % POSITIONS
        dt = now - kept[first, 0]
        dx = AHEAD_S * (x - kept[first, 1]) / dt if dt > 0.0 else 0.0
        dy = AHEAD_S * (y - kept[first, 2]) / dt if dt > 0.0 else 0.0
        for k in range(len(table)):
            if fired_at[k] == inf and contact(x, y, dx, dy, table[k]) <= 1.0:
                fired_at[k] = now


@law
def weigh(
    events: FloatArray,
    answers: FloatArray,
    table: FloatArray,
    coefficients: FloatArray,
    frame_s: float,
    shares: FloatArray,
) -> None:
    """The shares of all targets at the last event of each frame, in a row of ``shares``."""
    memory = np.zeros(cursor.State.length)
    for i in range(len(events)):
        cursor.follow(memory, events[i, 0], events[i, 1], events[i, 2], 0.0)
        if frame_end(events, i, frame_s) < inf:
            posterior.scores(memory, table, row_at(answers, i), coefficients, heading.ELSEWHERE, shares[i])
            posterior.normalise(shares[i])


@law
def fire_by_policy(
    events: FloatArray,
    shares: FloatArray,
    table: FloatArray,
    settings: FloatArray,
    threshold: float,
    frame_s: float,
    fired_at: FloatArray,
) -> None:
    """When each target first fires, s, into ``fired_at``; infinite where it never does.

    Targets that the movement starts in are at rest: the cursor went into them before it. ``frame_s``: the
    policy decides at the end of each frame; 0 for every event.
    """
    s = prefetch.State(np.zeros(prefetch.State.length))
    thresholds, visits, fired = np.zeros(len(table)), np.zeros(len(table)), np.zeros(len(table))
    thresholds[:] = threshold
    targets = table, thresholds, visits, fired
    for k in range(len(table)):
        if prefetch.inside(events[0, 1], events[0, 2], table[k]):
            fired[k] = prefetch.RESTING
    s.began = events[0, 0]
    fired_at[:] = inf
    for i in range(len(events)):
        cursor.follow(s.cursor.memory, events[i, 0], events[i, 1], events[i, 2], 0.0)
        now = frame_end(events, i, frame_s)
        if now == inf or prefetch.step(s.memory, targets, shares[i], settings) == 0:
            continue
        for k in range(len(table)):
            if fired[k] > prefetch.RESTING and fired_at[k] == inf:
                fired_at[k] = now


class Score(msgspec.Struct, frozen=True):
    """Of many movements over one layout."""

    movements: int
    firings: float
    """A movement, with targets that the movement starts in."""
    elsewhere: float
    """A movement, without them."""
    before: float
    """Share of movements whose right target fired before the cursor entered it."""
    lead_s: float
    """Median time from the right firing to the entry, over the movements with one before the entry."""
    lead_all_s: float
    """The same over all movements, 0 where nothing fired before the entry."""


def by_rule(movement: Movement, frame_s: float) -> FloatArray:
    """When each target fires by ForesightJS's rule, s; infinite where it does not."""
    fired_at = np.empty(len(movement.table))
    fire_by_rule(movement.events, movement.table, frame_s, fired_at)
    return fired_at


def shares_of(movement: Movement, predictor: str, coefficients: FloatArray, frame_s: float) -> FloatArray:
    """The shares of all targets at the end of each frame, a row an event."""
    shares = np.zeros((len(movement.events), len(movement.table) + 1))
    weigh(movement.events, movement.answers[predictor], movement.table, coefficients, frame_s, shares)
    return shares


def by_policy(
    movement: Movement,
    shares: FloatArray,
    settings: FloatArray,
    frame_s: float,
    threshold: float = prefetch.THRESHOLD,
) -> FloatArray:
    """When each target fires by the prefetch policy, s; infinite where it does not."""
    fired_at = np.empty(len(movement.table))
    fire_by_policy(movement.events, shares, movement.table, settings, threshold, frame_s, fired_at)
    return fired_at


def score(movements: Sequence[Movement], fired: Sequence[FloatArray]) -> Score:
    """The score of movements, given when each of their targets fired."""
    counts, elsewhere, leads = [], [], []
    for movement, at in zip(movements, fired, strict=True):
        x, y = movement.events[0, 1:3].tolist()
        starts = np.array([prefetch.inside(x, y, row) for row in movement.table])
        counts.append(int(np.isfinite(at).sum()))
        elsewhere.append(int((np.isfinite(at) & ~starts).sum()))
        leads.append(movement.events[movement.entry, 0] - at[movement.right])
    lead = np.array(leads)
    early = lead > 0.0
    return Score(
        len(lead),
        float(np.mean(counts)),
        float(np.mean(elsewhere)),
        float(early.mean()),
        float(np.median(lead[early])) if early.any() else 0.0,
        float(np.median(np.where(early, lead, 0.0))),
    )


HOVER_S = {"eager": 0.01, "moderate": 0.2}
HOVER_HEADS = ("firings", "after the entry", "before the press")


def by_hover(movement: Movement, hover_s: float) -> FloatArray:
    """When each target fires, s; infinite where it does not."""
    t = movement.events[:, 0]
    return np.array([_first_hover(t, inside(row, movement.events), hover_s) for row in movement.table])


def _first_hover(t: FloatArray, within: np.ndarray[tuple[int], np.dtype[np.bool_]], hover_s: float) -> float:
    """When the cursor has first been in a target for so long, or is in it at the end; infinite if never."""
    changes = np.flatnonzero(np.diff(within.astype(np.int8), prepend=0, append=0))
    for begin, end in zip(changes[::2], changes[1::2], strict=True):
        if end == len(t):
            return float(min(t[begin] + hover_s, t[-1]))
        if t[end] - t[begin] >= hover_s:
            return float(t[begin] + hover_s)
    return float("inf")


def hovered(movements: Sequence[Movement], hover_s: float) -> tuple[str, str, str]:
    """Firings a movement; medians of how late after the entry and how early before the press it fires, ms."""
    fired = [by_hover(one, hover_s) for one in movements]
    after = [at[one.right] - one.events[one.entry, 0] for one, at in zip(movements, fired, strict=True)]
    early = [one.events[-1, 0] - at[one.right] for one, at in zip(movements, fired, strict=True)]
    counts = [np.isfinite(at).sum() for at in fired]
    return (
        f"{np.mean(counts):.2f}",
        f"{1e3 * np.median(after):.0f}",
        f"{1e3 * np.median(np.maximum(early, 0.0)):.0f}",
    )
