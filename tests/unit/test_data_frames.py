"""DataFrames of pandas in and out, and what a notebook prints."""

from __future__ import annotations

import sys

import numpy as np
import pandas as pd
import pytest

from pointpred import EventColumns, build, run
from pointpred.datasets import sample
from pointpred.errors import EventError, MissingExtraError, RecordingError
from pointpred.recordings import read_any
from pointpred.scoring import score, summarise

SHORT = sample().part(0, 12)
PIPELINE = "kinematic-adaptive"


def test_a_recording_goes_through_a_frame_and_comes_back_the_same() -> None:
    frame = SHORT.to_pandas()
    assert frame["begin"].sum() == 12
    [back] = read_any(frame)
    assert back.events.table.tobytes() == SHORT.events.table.tobytes()
    assert back.trials == SHORT.trials
    assert np.array_equal(back.offsets, SHORT.offsets)
    [fewer] = read_any(frame[["user", "trial", "t_s", "x_px", "y_px"]])
    assert np.isnan(fewer.events.dx).all()


def test_run_answers_in_a_frame_with_the_same_index_as_in_columns() -> None:
    frame = SHORT.to_pandas().set_index(np.arange(len(SHORT.events)) + 7)
    columns = run(build(PIPELINE, cpi=2000.0), SHORT.events)
    answers = run(build(PIPELINE, cpi=2000.0), frame)
    assert answers.index.equals(frame.index)
    assert np.array_equal(answers["x_px"], columns.x, equal_nan=True)
    assert np.array_equal(
        answers.drop(columns="phase").to_numpy(), np.delete(columns.table, 7, 1), equal_nan=True
    )
    with pytest.raises(EventError, match="backwards"):
        run(build(PIPELINE), SHORT.to_pandas().iloc[11::-1])
    assert answers["phase"].iloc[0] == "still"
    plain = frame.rename(columns={"t_s": "t", "x_px": "x", "y_px": "y"})[["t", "x", "y"]].iloc[:900]
    stream = run(build("linear"), EventColumns(SHORT.events.table[:900] * [1, 1, 1, np.nan, np.nan, 0]))
    assert np.array_equal(run(build("linear"), plain)["y_px"], stream.y, equal_nan=True)
    assert len(run(build("hold"), plain.iloc[:0])) == 0


def test_frames_that_hold_no_events_are_refused_by_name() -> None:
    with pytest.raises(EventError, match="needs a column y or y_px, received t, x"):
        run(build("hold"), pd.DataFrame({"t": [0.0], "x": [1.0]}))
    with pytest.raises(EventError, match="x needs numbers"):
        run(build("hold"), pd.DataFrame({"t": [0.0], "x": ["left"], "y": [1.0]}))
    with pytest.raises(RecordingError, match=r"^DataFrame: no column for y") as caught:
        read_any(pd.DataFrame({"t": [0.0, 0.1], "x": [1, 2]}))
    assert "/" not in str(caught.value).replace("t=COLUMN", "")
    with pytest.raises(RecordingError, match="DataFrame"):
        read_any(pd.DataFrame({"t": [0.0, 0.1], "x": [1, {2}], "y": [1, 2]}))


def test_without_pandas_the_command_that_installs_it_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MissingExtraError, match=r"a DataFrame needs pandas.*report"):
        SHORT.to_pandas()
    assert len(run(build("hold"), SHORT.events)) == len(SHORT.events)


def test_what_a_notebook_prints_is_short_and_tab_completion_knows_the_columns() -> None:
    (scored,) = score([SHORT], ["linear"])
    pipeline = build("kinematic-adaptive", cpi=2000.0, places=0)
    shown = [SHORT, SHORT.events, pipeline, scored, summarise(scored), summarise(scored).predictors[1]]
    assert max(len(repr(one)) for one in shown) < 300
    assert "places=0" in repr(pipeline)
    assert "cpi=2000.0" in repr(pipeline)
    assert {"t", "buttons", "begin", "to_pandas"} <= set(dir(SHORT.events))
    assert "remaining_s" in dir(run(pipeline, SHORT.events))


def test_a_named_index_is_a_column() -> None:
    frame = sample().part(0, 4).to_pandas()
    [plain] = read_any(frame)
    [indexed] = read_any(frame.set_index(["user", "trial"]))
    assert [(one.user, one.trial) for one in indexed.trials] == [
        (one.user, one.trial) for one in plain.trials
    ]
