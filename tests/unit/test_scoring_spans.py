"""Work on many trials: the same answers in one thread and in several, and no pool for one."""

from __future__ import annotations

import threading

import numpy as np
import pytest

from pointpred.scoring import spans

OFFSETS = np.array([0, 30_000, 60_000, 61_000, 90_000])


def place(first: int, stop: int) -> tuple[int, int, int]:
    return first, stop, threading.get_ident()


def test_one_thread_is_the_callers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(spans, "ThreadPoolExecutor", lambda most: pytest.fail("a pool of one"))
    found = list(spans.in_threads(place, OFFSETS, 1))
    assert [one[:2] for one in found] == spans.spans(OFFSETS)
    assert {one[2] for one in found} == {threading.get_ident()}


@pytest.mark.parametrize("threads", [2, None])
def test_several_threads_answer_in_the_same_order(threads: int | None) -> None:
    found = list(spans.in_threads(place, OFFSETS, threads))
    assert [one[:2] for one in found] == spans.spans(OFFSETS)
    assert threading.get_ident() not in {one[2] for one in found}


@pytest.mark.parametrize("threads", [1, 2])
def test_what_breaks_comes_out(threads: int) -> None:
    def broken(first: int, stop: int) -> int:
        raise ValueError("here")

    with pytest.raises(ValueError, match="here"):
        list(spans.in_threads(broken, OFFSETS, threads))
