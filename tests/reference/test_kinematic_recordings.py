"""The learned predictor on people: what must not matter, and regions that are as sure as they say."""

from __future__ import annotations

import os
from functools import cache
from math import cos, pi, sin
from pathlib import Path

import msgspec
import numpy as np
import pytest

from pointpred import EventColumns, build, run
from pointpred.recording import Recording
from pointpred.scoring import prepare, score
from pointpred.scoring.measures.regions import LEVELS
from pointpred.training import calibration, data, train
from pointpred.training.fitting import Settings

FOLDER = os.environ.get("POINTPRED_RECORDINGS")
pytestmark = [
    pytest.mark.recordings,
    pytest.mark.skipif(not FOLDER, reason="POINTPRED_RECORDINGS names no folder of recordings"),
]
SETS = ("freihaut2021", "pvplib23714", "humanmovemouse")
TRIALS = 60
"""Of each set, spread over it."""


@cache
def recording(name: str, trials: int = TRIALS) -> Recording:
    """Some trials of a set, without samples that come at the time of another."""
    from pointpred.recordings import read

    whole = read(Path(FOLDER or "") / f"{name}_samples.parquet")
    picked = np.linspace(0, len(whole.trials) - 1, trials).astype(int).tolist()
    paths = []
    for k in picked:
        table = whole.rows(k).table
        paths.append(EventColumns(table[np.append(np.diff(table[:, 0]) > 0.0, True)]))
    return Recording.of(name, paths, [whole.trials[k] for k in picked])


def error(given: Recording) -> float:
    """Time-averaged error of ``kinematic`` as a share of that of ``hold``, which knows of no rate either."""
    (scored,) = score([given], ["kinematic"], threads=1)
    hold, ours = (one.time_averaged.mean() for one in scored.predictors)
    return float(ours / hold)


def at_rate(given: Recording, rate: float) -> Recording:
    """The same movements on smooth curves through their samples, in whole pixels."""
    from scipy.interpolate import PchipInterpolator

    paths = []
    for k in range(len(given.trials)):
        rows = given.rows(k)
        t = rows.t - rows.t[0]
        grid = np.append(np.arange(0.0, t[-1] - 0.5 / rate, 1.0 / rate), t[-1])
        paths.append(EventColumns.of(grid, *np.round(PchipInterpolator(t, rows.table[:, 1:3])(grid)).T))
    return Recording.of(given.name, paths, given.trials)


@pytest.mark.parametrize("name", SETS)
@pytest.mark.parametrize("rate", [60.0, 250.0, 1000.0, 8000.0])
def test_the_sampling_rate_changes_the_error_by_less_than_5_percent(name: str, rate: float) -> None:
    """From 125 Hz. humanmovemouse, at 60 Hz by nature, gains more than that from finer samples."""
    given = recording(name, 15 if rate > 1000.0 else TRIALS)
    here, there = error(at_rate(given, 125.0)), error(at_rate(given, rate))
    assert there < 1.05 * here
    assert there > 0.95 * here or name == "humanmovemouse"


@pytest.mark.parametrize("name", SETS)
@pytest.mark.parametrize(
    ("scale", "angle", "mirror"), [(1.0, pi / 5, 1.0), (1.0, 2.2, -1.0), (2.5, 0.0, 1.0)]
)
def test_rotation_and_scale_turn_and_scale_every_answer(
    name: str, scale: float, angle: float, mirror: float
) -> None:
    """Scale with the motor space given: so many more px an inch. Stronger than errors that stay alike."""
    events = prepare(recording(name), threads=1).events
    matrix = scale * np.array([[cos(angle), -mirror * sin(angle)], [sin(angle), mirror * cos(angle)]])
    table = events.table.copy()
    table[:, 1:3] = table[:, 1:3] @ matrix.T
    here = run(build("kinematic"), events).table
    there = run(build("kinematic", dpi=96.0 * scale), EventColumns(table, events.begin)).table
    away = np.hypot(*(there[:, 1:3] - here[:, 1:3] @ matrix.T).T)
    size = np.hypot(*(here[:, 1:3] - events.table[:, 1:3]).T) + 1.0
    assert (away < 0.01 * scale * size).mean() > 0.999
    assert away.mean() < 1e-3 * scale * size.mean()


def test_regions_are_as_sure_as_they_say_on_other_people() -> None:
    """Fitted to a third of the people, calibrated on a third, tested on a third; all deciles of the time."""
    settings = msgspec.structs.replace(Settings(), passes=4, hidden=(32, 32))
    from pointpred.recordings import read

    whole = read(Path(FOLDER or "") / "freihaut2021_samples.parquet")
    school = data.training_data([whole], 1, lambda _: None, variants=1)
    order = np.random.default_rng(2).permutation(len(school.users)).tolist()
    fitted = train.fit_without(school, set(order[12:]), None, settings)
    own = school.own[0]
    known, tested = (
        calibration.claims_of(fitted, own.only(np.isin(own.user, users)), settings)
        for users in (order[12:24], order[24:])
    )
    table = calibration.fit_table(known)
    after = calibration.coverage(calibration.apply_table(tested, table))
    wanted = np.array([*LEVELS, *LEVELS])
    off = np.abs(after - wanted)[:, :5]  # the table knows the intervals of 50 and 80 % only
    before = np.abs(calibration.coverage(tested) - wanted)[:, :5]
    assert off.mean() < 0.5 * before.mean()
    assert off.mean() < 0.035
