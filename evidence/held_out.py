"""Coefficients of the learned predictor that have not seen a set, or not seen a person.

``python -m evidence.held_out`` fits them to the recordings in POINTPRED_RECORDINGS, a network for each set
left out and one for each fold of people left out, and keeps them in the user's cache: the same code and the
same recordings are not fitted twice. The files ``pointpred/datasets/set_left_out/SET.npz`` of the benchmark
are copies of ``set SET.npz``.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import msgspec

import pointpred
from evidence.arguments import parse
from pointpred import REGISTRY, build
from pointpred.benchmark import SET_OUT
from pointpred.pipeline import Pipeline
from pointpred.predictors import KinematicPredictor
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recording import Recording
from pointpred.registry import settings_in
from pointpred.scoring import resolution
from pointpred.training import data, train
from pointpred.training.data import Examples, TrainingData
from pointpred.training.fitting import Settings

CODE = (
    "training/*",
    *("predictors/kinematic/*", "predictors/m[io]*", "predictors/predictor*", "differentiators/*"),
    *("scoring/**/*", "recordings/**/*", "recording*", "columns*", "registry*"),
)
"""What the coefficients hang on."""
PEOPLE_OUT = " (people left out)"
"""What is added to a name of the registry where its coefficients did not see the people; SET_OUT: the set."""
THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


class HeldOut(msgspec.Struct, frozen=True):
    """Files of coefficients; a set that is not named was never trained on."""

    set_out: dict[str, Path]
    """Of each set, from the other sets."""
    folds: list[Path]
    """Of each fold of people, from the other people of all sets."""
    fold_of: dict[str, int]
    """Of each person, named set and user."""

    def of_set(self, name: str, recording: Recording) -> Pipeline | None:
        """A predictor that has not seen the recording; ``None`` where it was the only one to learn from."""
        path = self.set_out.get(recording.name)
        return None if path is None else pipeline(name, path, SET_OUT, recording)

    def of_people(self, name: str, recording: Recording) -> dict[str, Pipeline]:
        """For each user of the recording a predictor that has not seen this person."""
        pipelines = [pipeline(name, path, PEOPLE_OUT, recording) for path in self.folds]
        start = f"{recording.name} "
        return {who[len(start) :]: pipelines[k] for who, k in self.fold_of.items() if who.startswith(start)}


def in_one_thread() -> None:
    """Start again where sums may run in several threads: in one thread their order, and they, repeat."""
    if any(os.environ.get(name) != "1" for name in THREADS):
        os.environ.update(dict.fromkeys(THREADS, "1"))
        os.execv(sys.executable, [sys.executable, *sys.orig_argv[1:]])


def trained_predictors() -> list[str]:
    """The names of the registry that have learned from recordings."""
    return [name for name, entry in REGISTRY.items() if issubclass(entry.predictor, KinematicPredictor)]


def training_sets() -> set[str]:
    """The sets that the package's own coefficients were made from."""
    return {one["name"] for one in coefficient_file.card()["sets"]}


def pipeline(name: str, coefficients: Path, words: str, recording: Recording) -> Pipeline:
    """A name of the registry and what is set behind it, with other coefficients, for a recording's screen."""
    known, settings = settings_in(name)
    own = build(known, coefficients=coefficients, **settings, **resolution(recording, None, None))
    own.name = name + words
    return own


def key(folder: Path) -> str:
    """A digest of the code, the settings and the recordings."""
    digest = hashlib.blake2b(digest_size=12)
    package = Path(pointpred.__file__).parent
    files = [path for part in CODE for path in package.glob(f"{part}.py")]
    for path in sorted([*files, Path(__file__)]) + sorted(folder.glob("*_*.parquet")):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()


def place(folder: Path) -> Path:
    """Where the coefficients for these recordings stand in the cache."""
    named = os.environ.get("XDG_CACHE_HOME")
    cache = Path(named) if named else Path.home() / ".cache"
    return cache / "pointpred-held-out" / key(folder)


def held_out(folder: Path | None) -> HeldOut:
    """The coefficients, from the cache or fitted now, in a process of one thread so that sums repeat."""
    if folder is None or not any((folder / f"{name}_samples.parquet").is_file() for name in data.SETS):
        return HeldOut({}, [], {})
    where = place(folder)
    if not where.is_dir():
        print("fitting coefficients to everybody but one set, and to everybody but a fold of people")
        env = os.environ | {"POINTPRED_RECORDINGS": str(folder)}
        subprocess.run([sys.executable, "-m", "evidence.held_out"], env=env, check=True)
    return stored(where)


def stored(where: Path) -> HeldOut:
    """The coefficients that a folder holds."""
    files = {path.stem: path for path in where.glob("*.npz")}
    sets = {name.removeprefix("set "): path for name, path in files.items() if name.startswith("set ")}
    folds = [files[name] for name in sorted(files) if name.startswith("fold ")]
    return HeldOut(sets, folds, json.loads((where / "people.json").read_text(encoding="utf-8")))


def fit(school: TrainingData, settings: Settings, where: Path) -> None:
    """Fit all networks and write them. The regions of each are calibrated on people its table may know.

    A fold's table comes from the people of the other folds. A left-out set's table comes from people of the
    other sets, judged by the folds' networks, which knew the set.
    """

    def say(what: str) -> None:
        print(what, flush=True)

    nets = train.folds(school, settings, say)
    everybody = {name: number for number, name in enumerate(r.name for r in school.recordings)}
    fold_of = {}
    for k, (users, fitted) in enumerate(nets):
        others = [net for place, net in enumerate(nets) if place != k]
        train.save(where / f"fold {k}.npz", fitted, train.calibration_table(school, others, settings), {})
        fold_of |= {name: k for name, user in school.users.items() if user in users}
    (where / "people.json").write_text(json.dumps(fold_of), encoding="utf-8")
    card = train.card_of(school, settings)
    for name, number in everybody.items() if len(everybody) > 1 else ():
        others_seen = {"sets": [one for one in card["sets"] if one["name"] != name]}
        rest = msgspec.structs.replace(school, own=tuple(_without(school, number)))
        table = train.calibration_table(rest, nets, settings)
        fitted = train.fit_without(school, set(), number, settings)
        train.save(where / f"set {name}.npz", fitted, table, card | others_seen)
        say(f"{name} left out")


def _without(school: TrainingData, number: int) -> Iterator[Examples]:
    return (part for k, part in enumerate(school.own) if k != number)


def main(arguments: list[str]) -> None:
    """Fit, into the folder named or into the cache; the folder appears only when it is complete."""
    folder = data.folder()
    where = Path(*arguments) if arguments else place(folder)
    if where.exists():
        raise SystemExit(f"{where} is there already: remove it, or name another folder")
    where.parent.mkdir(parents=True, exist_ok=True)
    settings = Settings()
    school = data.training_data(data.read_sets(folder), settings.seed, lambda what: print(what, flush=True))
    with tempfile.TemporaryDirectory(dir=where.parent) as temporary:
        whole = Path(temporary) / "made"
        whole.mkdir()
        fit(school, settings, whole)
        whole.rename(where)


if __name__ == "__main__":
    names = parse(__doc__, metavar="folder", most=1)
    in_one_thread()
    main(names)
