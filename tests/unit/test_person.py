"""A person's knowledge as a string: exact, bounded, and refused where it is not what a pipeline wrote."""

from __future__ import annotations

import base64
import hashlib
import pickle
import string

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred import REGISTRY, EventColumns, Pipeline, build, run
from pointpred import person as persons
from pointpred.errors import ParameterError
from pointpred.layout import Slot
from pointpred.predictors import AdaptiveKinematicPredictor
from pointpred.records import FloatArray

NAME = "kinematic-adaptive"
SLOTS = AdaptiveKinematicPredictor.slots


def movement(distance: float, seconds: float, begun: float = 0.0, side: float = 0.2) -> EventColumns:
    """A minimum-jerk movement at 125 Hz that ends with a short rest."""
    t = np.arange(0.0, seconds + 0.15, 0.008)
    share = np.minimum(t / seconds, 1.0)
    way = np.round(distance * (10 * share**3 - 15 * share**4 + 6 * share**5))
    return EventColumns.of(begun + t, way, np.round(side * way))


MOVEMENTS = [movement(150.0 + 90.0 * k, 0.4 + 0.05 * k, 10.0 * k, 0.1 * k) for k in range(9)]


def taught(count: int = 5) -> Pipeline:
    """A pipeline after some finished movements."""
    pipeline = build(NAME)
    for one in MOVEMENTS[:count]:
        run(pipeline, one)
        pipeline.reset()
    return pipeline


PERSON = taught().person


def known() -> FloatArray:
    return persons.unpacked(SLOTS, PERSON).copy()


@pytest.mark.parametrize("name", REGISTRY)
def test_nobody_is_known_before_anybody_moved(name: str) -> None:
    assert build(name).person == ""
    assert build(name, person="").person == ""


@pytest.mark.parametrize("name", REGISTRY)
def test_every_predictor_restores_what_it_saves(name: str) -> None:
    pipeline = build(name)
    for one in MOVEMENTS[:3]:
        run(pipeline, one)
        pipeline.reset()
    assert build(name, person=pipeline.person).person == pipeline.person
    assert bool(pipeline.person) == (name == NAME)


def test_it_is_short_printable_and_exact() -> None:
    assert len(PERSON) <= persons.LARGEST
    assert set(PERSON) <= set(string.ascii_letters + string.digits + "-_.")
    restored = build(NAME, person=PERSON)
    assert restored.person == PERSON
    assert restored.predictor.known.tobytes() == taught().predictor.known.tobytes()


@pytest.mark.parametrize("pause", [False, True], ids=["by reset", "by a pause"])
@pytest.mark.parametrize("cut", [1, 4, 8])
def test_a_session_cut_in_two_goes_on_bit_for_bit(cut: int, pause: bool) -> None:
    whole, first = build(NAME), build(NAME)
    tables = [run(whole, one).table for one in MOVEMENTS] if pause else []
    for one in [] if pause else MOVEMENTS:
        tables.append(run(whole, one).table)
        whole.reset()
    for one in MOVEMENTS[:cut]:
        run(first, one)
        first.reset()
    second = build(NAME, person=first.person)
    for one, table in zip(MOVEMENTS[cut:], tables[cut:], strict=True):
        assert run(second, one).table.tobytes() == table.tobytes()
        second.reset()
    whole.reset()
    assert second.person == whole.person
    assert tables[-1].tobytes() != run(build(NAME), MOVEMENTS[-1]).table.tobytes()  # it learned something


def test_the_movement_that_goes_on_is_not_saved() -> None:
    pipeline = taught()
    run(pipeline, MOVEMENTS[5])
    assert pipeline.person == PERSON
    pipeline.reset()
    assert pipeline.person == taught(6).person != PERSON


def test_fresh_knows_nobody_and_a_pickle_knows_the_person() -> None:
    restored = build(NAME, person=PERSON)
    assert restored.fresh().person == ""
    assert restored.person == PERSON
    assert pickle.loads(pickle.dumps(restored)).person == PERSON


def test_who_adapts_to_nobody_saves_and_takes_nobody() -> None:
    assert build(NAME, adapt=0, person="").person == ""
    with pytest.raises(ParameterError, match="person"):
        build(NAME, adapt=0, person=PERSON)


@pytest.mark.parametrize("name", sorted(set(REGISTRY) - {NAME}))
def test_others_refuse_a_person(name: str) -> None:
    with pytest.raises(ParameterError, match="person"):
        build(name, person=PERSON)


@pytest.mark.parametrize(
    "wrong",
    [
        "x",
        "1.",
        "1.AA",
        "2" + PERSON[1:],
        PERSON[2:],
        PERSON[:-1],
        PERSON[:-4],
        PERSON + "A",
        PERSON + "AAAA",
        PERSON + "=",
        PERSON + "\n",
        " " + PERSON,
        PERSON[:200] + chr(ord(PERSON[200]) ^ 1) + PERSON[201:],
        PERSON[:200] + "+" + PERSON[201:],
        PERSON[:200] + "é" + PERSON[201:],
        PERSON[:200] + "\ud800" + PERSON[201:],
        "1." + "A" * persons.LARGEST,
        persons.packed(SLOTS, np.zeros_like(known())),
        persons.packed(SLOTS, known()[:-1]),
        persons.packed(SLOTS, np.append(known(), 1.0)),
        persons.packed(SLOTS[:-1], known()),
        persons.packed((Slot("other", 1, 0.0, 1.0), *SLOTS[1:]), known()),
        None,
        b"1.AA",
        7,
    ],
)
def test_what_no_pipeline_wrote_is_refused(wrong: object) -> None:
    with pytest.raises(ParameterError, match="person"):
        build(NAME, person=wrong)  # type: ignore[arg-type]


def test_a_damaged_character_is_noticed_wherever_it_is() -> None:
    for at in range(0, len(PERSON), 3):
        other = "A" if PERSON[at] != "A" else "B"
        with pytest.raises(ParameterError, match="person"):
            build(NAME, person=PERSON[:at] + other + PERSON[at + 1 :])


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -np.inf, 1e300, -1e300])
def test_every_number_is_bounded(wrong: float) -> None:
    for at in range(len(known())):
        values = known()
        values[at] = wrong
        with pytest.raises(ParameterError, match="person contains"):
            build(NAME, person=persons.packed(SLOTS, values))


def test_bounds_are_closed_and_kept_for_each_number() -> None:
    at = 0
    for slot in SLOTS:
        for place in range(at, at + slot.count):
            for bound, beyond in ((slot.low, -np.inf), (slot.high, np.inf)):
                values = known()
                values[place] = np.nextafter(bound, beyond)
                with pytest.raises(ParameterError, match=slot.name):
                    build(NAME, person=persons.packed(SLOTS, values))
        at += slot.count
    assert at == build(NAME).predictor.learned


def test_numbers_that_count_something_are_whole() -> None:
    at = 0
    for slot in SLOTS:
        if slot.whole and slot.high > slot.low:
            values = known()
            values[at] = slot.low + 0.5
            with pytest.raises(ParameterError, match=f"{slot.name} must be whole, is"):
                build(NAME, person=persons.packed(SLOTS, values))
        at += slot.count
    assert any(slot.whole and slot.high > slot.low for slot in SLOTS)


def place_of(name: str) -> int:
    at = 0
    for slot in SLOTS:
        if slot.name == name:
            return at
        at += slot.count
    raise AssertionError(name)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("distances held", 2.5),
        ("durations held", 0.5),
        ("distances", 0.0),
        ("distances", 1e-9),
        ("distances held", 4.0),
        ("durations", 0.0),
        ("median", 1e9),
    ],
)
def test_numbers_fit_each_other(name: str, value: float) -> None:
    values = known()
    values[place_of(name)] = value
    with pytest.raises(ParameterError, match=name):
        build(NAME, person=persons.packed(SLOTS, values))


# Values near each bound of a number, at it, and between.
anywhere = st.tuples(
    st.integers(0, len(known()) - 1), st.sampled_from([0.0, 1e-9, 0.3, 0.5, 1.0 - 1e-9, 1.0])
)


@settings(max_examples=40)
@given(st.lists(anywhere, min_size=1, max_size=8))
def test_a_person_made_by_hand_is_refused_or_predicts_finite_numbers(
    changes: list[tuple[int, float]],
) -> None:
    bounds = [(slot.low, slot.high, slot.whole) for slot in SLOTS for _ in range(slot.count)]
    values = known()
    for at, share in changes:
        low, high, whole = bounds[at]
        value = low + share * (high - low)
        values[at] = round(value) if whole else value
    try:
        pipeline = build(NAME, person=persons.packed(SLOTS, values))
    except ParameterError as refused:
        if "person contains" not in str(refused):
            raise
        return
    for one in MOVEMENTS[5:7]:  # the second with what the first taught
        table = run(pipeline, one).table
        assert not np.isinf(table).any()
        assert np.array_equal(np.isnan(table), np.isnan(run(build(NAME, person=PERSON), one).table))
        pipeline.reset()
    assert build(NAME, person=pipeline.person).person == pipeline.person


@pytest.mark.parametrize(
    "shares",
    [np.full(7, 0.9), np.full(7, 1.1), np.array([1.0] * 6 + [0.0])],
    ids=["sum below one", "sum above one", "nothing left for nothing known"],
)
def test_belief_sums_to_one_and_leaves_something_for_nothing_known(shares: np.ndarray) -> None:
    values = known()
    belief = place_of("belief")
    values[belief : belief + 7] *= shares
    with pytest.raises(ParameterError, match="belief"):
        build(NAME, person=persons.packed(SLOTS, values))


def test_the_digest_is_blake2b_of_what_stands_before_it() -> None:
    """The format as the docs give it, taken apart without the code that writes it."""
    body = base64.urlsafe_b64decode(PERSON[2:] + "=" * (-len(PERSON[2:]) % 4))
    assert hashlib.blake2b(body[:-8], digest_size=8).digest() == body[-8:]
    assert np.array_equal(np.frombuffer(body[8:-8], "<f8"), taught().predictor.known)


def test_a_person_of_which_half_is_damaged_changes_nothing() -> None:
    pipeline = taught()
    with pytest.raises(ParameterError, match="person"):
        pipeline.person = f"{taught(2).person}+1.AAAA"
    assert pipeline.person == PERSON
    with pytest.raises(ParameterError, match="cut off"):
        pipeline.person = f"{PERSON}+"


@pytest.mark.parametrize("wrong", [None, 5, {1}])
def test_targets_that_are_no_sequence_are_refused(wrong: object) -> None:
    with pytest.raises(ParameterError, match="sequence of Target"):
        build("minimum-jerk").register(wrong)  # type: ignore[arg-type]
