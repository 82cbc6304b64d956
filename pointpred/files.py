"""Names for files that are written whole before they take their place."""

from __future__ import annotations

import os
from collections.abc import Iterator
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
