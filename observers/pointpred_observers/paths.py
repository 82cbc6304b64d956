"""Files that a caller names: what is no path is refused in words."""

from __future__ import annotations

import os
from pathlib import Path

from pointpred.errors import ParameterError


def path_of(file: object) -> Path:
    """The path that names a file; raises ParameterError for what is no path, and for an empty one.

    >>> path_of("")
    Traceback (most recent call last):
    pointpred.errors.ParameterError: file must be the path of a file, received ''
    """
    if not isinstance(file, str | os.PathLike) or not str(file):
        raise ParameterError(f"file must be the path of a file, received {file!r}", field="file", value=file)
    return Path(file)


def writable(file: object) -> Path:
    """The path of a file to write; raises ParameterError for a folder, and where its folder is missing."""
    path = path_of(file)
    if path.is_dir() or not path.parent.is_dir():
        words = f"cannot write {path}: its folder must exist and it must not be a folder itself"
        raise ParameterError(words, field="file", value=file)
    return path
