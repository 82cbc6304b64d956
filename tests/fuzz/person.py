"""Any text as a person, and any numbers as what was learned: refused, or a predictor that works with them."""

from __future__ import annotations

from functools import cache

import numpy as np

from pointpred.errors import ParameterError
from pointpred.person import packed, person_of, restore
from pointpred.pipeline import Pipeline
from pointpred.registry import build
from pointpred.stage import CompiledStage
from tests.fuzz.refusals import refused

NAME = "kinematic-adaptive"


@cache
def _pipeline() -> Pipeline:
    return build(NAME)


def check(data: bytes) -> str:
    """An input is the text, or a zero byte and the numbers, which then get a valid digest."""
    pipeline = _pipeline().fresh()
    predictor: CompiledStage = pipeline.predictor
    text = data.decode("latin-1")
    if data[:1] == b"\0":
        count = sum(slot.count for slot in predictor.slots)
        numbers = np.frombuffer(data[1 : 1 + 8 * ((len(data) - 1) // 8)], "<f8")[:count]
        text = packed(predictor.slots, np.concatenate([numbers, np.zeros(count - len(numbers))]))
    try:
        restore(predictor, text)
    except ParameterError as error:
        came = refused(error)
    else:
        came = "restored"
    if came == "refused":
        assert not predictor.known.any()
        return came
    assert person_of(predictor) == text
    for place in range(40):
        row = (place / 100, 10.0 * place, 3.0 * place, float("nan"), float("nan"), 0.0)
        assert pipeline.advance(row)[0] == row[0]
    pipeline.reset()
    restore(build(NAME).predictor, person_of(predictor))
    return came


def seeds() -> list[bytes]:
    """A person of some movements as text and as numbers."""
    pipeline = _pipeline().fresh()
    for movement in range(6):
        for place in range(80):
            s = min(place / 60, 1.0)
            x = 300.0 * (10 * s**3 - 15 * s**4 + 6 * s**5) * (1 + movement % 2)
            pipeline.advance((movement + place / 100, x, 0.5 * x, float("nan"), float("nan"), 0.0))
        pipeline.reset()
    predictor: CompiledStage = pipeline.predictor
    numbers = predictor.known.astype("<f8").tobytes()
    return [person_of(predictor).encode(), b"\0" + numbers, b"\0" + numbers[:400], b"1.Avc", b""]
