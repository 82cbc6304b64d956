"""Adaptation: what it learns between movements, what it leaves alone, and that it can be switched off."""

from __future__ import annotations

import pickle
import re
from collections.abc import Callable, Iterable
from math import cos, sin
from pathlib import Path

import numpy as np
import pytest

from pointpred import EventColumns, Motion, Pipeline, build, run
from pointpred.datasets import sample
from pointpred.errors import ParameterError
from pointpred.predictors import AdaptiveKinematicPredictor, KinematicPredictor
from pointpred.predictors.adaptation import correction
from pointpred.predictors.adaptation.correction import Movement, Person, Settings
from pointpred.predictors.adaptation.time_left import Pace
from pointpred.records import FloatArray
from pointpred.scoring import prepare
from pointpred.scoring.replay import replay
from tests import building

X, Y, SXX, SXY, SYY, LEFT, PHASE, TAIL, SPREAD = range(1, 10)
NAME = "kinematic-adaptive"
PAGE = Path(__file__).parents[2] / "docs" / "guide" / "adaptation.md"
SUDDEN = (
    r"is predicted with (.*?) of the error.* fourth with (.*?), .* sixth with (.*?); .* ended with (.*?)\. "
)
"""What the page says of a sudden change."""


def reach(px: float, duration: float = 0.7, angle: float = 0.3, rate: float = 125.0) -> EventColumns:
    """A minimum-jerk reach, then a rest."""
    end = (px * cos(angle), px * sin(angle))
    return building.reach((0.0, 0.0), end, duration, rest_s=0.2, rate_hz=rate)


def session(pipeline: Pipeline, movements: Iterable[EventColumns]) -> list[FloatArray]:
    """The answers to each movement, the pipeline reset before it."""
    found = []
    for events in movements:
        pipeline.reset()
        found.append(run(pipeline, events).table)
    return found


def error(table: FloatArray, events: EventColumns) -> float:
    return float(np.hypot(table[:, X] - events.x[-1], table[:, Y] - events.y[-1]).mean())


def test_a_distance_made_again_and_again_is_expected_and_a_new_one_soon_too() -> None:
    adapted, plain = build(NAME), build("kinematic")
    movements = [reach(400.0, angle=0.4 * k) for k in range(8)] + [reach(900.0, 0.9) for _ in range(8)]
    ratios = [
        error(ours, events) / error(theirs, events)
        for ours, theirs, events in zip(
            session(adapted, movements), session(plain, movements), movements, strict=True
        )
    ]
    assert ratios[0] == 1.0
    assert max(ratios[4:8]) < 0.5
    assert max(ratios) < 1.7  # the price of a sudden change
    assert max(ratios[13:]) < 0.5
    told = re.search(SUDDEN, " ".join(PAGE.read_text(encoding="utf-8").split()))
    assert told is not None
    assert [f"{ratios[i]:.2f}" for i in (8, 11, 13, 7)] == list(told.groups())


@pytest.mark.parametrize("make", [lambda: build(NAME, adapt=0), lambda: Pipeline(
    NAME, build("kinematic").differentiator, AdaptiveKinematicPredictor(adapt=0))])  # fmt: skip
def test_switched_off_it_is_kinematic_bit_for_bit(make: Callable[[], Pipeline]) -> None:
    off = make()
    assert not off.learns
    movements = [reach(300.0 + 40.0 * k) for k in range(5)]
    for ours, theirs in zip(session(off, movements), session(build("kinematic"), movements), strict=True):
        assert ours.tobytes() == theirs.tobytes()


def test_the_first_movement_of_anybody_is_kinematic_bit_for_bit() -> None:
    events = reach(420.0)
    assert run(build(NAME), events).table.tobytes() == run(build("kinematic"), events).table.tobytes()


def test_reset_keeps_the_person_and_fresh_forgets_them() -> None:
    pipeline = build(NAME)
    assert pipeline.learns
    first, *_, last = session(pipeline, [reach(400.0)] * 6)
    pipeline.reset()
    again = run(pipeline, reach(400.0)).table
    assert error(again, reach(400.0)) < error(first, reach(400.0)) / 3.0
    assert not np.array_equal(last, first, equal_nan=True)
    assert run(pipeline.fresh(), reach(400.0)).table.tobytes() == first.tobytes()
    twin = pickle.loads(pickle.dumps(pipeline))
    assert session(twin, [reach(500.0)])[0].tobytes() == session(pipeline, [reach(500.0)])[0].tobytes()


@pytest.mark.parametrize(
    "nothing",
    [reach(6.0), reach(400.0, 0.05, rate=1000.0).rows(0, 40), reach(400.0, rate=8.0).rows(0, 5)],
    ids=["too short a way", "too short a time", "too few samples"],
)
def test_what_is_no_movement_teaches_nothing(nothing: EventColumns) -> None:
    pipeline = build(NAME)
    session(pipeline, [nothing] * 5)
    pipeline.reset()
    events = reach(400.0)
    assert run(pipeline, events).table.tobytes() == run(build(NAME), events).table.tobytes()


def test_a_start_mark_ends_a_movement_as_a_reset_does() -> None:
    marked, reset = AdaptiveKinematicPredictor(), AdaptiveKinematicPredictor()
    motions = build("hold").differentiator.run(reach(400.0)).motions()
    steps = list(motions)
    for movement in range(5):
        reset.reset()
        for i, one in enumerate(steps):
            later = Motion(
                one.t + 2.0 * movement, one.x, one.y, one.vx, one.vy, one.ax, one.ay, True, start=i == 0
            )
            assert marked.update(later) == reset.update(later)


@pytest.mark.parametrize(("angle", "mirror"), [(0.7, 1.0), (2.9, 1.0), (1.1, -1.0)])
def test_a_turned_or_mirrored_session_turns_the_answers(angle: float, mirror: float) -> None:
    matrix = np.array([[cos(angle), -sin(angle)], [sin(angle), cos(angle)]]) @ np.diag([1.0, mirror])
    movements = [reach(400.0 + 15.0 * (k % 3), angle=0.5 * k) for k in range(8)]
    turned = []
    for events in movements:
        table = events.table.copy()
        table[:, 1:3] = table[:, 1:3] @ matrix.T
        turned.append(EventColumns(table))
    for here, there in zip(session(build(NAME), movements), session(build(NAME), turned), strict=True):
        np.testing.assert_allclose(there[:, [X, Y]], here[:, [X, Y]] @ matrix.T, atol=1e-3)
        spread = here[:, [SXX, SXY, SXY, SYY]].reshape(-1, 2, 2)
        expected = (matrix @ spread @ matrix.T).reshape(-1, 4)[:, [0, 1, 3]]
        largest = np.abs(expected[1:]).max(axis=1, keepdims=True)
        np.testing.assert_allclose(there[1:, SXX:LEFT] / largest, expected[1:] / largest, atol=1e-3)
        np.testing.assert_allclose(there[1:, LEFT:], here[1:, LEFT:], rtol=1e-4)


def test_with_counts_the_screen_scales_the_answers() -> None:
    movements, scaled = [], []
    for k in range(7):
        table = reach(400.0, angle=0.5 * k).table.copy()
        table[:, 3:5] = np.round(np.diff(7.0 * table[:, 1:3], prepend=7.0 * table[:1, 1:3], axis=0))
        movements.append(EventColumns(table.copy()))
        table[:, 1:3] *= 3.0
        scaled.append(EventColumns(table))
    here, there = (session(build(NAME, cpi=800.0), some) for some in (movements, scaled))
    for ours, theirs in zip(here, there, strict=True):
        np.testing.assert_allclose(theirs[:, [X, Y]], 3.0 * ours[:, [X, Y]], rtol=1e-6, atol=1e-4)
        np.testing.assert_allclose(theirs[1:, LEFT:], ours[1:, LEFT:], rtol=1e-6)


def test_what_claims_too_little_is_passed_on() -> None:
    person, movement, settings = (np.zeros(one.length) for one in (Person, Movement, Settings))
    settings[:] = 1.0
    none = float("nan")
    for answer in (
        (0.1, 5.0, 6.0, none, none, none, none, 1.0, none, none),
        (0.1, 5.0, 6.0, 1.0, 0.0, 1.0, none, 1.0, 4.0, 0.3),
        (0.1, 5.0, 6.0, 1.0, 2.0, 1.0, 0.4, 1.0, 4.0, 0.3),
    ):
        correction.follow(movement, (0.1, 4.0, 3.0), (0.0, 0.0, 0.0))
        adapted = correction.adapt(settings, person, movement, answer, Pace(1.0, 0.0))
        np.testing.assert_array_equal(adapted, answer)


def test_it_is_better_than_unadapted_on_simulated_people_and_no_worse_at_first() -> None:
    prepared = prepare(sample(), cpi=sample().provenance.cpi, threads=1)
    cpi = sample().provenance.cpi
    ours, theirs = (replay(prepared, build(name, cpi=cpi), threads=1) for name in (NAME, "kinematic"))
    seen: dict[str, int] = {}
    order = []
    for one in prepared.trials:
        order.append(seen.get(one.trial.user, 0))
        seen[one.trial.user] = order[-1] + 1
    first = np.array(order) < 10
    assert ours.time_averaged[first].mean() < 1.01 * theirs.time_averaged[first].mean()
    assert ours.time_averaged[~first].mean() < theirs.time_averaged[~first].mean()


@pytest.mark.parametrize(
    ("given", "message"),
    [({"adapt": 0.5}, "adapt must be a whole number"), ({"distances": 2}, "distances must lie in"),
     ({"shortest_px": -1.0}, "shortest_px must lie in")],
)  # fmt: skip
def test_settings_are_checked(given: dict[str, float], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        build(NAME, **given)


def test_memory_does_not_grow_and_coefficients_are_shared() -> None:
    pipeline = build(NAME)
    size = len(pickle.dumps(pipeline))
    session(pipeline, [reach(float(px)) for px in range(100, 900, 20)])
    assert len(pickle.dumps(pipeline)) == size
    own, other = AdaptiveKinematicPredictor(), KinematicPredictor()
    assert own.shared[0] is other.shared[0]
    assert own.__dict__["_memory"].shape == (3949,)  # as its docstring says
