"""Scored trials as one table, a row a trial and predictor: for R, pandas or a spreadsheet."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.csv as pacsv
import pyarrow.parquet as pq

from pointpred.errors import ParameterError
from pointpred.files import whole
from pointpred.scoring.results import (
    AXIS_FRACTIONS,
    PATH_FRACTIONS,
    TIME_FRACTIONS,
    PredictorErrors,
    SetScore,
)
from pointpred.scoring.selection import OWN, SCORED, condition_column

EXTENSIONS = (".csv", ".parquet")
SERIES = (
    ("time", "by_time", TIME_FRACTIONS),
    ("path", "by_path", PATH_FRACTIONS),
    ("axis", "single_axis", AXIS_FRACTIONS),
)


def trial_table(scores: Iterable[SetScore]) -> Any:
    """A ``pyarrow.Table`` with a row a trial and predictor; its ``to_pandas()`` is a DataFrame.

    Columns: ``set, unit``; the trial, its target (px) and what scoring found, ``user, trial, target_x,
    target_y, target_w, clean, distance_px, onset_s, arrival_s, events, submovements, end_repeats,
    distance_repeats``; a column a condition;
    ``predictor, coverage, time_averaged_px``, the error at shares of the time and of the path as
    ``time_30_px`` and ``path_50_px``, along the longer axis as ``axis_50_px``; ``hit_30``, 1 where the
    prediction lay in the target. Where ``unit`` is counts, px are counts. What is not known is null.
    """
    listed = list(scores)
    words: dict[str, bool] = {}
    for one in (one for score in listed for one in score.trials):
        for name, value in one.trial.condition.items():
            words[name] = words.get(name, False) or isinstance(value, str)
    tables = [
        pa.table({**about, **_measured(errors)})
        for score in listed
        for about in [_about(score, words)]
        for errors in score.predictors
    ]
    return pa.concat_tables(tables) if tables else pa.table({})


def _about(score: SetScore, words: Mapping[str, bool]) -> dict[str, Any]:
    """The columns of the trials; ``words``: the conditions of all sets, and whether any value is a word."""
    trials = score.trials
    columns = {"set": [score.name] * len(trials), "unit": [score.unit] * len(trials)}
    kinds = {"user": pa.string(), "trial": pa.string(), "events": pa.int64()}
    kinds |= dict.fromkeys(("clean", "submovements", "end_repeats", "distance_repeats"), pa.bool_())
    arrays: dict[str, Any] = {name: pa.array(cells, pa.string()) for name, cells in columns.items()}
    for name in (*OWN, *SCORED):
        cells = [getattr(one if name in (*SCORED, "clean") else one.trial, name) for one in trials]
        arrays[name] = pa.array(cells, kinds.get(name, pa.float64()), from_pandas=True)
    for name in sorted(words):
        cells = [one.trial.condition.get(name) for one in trials]
        if words[name]:
            cells = [cell if cell is None or isinstance(cell, str) else f"{cell:g}" for cell in cells]
        kind = pa.string() if words[name] else pa.float64()
        arrays[condition_column(name)] = pa.array(cells, kind, from_pandas=True)
    return arrays


def _measured(errors: PredictorErrors) -> dict[str, Any]:
    """The columns of one predictor."""
    count = len(errors.coverage)
    columns = {
        "predictor": pa.array([errors.name] * count, pa.string()),
        "coverage": pa.array(errors.coverage),
        "time_averaged_px": pa.array(errors.time_averaged),
    }
    for kind, field, shares in SERIES:
        for share, cells in zip(shares, getattr(errors, field).T, strict=True):
            columns[f"{kind}_{100 * share:.0f}_px"] = pa.array(cells, from_pandas=True)
    for place, share in enumerate(TIME_FRACTIONS):
        hit = pa.nulls(count, pa.float64())
        if errors.hits is not None:
            hit = pa.array(errors.hits[:, place], from_pandas=True)
        columns[f"hit_{100 * share:.0f}"] = hit
    return columns


def check_trials_file(path: Path) -> None:
    """Raise ParameterError for a name that ends in something else than .csv or .parquet."""
    if path.suffix not in EXTENSIONS:
        expected = " or ".join(EXTENSIONS)
        raise ParameterError(f"--trials {path}: expected a name that ends in {expected}", field="trials")


def write_trials(table: Any, path: Path) -> None:
    """Write a table as CSV or Parquet, by the end of the name; raises OSError."""
    with whole(path) as stream:
        if path.suffix == ".csv":
            pacsv.write_csv(table, stream)
        else:
            pq.write_table(table, stream)
