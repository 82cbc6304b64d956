"""Files that take their place only when they are whole."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from pointpred.files import write_whole
from pointpred_observers import Persidskii, save


def test_a_link_stays_and_its_file_is_replaced(tmp_path: Path) -> None:
    held, link = tmp_path / "held.json", tmp_path / "link.json"
    held.write_text("old")
    link.symlink_to(held)
    write_whole(link, b"new")
    assert (link.is_symlink(), held.read_text()) == (True, "new")


def test_what_is_no_file_is_written_to(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    write_whole(pipe, b"new")
    assert os.read(reader, 9) == b"new"
    os.close(reader)
    assert pipe.is_fifo()


def test_an_error_names_the_file_that_was_asked_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(path: Path, *_: object) -> None:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "open", full)
    monkeypatch.setattr(Path, "write_bytes", full)
    target = tmp_path / "plant.json"
    with pytest.raises(PermissionError) as failure:
        save(Persidskii([[-1.0]], C0=[1.0]), target)
    assert failure.value.filename == str(target)
