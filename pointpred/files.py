"""Names for files that are written whole before they take their place."""

from __future__ import annotations

import os
from pathlib import Path


def beside(path: Path, what: str) -> Path:
    """A hidden name in the folder of ``path`` that neither a person nor another process gives a file.

    >>> beside(Path("study/me.npz"), "part").name.startswith(".me.npz.")
    True
    """
    return path.with_name(f".{path.name}.{os.getpid()}.{what}")
