"""Where the results of chunks are kept: in memory, or in a folder that outlives the process."""

from __future__ import annotations

import os
import shutil
import tempfile
import weakref
from pathlib import Path
from typing import Protocol

import numpy as np
import pyarrow as pa

from pointpred.batch import part_file
from pointpred.columns import FloatArray
from pointpred.errors import ParameterError
from pointpred.files import beside
from pointpred.scoring.parts import PartOutcome, ScoredPart, outcome

DAMAGED = (OSError, ValueError, pa.ArrowException)


class PartStore(Protocol):
    """The results of the chunks of one set, by the number of the chunk."""

    packed: bool
    """Whether parts come as the bytes of ``part_file``, packed where they were made."""

    def durations(self, number: int) -> FloatArray | None:
        """The durations of a chunk's trials, s; ``None`` while they are not known."""
        ...

    def put_durations(self, number: int, durations: FloatArray) -> None:
        """Keep the durations of a chunk's trials."""
        ...

    def outcome(self, number: int) -> PartOutcome | None:
        """The outcome of a chunk; ``None`` while it is not scored."""
        ...

    def part(self, number: int) -> ScoredPart:
        """A chunk that is scored."""
        ...

    def put(self, number: int, part: ScoredPart | bytes) -> None:
        """Keep a scored chunk."""
        ...


class MemoryStore:
    """Results in memory, for recordings that are there too."""

    packed = False

    def __init__(self) -> None:
        self._durations: dict[int, FloatArray] = {}
        self._parts: dict[int, ScoredPart] = {}

    def durations(self, number: int) -> FloatArray | None:
        """As every store."""
        return self._durations.get(number)

    def put_durations(self, number: int, durations: FloatArray) -> None:
        """As every store."""
        self._durations[number] = durations

    def outcome(self, number: int) -> PartOutcome | None:
        """As every store."""
        part = self._parts.get(number)
        return None if part is None else outcome(part)

    def part(self, number: int) -> ScoredPart:
        """As every store."""
        return self._parts[number]

    def put(self, number: int, part: ScoredPart | bytes) -> None:
        """As every store."""
        assert isinstance(part, ScoredPart)
        self._parts[number] = part


class FolderStore:
    """A file for each chunk, written whole and then renamed: a process that is killed leaves no half of one.

    A file that is damaged counts as missing. What the folder holds belongs to its name: see ``digests``.
    """

    packed = True

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            message = f"cannot keep checkpoints in {folder}: {error.strerror}; name another folder"
            raise ParameterError(message, field="checkpoints", value=str(folder)) from error

    def durations(self, number: int) -> FloatArray | None:
        """As every store."""
        try:
            data = self._file("durations", number).read_bytes()
            return np.frombuffer(data[8:], np.float64) if _count(data) == len(data) - 8 else None
        except DAMAGED:
            return None

    def put_durations(self, number: int, durations: FloatArray) -> None:
        """As every store."""
        data = durations.tobytes()
        self._write(self._file("durations", number), len(data).to_bytes(8, "little") + data)

    def outcome(self, number: int) -> PartOutcome | None:
        """As every store."""
        try:
            return part_file.decode_outcome(self._file("scores", number).read_bytes())
        except DAMAGED:
            return None

    def part(self, number: int) -> ScoredPart:
        """As every store."""
        return part_file.decode(self._file("scores", number).read_bytes())

    def put(self, number: int, part: ScoredPart | bytes) -> None:
        """As every store."""
        data = part if isinstance(part, bytes) else part_file.encode(part)
        self._write(self._file("scores", number), data)

    def _file(self, kind: str, number: int) -> Path:
        return self.folder / f"{kind}-{number:06d}.{'f64' if kind == 'durations' else 'arrow'}"

    def _write(self, path: Path, data: bytes) -> None:
        part = beside(path, "part")
        try:
            with part.open("wb") as file:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
            part.replace(path)
        except OSError as error:
            part.unlink(missing_ok=True)
            message = f"cannot keep a checkpoint in {self.folder}: {error.strerror}"
            raise ParameterError(message, field="checkpoints", value=str(self.folder)) from error


def temporary_store() -> FolderStore:
    """A folder that goes with the store: for sets whose results are too long for memory."""
    folder = Path(tempfile.mkdtemp(prefix="pointpred-scores-"))
    store = FolderStore(folder)
    weakref.finalize(store, shutil.rmtree, folder, ignore_errors=True)
    return store


def _count(data: bytes) -> int:
    return int.from_bytes(data[:8], "little")
