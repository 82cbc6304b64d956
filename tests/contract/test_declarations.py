"""What a stage declares: a replacement keeps its place, a law its loop, and help shows the names."""

from __future__ import annotations

import inspect

import numpy as np

from pointpred import PointerEvent, build
from pointpred.compiled import law
from pointpred.parameter import parameter
from pointpred.pipeline import Pipeline
from pointpred.predictors import LinearPredictor, Predictor
from pointpred.records import FloatArray, MotionRow, Row, TenFloats, endpoint


class Far(LinearPredictor):
    """The parent's law with another default."""

    horizon_s: float = parameter("s", 0.0, 1.0, "how far ahead the velocity is carried", default=0.5)


@law
def count(memory: FloatArray, motion: Row) -> TenFloats:
    """A law that checks nothing itself: how many motions it was given."""
    m = MotionRow(*motion)
    memory[0] += 1.0
    return endpoint(m.t, memory[0], m.y, 0.0)


class Count(Predictor):
    """Its endpoint is the number of motions."""

    step = staticmethod(count)
    states = 1


def test_a_replaced_parameter_keeps_its_place_in_the_memory() -> None:
    one = Pipeline("far", build("linear").differentiator, Far())
    other = build("linear", horizon_s=0.5)
    for i in range(20):
        event = PointerEvent(i / 100, 5.0 * i, 0.0)
        assert one.update(event) == other.update(event)


def test_a_signature_names_what_may_be_set() -> None:
    names = inspect.signature(Far).parameters
    assert {name: one.default for name, one in names.items()} == {"horizon_s": 0.5, "window_s": 0.12}


def test_a_refused_event_does_not_reach_the_predictor() -> None:
    pipeline = Pipeline("count", build("hold").differentiator, Count())
    row = (1.0, 0.0, 0.0, np.nan, np.nan, 0.0)
    pipeline.advance(row)
    assert np.isnan(pipeline.advance((0.5, *row[1:]))[0])
    assert pipeline.advance((1.5, *row[1:]))[1] == 2.0
