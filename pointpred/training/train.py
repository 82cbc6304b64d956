"""From recordings to coefficients: five fits to hold people out, one to all, a table, a file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from pointpred.columns import FloatArray
from pointpred.predictors.kinematic import coefficient_file
from pointpred.training import calibrate
from pointpred.training.calibrate import Held
from pointpred.training.examples import Examples, joined
from pointpred.training.fitting import Fitted, Settings, fit
from pointpred.training.people import FOLDS, SETS, Say, School

Nets = list[tuple[set[int], Fitted]]
"""Users held out, and the network fitted to the others."""


def taught(
    school: School,
    without_users: set[int],
    without_set: int | None,
    settings: Settings,
    start: Fitted | None = None,
) -> Fitted:
    """A network fitted to everybody but some users or a set; ``start``: a network to go on from."""
    parts = [
        part.only(~np.isin(part.user, list(without_users)))
        for part in (*school.own, *school.varied)
        if without_set is None or int(part.set[0]) != without_set
    ]
    return fit(joined([part for part in parts if len(part.reach)]), settings, start=start)


def held_out(school: School, fitted: Fitted, users: set[int], settings: Settings) -> Held | None:
    """What the network claims about the own movements of users it was not fitted to."""
    parts = [part.only(np.isin(part.user, list(users))) for part in school.own]
    parts = [part for part in parts if len(part.reach)]
    return calibrate.held(fitted, joined(parts), settings) if parts else None


def folds(school: School, settings: Settings, say: Say, start: Fitted | None = None) -> Nets:
    """A network for each fold of users, fitted to the other folds."""
    of = school.fold()
    found = []
    for number in range(FOLDS):
        users = {user for user, fold in of.items() if fold == number}
        if not users or len(users) == len(of):
            continue
        found.append((users, taught(school, users, None, settings, start)))
        say(f"fold {number + 1} of {FOLDS}: {len(users)} users held out")
    return found


def table_of(school: School, nets: Nets, settings: Settings) -> FloatArray:
    """The calibration from all people held out."""
    parts = [held_out(school, fitted, users, settings) for users, fitted in nets]
    known = [part for part in parts if part is not None]
    return calibrate.calibrated(calibrate.joined(known))


def save(path: Path, fitted: Fitted, table: FloatArray, card: dict[str, Any]) -> None:
    """Write a network and its calibration; one that has hardly learned may ask for factors without bound."""
    most = coefficient_file.LARGEST_LOG
    table = np.clip(table, -most, most)
    coefficient_file.write(path, fitted.mean, fitted.scale, fitted.layers, table, card)


def card_of(school: School, settings: Settings) -> dict[str, Any]:
    """What a file says of how it was made."""
    moments: list[Examples] = list(school.own)
    return {
        "sets": [
            {
                "name": recording.name,
                "licence": SETS.get(recording.name, "unknown"),
                "users": len({trial.user for trial in recording.trials}),
                "trials": len(np.unique(part.trial)),
                "moments": len(part.reach),
            }
            for recording, part in zip(school.recordings, moments, strict=True)
        ],
        "variants": len(school.varied) // max(len(school.own), 1),
        "hidden": list(settings.hidden),
        "passes": settings.passes,
        "seed": settings.seed,
        "folds": FOLDS,
    }


def train(school: School, settings: Settings, path: Path, say: Say) -> None:
    """Fit, calibrate and write."""
    nets = folds(school, settings, say)
    table = table_of(school, nets, settings)
    say("calibrated on the people held out")
    save(path, taught(school, set(), None, settings), table, card_of(school, settings))
    say(f"{path.name}: {path.stat().st_size} bytes, {coefficient_file.digest(path)}")
