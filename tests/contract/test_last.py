"""A table of which only the last event is answered: the same bits as answering each, in every pipeline."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from pointpred import build
from pointpred.errors import EventOrderError
from pointpred.registry import REGISTRY
from tests.contract.conftest import troubled, with_counts


@pytest.mark.parametrize("name", REGISTRY)
@pytest.mark.parametrize("cpi", [None, 1600.0])
def test_the_last_answer_is_that_of_the_whole_table(name: str, cpi: float | None) -> None:
    each, last = build(name, cpi=cpi), build(name, cpi=cpi)
    table = (troubled() if cpi is None else with_counts()).table
    starts = np.cumsum([0, *(1, 2, 3, 8, 32) * 3])
    for start, stop in pairwise(starts[starts <= len(table)].tolist()):
        part = np.ascontiguousarray(table[start:stop])
        answers, answer = each.push(part), last.push(part, want="last")
        assert np.array(answer).tobytes() == answers[-1].tobytes()
        for stage, other in (
            (each.differentiator, last.differentiator),
            (each.predictor, last.predictor),
        ):
            assert stage.remembered() == other.remembered()


@pytest.mark.parametrize("name", ["hold", "switched", "kinematic", "kinematic-adaptive"])
@pytest.mark.parametrize("place", [0, 3, 7])
def test_a_refused_event_changes_nothing(name: str, place: int) -> None:
    pipeline, table = build(name), troubled().table
    pipeline.push(np.ascontiguousarray(table[:20]), want="last")
    part = np.ascontiguousarray(table[20:28])
    part[place, 0] = -1.0
    before = pipeline.differentiator.remembered(), pipeline.predictor.remembered()
    with pytest.raises(EventOrderError, match=f"row {place}: t must not run backwards"):
        pipeline.push(part, want="last")
    assert (pipeline.differentiator.remembered(), pipeline.predictor.remembered()) == before
