"""A pipeline that learns its user is scored user by user, whatever the threads and the order."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

from pointpred import EventColumns, build, run
from pointpred.compiled import law
from pointpred.pipeline import Pipeline
from pointpred.predictors.predictor import Predictor
from pointpred.recording import Recording, Trial
from pointpred.records import Row, TenFloats, endpoint
from pointpred.scoring import prepare, replay, spans
from pointpred.scoring.replay import answers_to

MOVEMENTS, LAST_X = 0, 1


@law
def conclude(memory: Any) -> None:
    """Count the movements that were finished."""
    if memory[LAST_X] != 0.0:
        memory[MOVEMENTS] += 1.0


@law
def step(memory: Any, motion: Row) -> TenFloats:
    """The cursor, moved right by one px for each finished movement."""
    memory[LAST_X] = 1.0
    t, x, y = motion[:3]
    return endpoint(t, x + memory[MOVEMENTS], y, 0.0)


class Counter(Predictor):
    """Says how many movements it has seen finished, as an error in px."""

    learned = 1
    step = staticmethod(step)
    conclude = staticmethod(conclude)
    states = 1


def learner() -> Pipeline:
    return Pipeline("counter", build("hold").differentiator, Counter())


def walks(users: list[str], seed: int = 3) -> Recording:
    """Straight reaches of 100 px to the right, of these users in this order."""
    random = np.random.default_rng(seed)
    parts = []
    for _ in users:
        x = np.linspace(0.0, 100.0, int(random.integers(10, 30)))
        parts.append(EventColumns.of(0.01 * np.arange(len(x)), x, np.zeros(len(x))))
    return Recording.of("walks", parts, [Trial(user, str(k)) for k, user in enumerate(users)])


USERS = ["ann", "ann", "bob", "ann", "bob", "eve", "ann", "eve"]
SEEN = [0, 1, 0, 2, 1, 0, 3, 1]


@pytest.mark.parametrize("threads", [1, 4])
@pytest.mark.parametrize("events", [1, 40, 10**6])
def test_each_trial_knows_the_user_s_earlier_ones_and_nobody_else_s(
    threads: int, events: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(spans, "SPAN_EVENTS", events)
    scored = replay(prepare(walks(USERS)), learner(), threads=threads)
    assert scored.by_path[:, -1].tolist() == SEEN
    assert scored.failed == ()


def test_one_trial_alone_is_answered_as_in_the_replay() -> None:
    prepared = prepare(walks(USERS))
    for k, seen in enumerate(SEEN):
        assert answers_to(prepared, learner(), k).x[-1] == 100.0 + seen
        assert answers_to(prepared, build("hold"), k).x[-1] == 100.0


def test_a_trial_that_fails_keeps_what_the_others_teach() -> None:
    prepared = prepare(walks(["ann"] * 4))

    class Moody(Counter):
        def walk(self, begin: Any, rows: Any) -> Any:
            if (rows[:, 0] == prepared.rows(1).t[3]).any() and len(rows) == len(prepared.rows(1)):
                raise RuntimeError("lost its way")
            if begin.sum() > 1:
                raise RuntimeError("one at a time")
            return super().walk(begin, rows)

    scored = replay(prepared, Pipeline("moody", build("hold").differentiator, Moody()))
    assert [skip.trial for skip in scored.failed] == ["1"]
    assert scored.by_path[:, -1].tolist() == [0.0, 0.0, 1.0, 2.0]


def test_reset_keeps_the_person_and_fresh_meets_a_new_one() -> None:
    events = walks(["ann"]).events
    pipeline = learner()
    assert pipeline.learns
    assert not build("hold").learns
    for seen in range(3):
        assert run(pipeline, events.rows(0, len(events))).x[-1] == 100.0 + seen
        kept = pickle.dumps(pipeline)
        twin = pipeline.fresh()
        assert pickle.dumps(pipeline) == kept
        assert pickle.dumps(twin) == pickle.dumps(learner())
    pipeline.reset()
    pipeline.reset()  # no movement since: nothing more is learnt
    assert run(pipeline, EventColumns(events.table)).x[-1] == 103.0
