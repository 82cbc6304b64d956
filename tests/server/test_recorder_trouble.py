"""The recorder in trouble: full disks, slow disks, folders it may not use. No session notices."""

from __future__ import annotations

import errno
import logging
import os
import threading
from pathlib import Path

import numpy as np
import pytest

from pointpred.datasets import sample
from pointpred.errors import SourceError
from pointpred.protocol.client_messages import Goal
from pointpred.recorder.recordings import listing
from pointpred.recorder.writer import Recorder
from pointpred.recordings import read
from tests.server.listener import soon
from tests.server.recorded import HELLO, Opened, begin, feed, record
from tests.server.running import PATIENCE_S


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


def rows_in(file: Path) -> int:
    """Whole rows in a samples file, below its two lines of heading."""
    return file.read_bytes().count(b"\n") - 2


def test_a_full_disk_ends_the_recording_and_nothing_else(
    opened: Opened, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    disk = FullDisk(5_000)  # less than the first piece: however it falls to the writer, that does not fit
    recorder = opened(write=disk)
    session, source = record(recorder, range(3), marks=True)
    count = int(source.offsets[3])
    feed(session, source.rows(0))
    assert recorder.close()
    assert session.failed
    assert recorder.failures == 1
    said = [entry for entry in caplog.records if entry.levelno == logging.ERROR]
    assert len(said) == 1
    assert "No space left on device" in said[0].getMessage()
    back = read(tmp_path / "kept" / f"{session.name}_samples.csv")
    assert back.notes[0].startswith(f"{session.name}_samples.csv: the last line is cut")
    kept = sum(len(back.rows(i)) for i in range(len(back.trials)))
    stands = rows_in(tmp_path / "kept" / f"{session.name}_samples.csv")  # also of a trial that never ended
    ends = 3  # of trials
    assert recorder.lost == session.lost == count + ends + len(source.rows(0)) - stands
    np.testing.assert_array_equal(back.events.table, source.events.table[:kept])


def test_events_whose_predictions_alone_found_no_room_are_not_lost(opened: Opened, tmp_path: Path) -> None:
    def full(descriptor: int, data: bytes) -> int:
        if b"phase" in data:  # the header of the predictions
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return os.write(descriptor, data)

    recorder = opened(write=full)
    session = begin(recorder)
    feed(session, sample().rows(0), pieces=1)
    assert recorder.close()
    assert (recorder.failures, recorder.lost, session.lost) == (1, 0, 0)
    (back,) = listing(tmp_path / "kept")
    assert back.events == len(sample().rows(0))


def test_ends_of_trials_after_a_failure_or_the_end_are_lost(opened: Opened) -> None:
    recorder = opened(write=FullDisk(0))
    session = begin(recorder)
    feed(session, sample().rows(0), pieces=1)
    soon(lambda: recorder.failures, "it has failed")
    soon(lambda: recorder.lost == len(sample().rows(0)), "and is counted")
    session.trial("start")
    session.trial("end")
    assert recorder.close()
    session.trial("start")
    session.trial("end")
    assert recorder.lost == session.lost == len(sample().rows(0)) + 2


def test_events_queued_while_the_disk_fills_are_counted_as_lost(opened: Opened) -> None:
    entered, held = threading.Event(), threading.Event()

    def full(descriptor: int, data: bytes) -> int:
        entered.set()
        held.wait(PATIENCE_S)
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    recorder = opened(write=full)
    session = begin(recorder)
    events = sample().rows(0)
    feed(session, events.rows(0, 100), pieces=1)
    assert entered.wait(PATIENCE_S)
    feed(session, events.rows(100, 400), pieces=3)
    held.set()
    assert recorder.close()
    assert recorder.failures == 1
    assert recorder.lost == session.lost == 400
    assert recorder.waiting == 0


def test_after_a_full_disk_a_new_session_is_recorded_again(opened: Opened, tmp_path: Path) -> None:
    disk = FullDisk(0)
    recorder = opened(write=disk)
    first = begin(recorder, "first")
    feed(first, sample().rows(0))
    soon(lambda: recorder.failures, "it has failed")
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
        held.wait(PATIENCE_S)
        return os.write(descriptor, data)

    recorder = opened(write=slow, waiting_most=200)
    session = begin(recorder)
    events = sample().rows(0)
    session.trial("start", Goal(1.0, 2.0, 3.0))
    feed(session, events.rows(0, 100), pieces=1)
    assert entered.wait(PATIENCE_S)
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
