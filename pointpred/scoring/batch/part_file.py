"""Scored trials as a file of columns: Arrow's IPC format, a row a trial, which any reader of Arrow opens."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
import pyarrow as pa

from pointpred.columns import FloatArray
from pointpred.recording import Trial
from pointpred.scoring.measures.trial_measures import TrialMeasures
from pointpred.scoring.replay import Measured
from pointpred.scoring.results import ScoredTrial
from pointpred.scoring.scorer import PartOutcome, ScoredPart, outcome

KEY = b"pointpred"
TRIAL = ("user", "trial", "target_x", "target_y", "target_w")
SCORED = ("distance_px", "onset_s", "arrival_s", "submovements", "events", "clean")


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
    return ScoredPart(trials, totals.unread, totals.unscored, tuple(measured))


def _type(name: str) -> Any:
    kinds = {"user": pa.string(), "trial": pa.string(), "events": pa.int64()}
    return pa.bool_() if name in ("submovements", "clean") else kinds.get(name, pa.float64())


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
