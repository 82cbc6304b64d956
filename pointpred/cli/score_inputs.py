"""The recordings that a command is given, one by one, each with a name of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import msgspec

from pointpred.cli.reading_options import recordings_in, shown
from pointpred.console import remarks
from pointpred.errors import PointpredError
from pointpred.recording import Recording

if TYPE_CHECKING:
    from pointpred.recordings import Reading, StoredRecording

Reasons = dict[str, str]
"""Files that could not be read and recordings that could not be scored, and why."""
Source = TypeVar("Source", "Recording", "Recording | StoredRecording")


def in_memory(files: list[Path], reading: Reading, reasons: Reasons) -> Iterator[Recording]:
    """The recordings of files, so that only one is in memory; complains where a file cannot be read."""
    return _named(files, lambda file: recordings_in(file, reading), reasons)


def in_memory_or_stored(
    files: list[Path], reading: Reading, reasons: Reasons
) -> Iterator[Recording | StoredRecording]:
    """The same, but long files of pointpred's own stay where they are."""
    return _named(files, lambda file: recordings_in(file, reading, stored=True), reasons)


def _named(
    files: list[Path], open_one: Callable[[Path], Sequence[Source]], reasons: Reasons
) -> Iterator[Source]:
    names: dict[str, Path] = {}
    for file in files:
        try:
            for recording in open_one(file):
                name = _free_name(recording.name, file, names)
                if name != recording.name:
                    first = shown(names[recording.name])
                    note = f"{shown(file)} is called {name!r} here: {recording.name!r} is {first}"
                    remarks().print(note, markup=False)
                names[name] = file
                yield _called(recording, name)
        except (PointpredError, OSError) as error:
            leave_out(reasons, shown(file), error)


def _called(recording: Source, name: str) -> Source:
    if isinstance(recording, Recording):
        return msgspec.structs.replace(recording, name=name)
    about = msgspec.structs.replace(recording.about, name=name)
    return msgspec.structs.replace(recording, about=about)


def _free_name(name: str, file: Path, names: Mapping[str, Path]) -> str:
    """A name that no other recording has: with its folder before it where it is taken, then with a number."""
    free, count = name, 1
    while free in names:
        folder = file.absolute() if file.is_dir() else file.absolute().parent
        free = f"{folder.name}/{name}" + f"_{count}" * (count > 1)
        count += 1
    return free


def leave_out(reasons: Reasons, name: str, error: Exception) -> None:
    """Complain about a file that cannot be read or a recording that cannot be scored, and remember it."""
    expected = isinstance(error, PointpredError | OSError)
    reason = str(error) if expected else f"{type(error).__name__}: {error}"
    reasons[name] = reason
    message = reason if name in reason else f"{name}: {reason}"
    remarks().print(f"left out: {message}", style="red", markup=False)
