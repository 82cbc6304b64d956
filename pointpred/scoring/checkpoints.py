"""Where the results of chunks are kept: in memory, or in a folder of files that outlives the process."""

from __future__ import annotations

import hashlib
import os
import shutil
import tempfile
import time
import weakref
from contextlib import suppress
from pathlib import Path
from typing import Any, Protocol

import msgspec
import numpy as np
import pyarrow as pa

from pointpred.errors import ParameterError
from pointpred.files import beside
from pointpred.recording import Trial
from pointpred.records import FloatArray
from pointpred.scoring.measures.trial_measures import TrialMeasures
from pointpred.scoring.replay import Measured
from pointpred.scoring.results import ScoredTrial
from pointpred.scoring.scorer import PartOutcome, ScoredPart, outcome

KEY = b"pointpred"
TRIAL = ("user", "trial", "target_x", "target_y", "target_w")
SCORED = tuple(name for name in ScoredTrial.__struct_fields__ if name != "trial")
FLAGS = ("submovements", "clean", "end_repeats", "distance_repeats")


class PartHeader(msgspec.Struct, frozen=True):
    """What a file says before its columns."""

    predictors: tuple[str, ...]
    outcome: PartOutcome


def encode(part: ScoredPart) -> bytes:
    """The bytes of a file; columns of a predictor are called after it, as ``hold.errors``."""
    trials = part.trials
    columns: dict[str, Any] = {
        name: pa.array([getattr(one.trial, name) for one in trials], _type(name)) for name in TRIAL
    }
    columns["judged_clean"] = pa.array([one.trial.clean for one in trials], pa.bool_())
    columns["condition"] = pa.array(
        [msgspec.json.encode(one.trial.condition).decode() for one in trials], pa.string()
    )
    columns |= {name: pa.array([getattr(one, name) for one in trials], _type(name)) for name in SCORED}
    for measured in part.measured:
        for name in TrialMeasures.__struct_fields__:
            values: FloatArray = getattr(measured.measures, name)
            width = int(np.prod(values.shape[1:]))
            flat = pa.array(np.ascontiguousarray(values).ravel())
            columns[f"{measured.name}.{name}"] = pa.FixedSizeListArray.from_arrays(flat, width)
    header = PartHeader(tuple(one.name for one in part.measured), outcome(part))
    table = pa.table(columns).replace_schema_metadata({KEY: msgspec.json.encode(header)})
    sink = pa.BufferOutputStream()
    options = pa.ipc.IpcWriteOptions(compression="zstd", use_threads=False)
    with pa.ipc.new_file(sink, table.schema, options=options) as writer:
        writer.write_table(table)
    return bytes(memoryview(sink.getvalue()))


def decode_outcome(data: bytes) -> PartOutcome:
    """What a part adds to its set beside the rows of its trials; raises ValueError for damaged bytes."""
    return _header(_reader(data)).outcome


def decode(data: bytes) -> ScoredPart:
    """The part whose ``encode`` these bytes are; raises ValueError for damaged bytes."""
    reader = _reader(data)
    header, table = _header(reader), reader.read_all().combine_chunks()
    cells = {name: table[name].to_pylist() for name in (*TRIAL, "judged_clean", "condition", *SCORED)}
    conditions = map(msgspec.json.Decoder(dict[str, str | float]).decode, cells.pop("condition"))
    about = zip(*(cells[name] for name in (*TRIAL, "judged_clean")), conditions, strict=True)
    scores = zip(*(cells[name] for name in SCORED), strict=True)
    trials = tuple(ScoredTrial(Trial(*one), *more) for one, more in zip(about, scores, strict=True))
    shapes = TrialMeasures.empty(len(trials))
    totals = header.outcome
    measured = []
    for place, name in enumerate(header.predictors):
        arrays = [
            _array(table[f"{name}.{column}"], getattr(shapes, column).shape)
            for column in TrialMeasures.__struct_fields__
        ]
        measured.append(
            Measured(
                name,
                TrialMeasures(*arrays),
                totals.failed[place],
                totals.events[place],
                totals.seconds[place],
            )
        )
    return ScoredPart(trials, totals.unread, totals.unscored, tuple(measured), totals.candidates)


def _type(name: str) -> Any:
    kinds = {"user": pa.string(), "trial": pa.string(), "events": pa.int64()}
    return pa.bool_() if name in FLAGS else kinds.get(name, pa.float64())


def _array(column: Any, shape: tuple[int, ...]) -> FloatArray:
    """A column of lists as an array."""
    parts = [np.from_dlpack(chunk.flatten()) for chunk in column.chunks if len(chunk)]
    flat = np.concatenate(parts) if parts else np.empty(0)
    rows: FloatArray = flat.reshape(shape)
    return rows


def _reader(data: bytes) -> Any:
    return pa.ipc.open_file(pa.BufferReader(data), options=pa.ipc.IpcReadOptions(use_threads=False))


def _header(reader: Any) -> PartHeader:
    return msgspec.json.decode((reader.schema.metadata or {}).get(KEY, b""), type=PartHeader)


PART = "part"
"""How the name of a file ends until it is written whole."""
PART_AGE_S = 24 * 3600.0
"""A part that was last written so long ago is of a run that was killed: writing one takes seconds."""


class PartStore(Protocol):
    """The results of the chunks of one set, by the number of the chunk."""

    packed: bool
    """Whether parts come as the bytes of ``encode``, packed where they were made."""

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

    A file's name ends with a digest of its bytes: a damaged one counts as missing. What the folder holds
    belongs to its name: see ``digests``.
    """

    packed = True

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        try:
            folder.mkdir(parents=True, exist_ok=True)
            _remove_old_parts(folder)
            self._files = {path.name.partition(".")[0]: path for path in folder.iterdir()}
        except OSError as error:
            message = f"cannot keep checkpoints in {folder}: {error.strerror}; name another folder"
            raise ParameterError(message, field="checkpoints", value=str(folder)) from error

    def durations(self, number: int) -> FloatArray | None:
        """As every store."""
        data = self._read("durations", number)
        return None if data is None else np.frombuffer(data, np.float64)

    def put_durations(self, number: int, durations: FloatArray) -> None:
        """As every store."""
        self._write("durations", number, "f64", durations.tobytes())

    def outcome(self, number: int) -> PartOutcome | None:
        """As every store."""
        data = self._read("scores", number)
        return None if data is None else decode_outcome(data)

    def part(self, number: int) -> ScoredPart:
        """As every store; raises ParameterError where the file is not as it was written."""
        data = self._read("scores", number)
        if data is None:
            message = f"checkpoint {number} in {self.folder} has changed meanwhile; score once more"
            raise ParameterError(message, field="checkpoints", value=str(self.folder))
        return decode(data)

    def put(self, number: int, part: ScoredPart | bytes) -> None:
        """As every store."""
        data = part if isinstance(part, bytes) else encode(part)
        self._write("scores", number, "arrow", data)

    def _read(self, kind: str, number: int) -> bytes | None:
        """The bytes of a file; ``None`` where there is none or they are not those that were written."""
        path = self._files.get(f"{kind}-{number:06d}")
        try:
            data = b"" if path is None else path.read_bytes()
        except OSError:
            return None
        return data if path is not None and f".{_digest(data)}." in path.name else None

    def _write(self, kind: str, number: int, suffix: str, data: bytes) -> None:
        name = f"{kind}-{number:06d}"
        path = self.folder / f"{name}.{_digest(data)}.{suffix}"
        part = beside(path, PART)
        try:
            with part.open("wb") as file:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
            part.replace(path)
            if (damaged := self._files.get(name, path)) != path:
                damaged.unlink(missing_ok=True)
        except OSError as error:
            part.unlink(missing_ok=True)
            message = f"cannot keep a checkpoint in {self.folder}: {error.strerror}"
            raise ParameterError(message, field="checkpoints", value=str(self.folder)) from error
        self._files[name] = path


def temporary_store() -> FolderStore:
    """A folder that goes with the store: for sets whose results are too long for memory."""
    folder = Path(tempfile.mkdtemp(prefix="pointpred-scores-"))
    store = FolderStore(folder)
    weakref.finalize(store, shutil.rmtree, folder, ignore_errors=True)
    return store


def _remove_old_parts(folder: Path) -> None:
    """Remove what killed runs were writing; younger parts may be of a run on this machine or another."""
    oldest_s = time.time() - PART_AGE_S
    for path in folder.glob(f".*.{PART}"):
        with suppress(FileNotFoundError):  # another run removed or renamed it
            if path.stat().st_mtime < oldest_s:
                path.unlink()


def _digest(data: bytes) -> str:
    return hashlib.blake2b(data, digest_size=8).hexdigest()
