"""The recorder without a socket: what is written is what came."""

from __future__ import annotations

import csv
import stat
from pathlib import Path

import numpy as np
import pytest

from pointpred.datasets import sample
from pointpred.protocol.client_messages import Hello
from pointpred.recorder.recordings import listing
from pointpred.recording import Recording
from pointpred.recordings import read, read_any
from pointpred.records import EventColumns
from pointpred.scoring import score
from tests.server.listener import soon
from tests.server.recorded import Opened, begin, feed, record


def test_a_marked_session_comes_back_bit_for_bit_and_scores_the_same(opened: Opened, tmp_path: Path) -> None:
    recorder = opened()
    session, source = record(recorder, range(3), marks=True)
    assert recorder.close()
    assert (recorder.lost, recorder.failures, recorder.waiting, session.lost) == (0, 0, 0, 0)
    (back,) = read_any(tmp_path / "kept")
    assert (back.name, back.skipped, back.notes) == ("20260102T030405Z-one", (), ())
    assert (back.provenance.cpi, back.provenance.dpi) == (800.0, 110.0)
    stop = int(source.offsets[3])
    assert back.events.table.tobytes() == source.events.table[:stop].tobytes()
    for mine, known in zip(back.trials, source.trials, strict=False):
        assert (mine.target_x, mine.target_y, mine.target_w) == (
            known.target_x,
            known.target_y,
            known.target_w,
        )
    wanted = Recording.of("wanted", [source.rows(i) for i in range(3)], source.trials[:3])
    options = {"cpi": 800.0, "dpi": 110.0, "threads": 1}
    (first,), (second,) = (score([one], ["switched", "hold"], **options) for one in (back, wanted))
    for ours, theirs in zip(first.predictors, second.predictors, strict=True):
        assert ours.time_averaged.tobytes() == theirs.time_averaged.tobytes()


def test_a_session_without_marks_is_cut_at_clicks(opened: Opened, tmp_path: Path) -> None:
    recorder = opened()
    session = begin(recorder)
    events = EventColumns.of(np.arange(6) / 8, range(6), [0] * 6, buttons=[0, 0, 1, 0, 0, 1])
    feed(session, events, pieces=3)
    assert recorder.close()  # without the session's close: as when the service stops
    back = read(tmp_path / "kept" / f"{session.name}_samples.csv")
    assert [len(back.rows(i)) for i in range(2)] == [3, 3]
    assert not (tmp_path / "kept" / f"{session.name}_trials.csv").exists()


def test_predictions_lie_beside_the_events(opened: Opened, tmp_path: Path) -> None:
    recorder = opened()
    session = begin(recorder)
    said = [feed(session, sample().rows(0))]
    session.configure(Hello(1, "hold", parameters={"dpi": 100.0}))
    said.append(feed(session, sample().rows(1)))
    assert recorder.close()
    with (tmp_path / "kept" / f"{session.name}_predictions.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    expected = np.concatenate([one.table for one in said])
    phases = ["still", "ballistic", "corrective"]
    assert len(rows) == len(expected)
    for row, values in zip(rows, expected.tolist(), strict=True):
        cells = list(row.values())
        assert [cells[8], cells[9]] == ["" if value != value else repr(value) for value in values[8:]]
        assert [cell == "" for cell in cells[:7]] == [value != value for value in values[:7]]
        assert [float(cell) for cell in cells[:7] if cell] == [
            value for value in values[:7] if value == value
        ]
        assert cells[7] == ("" if values[7] != values[7] else phases[int(values[7])])
    told = [(row["predictor"], row["parameters"]) for row in rows]
    assert told == [("switched", "")] * len(said[0]) + [("hold", '{"dpi":100.0}')] * len(said[1])


def test_conditions_of_trials_are_columns_that_are_read_again(opened: Opened, tmp_path: Path) -> None:
    recorder = opened()
    session = begin(recorder)
    told = [
        {"block": 1.0, "participant": "007", "note": 'a, "b"'},
        {"participant": "8", "block": 2.5},
        {"note": "", "block": 3.0, "participant": "\u00e4"},
    ]
    samples = tmp_path / "kept" / f"{session.name}_samples.csv"
    for index, conditions in enumerate(told):
        session.trial("start")
        feed(session, sample().rows(index))
        soon(samples.exists, "the beginning of the first trial is on the disk before its end")
        session.trial("end", None, conditions)
    session.close()
    assert recorder.close()
    back = read(samples)
    del told[2]["note"]  # an empty cell
    assert [trial.condition for trial in back.trials] == told
    assert not back.skipped


def test_files_are_the_owners_and_a_taken_name_is_never_written_to(
    opened: Opened, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    recorder = opened()
    record(recorder, range(1), marks=True)
    assert recorder.close()
    before = {path: path.read_bytes() for path in (tmp_path / "kept").iterdir()}
    assert len(before) == 3
    assert {stat.S_IMODE(path.stat().st_mode) for path in before} == {0o600}
    assert stat.S_IMODE((tmp_path / "kept").stat().st_mode) == 0o700
    again = opened()
    session, _ = record(again, range(1), marks=True)
    assert again.close()
    assert session.failed
    assert again.failures == 1
    assert again.lost == len(sample().rows(0)) + 1  # and the end of its trial
    assert {path: path.read_bytes() for path in before} == before
    assert "File exists" in caplog.text


@pytest.mark.parametrize("name", ["../../escape", "/etc/passwd", "a\0b", "", "..", "x" * 500, "_samples"])
def test_no_name_leads_out_of_the_folder(opened: Opened, tmp_path: Path, name: str) -> None:
    recorder = opened()
    feed(begin(recorder, name), sample().rows(0))
    assert recorder.close()
    assert [path.name for path in tmp_path.iterdir()] == ["kept"]
    assert recorder.failures == 0
    (one,) = listing(tmp_path / "kept")
    assert one.events == len(sample().rows(0))
