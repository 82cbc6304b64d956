"""Coefficients of one's own: held out, written whole, used by name."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from pointpred import __version__, build, run
from pointpred.errors import ParameterError, RecordingError
from pointpred.files import beside
from pointpred.predictors.kinematic import coefficient_file
from pointpred.predictors.kinematic import network as net
from pointpred.recording import Recording
from pointpred.recordings.writing import write
from pointpred.scoring import score
from pointpred.training import data, fitting, train
from pointpred.training.data import FOLDS
from pointpred.training.fitting import Settings
from tests.unit.test_training import reaches

TINY = Settings(passes=1, batch=512, rate=3e-4)


def mine(count: int = 60, users: int = 2) -> Recording:
    """Reaches of so many people."""
    made = reaches(count)
    trials = tuple(msgspec.structs.replace(one, user=f"u{k % users}") for k, one in enumerate(made.trials))
    return msgspec.structs.replace(made, trials=trials)


def trained(path: Path, recording: Recording | None = None, **options: Any) -> train.TrainingResult:
    options = {"settings": TINY, "variants": 0, **options}
    return train.train_custom([recording or mine()], path, **options)


def named(name: str, *users: str, count: int = 30) -> Recording:
    """A recording of so many reaches, of these users in turn."""
    made = mine(count, len(users))
    trials = tuple(msgspec.structs.replace(one, user=users[int(one.user[1:])]) for one in made.trials)
    return msgspec.structs.replace(made, name=name, trials=trials)


def test_the_network_of_the_file_is_what_training_goes_on_from() -> None:
    start = fitting.load_network()
    rows = data.training_data([mine(10)], 1, lambda _: None, variants=0).own[0].features
    flat = coefficient_file.read(coefficient_file.OWN)
    for seen, wanted in zip(rows[:20], start.outputs(rows[:20]), strict=True):
        said = np.empty(net.Outputs.length)
        net.evaluate(net.Coefficients(flat), seen.astype(np.float64), said)
        np.testing.assert_allclose(said, wanted, rtol=2e-3, atol=2e-4)


def test_training_on_own_movements_lowers_their_error(tmp_path: Path) -> None:
    """On movements that were held out: the shipped network has never seen such people."""
    result = trained(
        tmp_path / "me.npz", mine(80, 4), settings=msgspec.structs.replace(TINY, passes=12), variants=1
    )
    (one,) = result.held_out
    assert (result.movements, result.people, result.parts) == (80, 4, "people")
    assert one.own.mean() < 0.9 * one.shipped.mean() < one.hold.mean()
    assert one.ratio[0] == pytest.approx(one.own.mean() / one.shipped.mean())
    assert one.ratio[1] < one.ratio[0] < one.ratio[2] < 1.0
    assert result.better == 1
    assert not one.seen


def test_what_was_held_out_was_held_out(tmp_path: Path) -> None:
    """The scores are those of the folds' networks, fitted here once more without the people they judge."""
    recording = mine(60, 3)
    (one,) = trained(tmp_path / "me.npz", recording).held_out
    assert len(one.hold) == 60
    assert set(np.round(one.shipped, 6)) == set(np.round(shipped_errors(recording), 6))
    final = score([recording], [build("kinematic", coefficients=tmp_path / "me.npz")])[0].predictors[1]
    assert not np.isclose(np.sort(one.own), np.sort(final.time_averaged)).all()


def shipped_errors(recording: Recording) -> np.ndarray:
    (scored,) = score([recording], ["kinematic"])
    return scored.predictors[1].time_averaged


def test_one_person_is_held_out_in_stretches_of_their_movements(tmp_path: Path) -> None:
    result = trained(tmp_path / "me.npz", mine(60, 1))
    assert (result.people, result.parts) == (1, "movements")
    assert len(result.held_out[0].hold) == 60
    said = coefficient_file.card(tmp_path / "me.npz")
    assert said["sets"][0]["users"] == 1
    assert said["held_out"] == "movements of one person"


@pytest.mark.parametrize(
    ("first", "second", "people", "parts"),
    [
        (["ann"], ["ann"], 1, "movements"),
        (["ann", "bob"], ["ann", "bob"], 2, "people"),
        (["ann"], ["ann", "bob"], 2, "people"),
        (["ann"], ["bob"], 2, "recordings"),
        (["unknown"], ["unknown"], 2, "recordings"),
    ],
)
def test_a_name_is_one_person_in_all_recordings(
    first: list[str],
    second: list[str],
    people: int,
    parts: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made: list[tuple[data.TrainingData, train.Nets]] = []
    counted: list[tuple[int, int]] = []
    real = train.folds

    def folds(school: data.TrainingData, *rest: Any) -> train.Nets:
        made.append((school, real(school, *rest)))
        return made[0][1]

    monkeypatch.setattr(train, "folds", folds)
    result = train.train_custom(
        [named("one", *first), named("two", *second)],
        tmp_path / "me.npz",
        settings=TINY,
        variants=0,
        progress=lambda what, done, steps: counted.append((done, steps)),
    )
    assert (result.people, result.parts) == (people, parts)
    assert coefficient_file.card(tmp_path / "me.npz")["held_out"].split()[0] == parts
    assert [len(one.hold) for one in result.held_out] == [30, 30]
    steps = len(counted) - 1  # the first call says that nothing is done
    assert counted == [(done, steps) for done in range(steps + 1)]
    ((school, nets),) = made
    assert len(nets) == (people if people > 1 else FOLDS)
    if parts == "people":
        for name in {*first, *second}:
            keys = {school.users[key] for key in school.users if key.endswith(f" {name}")}
            assert [len(keys & out) for out, _ in nets].count(0) == len(nets) - 1


def test_few_movements_of_each_of_many_recordings_are_held_out(tmp_path: Path) -> None:
    """Stretches go through all recordings: one of a single movement can still be held out."""
    recordings = [named(f"part {k}", "ann", count=10) for k in range(6)]
    result = train.train_custom(recordings, tmp_path / "me.npz", settings=TINY, variants=0)
    assert [len(one.hold) for one in result.held_out] == [10] * 6


@pytest.fixture(scope="module")
def me(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Coefficients trained on ``mine()`` with the seed 5."""
    path = tmp_path_factory.mktemp("trained") / "me.npz"
    trained(path, seed=5)
    return path


def test_the_card_says_what_it_was_made_from(me: Path) -> None:
    said = coefficient_file.card(me)
    (one,) = said["sets"]
    assert (one["name"], one["licence"], one["users"], one["trials"]) == ("reaches", "unknown", 2, 60)
    assert (said["seed"], said["start"], said["pointpred"]) == (5, coefficient_file.digest(), __version__)
    assert build("kinematic", coefficients=me).predictor.saw("reaches")  # type: ignore[attr-defined]


def test_the_same_seed_makes_the_same_numbers(me: Path, tmp_path: Path) -> None:
    digests = [coefficient_file.digest(me)]
    for name, seed in (("same.npz", 5), ("other.npz", 2)):
        trained(tmp_path / name, seed=seed)
        digests.append(coefficient_file.digest(tmp_path / name))
    assert digests[0] == digests[1] != digests[2]


def test_from_scratch_starts_from_nothing(tmp_path: Path) -> None:
    trained(tmp_path / "me.npz", from_scratch=True, settings=msgspec.structs.replace(TINY, hidden=(8, 6)))
    assert coefficient_file.card(tmp_path / "me.npz")["start"] is None
    assert coefficient_file.read(tmp_path / "me.npz")[:2].tolist() == [8.0, 6.0]


def test_too_few_movements_are_refused_with_how_many_it_needs(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="50 movements at least, there are 49"):
        trained(tmp_path / "me.npz", mine(49))
    assert not list(tmp_path.iterdir())


def test_the_packages_own_file_is_never_written() -> None:
    before = coefficient_file.OWN.read_bytes()
    with pytest.raises(ParameterError, match="own file"):
        trained(coefficient_file.OWN)
    assert coefficient_file.OWN.read_bytes() == before


def test_an_interruption_leaves_no_file_and_an_old_one_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "me.npz"
    path.write_bytes(b"before")

    def interrupted(file: Any, **arrays: Any) -> None:
        file.write(b"half")
        raise KeyboardInterrupt

    monkeypatch.setattr(coefficient_file.np, "savez", interrupted)
    school = data.training_data([mine(20)], 1, lambda _: None, variants=0)
    with pytest.raises(KeyboardInterrupt):
        train.save(path, fitting.load_network(), np.zeros((10, 3)), train.card_of(school, TINY))
    assert path.read_bytes() == b"before"
    assert [one.name for one in tmp_path.iterdir()] == ["me.npz"]


@pytest.mark.parametrize("name", ["kinematic", "kinematic-adaptive"])
def test_both_names_take_the_file(name: str, me: Path, tmp_path: Path) -> None:
    events = mine().rows(0)
    given = [run(build(name, coefficients=one), events).table for one in (me, str(me))]
    assert np.array_equal(*given, equal_nan=True)
    assert not np.array_equal(given[0], run(build(name), events).table, equal_nan=True)
    for wrong in (tmp_path / "missing.npz", str(tmp_path), 7):
        with pytest.raises(ParameterError, match="coefficients must be"):
            build(name, coefficients=wrong)


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Training that takes a second."""
    monkeypatch.setattr(train, "GENTLE", TINY)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "mine_samples.csv"
    write(mine(), path)
    return path


@pytest.mark.usefixtures("quick")
def test_the_command_trains_and_score_uses_what_it_wrote(
    command: Callable[..., Any], file: Path, tmp_path: Path
) -> None:
    out, told, scored = tmp_path / "me.npz", tmp_path / "told.json", tmp_path / "scored.json"
    left = command("train", file, "--out", out, "--json", told)
    assert left.code == 0, left.err
    said = json.loads(told.read_text())
    assert (said["movements"], said["people"], said["held_out"]) == (60, 2, "people")
    (one,) = said["sets"]
    for name in ("hold_px", "shipped_px", "own_px"):
        assert f"{one[name]:.1f}" in left.out
    errors = []
    for options in ([], ["--coefficients", out]):
        options += ["--json", scored, "--force"]
        left = command("score", file, "--predictors", "kinematic,linear", *options)
        assert left.code == 0, left.err
        predictors = {p["name"]: p for p in json.loads(scored.read_text())["sets"][0]["predictors"]}
        errors.append({name: p["time_averaged"]["px"] for name, p in predictors.items()})
    assert errors[0]["kinematic"] != errors[1]["kinematic"]
    assert errors[0]["linear"] == errors[1]["linear"]


@pytest.mark.usefixtures("quick")
def test_wrong_uses_say_what_was_expected(command: Callable[..., Any], file: Path, tmp_path: Path) -> None:
    (tmp_path / "text.npz").write_text("none")
    beside(tmp_path / "held.npz", "part").mkdir()  # in the place of the file that is written first
    (tmp_path / "me.npz.part").write_text("somebody's")
    for code, arguments in (
        (2, ["train", file, "--out", tmp_path / "me.csv"]),
        (2, ["train", file, "--out", coefficient_file.OWN]),
        (2, ["train", file, "--out", tmp_path / "no" / "me.npz"]),
        (2, ["train", tmp_path / "text.npz", "--out", Path("/proc/me.npz")]),  # nobody writes there
        (2, ["train", tmp_path / "text.npz", "--out", tmp_path / "held.npz"]),
        (2, ["train", tmp_path / "text.npz", "--json", "/proc/a.json", "--out", tmp_path / "me.npz"]),
        (2, ["train", tmp_path / "missing.csv", "--out", tmp_path / "me.npz"]),
        (2, ["train", file]),
        (1, ["train", tmp_path / "text.npz", "--out", tmp_path / "me.npz"]),
        (2, ["score", file, "--predictors", "linear", "--coefficients", tmp_path / "text.npz"]),
        (2, ["score", file, "--predictors", "kinematic", "--coefficients", tmp_path / "text.npz"]),
        (2, ["score", file, "--predictors", "kinematic", "--coefficients", tmp_path / "missing.npz"]),
    ):
        left = command(*arguments)
        assert (left.code, left.err.count("\n") >= 1) == (code, True), arguments
        assert "Traceback" not in left.err
    assert not (tmp_path / "me.npz").exists()
    assert (tmp_path / "me.npz.part").read_text() == "somebody's"


def test_training_without_recordings_is_one_line() -> None:
    environment = {k: v for k, v in os.environ.items() if k != "POINTPRED_RECORDINGS"}
    run_it = [sys.executable, "-m", "evidence", "results", "train"]
    root = Path(__file__).parents[2]
    left = subprocess.run(run_it, env=environment, cwd=root, capture_output=True, text=True, check=False)
    assert left.returncode == 1
    assert left.stderr.count("\n") == 1
    assert "POINTPRED_RECORDINGS" in left.stderr
