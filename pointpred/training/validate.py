"""How well the learned predictor does on people, and on sets, that it was not fitted to."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.pipeline import Pipeline
from pointpred.predictors import KinematicPredictor
from pointpred.predictors import kinematic_features as features
from pointpred.recording import Recording
from pointpred.registry import build
from pointpred.scoring import SetScore, score
from pointpred.training import calibrate
from pointpred.training.calibrate import Held
from pointpred.training.fitting import Fitted, Settings
from pointpred.training.people import Say, School
from pointpred.training.train import Nets, folds, save, taught


class Verdict(msgspec.Struct, frozen=True):
    """One set scored with networks that did not know its people, or did not know it at all."""

    score: SetScore
    known: Held
    """Claims, calibrated, and how they turned out."""
    clock: tuple[float, float]
    """Error of the time left in s, and that of a clock that knows the set's median time."""


class Validation(msgspec.Struct, frozen=True):
    """Both ways of holding out, a verdict a set."""

    users_out: tuple[Verdict, ...]
    set_out: tuple[Verdict, ...]


def pipeline_of(fitted: Fitted, table: FloatArray) -> Pipeline:
    """``kinematic`` with other coefficients; they pass through a file, as the package's own do."""
    with tempfile.TemporaryDirectory() as where:
        path = Path(where) / "coefficients.npz"
        save(path, fitted, table, {})
        predictor = KinematicPredictor(coefficients=path)
    return Pipeline("kinematic", build("hold").differentiator, predictor)


def validate(school: School, settings: Settings, say: Say, nets: Nets | None = None) -> Validation:
    """Hold out users in folds, and each set in turn; the project's scorer judges.

    The table of a fold comes from the people of the other folds, that of a set left out from the people
    of the other sets. ``nets``: those of ``folds`` where they are known already.
    """
    nets = folds(school, settings, say) if nets is None else nets
    known = [known_by_set(school, fitted, users, settings) for users, fitted in nets]
    tables = []
    for place in range(len(nets)):
        others = [one for k, row in enumerate(known) if k != place for one in row.values()]
        tables.append(calibrate.calibrated(calibrate.joined(others)))
    users_out, set_out = [], []
    for number, recording in enumerate(school.recordings):
        runs = [
            _judged(school, number, users, fitted, table, settings)
            for (users, fitted), table in zip(nets, tables, strict=True)
            if np.isin(school.own[number].user, list(users)).any()
        ]
        users_out.append(_merged(runs))
        say(f"{recording.name}: users held out {ratio(users_out[-1].score):.3f} of hold")
    everybody = set(school.users.values())
    for number, recording in enumerate(school.recordings):
        others = [one for row in known for k, one in row.items() if k != number]
        fitted = taught(school, set(), number, settings)
        table = calibrate.calibrated(calibrate.joined(others))
        set_out.append(_judged(school, number, everybody, fitted, table, settings))
        say(f"{recording.name}: set left out {ratio(set_out[-1].score):.3f} of hold")
    return Validation(tuple(users_out), tuple(set_out))


def ratio(score: SetScore) -> float:
    """Time-averaged error over that of ``hold``."""
    hold, own = score.predictors
    return float(own.time_averaged.mean() / hold.time_averaged.mean())


def known_by_set(school: School, fitted: Fitted, users: set[int], settings: Settings) -> dict[int, Held]:
    """What a network claims of the people it did not know, set by set."""
    found = {}
    for number, part in enumerate(school.own):
        rows = np.isin(part.user, list(users))
        if rows.any():
            found[number] = calibrate.held(fitted, part.only(rows), settings)
    return found


def of_users(recording: Recording, names: list[str]) -> Recording:
    """The trials of some people, named set and user."""
    chosen = [k for k, trial in enumerate(recording.trials) if f"{recording.name} {trial.user}" in names]
    return Recording.of(
        recording.name, [recording.rows(k) for k in chosen], [recording.trials[k] for k in chosen]
    )


def _judged(
    school: School, number: int, users: set[int], fitted: Fitted, table: FloatArray, settings: Settings
) -> Verdict:
    """A set's trials by some people, scored with a network that did not know these."""
    own = school.own[number]
    mine = own.only(np.isin(own.user, list(users)))
    names = [name for name, user in school.users.items() if user in users]
    part = of_users(school.recordings[number], names)
    (scored,) = score([part], [pipeline_of(fitted, table)])
    whole = own.left_s / np.maximum(1.0 - own.share, 1e-6)
    _, first = np.unique(own.trial, return_index=True)
    since = mine.features[:, features.NAMES.index("time")].astype(np.float64)
    clock = np.maximum(float(np.median(whole[first])) - since, 0.0)
    left = calibrate.time_left(fitted, mine)
    errors = [float((mine.weight * np.abs(said - mine.left_s)).sum()) for said in (left, clock)]
    known = calibrate.applied(calibrate.held(fitted, mine, settings), table)
    return Verdict(scored, known, (errors[0], errors[1]))


def _merged(runs: list[Verdict]) -> Verdict:
    """The parts of one set together; its trials stand in the order of the parts."""
    first = runs[0].score
    predictors = []
    for place in range(len(first.predictors)):
        parts = [run.score.predictors[place] for run in runs]
        changed: dict[str, Any] = {}
        for name in parts[0].__struct_fields__:
            arrays = [getattr(part, name) for part in parts]
            if all(isinstance(array, np.ndarray) for array in arrays):
                changed[name] = np.concatenate(arrays)
            elif any(isinstance(array, np.ndarray) for array in arrays):
                changed[name] = None  # told of some people only
        predictors.append(msgspec.structs.replace(parts[0], **changed))
    trials = tuple(trial for run in runs for trial in run.score.trials)
    together = msgspec.structs.replace(first, trials=trials, predictors=tuple(predictors))
    clocks = np.array([run.clock for run in runs]).sum(axis=0)
    known = calibrate.joined([run.known for run in runs])
    return Verdict(together, known, (float(clocks[0]), float(clocks[1])))
