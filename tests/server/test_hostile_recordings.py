"""Recordings that are deleted while they are made, and descriptors that cannot be closed."""

from __future__ import annotations

import errno
import json
import logging
import os
from pathlib import Path

import pytest

from pointpred.server.recorder_files import SessionFiles
from pointpred.server.recordings import delete, listing
from tests.server.listener import soon
from tests.server.running import running


def event(t: float) -> str:
    return f'{{"type":"events","events":[[{t},5,6,null,null,0]]}}'


def test_what_is_deleted_while_it_is_made_leaves_nothing_and_is_said(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    folder = tmp_path / "kept"
    with running(record=folder) as here:
        with here.greeted() as socket:
            for t in range(3):
                socket.send(event(float(t)))
                assert json.loads(socket.recv(10))["t"] == t
            soon(lambda: len(list(folder.iterdir())) == 2, "samples and predictions are begun")
            (one,) = listing(folder)
            delete(folder, [one.name])
            assert not list(folder.iterdir())
            socket.send('{"type":"trial","action":"start"}')
            for t in range(3, 6):
                socket.send(event(float(t)))
                assert json.loads(socket.recv(10))["t"] == t
            socket.send('{"type":"trial","action":"end","target":{"x":5,"y":6,"width":9}}')
            assert json.loads(socket.recv(10))["type"] == "score"
        soon(lambda: not here.service._open, "the session is over")
    assert not list(folder.iterdir())
    (entry,) = (one for one in caplog.records if one.levelno == logging.ERROR)
    assert "stopped" in entry.getMessage()
    assert "deleted" in entry.getMessage()


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
