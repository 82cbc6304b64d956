"""A table of predictions made elsewhere is scored as the predictor that made it."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pointpred import build, run
from pointpred.datasets import sample
from pointpred.errors import RecordingError
from pointpred.recording import Recording
from pointpred.recordings import write
from pointpred.scoring import prepare, score
from pointpred.scoring.chunks import score_in_chunks
from pointpred.scoring.executors import open_executor
from pointpred.scoring.predictions import predicted
from pointpred.scoring.scorer import scoring_with

SHORT = sample().part(0, 10)
MAKER = "kinematic"
PLAIN = {"t_s": "t", "x_px": "x", "y_px": "y", "sxx_px2": "sxx", "sxy_px2": "sxy", "syy_px2": "syy"}


def made_of(recording: Recording) -> pd.DataFrame:
    """What the maker predicts of the events that predictors see, a row an event."""
    prepared = prepare(recording)
    frame = run(build(MAKER, cpi=2000.0), prepared.events).to_pandas()
    counts = np.diff(prepared.offsets)
    frame["user"] = np.repeat([one.trial.user for one in prepared.trials], counts)
    frame["trial"] = np.repeat([one.trial.trial for one in prepared.trials], counts)
    return frame


TABLE = made_of(SHORT)


def as_r(frame: pd.DataFrame, path: Path) -> Path:
    """As R's ``write.csv`` writes a data frame: names of rows, quoted words, NA, 15 digits."""
    frame = frame.rename(columns=PLAIN).drop(columns="phase")
    frame.index = np.arange(1, len(frame) + 1)
    frame.to_csv(path, na_rep="NA", float_format="%.15g", quoting=csv.QUOTE_NONNUMERIC, index_label="")
    return path


def as_parquet(frame: pd.DataFrame, path: Path) -> Path:
    """As pandas writes it, with trials as whole numbers and users as categories."""
    frame.astype({"trial": int, "user": "category"}).to_parquet(path)
    return path


@pytest.mark.parametrize(("writing", "near"), [(as_r, 1e-9), (as_parquet, 0.0)])
def test_a_table_scores_as_the_predictor_that_made_it(
    tmp_path: Path, writing: Callable[[pd.DataFrame, Path], Path], near: float
) -> None:
    mine = predicted(
        "mine",
        writing(
            TABLE.sample(frac=1.0, random_state=4),
            tmp_path / "table.parquet" if writing is as_parquet else tmp_path / "table.csv",
        ),
    )
    (one,) = score([SHORT], [MAKER, mine], worst=2)
    maker, table = one.predictors[1:]
    for field in ("time_averaged", "by_time", "single_axis", "coverage", "calibration", "time_left", "hits"):
        np.testing.assert_allclose(getattr(table, field), getattr(maker, field), rtol=near, atol=near)
    assert np.isnan(table.us_per_event)
    assert one.notes == ()


def test_chunks_and_checkpoints_know_the_table(tmp_path: Path) -> None:
    (whole,) = score([SHORT], [predicted("mine", TABLE)])
    for rows in (TABLE, TABLE.iloc[:-1]):
        scoring = scoring_with([predicted("mine", rows)], targets=True)
        with open_executor(threads=1) as executor:
            parts = score_in_chunks(SHORT, scoring, executor, checkpoints=tmp_path).joined()
        assert np.array_equal(parts.predictors[-1].by_time, whole.predictors[1].by_time)
        assert [each.name for each in parts.predictors] == ["hold", "hold + targets", "mine"]
    assert len(list(tmp_path.iterdir())) == 2  # another table is another result


def test_what_has_no_row_is_unanswered_and_what_is_not_scored_is_counted() -> None:
    few = TABLE[TABLE["trial"] != "3"]
    (one,) = score([SHORT], [predicted("mine", few.iloc[::2])])
    assert one.predictors[1].coverage[3] == 0.0
    assert one.predictors[1].coverage[0] == pytest.approx(0.5, abs=0.01)
    assert one.notes == ("mine: 1 of 10 trials have no row in the DataFrame",)
    whole = SHORT.to_pandas()
    (one,) = score([SHORT], [predicted("mine", whole)])
    outside = len(whole) - sum(trial.events for trial in one.trials)
    assert one.notes[0].startswith(
        f"mine: {outside} of {len(whole)} rows are not scored: they lie before the onset"
    )
    assert np.array_equal(one.predictors[1].by_time, one.predictors[0].by_time)


def changed(**columns: object) -> pd.DataFrame:
    return TABLE.iloc[:50].assign(**columns)


def first(column: str, value: float) -> pd.DataFrame:
    frame = TABLE.copy()
    frame.loc[7, column] = value
    return frame


WRONG = {
    "1 of 1 trials are not in the recording.*there are such as": changed(trial="99"),
    "50 of 50 rows of user, trial .* no event of their own.*the nearest event is at": changed(
        t_s=TABLE["t_s"].iloc[:50] + 5e-4
    ),
    "50 of 100 rows .*which has its row already": pd.concat([TABLE.iloc[:50]] * 2),
    "no row is of this set": changed(dataset="another"),
    "no column trial": TABLE.drop(columns="trial"),
    "no column x or x_px": TABLE.drop(columns="x_px"),
    "row 7 .*only one of x and y": first("y_px", np.nan),
    "row 0 .*only some of sxx": first("x_px", 3.0).assign(sxx_px2=1.0),
    "row 7 .*infinite": first("x_px", np.inf),
    "row 7 .*negative time left": first("remaining_s", -0.1),
    "row 0 .*covariance that is none": TABLE.assign(sxx_px2=1.0, syy_px2=1.0, sxy_px2=2.0),
    "must hold numbers": changed(x_px="left"),
}


@pytest.mark.parametrize("words", WRONG)
def test_rows_that_are_no_predictions_of_the_recording_are_refused_by_place(words: str) -> None:
    with pytest.raises(RecordingError, match=words):
        score([SHORT], [predicted("mine", WRONG[words])])


def test_the_command_line_takes_a_table_beside_names_for_each_of_several_sets(
    command, tmp_path: Path
) -> None:
    parts = {"one": SHORT.part(0, 4), "two": SHORT.part(4, 8)}
    files, frames = [], []
    for name, part in parts.items():
        own = Recording.of(name, [part.rows(k) for k in range(4)], part.trials, provenance=part.provenance)
        files.append(write(own, tmp_path / f"{name}_samples.csv")[0])
        frames.append(made_of(own).assign(dataset=name))
    table = as_r(pd.concat(frames), tmp_path / "made.csv")
    left = command("score", *files, "--predictors", f"{MAKER}, mine={table}", "--json", "-")
    sets = json.loads(left.out)["sets"]
    assert [one["name"] for one in sets] == list(parts)
    for one in sets:
        maker, mine = one["predictors"][1:]
        assert "mine: " in one["notes"][-1]
        assert "are of other sets" in one["notes"][-1]
        assert (mine["name"], mine["us_per_event"]) == ("mine", None)
        assert mine["time_averaged"]["px"] == pytest.approx(maker["time_averaged"]["px"], rel=1e-9)
    assert command("score", files[0], "--predictors", f"mine={tmp_path / 'none.csv'}").code == 2
    again = command("score", files[0], "--predictors", f"mine={table}", "--trials", table, "--force")
    assert "would replace a file that this command reads" in again.err
