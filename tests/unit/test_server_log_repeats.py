"""An entry that comes again and again: written at first, then seldom, and counted."""

from __future__ import annotations

import logging

from pointpred_server.log_repeats import AT_ONCE, KINDS_MOST, PER_S, RepeatLimit


def entry(at_s: float, sentence: str = "a request was refused: %s", filled: str = "x") -> logging.LogRecord:
    arguments = (filled,) if "%" in sentence else ()
    record = logging.LogRecord("pointpred.service", logging.INFO, "", 0, sentence, arguments, None)
    record.created = at_s
    return record


def test_an_entry_that_comes_too_often_is_dropped_and_counted() -> None:
    limit = RepeatLimit()
    written = [limit.filter(entry(1000.0, filled=str(k))) for k in range(5000)]
    assert written == [True] * AT_ONCE + [False] * (5000 - AT_ONCE)
    assert limit.filter(entry(1000.0, "another")), "others are written"
    assert not limit.filter(entry(1000.0 + 0.5 / PER_S))
    later = entry(1000.0 + 1.5 / PER_S)
    assert limit.filter(later)
    assert later.getMessage() == f"a request was refused: x ({5001 - AT_ONCE} like it were not written)"


def test_in_the_long_run_so_many_a_second_are_written() -> None:
    limit = RepeatLimit()
    written = sum(limit.filter(entry(k / 100)) for k in range(100 * 600))
    assert written <= AT_ONCE + PER_S * 600 + 1
    assert written >= PER_S * 600


def test_sentences_that_are_all_different_are_bounded_together() -> None:
    limit = RepeatLimit()
    written = sum(limit.filter(entry(0.0, f"sentence {k}")) for k in range(10_000))
    assert written == KINDS_MOST + AT_ONCE
