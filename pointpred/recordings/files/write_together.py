"""Write several files so that all appear or none: each is written under a temporary name first."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from pointpred.errors import RecordingError
from pointpred.files import beside


@contextmanager
def write_together() -> Iterator[Callable[[Path], Path]]:
    """Yield a path to write each file to; at the end of the block all are renamed to their final names.

    On a failure or an interrupt no file is left and none is replaced. Raises RecordingError naming the file
    that cannot be renamed.
    """
    files: list[Path] = []

    def part(path: Path) -> Path:
        files.append(path)
        return _part(path)

    try:
        yield part
        _place(files)
    finally:
        for path in files:
            _part(path).unlink(missing_ok=True)


def _place(files: list[Path]) -> None:
    """Rename all files; on a failure the replaced ones are restored."""
    placed: list[Path] = []
    path = files[0] if files else Path()
    try:
        for path in files:
            if path.is_dir():
                raise RecordingError(f"{path}: cannot be written: it is a folder")
            _keep(path)
        for path in files:
            placed.append(path)
            _part(path).replace(path)
    except BaseException as error:
        for done in placed:
            if not _part(done).exists():
                done.unlink(missing_ok=True)
        for done in files:
            if _old(done).exists():
                _old(done).replace(done)
                _old(done).unlink(missing_ok=True)  # two hard links to one file both remain
        if isinstance(error, OSError):
            raise RecordingError(f"{path}: cannot be written: {error.strerror or error}") from error
        raise
    for path in files:
        _old(path).unlink(missing_ok=True)


def _keep(path: Path) -> None:
    """Back up a file under another name, if it exists."""
    old = _old(path)
    old.unlink(missing_ok=True)
    if path.exists():
        try:
            os.link(path, old)
        except OSError:  # a file system without links
            path.replace(old)


def _part(path: Path) -> Path:
    return beside(path, "part")


def _old(path: Path) -> Path:
    return beside(path, "old")
