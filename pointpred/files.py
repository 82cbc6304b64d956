"""Files that are written whole before they take their place, alone or together."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO


def beside(path: Path, what: str) -> Path:
    """A hidden name in the folder of ``path`` that neither a person nor another process gives a file.

    >>> beside(Path("study/me.npz"), "part").name.startswith(".me.npz.")
    True
    """
    return path.with_name(f".{path.name}.{os.getpid()}.{what}")


@contextmanager
def whole(path: Path) -> Iterator[BinaryIO]:
    """A stream whose file takes its place only when it is whole; a link stays one, its file is replaced.

    What is no file, such as ``/dev/stdout``, is written to as it is. Raises OSError with the name that was
    asked for, not that of the unfinished file.

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     with whole(Path(folder, "plant.json")) as stream:
    ...         written = stream.write(b"{}")
    ...     [one.name for one in Path(folder).iterdir()]
    ['plant.json']
    """
    try:
        if path.exists() and not path.is_file():
            with path.open("wb") as stream:
                yield stream
            return
        place = path.resolve()
        part = beside(place, "part")
        try:
            with part.open("wb") as stream:
                yield stream
            part.replace(place)
        finally:
            part.unlink(missing_ok=True)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error


def write_whole(path: Path, content: bytes) -> None:
    """The same of content that is at hand."""
    with whole(path) as stream:
        stream.write(content)


@contextmanager
def together() -> Iterator[Callable[[Path], Path]]:
    """Yield a path to write each of several files to; all take their places at the end of the block.

    On a failure or an interrupt no file is left and none is replaced. Raises OSError naming the file that
    cannot take its place.
    """
    files: list[Path] = []

    def part(path: Path) -> Path:
        files.append(path)
        return beside(path, "part")

    try:
        yield part
        _place(files)
    finally:
        for path in files:
            beside(path, "part").unlink(missing_ok=True)


def _place(files: list[Path]) -> None:
    """Rename all files; on a failure the replaced ones are restored."""
    placed: list[Path] = []
    path = files[0] if files else Path()
    try:
        for path in files:
            if path.is_dir():
                raise IsADirectoryError(errno.EISDIR, "it is a folder")
            _keep(path)
        for path in files:
            placed.append(path)
            beside(path, "part").replace(path)
    except BaseException as error:
        for done in placed:
            if not beside(done, "part").exists():
                done.unlink(missing_ok=True)
        for done in files:
            if beside(done, "old").exists():
                beside(done, "old").replace(done)
                beside(done, "old").unlink(missing_ok=True)  # two hard links to one file both remain
        if isinstance(error, OSError):
            raise OSError(error.errno, error.strerror or str(error), str(path)) from error
        raise
    for path in files:
        beside(path, "old").unlink(missing_ok=True)


def _keep(path: Path) -> None:
    """Back up a file under another name, if it exists."""
    old = beside(path, "old")
    old.unlink(missing_ok=True)
    if path.exists():
        try:
            os.link(path, old)
        except OSError:  # a file system without links
            path.replace(old)
