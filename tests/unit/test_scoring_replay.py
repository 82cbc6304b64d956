"""Replay equals streaming, survives pipelines that fail, and counts what it does."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
import pytest

from pointpred import REGISTRY, EventColumns, build, run
from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline
from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.records import BoolArray, FloatArray, MotionColumns
from pointpred.scoring import prepare, replay, score, scorer, spans
from pointpred.scoring.measures import endpoint
from pointpred.scoring.results import PredictorErrors
from tests.scripted import Scripted, pipeline_with


def walks(trials: int, seed: int = 3, **fields: Any) -> Recording:
    """Trials with dwell before the onset, jittered clocks and whole pixels, of three users."""
    random = np.random.default_rng(seed)
    parts = []
    for _ in range(trials):
        count = int(random.integers(20, 60))
        t = np.cumsum(random.uniform(0.001, 0.02, count))
        s = np.clip((np.arange(count) - 5) / (count - 10), 0.0, 1.0)
        way = s**3 * (10 - 15 * s + 6 * s**2)
        end = random.uniform(-500, 500, 2)
        noise = random.normal(0.0, 1.0, (2, count))
        parts.append(EventColumns.of(t, *np.round(end[:, None] * way + noise)))
    return Recording.of("walks", parts, [Trial(f"u{i % 3}", str(i)) for i in range(trials)], **fields)


class Answers(Scripted):
    """A predictor whose answers a function of the motions gives."""

    def __init__(self, answer: Any) -> None:
        super().__init__()
        self.answer = answer

    def reset(self) -> None:
        pass

    def answers(self, motions: MotionColumns, begin: BoolArray) -> FloatArray:
        table = np.full((len(motions), 10), np.nan)
        table[:, 0] = motions.t
        table[:, 1:3] = self.answer(motions)
        return table


def scripted(answer: Any) -> Pipeline:
    return pipeline_with("scripted", Answers(answer))


def same(one: PredictorErrors, other: PredictorErrors) -> bool:
    names = ("time_averaged", "by_time", "by_path", "single_axis", "coverage")
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in names)


@pytest.mark.parametrize("name", list(REGISTRY))
def test_replay_gives_the_streaming_answers_bit_for_bit(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(spans, "SPAN_EVENTS", 150)
    prepared = prepare(walks(12))
    replayed = replay(prepared, build(name), threads=2)
    assert replayed.failed == ()
    pipelines = {user: build(name) for user in ("u0", "u1", "u2")}
    for k in range(len(prepared.trials)):
        pipeline = pipelines[prepared.trials[k].trial.user]
        pipeline.reset()
        answers = np.full((len(prepared.rows(k)), 10), np.nan)
        for row, event in zip(answers, prepared.rows(k).events(), strict=True):
            prediction = pipeline.update(event)
            if prediction is not None:
                row[1:3] = prediction.x, prediction.y
        out = np.empty(endpoint.MEASURES)
        arrival = int(prepared.arrivals[k] - prepared.offsets[k])
        endpoint.measure_trial(prepared.rows(k).table, answers, endpoint.FRACTIONS, arrival, out)
        assert out[endpoint.TIME_AVERAGED] == replayed.time_averaged[k]
        assert out[endpoint.COVERAGE] == replayed.coverage[k]
        assert np.array_equal(out[endpoint.BY_TIME : endpoint.BY_PATH], replayed.by_time[k])
        assert np.array_equal(out[endpoint.BY_PATH : endpoint.SINGLE_AXIS], replayed.by_path[k])
        assert np.array_equal(out[endpoint.SINGLE_AXIS :], replayed.single_axis[k])


@pytest.mark.parametrize("name", list(REGISTRY))
def test_no_pipeline_sees_the_future_of_its_trial(name: str) -> None:
    recording = walks(6)
    table, known = recording.events.table.copy(), []
    for first, stop in zip(recording.offsets[:-1], recording.offsets[1:], strict=True):
        middle = (first + stop) // 2
        table[middle:stop, 1:3] = 3000.0 - 2.0 * table[middle:stop, 1:3]
        known.append(middle)
    other = Recording.of(
        "other",
        [
            EventColumns(table[a:b])
            for a, b in zip(recording.offsets[:-1], recording.offsets[1:], strict=True)
        ],
        recording.trials,
    )
    here, there = prepare(recording), prepare(other)
    for k, middle in enumerate(known):
        onset = recording.offsets[k + 1] - (here.offsets[k + 1] - here.offsets[k])
        size = middle - onset
        assert size > 3
        before = [build(name), build(name)]  # what has been learned of earlier trials is the same
        for pipeline in before:
            run(pipeline, here.events.rows(0, int(here.offsets[k])))
        one, two = (run(p, of.rows(k)).table[:size] for p, of in zip(before, (here, there), strict=True))
        assert np.array_equal(one, two, equal_nan=True)
        assert here.trials[k].distance_px != there.trials[k].distance_px


@pytest.mark.parametrize(("size", "threads"), [(1, 1), (90, 3), (10**6, 2)])
def test_spans_and_threads_change_nothing(size: int, threads: int, monkeypatch: pytest.MonkeyPatch) -> None:
    prepared = prepare(walks(30))
    whole = replay(prepared, build("hold"), threads=1)
    monkeypatch.setattr(spans, "SPAN_EVENTS", size)
    assert same(replay(prepared, build("hold"), threads=threads), whole)
    assert prepare(walks(30), threads=threads).trials == prepared.trials


def test_spans_hold_every_trial_once_and_no_more_events_than_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(spans, "SPAN_EVENTS", 100)
    offsets = np.array([0, 40, 80, 100, 350, 360, 361])
    assert spans.spans(offsets) == [(0, 3), (3, 4), (4, 6)]
    assert spans.spans(np.array([0])) == []


def test_a_trial_in_which_a_pipeline_fails_is_scored_as_unanswered_and_reported() -> None:
    prepared = prepare(walks(6))
    bad = prepared.rows(2).t[4]

    def answer(motions: Any) -> Any:
        if (motions.t == bad).any():
            raise RuntimeError("lost its way")
        return np.column_stack([motions.x + 1.0, motions.y])

    errors = replay(prepared, scripted(answer), threads=2)
    assert errors.failed == (Skip("2", "RuntimeError: lost its way", user="u2"),)
    assert errors.coverage.tolist() == [1.0, 1.0, 0.0, 1.0, 1.0, 1.0]
    held = replay(prepared, build("hold"))
    assert errors.time_averaged[2] == held.time_averaged[2]
    assert (np.delete(errors.time_averaged, 2) != np.delete(held.time_averaged, 2)).all()


def test_memory_that_runs_out_is_no_failure_of_a_pipeline() -> None:
    def exhausted(motions: MotionColumns) -> FloatArray:
        raise MemoryError("no room for 1 TB")

    with pytest.raises(MemoryError, match="1 TB"):
        replay(prepare(walks(3)), scripted(exhausted))


def test_a_prediction_that_is_not_finite_fails_its_trial_only() -> None:
    prepared = prepare(walks(5))

    def answer(motions: Any) -> Any:
        x = motions.x.copy()
        x[motions.t == prepared.rows(3).t[7]] = np.inf
        return np.column_stack([x, motions.y])

    errors = replay(prepared, scripted(answer))
    assert errors.failed == (Skip("3", "event 7: the prediction is not finite", user="u0"),)
    assert errors.coverage.tolist() == [1.0, 1.0, 1.0, 0.0, 1.0]
    assert same(replay(prepared, scripted(lambda m: m.table[:, 1:3])), replay(prepared, build("hold")))


def test_the_pattern_given_is_not_used_up() -> None:
    pipeline = build("hold")
    replay(prepare(walks(3)), pipeline)
    first = EventColumns.of([0.0], [5.0], [6.0])
    assert np.array_equal(run(pipeline, first).table, run(build("hold"), first).table, equal_nan=True)


def test_cost_is_positive_and_nothing_for_nothing() -> None:
    assert replay(prepare(walks(5)), build("hold")).us_per_event > 0.0
    empty = replay(prepare(Recording.of("none", [], [])), build("hold"))
    assert np.isnan(empty.us_per_event)
    assert empty.by_path.shape == (0, 7)


def test_progress_counts_every_event_of_every_predictor_once_on_the_caller_s_thread() -> None:
    seen: list[tuple[str, int, int]] = []

    def progress(name: str, done: int, total: int) -> None:
        assert threading.current_thread() is threading.main_thread()
        seen.append((name, done, total))

    scores = score([walks(8)], ["hold", scripted(lambda m: m.table[:, 1:3])], progress=progress)
    total = 2 * sum(trial.events for trial in scores[0].trials)
    assert seen[-1] == ("walks", total, total)
    assert [done for _, done, _ in seen] == sorted(done for _, done, _ in seen)


def test_hold_is_always_scored_first_and_names_are_given_once() -> None:
    mine = scripted(lambda m: m.table[:, 1:3])
    assert [errors.name for errors in score([walks(2)], [mine])[0].predictors] == ["hold", "scripted"]
    assert [errors.name for errors in score([walks(2)], [])[0].predictors] == ["hold"]
    with pytest.raises(ParameterError, match="'hold' 2 times"):
        score([walks(2)], ["hold", "hold"])
    with pytest.raises(ParameterError, match="unknown predictor 'holt'; did you mean 'hold'"):
        score([walks(2)], ["holt"])


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({}, {"cpi": 400.0, "dpi": 120.0}),
        ({"cpi": 800.0}, {"cpi": 800.0, "dpi": 120.0}),
        ({"dpi": 90.0}, {"cpi": 400.0, "dpi": 90.0}),
    ],
)
def test_resolution_reaches_the_pipelines_from_the_caller_or_else_from_the_recording(
    given: dict[str, float], expected: dict[str, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[dict[str, Any]] = []

    def watched(name: str, **settings: Any) -> Pipeline:
        seen.append(settings)
        return build(name, **settings)

    monkeypatch.setattr(scorer, "build", watched)
    score([walks(2, provenance=Provenance("own", cpi=400.0, dpi=120.0))], ["linear"], **given)
    assert seen[2:] == [expected] * 2  # the first two only look for names and values that are wrong


def test_every_set_keeps_its_name_and_says_whether_people_were_simulated() -> None:
    simulated = walks(2, provenance=Provenance("own", simulated=True), notes=["mended"])
    scores = score([walks(3), simulated], ["hold"], seed=5)
    assert [(s.name, len(s.trials), s.simulated, s.notes, s.seed) for s in scores] == [
        ("walks", 3, False, (), 5),
        ("walks", 2, True, ("mended",), 5),
    ]
