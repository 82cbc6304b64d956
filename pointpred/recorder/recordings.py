"""The folder of recorded sessions: the names of the files, listing and deleting them.

A name holds the time when the session began and random letters: nothing that a client sent.
"""

from __future__ import annotations

import os
import re
import stat
from datetime import UTC, datetime
from pathlib import Path

import msgspec

from pointpred.errors import ParameterError, PointpredError, SourceError

STAMP = "%Y%m%dT%H%M%SZ"
_file = re.compile(
    r"(?P<name>(?P<stamp>[0-9]{8}T[0-9]{6}Z)-[A-Za-z0-9_-]{1,40}?)_(?P<part>samples|trials|predictions)\.csv"
)
_other = re.compile(r"[^A-Za-z0-9_-]+")


class Recorded(msgspec.Struct, frozen=True):
    """One session on disk; ``problem`` says why its samples could not be read, where they could not."""

    name: str
    begun: datetime
    files: tuple[Path, ...]
    size: int
    events: int = 0
    trials: int = 0
    skipped: int = 0
    notes: tuple[str, ...] = ()
    problem: str | None = None


def name_of(session: str, begun: datetime) -> str:
    """The name of a session's files: letters, digits, - and _ only, whatever the session is called.

    >>> name_of("../../etc/passwd", datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC))
    '20260102T030405Z-etc-passwd'
    """
    safe = _other.sub("-", session).strip("-_")[:40].rstrip("-_")
    return f"{begun.astimezone(UTC).strftime(STAMP)}-{safe or 'session'}"


def prepare(folder: Path) -> bool:
    """Create the folder, for its owner only, and check that it can be written.

    Returns whether others can read it, which happens only where it existed before; raises SourceError.
    """
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        mode = folder.stat().st_mode
    except OSError as error:
        raise SourceError(f"{folder}: cannot record there: {error.strerror}") from error
    if not os.access(folder, os.W_OK | os.X_OK):
        raise SourceError(f"{folder}: cannot record there: it is read-only, or not this user's")
    # Windows gives no such bits: who may look is decided by the lists of the folder above.
    return hasattr(os, "getuid") and bool(stat.S_IMODE(mode) & 0o077)


def listing(folder: Path, *, counted: bool = True) -> list[Recorded]:
    """The sessions in a folder, the oldest first; other files are ignored.

    ``counted``: read each one for its events and trials. Raises SourceError where the folder cannot be read.
    """
    sessions: dict[str, list[Path]] = {}
    try:
        for path in sorted(folder.iterdir()):
            matched = _file.fullmatch(path.name)
            if matched is not None and path.is_file():  # a pipe would be waited for
                sessions.setdefault(matched["name"], []).append(path)
    except OSError as error:
        raise SourceError(f"{folder}: cannot be listed: {error.strerror}") from error
    return [_describe(name, files, counted) for name, files in sorted(sessions.items())]


def delete(folder: Path, names: list[str] | None = None) -> list[Recorded]:
    """Delete sessions by name, or every one; returns what was deleted.

    Only files that a listing of this folder shows are touched, and nothing is deleted where a name is
    unknown. Raises ParameterError for an unknown name, SourceError where a file cannot be deleted.
    """
    there = {one.name: one for one in listing(folder, counted=False)}
    for name in names or ():
        if name not in there:
            raise ParameterError(f"no recording {name!r} in {folder}; 'pointpred recordings list' shows all")
    chosen = list(there.values()) if names is None else [there[name] for name in dict.fromkeys(names)]
    for one in chosen:
        for path in one.files:
            try:
                path.unlink(missing_ok=True)
            except OSError as error:
                raise SourceError(f"{path}: cannot be deleted: {error.strerror}") from error
    return chosen


def _describe(name: str, files: list[Path], counted: bool) -> Recorded:
    begun = datetime.strptime(name.split("-")[0], STAMP).replace(tzinfo=UTC)
    one = Recorded(name, begun, tuple(files), sum(path.lstat().st_size for path in files))
    samples = [path for path in files if path.name == f"{name}_samples.csv"]
    if not counted or not samples:
        problem = "its samples are missing" if counted else None
        return msgspec.structs.replace(one, problem=problem)
    from pointpred.recordings import read

    try:
        recording = read(samples[0])
        with samples[0].open("rb") as file:
            lines = sum(block.count(b"\n") for block in iter(lambda: file.read(1 << 20), b""))
    except (PointpredError, OSError) as error:
        return msgspec.structs.replace(one, problem=str(error).removeprefix(f"{samples[0]}: "))
    return msgspec.structs.replace(
        one,
        events=max(0, lines - 2),
        trials=len(recording.trials),
        skipped=len(recording.skipped),
        notes=recording.notes,
    )
