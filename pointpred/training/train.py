"""From recordings to coefficients: those of the package, and those fitted to somebody's own recordings.

Five fits hold people out, one is to all, and a table makes claims as sure as they say. One's own training
goes on from the package's network unless ``from_scratch``. Where there is one person, movements are held out,
in stretches of their order. Users of one name are one person everywhere.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

import msgspec
import numpy as np

import pointpred
from pointpred.errors import ParameterError, RecordingError
from pointpred.extras import require
from pointpred.pipeline import Pipeline
from pointpred.predictors import KinematicPredictor
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recording import Recording
from pointpred.records import FloatArray
from pointpred.registry import build
from pointpred.scoring import score
from pointpred.scoring.executors import Executor
from pointpred.scoring.summary.bootstrap import ratio_intervals
from pointpred.training import calibration
from pointpred.training.calibration import Claims
from pointpred.training.data import (
    FOLDS,
    SETS,
    VARIANTS,
    Examples,
    Log,
    TrainingData,
    join,
    numbered,
    training_data,
)
from pointpred.training.fitting import FittedNetwork, Settings, fit, load_network

Nets = list[tuple[set[int], FittedNetwork]]
"""Users held out, and the network fitted to the others."""


def fit_without(
    data: TrainingData,
    without_users: set[int],
    without_set: int | None,
    settings: Settings,
    start: FittedNetwork | None = None,
) -> FittedNetwork:
    """A network fitted to everybody but some users or a set; ``start``: a network to go on from."""
    parts = [
        part.only(~np.isin(part.user, list(without_users)))
        for part in (*data.own, *data.varied)
        if without_set is None or int(part.set[0]) != without_set
    ]
    return fit(join([part for part in parts if len(part.reach)]), settings, start=start)


def claims_about(
    data: TrainingData, fitted: FittedNetwork, users: set[int], settings: Settings
) -> Claims | None:
    """What the network claims about the own movements of users it was not fitted to."""
    parts = [part.only(np.isin(part.user, list(users))) for part in data.own]
    parts = [part for part in parts if len(part.reach)]
    return calibration.claims_of(fitted, join(parts), settings) if parts else None


def folds(data: TrainingData, settings: Settings, log: Log, start: FittedNetwork | None = None) -> Nets:
    """A network for each fold of users, fitted to the other folds."""
    of = data.fold()
    nets: Nets = []
    for number in range(FOLDS):
        users = {user for user, fold in of.items() if fold == number}
        if not users or len(users) == len(of):
            continue
        nets.append((users, fit_without(data, users, None, settings, start)))
        log(f"fold {number + 1} of {FOLDS}: {len(users)} users held out")
    return nets


def calibration_table(data: TrainingData, nets: Nets, settings: Settings) -> FloatArray:
    """The calibration from all people held out."""
    parts = [claims_about(data, fitted, users, settings) for users, fitted in nets]
    claims = [part for part in parts if part is not None]
    return calibration.fit_table(calibration.join(claims))


def save(path: Path, fitted: FittedNetwork, table: FloatArray, card: dict[str, Any]) -> None:
    """Write a network and its calibration; one that has hardly learned may ask for factors without bound."""
    most = coefficient_file.LARGEST_LOG
    table = np.clip(table, -most, most)
    coefficient_file.write(path, fitted.mean, fitted.scale, fitted.layers, table, card)


def card_of(data: TrainingData, settings: Settings) -> dict[str, Any]:
    """What a file says of how it was made."""
    moments: list[Examples] = list(data.own)
    return {
        "sets": [
            {
                "name": recording.name,
                "licence": SETS.get(recording.name, "unknown"),
                "users": len({trial.user for trial in recording.trials}),
                "trials": len(np.unique(part.trial)),
                "moments": len(part.reach),
            }
            for recording, part in zip(data.recordings, moments, strict=True)
        ],
        "variants": len(data.varied) // max(len(data.own), 1),
        "hidden": list(settings.hidden),
        "passes": settings.passes,
        "seed": settings.seed,
        "folds": FOLDS,
    }


def train(data: TrainingData, settings: Settings, path: Path, log: Log) -> None:
    """Fit, calibrate and write."""
    nets = folds(data, settings, log)
    table = calibration_table(data, nets, settings)
    log("calibrated on the people held out")
    save(path, fit_without(data, set(), None, settings), table, card_of(data, settings))
    log(f"{path.name}: {path.stat().st_size} bytes, {coefficient_file.digest(path)}")


GENTLE = Settings(passes=4, batch=512, rate=3e-4)
"""How the package's network is fitted further to few movements: more would be learnt by heart."""
FIRM = Settings(passes=12, batch=512, rate=1e-3)
"""How it is fitted further to more."""
MOVEMENTS_LEAST, MOVEMENTS_FIRM = 50, 100
"""With fewer movements than the first nothing can be held out; from the second on training is firm."""

UNKNOWN = "unknown"
"""The user of a recording that names none."""
Progress = Callable[[str, int, int], None]
"""What has been reached, how many steps are done, and of how many; the last call says that all are."""
HeldOut = Literal["people", "recordings", "movements"]
"""What is held out. Recordings, where each has one user under a name of its own: these may be one person."""
WORDS: dict[HeldOut, str] = {
    "people": "people",
    "recordings": "recordings",
    "movements": "movements of one person",
}
"""As the card says it."""


class SetComparison(msgspec.Struct, frozen=True):
    """One recording's movements, each predicted by coefficients that were not fitted to it.

    Time-averaged errors in px, a movement each.
    """

    name: str
    hold: FloatArray
    shipped: FloatArray
    own: FloatArray
    ratio: tuple[float, float, float]
    """Of the means, own over shipped, and the ends of its interval of 95 %; NaN where there is none."""
    seen: bool
    """Whether the shipped coefficients were fitted to these people: their error is then too small."""


class TrainingResult(msgspec.Struct, frozen=True):
    """What came of training."""

    movements: int
    people: int
    """Names of users; where recordings were held out, these may be one person."""
    parts: HeldOut
    """What was held out; movements of one person in stretches of their order."""
    held_out: tuple[SetComparison, ...]

    @property
    def better(self) -> int:
        """1 where the own coefficients are surely better on every recording, -1 surely worse, 0 else."""
        if all(one.ratio[2] < 1.0 for one in self.held_out):
            return 1
        return -1 if all(one.ratio[1] > 1.0 for one in self.held_out) else 0


def train_custom(
    recordings: list[Recording],
    path: Path,
    *,
    seed: int = 1,
    from_scratch: bool = False,
    settings: Settings | None = None,
    variants: int = VARIANTS,
    progress: Progress = lambda what, done, total: None,
    executor: Executor | None = None,
) -> TrainingResult:
    """Fit ``kinematic``'s coefficients to recordings, write them, and score them on what was held out.

    ``from_scratch``: begin with a network at random instead of the package's. The same recordings, seed and
    settings write the same numbers on the same machine, whatever the ``executor`` that collects examples. The
    file is written last: an interruption leaves none. Raises RecordingError for fewer than 50 movements,
    ParameterError for a recording in which nobody moves, and, before any work, where ``path`` cannot be
    written or is the package's own file; MissingExtraError where the extra ``train`` is not installed.
    """
    require("train", "training")
    if path.resolve() == coefficient_file.OWN.resolve():
        message = f"{path} is the package's own file, which `make train` writes; name another"
        raise ParameterError(message, field="path", value=str(path))
    coefficient_file.check_writable(path)
    start = None if from_scratch else load_network()
    _check_enough(sum(len(one.trials) for one in recordings))  # before the work on each of them
    recordings = [_unknown_apart(one, k) for k, one in enumerate(recordings)]
    people = {trial.user for one in recordings for trial in one.trials}
    parts = _parts(recordings, len(people))
    material = _in_stretches(recordings) if parts == "movements" else recordings
    count, steps = 0, _steps(TrainingData(tuple(material), (), (), numbered(material, by_name=True)))

    def log(what: str) -> None:
        nonlocal count
        count += 1
        progress(what, count, steps)

    progress("reading movements", 0, steps)
    data = training_data(material, seed, lambda _: None, variants, by_name=True, executor=executor)
    movements = sum(len(np.unique(part.trial)) for part in data.own)
    _check_enough(movements)  # some trials hold none
    if settings is None:
        firm = movements >= MOVEMENTS_FIRM
        settings = Settings() if from_scratch else FIRM if firm else GENTLE
    settings = msgspec.structs.replace(settings, seed=seed)
    log("fitting")
    nets = folds(data, settings, log, start)
    claims = [claims_by_set(data, fitted, users, settings) for users, fitted in nets]
    held_out = tuple(_compare(data, k, nets, claims, parts != "movements", log) for k in range(len(material)))
    table = calibration_table(data, nets, settings)
    card = card_of(data, settings) | {
        "pointpred": pointpred.__version__,
        "start": None if from_scratch else coefficient_file.digest(),
        "held_out": WORDS[parts],
    }
    for one in card["sets"]:
        one["licence"] = "unknown"
        one["users"] = 1 if parts == "movements" else one["users"]
    save(path, fit_without(data, set(), None, settings, start), table, card)
    log("written")
    return TrainingResult(movements, len(people), parts, held_out)


def _check_enough(movements: int) -> None:
    if movements < MOVEMENTS_LEAST:
        message = f"training needs {MOVEMENTS_LEAST} movements at least, there are {movements}"
        raise RecordingError(message, code="too_few", field="movements", value=movements)


def _unknown_apart(recording: Recording, number: int) -> Recording:
    """The same, in which the user that no file names is another one than that of other recordings."""
    trials = tuple(
        msgspec.structs.replace(one, user=f"{UNKNOWN} {number}") if one.user == UNKNOWN else one
        for one in recording.trials
    )
    return msgspec.structs.replace(recording, trials=trials)


def _parts(recordings: list[Recording], people: int) -> HeldOut:
    """What can be held out of recordings with so many names of users."""
    if people == 1:
        return "movements"
    single = people == len(recordings) and all(
        len({trial.user for trial in one.trials}) == 1 for one in recordings
    )
    return "recordings" if single else "people"


def _steps(data: TrainingData) -> int:
    """How many steps are reported: reading, a fit each fold, a score each fold and recording, the file."""
    fold = data.fold()
    scores = [
        len({fold[data.users[f"{one.name} {trial.user}"]] for trial in one.trials}) for one in data.recordings
    ]
    return 1 + len(set(fold.values())) + sum(scores) + 1


def _in_stretches(recordings: list[Recording]) -> list[Recording]:
    """One person's trials as if each fifth of them all, in their order, were another person's."""
    count, first, stretches = sum(len(one.trials) for one in recordings), 0, []
    for recording in recordings:
        trials = tuple(
            msgspec.structs.replace(trial, user=f"{trial.user}, stretch {k * FOLDS // count + 1}")
            for k, trial in enumerate(recording.trials, first)
        )
        stretches.append(msgspec.structs.replace(recording, trials=trials))
        first += len(trials)
    return stretches


def _compare(
    data: TrainingData,
    number: int,
    nets: Nets,
    claims: list[dict[int, calibration.Claims]],
    by_person: bool,
    log: Callable[[str], None],
) -> SetComparison:
    """A recording's movements, each scored with the coefficients of the fold that did not know it."""
    recording = data.recordings[number]
    rows, users, seen = [], [], False
    for place, (out, fitted) in enumerate(nets):
        part = of_users(recording, [name for name, user in data.users.items() if user in out])
        if not part.trials:
            continue
        others = [one for k, row in enumerate(claims) if k != place for one in row.values()]
        pipeline = pipeline_of(fitted, calibration.fit_table(calibration.join(others)), "own")
        (scored,) = score([part], [pipeline, "kinematic"])
        rows.append(np.stack([one.time_averaged for one in scored.predictors]))
        users += [one.trial.user if by_person else "" for one in scored.trials]
        seen = scored.predictors[2].seen
        log(f"scoring {recording.name}")
    hold, own, shipped = np.concatenate(rows, axis=1)
    interval = ratio_intervals(own[:, None], shipped[:, None], users)
    ratio = (float(own.mean() / shipped.mean()), float(interval.low[0]), float(interval.high[0]))
    return SetComparison(recording.name, hold, shipped, own, ratio, seen)


def pipeline_of(fitted: FittedNetwork, table: FloatArray, name: str = "kinematic") -> Pipeline:
    """``kinematic`` with other coefficients; they pass through a file, as the package's own do."""
    with tempfile.TemporaryDirectory() as where:
        path = Path(where) / "coefficients.npz"
        save(path, fitted, table, {})
        predictor = KinematicPredictor(coefficients=path)
    return Pipeline(name, build("hold").differentiator, predictor)


def claims_by_set(
    data: TrainingData, fitted: FittedNetwork, users: set[int], settings: Settings
) -> dict[int, Claims]:
    """What a network claims of the people it did not know, set by set."""
    claims = {}
    for number, part in enumerate(data.own):
        rows = np.isin(part.user, list(users))
        if rows.any():
            claims[number] = calibration.claims_of(fitted, part.only(rows), settings)
    return claims


def of_users(recording: Recording, names: list[str]) -> Recording:
    """The trials of some people, named set and user."""
    trials = [k for k, trial in enumerate(recording.trials) if f"{recording.name} {trial.user}" in names]
    return Recording.of(
        recording.name, [recording.rows(k) for k in trials], [recording.trials[k] for k in trials]
    )
