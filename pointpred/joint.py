"""Two laws as one: a differentiator's answer goes straight into the predictor, in one compiled call.

For one event, and for a table of events of which only the last is answered.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from pointpred.compiled import law
from pointpred.records import REFUSED, FloatArray, Row, TenFloats, event_at


@cache
def joint_of(
    first: Callable[..., Any], second: Callable[..., Any], compiled: bool
) -> Callable[..., TenFloats]:
    """The law ``first`` and then ``second`` with what it answered; both refuse by a NaN time.

    Takes the memory of each and the row. Where either refuses, both memories are as they were: ``second``
    changes nothing then, and that of ``first`` is copied back. Made once for two laws. Not ``compiled``, it
    calls the two as they are: a pair that is chosen by few would else be compiled when it is chosen.
    """

    def joint(memory: FloatArray, other: FloatArray, row: Row) -> TenFloats:
        kept = memory.copy()
        between = first(memory, row)
        answer = REFUSED
        if between[0] == between[0]:
            answer = second(other, between)
            if answer[0] != answer[0]:
                memory[:] = kept
        return answer

    return law(joint) if compiled else joint


@cache
def joint_sharing(
    first: Callable[..., Any], second: Callable[..., Any], compiled: bool
) -> Callable[..., TenFloats]:
    """``joint_of`` where ``second`` takes an array that many stages share, which comes first here."""

    def joint(shared: FloatArray, memory: FloatArray, other: FloatArray, row: Row) -> TenFloats:
        kept = memory.copy()
        between = first(memory, row)
        answer = REFUSED
        if between[0] == between[0]:
            answer = second(other, between, shared)
            if answer[0] != answer[0]:
                memory[:] = kept
        return answer

    return law(joint) if compiled else joint


@cache
def last_of(
    first: Callable[..., Any], second: Callable[..., Any], follow: Callable[..., bool] | None
) -> Callable[..., TenFloats]:
    """``first`` and then ``second`` over a table of at least one event; the answer to the last of them.

    ``follow`` takes a motion into the memory of ``second`` as that does, and says whether it was accepted;
    without one, ``second`` is called for each. Where an event is refused, both memories are as they were.
    """
    follow_one = follow or _following(second)

    def last(memory: FloatArray, other: FloatArray, rows: FloatArray, *shared: FloatArray) -> TenFloats:
        kept, other_kept = memory.copy(), other.copy()
        answer, count = REFUSED, 0
        for i in range(len(rows) - 1):
            between = first(memory, event_at(rows, i))
            if between[0] != between[0] or not follow_one(other, between, *shared):
                break
            count += 1
        if count == len(rows) - 1:
            between = first(memory, event_at(rows, count))
            if between[0] == between[0]:
                answer = second(other, between, *shared)
        if answer[0] != answer[0]:
            memory[:] = kept
            other[:] = other_kept
        return answer

    return law(last)


def _following(step: Callable[..., Any]) -> Callable[..., bool]:
    """A law that does what ``step`` does, and says only whether it accepts."""

    def follow(memory: FloatArray, row: Row, *shared: FloatArray) -> bool:
        t = step(memory, row, *shared)[0]
        return bool(t == t)

    return law(follow)
