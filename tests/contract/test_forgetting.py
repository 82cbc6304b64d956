"""What a pipeline forgets: everything with ``fresh``, the movement with ``reset`` and a ``begin`` mark.

A pipeline that learns its person keeps across a reset what it learned of finished movements, and nothing
else; one that learns nothing is as good as new.
"""

from __future__ import annotations

import numpy as np

from pointpred import EventColumns
from pointpred.records import MotionColumns
from tests.contract.conftest import minimum_jerk
from tests.contract.test_stage_laws import EVERY, answers, make, same


@EVERY
def test_fresh_remembers_nothing(name: str, events: EventColumns, troubled_events: EventColumns) -> None:
    used = make(name)
    answers(used, troubled_events)
    used.reset()
    answers(used, troubled_events)
    first = answers(make(name), events)
    assert same(answers(used.fresh(), events), first)


@EVERY
def test_reset_forgets_every_event(name: str, events: EventColumns, troubled_events: EventColumns) -> None:
    """It equals fresh, but for what a pipeline that learns has learned of movements that were finished."""
    used = make(name)
    used.reset()
    used.reset()
    answers(used, troubled_events)
    first = answers(make(name), events)
    if not used.learns:
        used.reset()
        assert same(answers(used, events), first)
        return
    still = make(name)
    answers(still, EventColumns(np.concatenate([events.table[:1]] * 5)))
    still.reset()
    assert same(answers(still, events), first)
    again = make(name)
    answers(again, troubled_events)
    for _ in range(3):
        again.reset()  # once is as good as three times
    used.reset()
    assert same(answers(used, events), answers(again, events))


@EVERY
def test_a_begin_mark_is_a_reset(name: str, events: EventColumns, troubled_events: EventColumns) -> None:
    table = np.concatenate([troubled_events.table, events.table])
    begin = np.zeros(len(table), dtype=np.bool_)
    begin[[0, len(troubled_events)]] = True
    joined = answers(make(name), EventColumns(table, begin))
    apart = make(name)
    assert same(joined[: len(troubled_events)], answers(apart, troubled_events))
    if not apart.learns:
        apart = make(name)
    apart.reset()
    assert same(joined[len(troubled_events) :], answers(apart, events))


@EVERY
def test_the_phases_of_a_movement_are_judged_by_its_own_peak(name: str) -> None:
    """A movement ten times as fast, which ended without a reset, changes nothing."""
    fast = make(name).differentiator.run(minimum_jerk(0.7, 0.008)).table
    fast[:, 8] = np.arange(len(fast)) == 0
    slow = fast.copy()
    slow[:, 1:7] *= 0.1
    after = slow.copy()
    after[:, 0] += 8.0
    begin = np.zeros(2 * len(fast), dtype=np.bool_)
    alone = make(name).predictor.run(MotionColumns(slow), begin[: len(slow)]).table[:, 7]
    both = make(name).predictor.run(MotionColumns(np.concatenate([fast, after])), begin).table[:, 7]
    assert (alone == 1.0).any()
    assert same(both[len(fast) :], alone)
