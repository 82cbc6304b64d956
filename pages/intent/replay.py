"""The prefetch policy over one recorded movement, as a page runs it: every event, a decision a frame."""

from __future__ import annotations

from math import inf

import numpy as np

from pages.intent.foresight import frame_end
from pointpred.compiled import law
from pointpred.records import FloatArray, row_at
from pointpred.targets import cursor, posterior, prefetch


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
    memory = np.zeros(cursor.STATES)
    for i in range(len(events)):
        cursor.follow(memory, events[i, 0], events[i, 1], events[i, 2], 0.0)
        if frame_end(events, i, frame_s) < inf:
            posterior.scores(memory, table, row_at(answers, i), coefficients, prefetch.ELSEWHERE, shares[i])
            posterior.normalise(shares[i])


@law
def fire(
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
    memory = np.zeros(prefetch.STATES)
    thresholds, visits, fired = np.zeros(len(table)), np.zeros(len(table)), np.zeros(len(table))
    thresholds[:] = threshold
    targets = table, thresholds, visits, fired
    for k in range(len(table)):
        if prefetch.inside(events[0, 1], events[0, 2], table[k]):
            fired[k] = prefetch.RESTING
    memory[prefetch.BEGAN] = events[0, 0]
    fired_at[:] = inf
    for i in range(len(events)):
        cursor.follow(memory, events[i, 0], events[i, 1], events[i, 2], 0.0)
        now = frame_end(events, i, frame_s)
        if now == inf or prefetch.step(memory, targets, shares[i], settings) == 0:
            continue
        for k in range(len(table)):
            if fired[k] > prefetch.RESTING and fired_at[k] == inf:
                fired_at[k] = now
