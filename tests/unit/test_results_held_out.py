"""Nobody is judged by coefficients that saw him: which pipeline judges whom."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from evidence import held_out
from evidence.held_out import HeldOut
from evidence.results import measure
from pointpred import EventColumns
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recording import Recording, Trial
from pointpred.scoring import prepare, replay

NAMES = ("hold", "kinematic")


def recording(name: str) -> Recording:
    random, s = np.random.default_rng(3), np.linspace(0.0, 1.0, 40)
    way = s**3 * (10 - 15 * s + 6 * s**2)
    parts = [
        EventColumns.of(0.016 * np.arange(40), *(random.uniform(-600, 600, (2, 1)) * way)) for _ in range(9)
    ]
    return Recording.of(name, parts, [Trial(f"u{i % 3}", str(i), 0.0, 0.0, 40.0) for i in range(9)])


@pytest.fixture(scope="module")
def held(tmp_path_factory: pytest.TempPathFactory) -> HeldOut:
    """Three files that differ in one number each, so that their answers do."""
    folder, made = tmp_path_factory.mktemp("coefficients"), []
    with np.load(coefficient_file.OWN) as file:
        own = {key: file[key] for key in file.files}
    for number in range(3):
        changed = own | {"offset2": own["offset2"] + np.float32(0.02 * number)}
        made.append(folder / f"{number}.npz")
        np.savez(made[-1], **changed)
    people = {"freihaut2021 u0": 0, "freihaut2021 u1": 1, "freihaut2021 u2": 1}
    return HeldOut({"freihaut2021": made[2]}, made[:2], people)


def test_a_set_that_was_trained_on_is_judged_without_it(held: HeldOut) -> None:
    assert "freihaut2021" in held_out.training_sets()
    scored = measure.scored(recording("freihaut2021"), NAMES, held, seed=0)
    assert [p.name for p in scored.predictors] == [
        "hold", "kinematic (set left out)", "kinematic (people left out)"
    ]  # fmt: skip
    prepared = prepare(recording("freihaut2021"))
    alone = held.of_set("kinematic", recording("freihaut2021"))
    assert alone is not None
    assert scored.predictors[1].time_averaged.tolist() == replay(prepared, alone).time_averaged.tolist()


def test_each_person_is_judged_by_the_fold_without_him(held: HeldOut) -> None:
    one = recording("freihaut2021")
    row, prepared = measure.scored(one, NAMES, held, seed=0).predictors[2], prepare(one)
    people = held.of_people("kinematic", one)
    by_fold = {user: replay(prepared, people[user]) for user in ("u0", "u1", "u2")}
    for k, trial in enumerate(prepared.trials):
        expected = by_fold[trial.trial.user]
        assert row.time_averaged[k] == expected.time_averaged[k]
        assert row.hits is not None
        assert expected.hits is not None
        assert row.hits[k].tolist() == expected.hits[k].tolist()
    assert by_fold["u0"].time_averaged.tolist() != by_fold["u1"].time_averaged.tolist()


def test_other_sets_may_meet_the_packages_own_coefficients(held: HeldOut) -> None:
    scored = measure.scored(recording("elsewhere"), NAMES, held, seed=0)
    assert [p.name for p in scored.predictors] == ["hold", "kinematic"]


def test_what_nobody_can_judge_is_said(held: HeldOut) -> None:
    none = HeldOut({}, held.folds, {"freihaut2021 u0": 0})
    scored = measure.scored(recording("freihaut2021"), NAMES, none, seed=0)
    assert [p.name for p in scored.predictors] == ["hold"]
    assert "no other set at hand" in scored.notes[0]
    assert "2 people of the set are in no fold" in scored.notes[1]


def test_the_cache_hangs_on_code_and_recordings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    (tmp_path / "one_samples.parquet").write_bytes(b"1")
    before = held_out.place(tmp_path)
    assert before.is_relative_to(tmp_path)
    assert held_out.place(tmp_path) == before
    (tmp_path / "one_samples.parquet").write_bytes(b"2")
    assert held_out.place(tmp_path) != before
    assert held_out.held_out(tmp_path) == HeldOut({}, [], {})  # no set that is trained on
    assert held_out.held_out(None) == HeldOut({}, [], {})
