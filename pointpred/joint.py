"""Two laws as one: a differentiator's answer goes straight into the predictor, in one compiled call."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.rows import REFUSED, Row, TenFloats


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
