"""The files in a folder and the folders below it, and those that cannot be read."""

from __future__ import annotations

import os
from pathlib import Path


def list_files(folder: Path) -> tuple[list[Path], list[str]]:
    """The files below a folder in the order of their paths, and notes on everything else.

    Hidden files are ignored. Links to folders are not followed, so that no file occurs twice.
    """
    files: list[Path] = []
    notes: list[str] = []

    def failed(error: OSError) -> None:
        notes.append(f"{_label(Path(error.filename), folder)} cannot be read: {error.strerror}")

    for place, below, names in os.walk(folder, onerror=failed):
        links = [name for name in below if Path(place, name).is_symlink()]
        notes += [
            f"{_label(Path(place, name), folder)} is a link to a folder: not followed" for name in links
        ]
        for path in (Path(place, name) for name in names if not name.startswith(".")):
            if path.is_file():
                files.append(path)
            else:
                what = "a link to nothing" if path.is_symlink() else "no file that can be read twice"
                notes.append(f"{_label(path, folder)} is {what}")
    return sorted(files), sorted(notes)


def _label(path: Path, folder: Path) -> str:
    return path.relative_to(folder).as_posix()
