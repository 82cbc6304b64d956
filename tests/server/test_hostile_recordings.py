"""Recordings that are deleted while they are made, and descriptors that cannot be closed."""

from __future__ import annotations

import errno
import json
import logging
import os
import threading
from pathlib import Path

import pytest

from pointpred.recorder.files import SessionFiles
from pointpred.recorder.recordings import delete, listing
from pointpred.recorder.writer import Recorder
from tests.server.listener import soon
from tests.server.recorded import begin
from tests.server.running import PATIENCE_S, event, running


def test_what_is_deleted_while_it_is_made_leaves_nothing_and_is_said(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    folder = tmp_path / "kept"
    with running(record=folder) as here:
        with here.greeted() as socket:
            for t in range(3):
                socket.send(event(float(t)))
                assert json.loads(socket.recv(PATIENCE_S))["t"] == t
            soon(lambda: len(list(folder.iterdir())) == 2, "samples and predictions are begun")
            (one,) = listing(folder)
            delete(folder, [one.name])
            assert not list(folder.iterdir())
            socket.send('{"type":"trial","action":"start"}')
            for t in range(3, 6):
                socket.send(event(float(t)))
                assert json.loads(socket.recv(PATIENCE_S))["t"] == t
            socket.send('{"type":"trial","action":"end","target":{"x":5,"y":6,"width":9}}')
            assert json.loads(socket.recv(PATIENCE_S))["type"] == "score"
        soon(lambda: not here.service._open, "the session is over")
    assert not list(folder.iterdir())
    (entry,) = (one for one in caplog.records if one.levelno == logging.ERROR)
    assert "stopped" in entry.getMessage()
    assert "deleted" in entry.getMessage()


def test_marks_that_wait_for_a_slow_disk_are_bounded(tmp_path: Path) -> None:
    entered, held = threading.Event(), threading.Event()

    def slow(descriptor: int, data: bytes) -> int:
        entered.set()
        held.wait(PATIENCE_S)
        return os.write(descriptor, data)

    recorder = Recorder(tmp_path, waiting_most=50, write=slow)
    session = begin(recorder)
    session.trial("start")
    session.trial("end")
    assert entered.wait(PATIENCE_S)
    for _ in range(500):
        session.trial("start")
        session.trial("end")
    assert len(recorder._items) <= 50
    kept = sum(item.ends for _, item in recorder._items)
    assert recorder.lost == session.lost == 500 - kept
    held.set()
    session.close()
    assert recorder.close()


def test_an_error_of_no_file_is_told_by_its_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def broken(*rows: object) -> bytes:
        raise ValueError("at 7315.25")

    monkeypatch.setattr("pointpred.recorder.writer.sample_rows", broken)
    with running(record=tmp_path / "kept") as here, here.greeted() as socket:
        socket.send(event(1.0))
        assert json.loads(socket.recv(PATIENCE_S))["t"] == 1.0
        soon(lambda: here.service.recorder.failures == 1, "it is noticed")
    assert "ValueError at writer.py" in caplog.text
    assert "7315.25" not in caplog.text


def test_every_file_is_closed_whatever_the_first_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files = SessionFiles(tmp_path, "one", {})
    for part in ("samples", "trials", "predictions"):
        files.append(part, b"")
    opened = list(files._opened.values())
    real, complained = os.close, []

    def close(descriptor: int) -> None:
        real(descriptor)
        complained.append(descriptor)
        raise OSError(errno.EIO, f"at file {len(complained)}")

    monkeypatch.setattr(os, "close", close)
    with pytest.raises(OSError, match="at file 1"):
        files.close()
    monkeypatch.undo()
    assert complained == opened
    files.close()


def test_a_pipe_with_the_name_of_a_recording_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "20260102T030405Z-one_samples.csv")
    assert listing(tmp_path) == []
