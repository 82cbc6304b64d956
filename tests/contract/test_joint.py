"""Both laws of a pipeline in one call: what one of them refuses changes neither."""

from __future__ import annotations

import pickle
from math import isnan

import pytest

from pointpred import build
from pointpred.compiled import law
from pointpred.differentiators import DIFFERENTIATORS
from pointpred.pipeline import Pipeline
from pointpred.predictors import Predictor
from pointpred.records import MOTION_FIELD, FloatArray, MotionRow, Row, TenFloats, endpoint, refused


@law
def fussy(memory: FloatArray, motion: Row) -> TenFloats:
    """Refuses every motion of the right half plane."""
    m = MotionRow(*motion)
    if m.x > 0.0:
        return refused(MOTION_FIELD + 1, m.x)
    memory[0] += 1.0
    return endpoint(m.t, m.x, m.y, 0.0)


class Fussy(Predictor):
    """Its law refuses what every differentiator accepts."""

    step = staticmethod(fussy)
    states = 1


@pytest.mark.parametrize("differentiator", DIFFERENTIATORS)
def test_a_motion_that_the_predictor_refuses_leaves_the_differentiator_as_it_was(differentiator: str) -> None:
    nan = float("nan")
    pipeline = Pipeline("fussy", build("hold", differentiator=differentiator).differentiator, Fussy())
    for i in range(5):
        assert pipeline.advance((0.01 * i, -10.0 + i, 0.0, nan, nan, 0.0))[0] == 0.01 * i
    before = pickle.dumps(pipeline)
    assert isnan(pipeline.advance((0.05, 3.0, 0.0, nan, nan, 0.0))[0])
    assert pickle.dumps(pipeline) == before
