"""What is known of a person laid over an answer, by the formula; what a movement teaches, by the scorer."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns, build, run
from pointpred.predictors.adaptation import correction, distances, time_left
from pointpred.predictors.adaptation.correction import Movement, Person, Settings
from pointpred.predictors.adaptation.distances import Ahead
from pointpred.predictors.adaptation.predictor import Memory
from pointpred.predictors.adaptation.time_left import Estimates, Pace, Way
from pointpred.predictors.adaptation.time_left_prior import PRIOR
from pointpred.recording import Recording, Trial
from pointpred.records import FloatArray
from pointpred.scoring import prepare

ALONG, WIDE, REACHED, LEFT = 60.0, 60.0, 200.0, 0.4
PACE = Pace(0.7, 0.05)


def person(duration: float, shift: float = 0.0) -> Person:
    """Somebody who made 400 px eight times; a clock that alone is believed; a bias of so many px."""
    made = Person(np.zeros(Person.length))
    for _ in range(8):
        distances.remember(made.distances.memory, 400.0)
    made.durations.count, made.durations.median, made.durations.best = 8.0, duration, 1.0
    for stage in made.stages.stages:
        stage.ahead = shift / ALONG
        stage.bias_paid = stage.bias_size = 1e12
    return made


def asked(known: Person, since: float, ask: float) -> tuple[float, float, float]:
    """Way ahead, its deviation and the time left, adapted, ``since`` after the start."""
    settings, movement = Settings(np.zeros(Settings.length)), Movement(np.zeros(Movement.length))
    settings.distances = ask
    movement.started, movement.t, movement.x = 1.0, since, REACHED
    answer = (since, REACHED + ALONG, 0.0, WIDE**2, 0.0, 40.0**2, LEFT, 0.0, 8.0, 0.3)
    _, x, y, sxx, _, _, left, *_ = correction.adapt(
        settings.memory, known.memory.copy(), movement.memory, answer, PACE
    )
    assert y == 0.0
    return x - REACHED, float(np.sqrt(sxx)), left


@pytest.mark.parametrize(
    ("since", "gone"), [(0.1, 0.2), (0.3, 0.6), (0.4, 0.8), (0.5, 0.5 / 0.52), (2.0, 2.0 / 2.02)]
)
def test_bias_and_distances_fade_out_by_the_clock(since: float, gone: float) -> None:
    """From 0.2 and 0.5 of the time on, the width too; the time left is the sum of its terms."""
    known_person = person(0.5, shift=12.0)
    biased = ALONG + 12.0 * min((1.0 - gone) / 0.8, 1.0)
    along, wide, left = asked(known_person, since, 0.0)
    assert along == pytest.approx(biased, rel=1e-12)
    assert wide == pytest.approx(WIDE, rel=1e-12)
    way = Way(REACHED, biased)
    mixed = max(0.5 - since, 0.02)
    known = time_left.terms(Estimates(mixed, LEFT), way, PACE, since, 0.5)
    assert known[0] == pytest.approx(2.0 * mixed, rel=1e-12)
    assert left == pytest.approx(0.5 * float(np.dot(PRIOR[: time_left.TERMS], known)), rel=1e-9)
    ahead = Ahead(biased, WIDE, 40.0, 8.0)
    usual, narrow, _ = distances.combine(known_person.distances.memory, REACHED, ahead)
    assert usual > biased + 50.0
    assert narrow < 0.8 * WIDE
    still = min((1.0 - gone) / 0.5, 1.0)
    along, wide, _ = asked(known_person, since, 1.0)
    assert along == pytest.approx(biased + still * (usual - biased), rel=1e-9)
    assert wide == pytest.approx(WIDE * (narrow / WIDE) ** still, rel=1e-9)


def learned(path: EventColumns, **settings: float) -> FloatArray:
    """The memory of a session after one movement."""
    pipeline = build("kinematic-adaptive", **settings)
    run(pipeline, path)
    pipeline.reset()
    memory: FloatArray = pipeline.predictor.__dict__["_memory"]
    return memory


def duration(memory: FloatArray) -> float:
    return float(Memory(memory).person.durations.last[0])


@pytest.mark.parametrize("rate", [60.0, 125.0, 500.0, 1000.0, 8000.0])
@pytest.mark.parametrize("stop", [False, True], ids=["slows down", "stops dead"])
def test_the_duration_learned_is_the_scorers(rate: float, stop: bool) -> None:
    """To within 5 ms or a sample, also where the last way lies between two places that are kept."""
    t = np.arange(0.0, 2.1, 1.0 / rate)
    s = np.clip(t / 0.3, 0.0, 1.0)
    path = EventColumns.of(t, 1500.0 * (s if stop else 10 * s**3 - 15 * s**4 + 6 * s**5), np.zeros(len(t)))
    (trial,) = prepare(Recording.of("one", [path], [Trial("ann", "1")]), threads=1).trials
    arrived = trial.onset_s + trial.arrival_s
    assert duration(learned(path)) == pytest.approx(arrived, abs=max(0.0052, 1.01 / rate))


def test_an_event_of_the_same_time_replaces_the_first_in_what_is_learned() -> None:
    t = np.arange(0.0, 0.9, 0.008)
    s = np.clip(t / 0.6, 0.0, 1.0)
    x = 400.0 * (10 * s**3 - 15 * s**4 + 6 * s**5)
    wrong = np.stack([x + 30.0, x], axis=1).ravel()
    wrong[0] = 0.0
    doubled = EventColumns.of(np.repeat(t, 2), wrong, np.zeros(2 * len(t)))
    once, twice = learned(EventColumns.of(t, x, np.zeros(len(t)))), learned(doubled)
    assert duration(once) == duration(twice)


def test_a_movement_that_ends_where_it_began_teaches_nothing() -> None:
    t = np.arange(0.0, 1.0, 0.01)
    there_and_back = EventColumns.of(t, 300.0 * np.sin(np.pi * t / t[-1]).round(6), np.zeros(len(t)))
    pipeline = build("kinematic-adaptive", shortest_px=0.0)
    s = np.clip(t / 0.6, 0.0, 1.0)
    straight = EventColumns.of(t, 300.0 * (10 * s**3 - 15 * s**4 + 6 * s**5), np.zeros(len(t)))
    for path in [there_and_back] * 4 + [straight] * 3:
        pipeline.reset()
        table = run(pipeline, path).table
    assert np.isfinite(table[-1]).all()
    memory = learned(there_and_back, shortest_px=0.0)
    assert not Memory(memory).person.memory.any()
