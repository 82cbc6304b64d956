"""From recordings to coefficients: five fits to hold people out, one to all, a table, a file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from pointpred.predictors.kinematic import coefficient_file
from pointpred.records import FloatArray
from pointpred.training import calibration
from pointpred.training.calibration import Claims
from pointpred.training.data import FOLDS, SETS, Examples, Log, TrainingData, join
from pointpred.training.fitting import FittedNetwork, Settings, fit

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
