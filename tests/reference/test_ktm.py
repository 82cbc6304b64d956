"""Kinematic template matching against a plain, slow implementation of the published description."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred import EventColumns, Motion, build, run
from pointpred.errors import ParameterError
from pointpred.predictors import TemplatePredictor, templates_of
from pointpred.recording import Recording, Trial
from pointpred.records import FloatArray
from tests.reference import naive_ktm

Move = tuple[FloatArray, FloatArray, FloatArray]


def moves(count: int, seed: int, longest_s: float = 1.5) -> list[Move]:
    """Reaches of all lengths and rates, with noise, pauses and corrections."""
    random = np.random.default_rng(seed)
    found = []
    for _ in range(count):
        events = int(random.integers(8, 90))
        t = np.sort(random.uniform(0.0, random.uniform(0.2, longest_s), events)) + random.uniform(0.0, 99.0)
        s = (t - t[0]) / (t[-1] - t[0])
        way = 10 * s**3 - 15 * s**4 + 6 * s**5
        end = random.uniform(-700.0, 700.0, 2)
        bend = random.uniform(-60.0, 60.0) * np.sin(np.pi * s)
        x, y = end[0] * way + bend, end[1] * way - bend + random.normal(0.0, 1.0, events)
        found.append((t, x, y))
    return found


def recording(of: list[Move]) -> Recording:
    parts = [EventColumns.of(*move) for move in of]
    return Recording.of("moves", parts, [Trial("ann", str(k)) for k in range(len(of))])


def motions(move: Move) -> Any:
    rows = np.zeros((len(move[0]), 10))
    rows[:, 0], rows[:, 1], rows[:, 2] = move
    rows[0, 8] = 1.0
    return rows


def answers(predictor: TemplatePredictor, move: Move) -> FloatArray:
    begin = np.zeros(len(move[0]), np.bool_)
    begin[0] = True
    return predictor.walk(begin, motions(move))[:, 1:3]


@pytest.mark.parametrize("seed", range(6))
def test_event_by_event_as_the_published_description(seed: int) -> None:
    library = moves(25, seed)
    predictor = TemplatePredictor(templates=0, longest_s=4.0, library=templates_of(recording(library)))
    for move in moves(6, 100 + seed, longest_s=2.5):
        expected = naive_ktm.predictions(*move, library)
        np.testing.assert_allclose(answers(predictor, move), expected, rtol=1e-9, atol=1e-6)


def test_the_winner_changes_during_a_movement() -> None:
    """Else the comparison above would compare little."""
    library = moves(25, 0)
    for move in moves(6, 100, longest_s=2.5):
        found = naive_ktm.predictions(*move, library)[3:]
        far = np.hypot(found[:, 0] - move[1][0], found[:, 1] - move[2][0])
        assert len(np.unique(far.round(6))) > 2


def test_what_a_session_teaches_is_what_a_library_holds() -> None:
    taught, known = moves(8, 3), moves(1, 9)[0]
    pupil = TemplatePredictor(templates=5, shortest_px=0.0)
    for move in taught:
        answers(pupil, move)
    held = pupil.template_table()
    given = templates_of(recording(taught))
    order = [5, 6, 7, 3, 4]  # places are taken in turn: the oldest gives way
    np.testing.assert_array_equal(held, given[order])
    expected = naive_ktm.predictions(*known, [taught[k] for k in order])
    np.testing.assert_allclose(answers(pupil, known), expected, rtol=1e-9, atol=1e-6)


@pytest.mark.parametrize("how", ["reset", "begin", "start"])
def test_each_end_of_a_movement_teaches_it_once(how: str) -> None:
    move = moves(1, 4)[0]
    predictor = TemplatePredictor()
    rows = motions(move)
    if how != "start":
        rows[:, 8] = 0.0
    predictor.walk(np.zeros(len(rows), np.bool_), rows)
    begin = np.zeros(len(rows), np.bool_)
    if how == "reset":
        predictor.reset()
        predictor.reset()
    begin[0] = how == "begin"
    later = rows.copy()
    later[:, 0] += 100.0
    predictor.walk(begin, later[:3])
    predictor.reset()  # three points make no template
    assert len(predictor.template_table()) == 1


def test_too_short_too_long_and_too_near_teach_nothing() -> None:
    def taught(seconds: float, px: float, points: int = 20) -> int:
        predictor = TemplatePredictor(longest_s=1.0, shortest_px=30.0)
        t = np.linspace(0.0, seconds, points)
        answers(predictor, (t, np.linspace(0.0, px, points), 0.0 * t))
        return len(predictor.template_table())

    assert [taught(0.5, 30.0), taught(1.0, 40.0), taught(0.5, 40.0, 4)] == [1, 1, 1]
    assert [taught(0.5, 29.0), taught(1.06, 40.0), taught(0.04, 40.0), taught(0.5, 40.0, 3)] == [0, 0, 0, 0]


def test_a_second_motion_of_one_time_moves_the_cursor_only() -> None:
    library = templates_of(recording(moves(10, 5)))
    one, two = (TemplatePredictor(templates=0, library=library) for _ in range(2))
    t, x, y = moves(1, 6)[0]
    for k, row in enumerate(motions((t, x, y))):
        motion = Motion(*row[:7].tolist(), True, bool(row[8]))
        once = one.update(motion)
        twice = two.update(motion)
        if k % 3 == 2:
            again = two.update(Motion(*row[:7].tolist(), True))
            assert again == twice
        assert once == twice


def test_a_session_without_a_finished_movement_answers_nothing_and_its_second_one_is_answered() -> None:
    move = moves(1, 7)[0]
    events = EventColumns.of(*move)
    pipeline = build("ktm")
    assert np.isnan(run(pipeline, events).x).all()
    pipeline.reset()
    again = run(pipeline, events)
    far = np.hypot(move[1][-1] - move[1][0], move[2][-1] - move[2][0])
    assert np.isnan(again.x[:3]).all()
    np.testing.assert_allclose(np.hypot(again.x[3:] - move[1][0], again.y[3:] - move[2][0]), far)
    assert np.isnan(run(pipeline.fresh(), events).x).all()


def test_a_long_silence_costs_no_more_than_the_longest_template() -> None:
    predictor = TemplatePredictor(library=templates_of(recording(moves(3, 8))))
    for i in range(6):
        predictor.update(Motion(0.05 * i, 10.0 * i, 0.0, 0.0, 0.0, 0.0, 0.0, True, start=i == 0))
    prediction = predictor.update(Motion(1e11, 70.0, 0.0, 0.0, 0.0, 0.0, 0.0, True))
    assert prediction is not None
    assert np.isfinite(prediction.x)


def test_a_library_is_checked() -> None:
    good = templates_of(recording(moves(3, 8)))
    assert len(TemplatePredictor(templates=997, library=good).template_table()) == 3
    with pytest.raises(ParameterError) as too_many:
        TemplatePredictor(templates=998, library=good)
    assert (too_many.value.field, too_many.value.value) == ("templates", 998)
    for settings in ({"longest_s": 0.2, "library": good}, {"library": good[0]}):
        with pytest.raises(ParameterError) as misshapen:
            TemplatePredictor(**settings)
        assert misshapen.value.field == "library"
    for place, value in ((0, 0.0), (0, 99.0), (4, float("nan"))):
        bad = good.copy()
        bad[1, place] = value
        with pytest.raises(ParameterError) as impossible:
            TemplatePredictor(library=bad)
        assert impossible.value.field == "library"
    with pytest.raises(ParameterError) as halved:
        TemplatePredictor(templates=2.5)  # type: ignore[arg-type]
    assert (halved.value.field, halved.value.value) == ("templates", 2.5)
    with pytest.raises(ParameterError, match="1 to 1000 trials, received 0"):
        templates_of(recording([]))
    with pytest.raises(
        ParameterError, match=r"trial '0' of 'ann' is no template.*received 3 points in 0.1 s"
    ):
        templates_of(recording([(np.array([0.0, 0.05, 0.1]), np.arange(3.0), np.arange(3.0))]))
