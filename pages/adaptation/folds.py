"""Coefficients that never saw the people they are tried on: each fifth of them left out in turn."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from pointpred.recording import Recording
from pointpred.training import calibration, data, train
from pointpred.training.fitting import Settings


def say(what: str) -> None:
    """Progress, for whoever waits."""
    print(what, file=sys.stderr, flush=True)


def coefficients(where: Path) -> Iterator[tuple[Recording, Path]]:
    """For each set and fifth of its people: their recording, and the file fitted to none of them.

    The calibration of a fifth comes from the other fifths. Files are kept in ``where`` and used again.
    """
    sets, settings = data.read_sets(data.folder()), Settings()
    school = data.training_data(sets, settings.seed, say)
    of = school.fold()
    if not all((where / f"fold{number}.npz").is_file() for number in range(data.FOLDS)):
        nets = train.folds(school, settings, say)
        claims = [train.claims_about(school, fitted, users, settings) for users, fitted in nets]
        for number, (_, fitted) in enumerate(nets):
            others = [one for place, one in enumerate(claims) if place != number and one is not None]
            table = calibration.fit_table(calibration.join(others))
            train.save(where / f"fold{number}.npz", fitted, table, {})
    for recording in sets:
        folds = np.array([of[school.users[f"{recording.name} {one.user}"]] for one in recording.trials])
        for number in np.unique(folds).tolist():
            rows = np.flatnonzero(folds == number).tolist()
            part = Recording.of(
                recording.name, [recording.rows(k) for k in rows], [recording.trials[k] for k in rows]
            )
            yield part, where / f"fold{number}.npz"


def coefficient_folder(named: str | None) -> Path:
    """The folder for the coefficients: the one named, else a new one."""
    return Path(named) if named else Path(tempfile.mkdtemp())
