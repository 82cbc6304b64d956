"""Predictors scored with the recording's targets: the same as an application that registers them itself."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from pointpred import build
from pointpred.datasets import sample
from pointpred.recording import Recording, Trial
from pointpred.recordings import read, write
from pointpred.records import EventColumns
from pointpred.scoring import FLOOR, about_targets, chunks, prepare, score, summarise
from pointpred.scoring.chunks import score_in_chunks
from pointpred.scoring.executors import open_executor
from pointpred.scoring.replay import WITH_TARGETS, answers_to, given_targets
from pointpred.scoring.scorer import scoring_with
from pointpred.scoring.target_layouts import own_layouts, with_candidates
from tests.building import reach
from tests.conftest import Left

PLACES = ((0.0, 0.0), (400.0, 30.0), (90.0, 350.0), (500.0, 420.0), (-200.0, 210.0), (240.0, -260.0))
NAME = "minimum-jerk"


def study(people: str = "ababbaab", *, known: int = 99, **conditions: Any) -> Recording:
    """Movements of these people among six places, in turns; ``known``: how many say their target."""
    generator = np.random.default_rng(3)
    last, parts, trials = 0, [], []
    for k, who in enumerate(people * 6):
        at = (last + int(generator.integers(1, len(PLACES)))) % len(PLACES)
        parts.append(reach(PLACES[last], np.add(PLACES[at], generator.normal(0.0, 5.0, 2)).tolist()))
        target = (*PLACES[at], 40.0) if k < known else ()
        condition = {name: value(k) if callable(value) else value for name, value in conditions.items()}
        trials.append(Trial(who, str(k), *target, condition=condition))
        last = at
    return Recording.of("study", parts, trials)


def sorted_by_person(one: Recording) -> Recording:
    """The same trials, those of each person together."""
    order = sorted(range(len(one.trials)), key=lambda k: one.trials[k].user)
    return Recording.of(one.name, [one.rows(k) for k in order], [one.trials[k] for k in order])


def test_the_numbers_are_those_of_an_application_that_registers_the_targets() -> None:
    first = study(block=0.0)
    rows = [first.rows(k) for k in range(48)]
    moved = [EventColumns.of(one.t, one.x + 2000.0, one.y) for one in rows]
    there = [
        msgspec.structs.replace(
            one, trial=f"{one.trial} moved", target_x=one.target_x + 2000.0, condition={"block": 1.0}
        )
        for one in first.trials
    ]
    recording = sorted_by_person(Recording.of("study", [*rows, *moved], [*first.trials, *there]))
    (scored,) = score([recording], [NAME], targets=True)
    given = next(one for one in scored.predictors if one.name == NAME + WITH_TARGETS)
    prepared = with_candidates(prepare(recording))
    assert prepared.candidates is not None
    ours, pipelines = [], {}
    for k, one in enumerate(prepared.trials):
        pipeline = pipelines.setdefault(one.trial.user, build(NAME))
        pipeline.reset()
        pipeline.register(prepared.candidates.targets[k])
        events = prepared.rows(k)
        arrival = int(prepared.arrivals[k] - prepared.offsets[k])
        off = []
        for event in events.events():
            answer = pipeline.update(event)
            x, y = (event.x, event.y) if answer is None else (answer.x, answer.y)
            off.append(np.hypot(x - events.x[-1], y - events.y[-1]))
        last = np.minimum(np.diff(events.t[: arrival + 1]), 0.05)
        ours.append(float(np.sum(off[:arrival] * last) / np.sum(last)))
        alone = answers_to(prepared, given_targets(build(NAME)), k)
        assert np.allclose(np.hypot(alone.x - events.x[-1], alone.y - events.y[-1])[-1], off[-1])
    assert given.time_averaged == pytest.approx(ours, rel=1e-12)
    without = next(one for one in scored.predictors if one.name == NAME)
    assert given.time_averaged.mean() < 0.7 * without.time_averaged.mean()
    assert (
        without.time_averaged.tolist() == score([recording], [NAME])[0].predictors[1].time_averaged.tolist()
    )


@pytest.mark.parametrize("recording", [sorted_by_person(study()), sample()], ids=["scattered", "circle"])
def test_neither_names_nor_order_tell_the_right_target(recording: Recording) -> None:
    prepared = with_candidates(prepare(recording))
    assert prepared.candidates is not None
    right_at = []
    for layout in next(iter(own_layouts(prepared).values())):
        targets = prepared.candidates.targets[layout.trial]
        assert sorted(map(str, targets)) == sorted(map(str, layout.targets))
        right_at.append(targets.index(layout.targets[layout.right]))
    assert len(set(right_at)) >= 5
    assert max(map(right_at.count, right_at)) < 0.4 * len(right_at)
    names = [{one.id for one in targets} for targets in prepared.candidates.targets[:3]]
    assert names[0] == names[1] == names[2]


def test_a_block_that_each_trial_has_another_of_is_none() -> None:
    for conditions in ({}, {"block": lambda k: float(k)}, {"block": 1.0}):
        prepared = prepare(sorted_by_person(study(**conditions)))
        assert {kind: len(own) for kind, own in own_layouts(prepared).items()} == {"scattered targets": 48}
    halves = prepare(sorted_by_person(study(block=lambda k: float(k % 48 >= 24))))
    assert {len(one.targets) for one in own_layouts(halves)["scattered targets"]} <= {5, 6}


def test_trials_without_targets_are_scored_without_and_counted() -> None:
    blocks = study("aaaa", known=12, block=lambda k: float(k >= 12))
    part = blocks.part(0, 24)
    (scored,) = score([part], [NAME], targets=True)
    by_name = {one.name: one.time_averaged for one in scored.predictors}
    assert list(by_name) == [FLOOR, FLOOR + WITH_TARGETS, NAME, NAME + WITH_TARGETS]
    assert by_name[NAME][12:].tolist() == by_name[NAME + WITH_TARGETS][12:].tolist()
    assert by_name[NAME][:12].tolist() != by_name[NAME + WITH_TARGETS][:12].tolist()
    assert scored.candidates == {"scattered targets": 12}
    assert "scattered targets (12 of 24 trials), none (12 of 24 trials)." in about_targets(summarise(scored))


def test_where_no_trial_has_targets_that_is_said_and_nothing_is_shown_twice() -> None:
    (scored,) = score([study("aa", known=0)], [NAME], targets=True)
    assert [one.name for one in scored.predictors] == [FLOOR, NAME]
    assert scored.candidates == {}
    assert "no trial has targets" in about_targets(summarise(scored))
    (without,) = score([study("aa", known=0)], [NAME])
    assert without.candidates is None
    assert about_targets(summarise(without)) == ""


@pytest.mark.parametrize("together", [True, False])
def test_chunks_and_executors_give_the_same_document(
    together: bool, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    recording = study("aabbccdd")
    recording = sorted_by_person(recording) if together else recording
    scoring = scoring_with([NAME], targets=True, parameters={NAME: {"learn": 0}})
    (whole,) = score([recording], [NAME], targets=True, parameters={NAME: {"learn": 0}})
    monkeypatch.setattr(chunks, "CHUNK_EVENTS", 100)
    expected = untimed(summarise(whole))
    for way in ({"threads": 1}, {"processes": 2}):
        with open_executor(**way) as executor:
            found = score_in_chunks(recording, scoring, executor)
            assert len(found.chunks) == (4 if together else 1)
            assert untimed(found.summary()) == expected
            assert found.joined(2).worst is not None
            kept = score_in_chunks(recording, scoring, executor, checkpoints=tmp_path)
            assert untimed(kept.summary()) == expected


def untimed(summary: Any) -> Any:
    """A summary without what was timed."""
    each = (msgspec.structs.replace(one, us_per_event=None) for one in summary.predictors)
    return msgspec.structs.replace(summary, predictors=tuple(each))


def test_the_command_shows_both_and_says_what_the_candidates_are(
    command: Callable[..., Left], tmp_path: Path
) -> None:
    file = write(sorted_by_person(study()), tmp_path / "study_samples.csv")[0]
    target, report = tmp_path / "out.json", tmp_path / "out.html"
    told = command("score", file, "--targets", "--predictors", NAME, "--json", target, "--report", report)
    assert told.code == 0
    rows = [line.split("  ")[0] for line in told.out.splitlines()]
    assert rows.index(NAME + WITH_TARGETS) == rows.index(NAME) + 1
    words = "all targets of a trial's block are candidates: scattered targets (48 of 48 trials)."
    assert words in told.out
    assert "scattered targets (48 of 48 trials)" in report.read_text(encoding="utf-8")
    document = json.loads(target.read_text(encoding="utf-8"))
    assert document["version"] == 1
    (one,), (choices,) = document["sets"], document["targets"]
    assert one["candidates"] == {"scattered targets": 48}
    assert [p["name"] for p in one["predictors"]] == [FLOOR, FLOOR + WITH_TARGETS, NAME, NAME + WITH_TARGETS]
    assert choices["layout"] == "scattered targets"
    plain = command("score", file, "--predictors", NAME, "--json", "-")
    assert json.loads(plain.out)["sets"][0]["candidates"] is None
    assert "targets" not in json.loads(plain.out)


@pytest.mark.recordings
def test_recorded_targets_that_come_again_are_those_of_the_person(recordings: Path) -> None:
    found = own_layouts(prepare(read(recordings / "freihaut2021_samples.parquet")))
    assert list(found) == ["scattered targets"]
    assert {len(one.targets) for one in found["scattered targets"]} == {10, 11, 12}
