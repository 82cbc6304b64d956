"""Score `kinematic` on people and sets that it was not fitted to: ``python -m pages.kinematic.measure``."""

from __future__ import annotations

import sys
import time
from typing import Any

import msgspec
import numpy as np

from pages import PAGES, data
from pages.arguments import parse
from pages.kinematic.records import Claims, Held, Ratio, SetRow, Validation
from pointpred.predictors.kinematic import features
from pointpred.records import FloatArray
from pointpred.scoring import SetScore, score, summarise
from pointpred.scoring.summary import Measure
from pointpred.training import calibration
from pointpred.training import data as training_data
from pointpred.training.__main__ import in_one_thread
from pointpred.training.custom import claims_by_set, of_users, pipeline_of
from pointpred.training.data import Log, TrainingData
from pointpred.training.fitting import FittedNetwork, Settings
from pointpred.training.train import Nets, fit_without, folds


class Verdict(msgspec.Struct, frozen=True):
    """One set scored with networks that did not know its people, or did not know it at all."""

    score: SetScore
    known: calibration.Claims
    """Claims, calibrated, and how they turned out."""
    clock: tuple[float, float]
    """Error of the time left in s, and that of a clock that uses the set's median time."""


class Verdicts(msgspec.Struct, frozen=True):
    """Both ways of holding out, a verdict a set."""

    users_out: tuple[Verdict, ...]
    set_out: tuple[Verdict, ...]


def validate(school: TrainingData, settings: Settings, say: Log, nets: Nets | None = None) -> Verdicts:
    """Hold out users in folds, and each set in turn; the project's scorer judges.

    The table of a fold comes from the people of the other folds, that of a set left out from the people
    of the other sets. ``nets``: those of ``folds`` where they are known already.
    """
    nets = folds(school, settings, say) if nets is None else nets
    claims = [claims_by_set(school, fitted, users, settings) for users, fitted in nets]
    tables = []
    for place in range(len(nets)):
        others = [one for k, row in enumerate(claims) if k != place for one in row.values()]
        tables.append(calibration.fit_table(calibration.join(others)))
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
        others = [one for row in claims for k, one in row.items() if k != number]
        fitted = fit_without(school, set(), number, settings)
        table = calibration.fit_table(calibration.join(others))
        set_out.append(_judged(school, number, everybody, fitted, table, settings))
        say(f"{recording.name}: set left out {ratio(set_out[-1].score):.3f} of hold")
    return Verdicts(tuple(users_out), tuple(set_out))


def ratio(score: SetScore) -> float:
    """Time-averaged error over that of ``hold``."""
    hold, own = score.predictors
    return float(own.time_averaged.mean() / hold.time_averaged.mean())


def _judged(
    school: TrainingData,
    number: int,
    users: set[int],
    fitted: FittedNetwork,
    table: FloatArray,
    settings: Settings,
) -> Verdict:
    """A set's trials by some people, scored with a network that did not know these."""
    own = school.own[number]
    mine = own.only(np.isin(own.user, list(users)))
    names = [name for name, user in school.users.items() if user in users]
    part = of_users(school.recordings[number], names)
    (scored,) = score([part], [pipeline_of(fitted, table)])
    whole = own.left_s / np.maximum(1.0 - own.share, 1e-6)
    _, first = np.unique(own.trial, return_index=True)
    since = mine.features[:, features.TIME].astype(np.float64)
    clock = np.maximum(float(np.median(whole[first])) - since, 0.0)
    left = calibration.time_left(fitted, mine)
    errors = [float((mine.weight * np.abs(times - mine.left_s)).sum()) for times in (left, clock)]
    claims = calibration.apply_table(calibration.claims_of(fitted, mine, settings), table)
    return Verdict(scored, claims, (errors[0], errors[1]))


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
    claims = calibration.join([run.known for run in runs])
    return Verdict(together, claims, (float(clocks[0]), float(clocks[1])))


def record(verdicts: Verdicts) -> Validation:
    """The numbers that are kept."""
    return Validation(_held(verdicts.users_out), _held(verdicts.set_out))


def _held(verdicts: tuple[Verdict, ...]) -> Held:
    together = calibration.join([verdict.known for verdict in verdicts])
    return Held(tuple(_row(verdict) for verdict in verdicts), _claims(together))


def _row(verdict: Verdict) -> SetRow:
    document = summarise(verdict.score)
    ours = next(one for one in document.predictors if one.name == "kinematic")
    clean = ours.groups.get("clean_trials")
    left, clock = (1e3 * s / document.trials for s in verdict.clock)
    return SetRow(
        document.name,
        document.users,
        document.trials,
        _ratio(ours.time_averaged),
        _ratio(clean.time_averaged) if clean else None,
        {at: cell.of_hold or 0.0 for at, cell in ours.by_time.items()},
        {at: cell.of_hold or 0.0 for at, cell in ours.by_path.items()},
        _claims(verdict.known),
        left,
        clock,
        left / clock,
    )


def _ratio(measure: Measure) -> Ratio:
    return Ratio(measure.of_hold, measure.interval)


def _claims(claims: calibration.Claims) -> Claims:
    shares = calibration.coverage(claims).tolist()
    return Claims(
        tuple((row[0], row[1], row[2]) for row in shares), tuple((row[3], row[4], row[5]) for row in shares)
    )


def main() -> None:
    """Validate and keep the numbers; progress goes to the error stream."""
    began = time.monotonic()

    def say(what: str) -> None:
        print(f"{time.monotonic() - began:6.1f} s  {what}", file=sys.stderr, flush=True)

    settings = Settings()
    school = training_data.training_data(training_data.read_sets(training_data.folder()), settings.seed, say)
    data.write(record(validate(school, settings, say)), PAGES / "kinematic" / "data.json")


if __name__ == "__main__":
    parse(__doc__)
    in_one_thread("pages.kinematic.measure")
    main()
