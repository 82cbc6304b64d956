"""The pipeline given targets: what it answers, learns, keeps and forgets."""

from __future__ import annotations

import pickle
from collections.abc import Sequence
from copy import copy
from itertools import pairwise

import numpy as np
import pytest

from pointpred import EventColumns, Pipeline, PointerEvent, build, run
from pointpred.errors import EventError, EventOrderError
from pointpred.predictors import Predictor
from pointpred.records import MOTION_FIELD, FloatArray, Row, TenFloats, refused
from pointpred.targets import Chooser, Target, around
from tests.building import reach

NAMES = ("hold", "minimum-jerk", "delphian", "kinematic-adaptive")
EVERY = pytest.mark.parametrize("name", NAMES)
TARGETS = [
    around("right", 400.0, 0.0, 40.0),
    Target("left", -430.0, -30.0, 60.0, 60.0, weight=2.0, kind="button"),
    around("up", 0.0, -300.0, 30.0),
    around("middle", 0.0, 0.0, 50.0),
]
CENTRES = {"right": (400.0, 0.0), "left": (-400.0, 0.0), "up": (0.0, -300.0), "middle": (0.0, 0.0)}


def movements(*ends: str | tuple[float, float], start: tuple[float, float] = (0.0, 0.0)) -> EventColumns:
    """Reaches from one place to the next, of targets or others, with a pause of 0.6 s between them."""
    parts, t = [], 0.0
    for end in ends:
        place = CENTRES[end] if isinstance(end, str) else end
        table = reach(start, place).table.copy()
        table[:, 0] += t
        parts.append(table)
        t, start = table[-1, 0] + 0.6, place
    return EventColumns(np.concatenate(parts))


MIXED = ("right", "middle", "left", (123.0, 250.0), "middle", "right", "left", "right")


def aimed(name: str, **settings: float) -> Pipeline:
    return build(name, targets=TARGETS, **settings)


def moved(t: float, x: float = 0.0, y: float = 0.0, count: int = 6) -> FloatArray:
    """What is added to rows that are moved."""
    return np.array([t, x, y, *[0.0] * (count - 3)])


def seen(pipeline: Pipeline) -> tuple[bytes, ...]:
    """All that a pipeline remembers."""
    stages = pipeline.differentiator, pipeline.predictor, pipeline.aim
    targets = pipeline.aim.shares, pipeline.aim.table
    return *(stage.remembered() for stage in stages), *(values.tobytes() for values in targets)


def same(left: FloatArray, right: FloatArray) -> bool:
    return left.tobytes() == right.tobytes()


@EVERY
def test_one_by_one_in_tables_and_in_chunks_are_the_same(name: str) -> None:
    events = movements(*MIXED)
    whole, single, chunked, last = (aimed(name) for _ in range(4))
    expected = run(whole, events).table
    answers = np.array([single.advance(tuple(row)) for row in events.table.tolist()])
    assert same(answers, expected)
    assert [single.update(event) for event in events.rows(0, 0).events()] == []
    cuts = np.unique([0, len(events), *np.random.default_rng(3).integers(0, len(events), 30)])
    for a, b in pairwise(cuts.tolist()):
        part = np.ascontiguousarray(events.table[a:b])
        assert same(chunked.push(part), expected[a:b])
        assert np.array(last.push(part, want="last")).tobytes() == expected[b - 1].tobytes()
    assert seen(single) == seen(whole) == seen(chunked) == seen(last)


@EVERY
def test_begin_marks_are_resets(name: str) -> None:
    events = movements(*MIXED)
    begin = np.zeros(len(events), np.bool_)
    begin[::70] = True
    marked, apart = aimed(name), aimed(name)
    answers = run(marked, EventColumns(events.table, begin)).table
    for first in range(0, len(events), 70):
        part = events.rows(first, min(first + 70, len(events)))
        apart.reset()
        assert same(run(apart, part).table, answers[first : first + 70])
    assert seen(marked) == seen(apart)


@EVERY
def test_without_targets_it_is_the_plain_pipeline(name: str) -> None:
    events = movements(*MIXED)
    plain, emptied = build(name), aimed(name)
    emptied.register(())
    assert emptied.shares == plain.shares == {None: 1.0}
    assert same(run(emptied, events).table, run(plain, events).table)
    assert emptied.mixture == plain.mixture
    assert emptied.shares == {None: 1.0}
    assert not emptied.aim.known.any()


@EVERY
def test_registered_later_they_count_from_the_next_event_on(name: str) -> None:
    events = movements("right")
    late, plain = build(name), build(name)
    assert same(run(late, events.rows(0, 20)).table, run(plain, events.rows(0, 20)).table)
    late.register(TARGETS)
    answers = run(late, events.rows(20, 50)).table
    assert late.shares["right"] > 0.5
    assert np.isnan(answers[:, 1]).tolist() == np.isnan(run(plain, events.rows(20, 50)).table[:, 1]).tolist()


@EVERY
def test_shares_sum_to_one_and_a_prediction_has_a_region(name: str) -> None:
    pipeline, plain = aimed(name), build(name)
    assert sum(pipeline.shares.values()) == pytest.approx(1.0)
    for event in movements(*MIXED).events():
        prediction, own = pipeline.update(event), plain.update(event)
        assert sum(pipeline.shares.values()) == pytest.approx(1.0)
        assert min(pipeline.shares.values()) >= 0.0
        assert (prediction is None) == (own is None)  # where a predictor claims nothing, nothing is claimed
        assert (pipeline.mixture is None) == (prediction is None)
        if prediction is not None and own is not None:
            assert prediction.scale is not None
            assert np.isfinite([prediction.x, prediction.y, *prediction.scale, prediction.tail]).all()
            assert (prediction.remaining_s is None) == (own.remaining_s is None)
            assert prediction.phase == own.phase


@EVERY
def test_the_mixture_is_of_the_shares(name: str) -> None:
    pipeline = aimed(name)
    run(pipeline, movements("right", "middle", "left", "right").rows(0, 270))
    mixture = pipeline.mixture
    assert mixture is not None
    assert sum(part.share for part in mixture.parts) == pytest.approx(1.0)
    likeliest = max((part for part in mixture.parts if part.tail is None), key=lambda part: part.share)
    assert likeliest.share in pipeline.shares.values()


@EVERY
def test_what_comes_later_changes_nothing(name: str) -> None:
    events = movements(*MIXED)
    other = events.table.copy()
    other[300:, 1:3] *= -1.5
    ours, theirs = (run(aimed(name), EventColumns(table)).table for table in (events.table, other))
    assert same(ours[:300], theirs[:300])


@EVERY
def test_a_reset_keeps_the_targets_and_the_person_and_fresh_keeps_the_targets_only(name: str) -> None:
    pipeline = aimed(name)
    run(pipeline, movements(*MIXED))
    pipeline.reset()
    assert pipeline.aim.known.any()
    assert list(pipeline.shares) == ["right", "left", "up", "middle", None]
    assert pipeline.mixture is None
    for fresh in (pipeline.fresh(), build(name, targets=TARGETS)):
        assert seen(fresh) == seen(aimed(name))
    before = pipeline.shares
    pipeline.fresh().register(())
    assert pipeline.shares == before
    pipeline.forget()
    assert seen(pipeline) == seen(aimed(name))
    given = {"right": 0.196, "left": 0.392, "up": 0.196, "middle": 0.196, None: 0.02}
    assert pipeline.shares == pytest.approx(given)


@EVERY
def test_a_pickle_goes_on(name: str) -> None:
    events, pipeline = movements(*MIXED), aimed(name)
    run(pipeline, events.rows(0, 333))
    twin = pickle.loads(pickle.dumps(pipeline))
    rest = events.rows(333, len(events))
    assert same(run(twin, rest).table, run(pipeline, rest).table)
    assert twin.shares == pipeline.shares


@EVERY
def test_a_copy_goes_on_apart(name: str) -> None:
    events, pipeline = movements(*MIXED), aimed(name)
    run(pipeline, events.rows(0, 333))
    twin, before = copy(pipeline), seen(pipeline)
    rest = events.rows(333, len(events))
    answers = run(twin, rest).table
    assert seen(pipeline) == before
    assert same(run(pipeline, rest).table, answers)


@EVERY
def test_memory_does_not_grow(name: str) -> None:
    pipeline, ends = aimed(name), ["right", "left", "up", "middle"] * 5
    run(pipeline, movements("right"))
    size = len(pickle.dumps(pipeline))
    run(pipeline, EventColumns(movements(*ends).table + moved(9.0)))
    assert len(pickle.dumps(pipeline)) == size


@EVERY
def test_the_screen_and_the_clock_have_no_origin(name: str) -> None:
    events = movements(*MIXED)
    targets = [Target(t.id, t.x + 4096.0, t.y - 512.0, t.width, t.height, t.weight, t.kind) for t in TARGETS]
    here, there = aimed(name), build(name, targets=targets)
    shifted = EventColumns(events.table + moved(64.0, 4096.0, -512.0))
    back = run(there, shifted).table - moved(64.0, 4096.0, -512.0, count=10)
    np.testing.assert_allclose(back, run(here, events).table, rtol=1e-5, atol=1e-5)
    assert there.shares == pytest.approx(here.shares, rel=1e-5, abs=1e-9)


@EVERY
@pytest.mark.parametrize("x", [np.nan, np.inf, 2e9])
def test_a_refused_event_changes_nothing(name: str, x: float) -> None:
    pipeline, events = aimed(name), movements("right")
    run(pipeline, events.rows(0, 30))
    before = seen(pipeline)
    with pytest.raises(EventError):
        pipeline.update(PointerEvent(0.5, x, 0.0))
    with pytest.raises(EventOrderError):
        pipeline.update(PointerEvent(0.1, 0.0, 0.0))
    wrong = events.table[30:40].copy()
    wrong[7, 1] = x
    for want in ("all", "last"):
        with pytest.raises(EventError, match="row 7"):
            pipeline.push(wrong, want=want)
    assert seen(pipeline) == before


class Refusing(Predictor):
    """Its law refuses every motion."""

    step = staticmethod(lambda memory, motion: refused(MOTION_FIELD + 1, 0.0))
    states = 1


def test_what_the_predictor_refuses_does_not_reach_the_targets() -> None:
    pipeline = Pipeline("refusing", build("hold").differentiator, Refusing())
    pipeline.register(TARGETS)
    before = pipeline.aim.remembered()
    assert np.isnan(pipeline.advance((0.0, 1.0, 2.0, np.nan, np.nan, 0.0))[0])
    assert pipeline.aim.remembered() == before


def after(pipeline: Pipeline, *ends: str | tuple[float, float]) -> None:
    """After movements to these places, each finished."""
    run(pipeline, movements(*ends))
    pipeline.reset()


@EVERY
@pytest.mark.parametrize(("elsewhere", "least"), [(0.02, 0.2), (0.2, 0.7)])
def test_whoever_passes_all_targets_is_for_none_of_them(name: str, elsewhere: float, least: float) -> None:
    """Two targets on a line, and a cursor that goes on far beyond both; the more surely, the more do."""
    targets = [around("first", 200.0, 0.0, 30.0), around("second", 300.0, 0.0, 30.0)]
    pipeline, towards, beyond = build(name, targets=targets, elsewhere=elsewhere), [], []
    for event in reach((0.0, 0.0), (1600.0, 0.0), 0.8).events():
        pipeline.update(event)
        if event.x < 1400.0:
            (towards if event.x < 315.0 else beyond).append(pipeline.shares[None])
    assert min(towards) < 0.5 * elsewhere + 0.1
    assert min(towards) < beyond[4] < max(beyond)
    assert max(beyond) > least


@EVERY
def test_ends_at_none_of_the_targets_are_learned(name: str) -> None:
    pipeline = aimed(name)
    shares = [pipeline.shares[None]]
    assert shares == pytest.approx([0.02])
    for count in range(1, 8):
        after(pipeline, (150.0 + 9.0 * count, 250.0))
        shares.append(pipeline.shares[None])
    assert shares == sorted(set(shares))
    assert shares[-1] > 0.5
    for _ in range(12):
        after(pipeline, "right")
    assert pipeline.shares[None] < 0.4


@EVERY
def test_the_target_that_is_taken_is_learned_by_its_id_wherever_it_stands_then(name: str) -> None:
    pipeline = aimed(name)
    for _ in range(8):
        after(pipeline, "up")
    assert max(pipeline.shares, key=lambda id: pipeline.shares[id]) == "up"
    pipeline.register([around("new", 0.0, -300.0, 30.0), around("up", 500.0, 500.0, 30.0)])
    assert pipeline.shares["up"] > pipeline.shares["new"]
    pipeline.register([])
    pipeline.register(TARGETS)
    assert max(pipeline.shares, key=lambda id: pipeline.shares[id]) == "up"


def test_kinds_are_learned() -> None:
    pages = [
        [Target(f"{kind} {page} {i}", x, y, 40.0, 40.0, kind=kind) for i, (kind, x, y) in enumerate(laid)]
        for page in range(10)
        for laid in [[("link", 380.0, -20.0), ("button", -420.0, -20.0), ("link", -20.0, 300.0)]]
    ]
    pipeline = build("minimum-jerk")
    for page in pages[:-1]:
        pipeline.register(page)
        after(pipeline, "left")
    pipeline.register(pages[-1])
    weights = list(pipeline.shares.values())
    assert weights[1] > 1.2 * weights[0] == pytest.approx(1.2 * weights[2])


@EVERY
def test_without_learning_nothing_is_known_of_the_person(name: str) -> None:
    pipeline = aimed(name, learn=0)
    before = pipeline.shares
    after(pipeline, *MIXED)
    assert not pipeline.aim.known.any()
    assert pipeline.shares == before
    assert aimed("hold", learn=0).learns is False
    assert aimed("hold").learns is True


@EVERY
@pytest.mark.parametrize("few", [EventColumns.of([0.0, 5.0], [0.0, 400.0], [0.0, 0.0]), movements("middle")])
def test_what_is_no_movement_teaches_nothing(name: str, few: EventColumns) -> None:
    pipeline = aimed(name)
    run(pipeline, few)
    pipeline.reset()
    assert not pipeline.aim.known.any()


@pytest.mark.parametrize("name", [name for name in NAMES if name != "delphian"])  # which says nothing halfway
def test_given_the_targets_the_endpoint_is_nearer(name: str) -> None:
    """Halfway, over movements to targets: the mean distance from the end."""
    ends: Sequence[str] = ("right", "left", "up", "middle", "left", "right", "up", "right")
    events = movements(*ends)
    begins = np.flatnonzero(np.diff(events.t, prepend=-1.0) > 0.3)
    given, plain = run(aimed(name), events).table, run(build(name), events).table
    away = []
    for table in (given, plain):
        rows = [table[begin + 32, 1:3] - CENTRES[end] for begin, end in zip(begins, ends, strict=True)]
        away.append(np.mean([np.hypot(*row) for row in rows]))
    assert away[0] < 0.8 * away[1]


def test_choosers_go_on_where_the_pipeline_forgets_and_where_it_takes_the_aim_of_another() -> None:
    first, later = aimed("minimum-jerk"), build("hold")
    chooser = Chooser(first, precision=0.5)
    first.forget()
    for pipeline in (first, later):
        pipeline.aim, chooser.pipeline = first.aim, pipeline
        pipeline.reset()
        chooser.reset()
        choices = []
        for event in movements("right").events():
            pipeline.update(event)
            choices += chooser.update()
        assert chooser.standing == "right" == next(one.id for one in choices if one.reason == "predicted")


def test_the_likeliest_are_the_largest_shares_best_first() -> None:
    pipeline = aimed("minimum-jerk")
    run(pipeline, movements("right", "left").rows(0, 110))
    shares = pipeline.shares
    shares.pop(None)
    order = sorted(shares.items(), key=lambda one: -one[1])
    assert pipeline.aim.likeliest(2) == order[:2]
    assert pipeline.aim.likeliest() == order


def test_rows_are_answered_as_tuples_of_floats() -> None:
    pipeline = aimed("hold")
    row: Row = (0.0, 1.0, 2.0, np.nan, np.nan, 0.0)
    answer: TenFloats = pipeline.advance(row)
    assert {type(value) for value in answer} == {float}
