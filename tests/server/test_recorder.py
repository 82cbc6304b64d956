"""The recorder without a socket: what is written is what came; what goes wrong reaches no session."""

from __future__ import annotations

import csv
import errno
import logging
import os
import stat
import threading
from collections.abc import Callable, Iterator
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from pointpred import build, run
from pointpred.columns import EventColumns, PredictionColumns
from pointpred.datasets import sample
from pointpred.errors import SourceError
from pointpred.recording import Recording
from pointpred.scoring import score
from pointpred.server.messages import Device, Goal, Hello, Screen
from pointpred.server.recorder import Recorder
from pointpred.server.recorder_session import SessionRecorder
from pointpred.server.recordings import listing
from pointpred.sources import read, read_any

BEGUN = datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC)
HELLO = Hello(1, "switched", device=Device(cpi=800.0), screen=Screen(dpi=110.0))
Opened = Callable[..., Recorder]


@pytest.fixture
def opened(tmp_path: Path) -> Iterator[Opened]:
    """Recorders into one folder, closed in the end."""
    made: list[Recorder] = []

    def make(**options: object) -> Recorder:
        made.append(Recorder(tmp_path / "kept", today=lambda: BEGUN, **options))  # type: ignore[arg-type]
        return made[-1]

    yield make
    for recorder in made:
        assert recorder.close()


def begin(recorder: Recorder, name: str = "one", hello: Hello = HELLO) -> SessionRecorder:
    session = recorder.open(name, hello)
    assert session is not None
    return session


def feed(session: SessionRecorder, events: EventColumns, pieces: int = 7) -> PredictionColumns:
    """Send events piece by piece with their predictions."""
    pipeline = build("switched", cpi=800.0, dpi=110.0)
    answers = []
    for rows in np.array_split(events.table, pieces):
        part = EventColumns(rows)
        answers.append(run(pipeline, part).table)
        session.events(part, PredictionColumns(answers[-1]))
    return PredictionColumns(np.concatenate(answers))


def record(recorder: Recorder, trials: range, *, marks: bool) -> tuple[SessionRecorder, Recording]:
    source = sample()
    session = begin(recorder)
    for index in trials:
        known = source.trials[index]
        if marks:
            session.trial("start", Goal(known.target_x, known.target_y, known.target_w))
        feed(session, source.rows(index))
        if marks:
            session.trial("end")
    session.close()
    return session, source


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

        assert [cell == "" for cell in cells[:7]] == [value != value for value in values[:7]]
        assert [float(cell) for cell in cells[:7] if cell] == [
            value for value in values[:7] if value == value
        ]
        assert cells[7] == ("" if values[7] != values[7] else phases[int(values[7])])
    told = [(row["predictor"], row["parameters"]) for row in rows]
    assert told == [("switched", "")] * len(said[0]) + [("hold", '{"dpi":100.0}')] * len(said[1])


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
    assert again.lost == len(sample().rows(0))
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


class FullDisk:
    """Takes ``room`` bytes, the last ones only in part, and then says that no space is left."""

    def __init__(self, room: int) -> None:
        self.room = room

    def __call__(self, descriptor: int, data: bytes) -> int:
        if not self.room:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        taken = os.write(descriptor, data[: self.room])
        self.room -= taken
        return taken


def test_a_full_disk_ends_the_recording_and_nothing_else(
    opened: Opened, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    disk = FullDisk(30_000)
    recorder = opened(write=disk)
    session, source = record(recorder, range(3), marks=True)
    count = int(source.offsets[3])
    feed(session, source.rows(0))
    assert recorder.close()
    assert session.failed
    assert recorder.failures == 1
    assert recorder.lost == session.lost == count + len(source.rows(0))
    said = [entry for entry in caplog.records if entry.levelno == logging.ERROR]
    assert len(said) == 1
    assert "No space left on device" in said[0].getMessage()
    back = read(tmp_path / "kept" / f"{session.name}_samples.csv")
    assert back.notes[0].startswith(f"{session.name}_samples.csv: the last line is cut")
    kept = sum(len(back.rows(i)) for i in range(len(back.trials)))
    np.testing.assert_array_equal(back.events.table, source.events.table[:kept])


def test_after_a_full_disk_a_new_session_is_recorded_again(opened: Opened, tmp_path: Path) -> None:
    disk = FullDisk(0)
    recorder = opened(write=disk)
    first = begin(recorder, "first")
    feed(first, sample().rows(0))
    while not recorder.failures:
        threading.Event().wait(0.01)
    disk.room = 1 << 30
    feed(begin(recorder, "second"), sample().rows(1))
    feed(first, sample().rows(1))
    assert recorder.close()
    assert recorder.failures == 1
    assert recorder.lost == len(sample().rows(0)) + len(sample().rows(1))
    (back,) = [one for one in listing(tmp_path / "kept") if one.name.endswith("second")]
    assert back.events == len(sample().rows(1))


def test_a_slow_disk_costs_events_but_no_memory_and_no_false_trial(opened: Opened, tmp_path: Path) -> None:
    held = threading.Event()
    entered = threading.Event()

    def slow(descriptor: int, data: bytes) -> int:
        entered.set()
        held.wait(10)
        return os.write(descriptor, data)

    recorder = opened(write=slow, waiting_most=200)
    session = begin(recorder)
    events = sample().rows(0)
    session.trial("start", Goal(1.0, 2.0, 3.0))
    feed(session, events.rows(0, 100), pieces=1)
    assert entered.wait(10)
    feed(session, events.rows(100, 1000), pieces=9)
    assert recorder.waiting == 200
    assert recorder.lost == session.lost == 800
    session.trial("end")
    held.set()
    session.trial("start")
    assert recorder.close()
    back = read(tmp_path / "kept" / f"{session.name}_samples.csv")
    assert back.skipped[0].reason == "200 samples, expected 1000 as the trials file says"


def test_a_folder_that_cannot_be_written_is_refused_at_once(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("no folder", encoding="utf-8")
    with pytest.raises(SourceError, match="cannot record there"):
        Recorder(tmp_path / "file")


def test_a_folder_that_others_can_look_into_is_named(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    tmp_path.chmod(0o755)
    assert Recorder(tmp_path).close()
    assert f"others on this machine can look into {tmp_path}" in caplog.text


def test_a_recorder_that_was_closed_opens_nothing(opened: Opened) -> None:
    recorder = opened()
    session = begin(recorder)
    assert recorder.close()
    assert recorder.open("late", HELLO) is None
    feed(session, sample().rows(0))
    assert recorder.lost == len(sample().rows(0))
