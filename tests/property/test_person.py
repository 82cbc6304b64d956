"""No accepted person makes a prediction fail, and what comes of one is accepted again."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

import numpy as np
from hypothesis import example, given, settings
from hypothesis import strategies as st

from pointpred import build, run
from pointpred import person as persons
from pointpred.errors import ParameterError
from pointpred.layout import Slot
from pointpred.predictors import AdaptiveKinematicPredictor
from pointpred.predictors.adaptation import distances, places, time_left
from pointpred.predictors.adaptation.correction import Person
from pointpred.records import FloatArray
from tests.building import reach

NAME = "kinematic-adaptive"
SLOTS = AdaptiveKinematicPredictor.slots


def number(slot: Slot) -> st.SearchStrategy[float]:
    """Any number within the bounds of a slot; often a bound, nothing, or a plausible one."""
    plain = st.floats(slot.low, slot.high, allow_nan=False)
    if slot.whole:
        plain = st.integers(int(slot.low), int(slot.high)).map(float)
    usual = [slot.low, 0.0, 1e-6, 0.04, 0.5, 3.0, 12.0, 300.0, slot.high]
    if slot.whole:
        usual = [value for value in usual if value == int(value)]
    return st.sampled_from([value for value in usual if slot.low <= value <= slot.high]) | plain


def consistent(numbers: Sequence[float]) -> FloatArray:
    """The numbers, changed as ``doubt`` asks: what is held fits, belief sums to 1, products are of terms."""
    known = np.array(numbers)
    person = Person(known)
    root = np.zeros((time_left.TERMS, time_left.TERMS))
    lower, products = np.tril_indices(time_left.TERMS), person.time_left.products
    root[lower] = products / time_left.MOST_PRODUCT
    products[:] = (root @ root.T * time_left.MOST_PRODUCT / time_left.TERMS)[lower]
    far, long, where = person.distances, person.durations, person.places
    far.last[:] = np.maximum(far.last, distances.SHORTEST_PX)
    long.count = far.count
    held = int(long.count)
    if held:
        long.last[:held] = np.maximum(long.last[:held], 1e-6)
        long.median = np.median(long.last[:held])
        belief = far.belief
        belief[-1] = np.clip(belief[-1], distances.FORGET * distances.UNKNOWN_SHARE, 1.0)
        others = belief[:-1].sum()
        if others > 1e-9:
            belief[:-1] *= (1.0 - belief[-1]) / others
        else:
            belief[:-1], belief[-1] = 0.0, 1.0
    for place in where.places:
        place.visits = max(place.visits, places.LIGHTEST)
    where.history[:] = np.minimum(where.history, where.count - 1.0)
    return known


KNOWN = st.tuples(*(number(slot) for slot in SLOTS for _ in range(slot.count))).map(consistent)
MOVES = st.lists(
    st.tuples(st.floats(0.0, 3000.0), st.floats(-2000.0, 2000.0), st.floats(0.05, 3.0)),
    min_size=2,
    max_size=5,
)


@settings(max_examples=100)
@given(KNOWN, MOVES)
@example(consistent([slot.high for slot in SLOTS for _ in range(slot.count)]), [(500.0, 0.0, 0.5)] * 3)
def test_an_accepted_person_never_breaks_the_law(
    known: FloatArray, moves: list[tuple[float, float, float]]
) -> None:
    pipeline = build(NAME, person=persons.packed(SLOTS, known))
    for one in moves:
        *end, seconds = one
        path = reach((0.0, 0.0), end, seconds, rest_s=0.1, rate_hz=50.0)
        table, plain = run(pipeline, path).table, run(build("kinematic"), path).table
        assert np.array_equal(np.isnan(table), np.isnan(plain))  # it answers where `kinematic` does
        assert np.isfinite(table[~np.isnan(plain)]).all()
        pipeline.reset()
        assert build(NAME, person=pipeline.person).person == pipeline.person


@given(st.text(max_size=60) | st.text(alphabet="AB1.-_=\n", max_size=3000))
def test_text_is_refused_or_nobody(text: str) -> None:
    with suppress(ParameterError):
        assert build(NAME, person=text).person == text == ""
