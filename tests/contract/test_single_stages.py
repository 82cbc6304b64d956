"""The laws of a stage, for every predictor fed with motions and every differentiator fed with events."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from pointpred import REGISTRY, EventColumns, Motion, PointerEvent, build, run
from pointpred.differentiators import DIFFERENTIATORS
from pointpred.errors import EventError, EventOrderError
from pointpred.records import BoolArray, FloatArray, MotionColumns

LARGEST_STAGE_BYTES = 64 * 1024


@dataclass(frozen=True)
class Alone:
    """A stage by itself: how to make it, how to feed it a table, and its input of a row."""

    make: Callable[[], Any]
    feed: Callable[[Any, FloatArray, BoolArray], FloatArray]
    sample: Callable[[FloatArray], Any]
    rows: Callable[[], FloatArray]
    measured: int
    """How many fields of a row must be finite."""

    def run(self, stage: Any, rows: FloatArray, begin: BoolArray | None = None) -> FloatArray:
        return self.feed(stage, rows, np.zeros(len(rows), np.bool_) if begin is None else begin)


def wandering() -> FloatArray:
    """Events that wander, pause and click, some of them at one time."""
    random = np.random.default_rng(4)
    count = 300
    table = np.full((count, 6), np.nan)
    table[:, 0] = np.cumsum(random.choice([0.0, 0.001, 0.008, 0.05, 0.15, 0.4], count))
    table[:, 1:3] = np.cumsum(random.integers(-9, 20, (count, 2)), axis=0)
    table[:, 5] = random.integers(0, 2, count)
    return table


def motions() -> FloatArray:
    """What a differentiator makes of them: the accelerations are not zero."""
    table = DIFFERENTIATORS["homogeneous"]().run(EventColumns(wandering())).table
    assert np.abs(table[:, 3:7]).max(axis=0).min() > 0.01
    return table


def differentiator(name: str) -> Alone:
    return Alone(
        DIFFERENTIATORS[name],
        lambda stage, rows, begin: stage.run(EventColumns(rows, begin)).table,
        lambda row: next(EventColumns(row[None]).events()),
        wandering,
        3,
    )


def predictor(name: str) -> Alone:
    return Alone(
        lambda: build(name).predictor,
        lambda stage, rows, begin: stage.run(MotionColumns(rows), begin).table,
        lambda row: next(MotionColumns(row[None]).motions()),
        motions,
        7,
    )


STAGES = {f"differentiator {name}": differentiator(name) for name in DIFFERENTIATORS}
STAGES |= {f"predictor {name}": predictor(name) for name in REGISTRY}


@pytest.fixture(params=list(STAGES))
def alone(request: pytest.FixtureRequest) -> Alone:
    return STAGES[request.param]


def same(left: FloatArray, right: FloatArray) -> bool:
    return left.tobytes() == right.tobytes()


def test_reset_fresh_and_a_begin_mark_forget_everything(alone: Alone) -> None:
    rows = alone.rows()
    first = alone.run(alone.make(), rows)
    used = alone.make()
    alone.run(used, rows)
    assert same(alone.run(used.fresh(), rows), first)
    used.reset()
    second = alone.run(used, rows)  # of what it has learned a stage forgets nothing
    assert same(second, first) or used.learned
    begin = np.zeros(2 * len(rows), np.bool_)
    begin[len(rows)] = True
    joined = alone.run(alone.make(), np.concatenate([rows, rows]), begin)
    assert same(joined[: len(rows)], first)
    assert same(joined[len(rows) :], second)


def test_chunks_and_single_samples_equal_the_whole(alone: Alone) -> None:
    rows = alone.rows()
    whole = alone.run(alone.make(), rows)
    for cut in (0, 1, 77, len(rows)):
        stage = alone.make()
        assert same(np.concatenate([alone.run(stage, rows[:cut]), alone.run(stage, rows[cut:])]), whole)
    stage, table = alone.make(), alone.make()
    for row in rows:
        streamed = stage.update(alone.sample(row))
        (answer,) = alone.run(table, row[None])
        if isinstance(streamed, Motion):
            assert (streamed.t, streamed.vx, streamed.ay) == (answer[0], answer[3], answer[6])
        elif streamed is None:
            assert np.isnan(answer[1])
        else:
            assert (streamed.t, streamed.x, streamed.y) == tuple(answer[:3])


@pytest.mark.parametrize("wrong", [float("nan"), float("inf"), -float("inf")])
def test_what_is_not_finite_is_refused_in_every_field(alone: Alone, wrong: float) -> None:
    rows = alone.rows()
    stage = alone.make()
    alone.run(stage, rows[:100])
    kept = pickle.dumps(stage)
    for field in range(alone.measured):
        bad = rows[100].copy()
        bad[field] = wrong
        with pytest.raises(EventError):
            stage.update(alone.sample(bad))
        with pytest.raises(EventError, match="row 1"):
            alone.run(stage, np.stack([rows[100], bad]))
        assert pickle.dumps(stage) == kept


def test_time_backwards_is_refused(alone: Alone) -> None:
    rows = alone.rows()
    stage = alone.make()
    alone.run(stage, rows[:100])
    kept = pickle.dumps(stage)
    with pytest.raises(EventError):
        stage.update(alone.sample(rows[50]))
    assert pickle.dumps(stage) == kept


def test_it_pickles_goes_on_and_does_not_grow(alone: Alone) -> None:
    rows = alone.rows()
    stage = alone.make()
    size = len(pickle.dumps(stage))
    alone.run(stage, rows[:150])
    twin = pickle.loads(pickle.dumps(stage))
    assert same(alone.run(twin, rows[150:]), alone.run(stage, rows[150:]))
    assert len(pickle.dumps(stage)) == size < LARGEST_STAGE_BYTES


def test_two_stages_share_nothing(alone: Alone) -> None:
    rows = alone.rows()
    whole = alone.run(alone.make(), rows)
    one = alone.make()
    head = alone.run(one, rows[:50])
    alone.run(one.fresh(), rows)
    alone.run(alone.make(), rows)
    assert same(np.concatenate([head, alone.run(one, rows[50:])]), whole)


@pytest.mark.parametrize("name", list(REGISTRY))
def test_a_motion_of_whole_numbers_is_one_and_words_are_none(name: str) -> None:
    one, two = build(name).predictor, build(name).predictor
    assert one.update(Motion(1, 2, 3, 0, 0, 0, 0, True)) == two.update(
        Motion(1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, True)
    )
    kept = pickle.dumps(one)
    with pytest.raises(EventError, match="motion must be numbers"):
        one.update(Motion(2.0, "left", 3.0, 0.0, 0.0, 0.0, 0.0, True))  # type: ignore[arg-type]
    assert pickle.dumps(one) == kept


def test_a_pipeline_whose_predictor_refuses_is_unchanged() -> None:
    """The differentiator has moved on by then: it must go back."""
    pipeline = build("hold")
    pipeline.update(PointerEvent(1.0, 0.0, 0.0))
    pipeline.predictor.update(Motion(9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, settled=True))
    kept = pickle.dumps(pipeline)
    stage = pipeline.differentiator
    with pytest.raises(EventOrderError, match=r"received 2\.0 s after 9\.0 s"):
        pipeline.update(PointerEvent(2.0, 5.0, 0.0))
    assert np.isnan(pipeline.advance((2.0, 5.0, 0.0, np.nan, np.nan, 0.0))[0])
    assert pickle.dumps(pipeline) == kept
    with pytest.raises(EventError, match="row 0"):
        run(pipeline, EventColumns.of([2.0], [5.0], [0.0]))
    assert pickle.dumps(pipeline) == kept
    assert pipeline.differentiator is stage
