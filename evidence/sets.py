"""The sets that pages are made from: the embedded sample and the folder of recordings."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from pointpred.datasets import sample
from pointpred.errors import RecordingError
from pointpred.recording import Recording
from pointpred.recordings import read

VARIABLE = "POINTPRED_RECORDINGS"


def folder() -> Path | None:
    """The folder that the environment names; ``None``, with a message, without one."""
    named = os.environ.get(VARIABLE)
    if named is None:
        print(f"{VARIABLE} names no folder: only the embedded sample is used")
        return None
    if not Path(named).is_dir():
        raise SystemExit(f"{VARIABLE} must name a folder, received {named!r}")
    return Path(named)


def folder_with(name: str) -> Path | None:
    """The folder that the environment names, if it holds a file of this name; ``None`` otherwise."""
    named = folder()
    return named if named is not None and (named / name).is_file() else None


def recordings(folder: Path | None, unread: dict[str, str]) -> Iterator[Recording]:
    """The embedded sample, then one set after the other; what cannot be read goes into ``unread``."""
    yield sample()
    for file in sorted(folder.glob("*_samples.*")) if folder else []:
        try:
            yield read(file)
        except RecordingError as error:
            # The message begins with the file's whole path, which is nobody's business but the machine's.
            unread[file.name] = str(error).replace(str(file), file.name)
