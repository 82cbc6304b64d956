"""Places: what is remembered of where movements ended, and what of it enters the prediction."""

from __future__ import annotations

from math import hypot

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import optimize, stats

from pointpred import Pipeline, build, run
from pointpred.errors import ParameterError
from pointpred.predictors.adaptation import destination, distances, habits, places
from pointpred.predictors.adaptation.destination import Heading
from pointpred.predictors.adaptation.habits import Habits
from pointpred.predictors.adaptation.places import Places
from pointpred.records import FloatArray, Prediction, prediction_of
from pointpred.scene import scene
from tests.building import reach

NAME = "kinematic-adaptive"
Point = tuple[float, float]


def move(pipeline: Pipeline, start: Point, end: Point) -> Prediction:
    """The prediction after a third of the time of a movement that is then finished."""
    table = run(pipeline, reach(start, end))
    pipeline.reset()
    early = prediction_of(tuple(table.table[20].tolist()))
    assert early is not None
    return early


def visits(ends: list[Point], key: float = 0.0, near: float = 10.0) -> FloatArray:
    """A memory of places after these ends."""
    memory = np.zeros(Places.length)
    for end in ends:
        places.visit(memory, key, end, near)
    return memory


def test_a_place_that_was_visited_draws_the_prediction_and_a_free_direction_does_not() -> None:
    person, stranger = build(NAME), build(NAME, places=0)
    ends: list[Point] = [(500.0, 100.0), (-300.0, 350.0), (120.0, -420.0)]
    for k in range(12):
        for one in (person, stranger):
            move(one, (0.0, 0.0), ends[k % 3])
    with_places, without = (move(one, (0.0, 0.0), ends[0]) for one in (person, stranger))
    assert hypot(with_places.x - 500.0, with_places.y - 100.0) < 0.5 * hypot(
        without.x - 500.0, without.y - 100.0
    )
    aside, plain = (move(one, (0.0, 0.0), (-200.0, -450.0)) for one in (person, stranger))
    assert hypot(aside.x - plain.x, aside.y - plain.y) < 60.0


def test_the_places_say_where_and_how_likely() -> None:
    pipeline = build(NAME)
    assert pipeline.places == ()
    for _ in range(4):
        move(pipeline, (0.0, 0.0), (400.0, 0.0))
        move(pipeline, (400.0, 0.0), (0.0, 0.0))
    before = pipeline.places
    assert [(round(one.x), round(one.y)) for one in before] == [(400, 0), (0, 0)]
    assert all(one.p == one.before for one in before)
    events = reach((0.0, 0.0), (400.0, 0.0))
    run(pipeline, events.rows(0, 20))
    now = pipeline.places
    assert now[0].p > 0.9 > now[0].before > 0.3
    assert sum(one.p for one in now) < 1.0


def test_the_sequence_tells_what_follows_what() -> None:
    """A, B, C in turn: from A most of the belief lies on B; without the sequence it is shared."""
    ends: list[Point] = [(400.0, 0.0), (200.0, 350.0), (0.0, 0.0)]
    beliefs = {}
    for sequence in (0, 1):
        pipeline = build(NAME, sequence=sequence)
        for k in range(60):
            move(pipeline, ends[(k - 1) % 3], ends[k % 3])
        move(pipeline, ends[2], ends[0])
        first = pipeline.places[0]
        beliefs[sequence] = first.before / sum(one.before for one in pipeline.places)
        if sequence:
            assert (round(first.x), round(first.y)) == (200, 350)
    assert beliefs[1] > 0.7
    assert beliefs[0] < 0.6


def test_places_belong_to_a_window_and_move_with_it() -> None:
    pipeline = build(NAME)
    pipeline.enter("editor", 100.0, 50.0)
    for _ in range(3):
        move(pipeline, (150.0, 80.0), (600.0, 250.0))
    pipeline.enter("mail", 0.0, 0.0)
    assert pipeline.places == ()
    pipeline.enter("editor", 300.0, 0.0)
    (place,) = pipeline.places
    assert (round(place.x), round(place.y)) == (800, 200)
    moved = move(pipeline, (350.0, 30.0), (800.0, 200.0))
    still = build(NAME, person=pipeline.person)
    still.enter("other", 300.0, 0.0)
    unknown = move(still, (350.0, 30.0), (800.0, 200.0))
    assert hypot(moved.x - 800, moved.y - 200) < hypot(unknown.x - 800, unknown.y - 200)


def test_a_movement_into_another_window_goes_on_and_ends_where_it_stops() -> None:
    """Entered on the way, the window is that of the next movement; nothing is learned of the border."""
    crossing, other = build(NAME), build(NAME)
    for pipeline in (crossing, other):
        pipeline.enter("left", 0.0, 0.0)
    events = reach((100.0, 100.0), (900.0, 400.0))
    answers = run(crossing, events.rows(0, 30)).table
    crossing.enter("right", 500.0, 0.0)
    answers = np.vstack([answers, run(crossing, events.rows(30, len(events))).table])
    np.testing.assert_array_equal(answers, run(other, events).table)
    crossing.reset()
    other.reset()
    assert crossing.places == ()
    assert [(round(one.x), round(one.y)) for one in other.places] == [(900, 400)]
    crossing.enter("left", 0.0, 0.0)
    assert crossing.places == other.places


def test_before_a_movement_it_starts_where_the_last_one_in_this_window_ended() -> None:
    pipeline = build(NAME)
    pipeline.enter("a", 0.0, 0.0)
    for k in range(6):
        ends = ((400.0, 0.0), (0.0, 0.0))
        move(pipeline, ends[(k + 1) % 2], ends[k % 2])
    here = {(round(one.x), round(one.y)): one.before for one in pipeline.places}
    pipeline.enter("b", 0.0, 0.0)
    move(pipeline, (0.0, 0.0), (390.0, 10.0))
    pipeline.enter("a", 0.0, 0.0)
    there = {(round(one.x), round(one.y)): one.before for one in pipeline.places}
    assert here[0, 0] == there[0, 0] == 0.0  # the last movement of this window ended there
    run(pipeline, reach((401.0, 0.0), (0.0, 0.0)).rows(0, 1))
    begun = {(round(one.x), round(one.y)): one.before for one in pipeline.places}
    assert begun[400, 0] == 0.0 < begun[0, 0]


@pytest.mark.parametrize(
    ("key", "x", "field"),
    [("\ud800", 0.0, "key"), (3, 0.0, "key"), ("a", float("nan"), "x"), ("a", 2e9, "x")],
)
def test_a_window_that_cannot_be_is_refused_and_nothing_changes(key: str, x: float, field: str) -> None:
    pipeline = build(NAME)
    run(pipeline, reach((0.0, 0.0), (300.0, 0.0)))
    before = pipeline.predictor.remembered()
    with pytest.raises(ParameterError) as refused:
        pipeline.enter(key, x, 0.0)
    assert refused.value.field == field
    assert pipeline.predictor.remembered() == before


def test_forget_leaves_nothing_of_the_person() -> None:
    pipeline = build(NAME)
    pipeline.enter("editor", 10.0, 10.0)
    for _ in range(3):
        move(pipeline, (0.0, 0.0), (300.0, 40.0))
    pipeline.forget()
    assert (pipeline.places, pipeline.person) == ((), "")
    assert pipeline.predictor.remembered() == build(NAME).predictor.remembered()


def test_with_places_off_the_ends_leave_no_trace() -> None:
    pipeline = build(NAME, places=0)
    for _ in range(3):
        move(pipeline, (0.0, 0.0), (300.0, 40.0))
    assert pipeline.places == ()
    assert build(NAME, places=0, person=pipeline.person).person == pipeline.person


@given(
    st.lists(
        st.tuples(st.integers(0, 90), st.sampled_from([0.0, 7.0]), st.floats(-3.0, 3.0)),
        min_size=1,
        max_size=300,
    )
)
def test_memory_is_bounded_and_what_is_held_fits(ends: list[tuple[int, float, float]]) -> None:
    """At most 64 places are held, and the history names places that are held."""
    memory = np.zeros(Places.length)
    for number, key, off in ends:
        places.visit(memory, key, (100.0 * number, off), 10.0)
        assert places.doubt(Places(memory)) == ""
    count = int(Places(memory).count)
    assert count == min(count, places.CAPACITY, len({(number, key) for number, key, _ in ends}))
    held = Places(memory).places[:count]
    number, key, _ = ends[-1]
    last = held[places.visited(memory, 0)]
    assert last.key == key
    assert abs(last.x - 100.0 * number) < 1e-6
    assert sum(one.visits for one in held) <= sum(places.KEEP**k for k in range(len(ends))) + 1e-6


def test_the_least_visited_place_is_forgotten_and_its_visits_with_it() -> None:
    ends = [(100.0 * k, 0.0) for k in range(places.CAPACITY)]
    memory = visits([*ends, *ends[1:], (9000.0, 0.0)])
    held = [one.x for one in Places(memory).places]
    assert 0.0 not in held
    assert 9000.0 in held
    assert [places.visited(memory, age) for age in (0, places.CAPACITY * 2 - 1)] == [0, -1]


def test_habits_are_shares_of_one_for_each_rule() -> None:
    random = np.random.default_rng(3)
    where, habit = np.zeros(Places.length), np.zeros(Habits.length)
    at = (0.0, 0.0)
    for _ in range(200):
        end = (100.0 * float(random.integers(0, 9)), 50.0)
        habits.learn(habit, where, (0.0, 1.0, 5.0), (*at, *end), 1.0)
        places.visit(where, 0.0, end, 5.0)
        at = end
    out = np.zeros((habits.RULES, places.CAPACITY))
    assert habits.shares(habit, where, 0.0, (*at, 5.0), out)
    np.testing.assert_allclose(out.sum(axis=1), 1.0, rtol=1e-12)
    assert 0.9 < habits.returns(habit) < 1.0
    for with_sequence in (0.0, 1.0):
        weights = [habits.rule_weight(habit, k, with_sequence) for k in range(habits.RULES)]
        assert sum(weights) == pytest.approx(1.0, rel=1e-12)


def test_nearer_places_are_likelier_and_the_place_at_the_start_is_no_destination() -> None:
    held, habit = Places(np.zeros(Places.length)), np.zeros(Habits.length)
    going = destination.Movement(np.zeros(destination.Movement.length))
    for x in (0.0, 200.0, 400.0):
        places.visit(held.memory, 0.0, (x, 0.0), 5.0)
    for one in held.places:
        one.visits = 1.0
    held.history[:] = places.NOWHERE  # so that only how often counts
    destination.prepare(going.memory, held.memory, habit, (0.0, 0.0, 6.0), (3.0, 0.0))
    at_start, near, far = going.before[:3]
    assert at_start == 0.0
    assert near / far == pytest.approx((397.0 / 197.0) ** destination.NEARNESS, rel=1e-12)
    assert near + far == pytest.approx(1.0, rel=1e-12)


def test_a_rule_that_predicts_gains_weight_and_one_that_does_not_loses_it() -> None:
    """A cycle of seven places: what follows here, and how long ago, say more than how often."""
    where, habit, at = np.zeros(Places.length), np.zeros(Habits.length), (0.0, 0.0)
    ends = [(300.0 * np.cos(k), 300.0 * np.sin(k)) for k in range(7)]
    for k in range(60):
        habits.learn(habit, where, (0.0, 1.0, 9.0), (*at, *ends[k % 7]), 1.0)
        places.visit(where, 0.0, ends[k % 7], 9.0)
        at = ends[k % 7]
    weights = [habits.rule_weight(habit, k, 1.0) for k in range(habits.RULES)]
    assert weights[habits.FROM_HERE] + weights[habits.AFTER_SO_MANY] > 0.7


@pytest.mark.parametrize(("width", "angle"), [(0.05, 0.3), (0.1, 2.0)])
def test_the_density_of_a_place_is_that_of_a_normal_law_over_where_nothing_is_known(
    width: float, angle: float
) -> None:
    distance, end = 400.0, (12.0, -9.0)
    spread = width * distance
    own = stats.multivariate_normal([0.0, 0.0], spread**2 * np.eye(2)).pdf(end)
    unknown = 1.0 / (2.0 * np.pi * distance**2 * distances.UNKNOWN_LOGS)
    ratio = habits.density_ratio(end[0] ** 2 + end[1] ** 2, distance**2, width)
    assert ratio == pytest.approx(own / unknown, rel=1e-12)
    heading = Heading(30.0, 40.0, np.cos(angle), np.sin(angle), 50.0, 20.0, 5.0)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    shape = turn @ np.diag([50.0**2 + spread**2, 20.0**2 + spread**2]) @ turn.T
    law = stats.multivariate_t([30.0, 40.0], shape, df=5.0)
    likely = destination.likelihood(heading, 80.0, 10.0, distance, spread)
    assert likely == pytest.approx(law.pdf([80.0, 10.0]) / unknown, rel=1e-9)


def test_the_answer_is_the_point_of_least_mean_distance() -> None:
    rows = np.array([[0.3, 0.0, 0.0, 900.0], [0.5, 300.0, 40.0, 25.0], [0.2, -100.0, 200.0, 25.0]])

    def mean_distance(point: FloatArray) -> float:
        off = rows[:, 1:3] - point
        return float((rows[:, 0] * np.sqrt((off**2).sum(axis=1) + rows[:, 3])).sum())

    best = optimize.minimize(mean_distance, [100.0, 50.0], method="Nelder-Mead")
    x, y = destination.geometric_median(rows, 3)
    assert mean_distance(np.array([x, y])) < best.fun * 1.01


def test_nothing_depends_on_the_scale_or_the_place_of_the_screen() -> None:
    ends: list[Point] = [(400.0, 100.0), (-250.0, 300.0), (400.0, 100.0), (402.0, 97.0), (-250.0, 300.0)]

    def session(scale: float, shift: Point) -> FloatArray:
        where, habit, going = (np.zeros(one.length) for one in (Places, Habits, destination.Movement))
        start = shift
        for x, y in ends:
            end = (scale * x + shift[0], scale * y + shift[1])
            near = places.NEAR_SHARE * hypot(end[0] - start[0], end[1] - start[1])
            habits.learn(habit, where, (0.0, 1.0, near), (*start, *end), 1.0)
            places.visit(where, 0.0, end, near)
        destination.prepare(going, where, habit, (0.0, 1.0, near), start)
        ahead = Heading(
            scale * 300.0 + shift[0], scale * 90.0 + shift[1], 1.0, 0.0, scale * 80, scale * 40, 6.0
        )
        destination.weigh(going, where, start, ahead, (1.0, 1.0))
        x, y, _, _, wide, broad, _ = destination.combine(going, where, start, ahead)
        return np.array([(x - shift[0]) / scale, (y - shift[1]) / scale, wide / scale, broad / scale])

    np.testing.assert_allclose(session(3.0, (0.0, 0.0)), session(1.0, (0.0, 0.0)), rtol=1e-9)
    np.testing.assert_allclose(session(1.0, (512.0, -64.0)), session(1.0, (0.0, 0.0)), rtol=1e-9)


def test_names_of_windows_become_different_numbers() -> None:
    keys = [scene(name, 0.0, 0.0).key for name in ("", "a", "b", "editor", "Editor")]
    assert len(set(keys)) == 5
    assert keys[0] == 0.0
    assert all(key == int(key) < places.LARGEST_KEY for key in keys)
