"""Uploaded recordings: ``POST /v1/recording`` answers with their movements, ``POST /v1/score`` with scores.

Nothing of a recording is kept.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import msgspec

from pointpred.errors import ParameterError, PointpredError, RecordingError
from pointpred.recording import Recording, Trial
from pointpred.recordings import Reading, read_any
from pointpred.recordings.known_formats import format_of
from pointpred.recordings.reading import columns_of
from pointpred.registry import REGISTRY
from pointpred.scoring import Document, document, score
from pointpred_server.uploads.limits import NO_TEXT, PARQUET, check_most, check_unpacked

NAME = "recording"
NOTHING: Mapping[str, str] = {}
MOST_TRIALS = 5000
"""Statistics of many trials take longer than the predictions: so many take some seconds."""
OPTIONS = ("columns", "time_unit", "y_up", "px_per_unit", "records", "cut")
"""What a query may say about a table, named as the options of the command line."""


def open_body(body: bytes, query: Mapping[str, str]) -> dict[str, Any]:
    """The movements in a file of any format: rows of t, x, y, dx, dy and buttons, with their targets.

    Raises ColumnsError for a table whose columns are not certain, and what ``recordings_of`` raises.
    """
    recordings = recordings_of(body, reading_of(query))
    movements = [
        _movement(trial, recording.rows(at).table)
        for recording in recordings
        for at, trial in enumerate(recording.trials)
    ]
    about = recordings[0].provenance
    return {
        "version": 1,
        "name": recordings[0].name,
        "dpi": about.dpi,
        "cpi": about.cpi,
        "simulated": about.simulated,
        "movements": movements,
        "skipped": [
            {"trial": skip.trial, "reason": skip.reason}
            for recording in recordings
            for skip in recording.skipped
        ],
        "notes": [note for recording in recordings for note in recording.notes],
    }


def recordings_of(body: bytes, reading: Reading) -> list[Recording]:
    """The recordings in an uploaded file.

    Raises RecordingError, without the path of the file, for what is no recording, and UploadError for one
    that is too large.
    """
    check_unpacked(body)
    with as_file(body) as path:
        try:
            form = format_of(path, reading)
            if form is not None and form.binary and not body.startswith(PARQUET):
                raise RecordingError(NO_TEXT)  # its first bytes were made to look like text
            recordings = read_any(path, reading)
        except PointpredError as error:
            sentence = str(error).replace(f"score {path}", "score FILE")
            error.args = (sentence.replace(str(path), "the recording"),)
            raise
    for recording in recordings:
        check_most("trials", len(recording.trials) + len(recording.skipped), MOST_TRIALS)
    return [_named(one, path.stem) for one in recordings]


def score_body(body: bytes, names: tuple[str, ...], query: Mapping[str, str] = NOTHING) -> Document:
    """The document of ``pointpred score --json`` for one file; ``query``: what it says about a table.

    Raises ParameterError for an unknown predictor, and what ``recordings_of`` raises.
    """
    unknown = [name for name in names if name not in REGISTRY]
    if unknown:
        sentence = f"unknown predictor {unknown[0]!r}; known: {', '.join(REGISTRY)}"
        raise ParameterError(sentence, code="unknown_predictor", field="predictors", value=unknown[0])
    scores = score(recordings_of(body, reading_of(query)), names or tuple(REGISTRY), threads=1)
    return document(scores)


@contextmanager
def as_file(body: bytes) -> Iterator[Path]:
    """A path at which the bytes can be read until the block ends.

    In memory on Linux, since a service in a container may have no place to write to; elsewhere in a temporary
    folder.
    """
    if hasattr(os, "memfd_create"):
        with os.fdopen(os.memfd_create(NAME), "wb") as file:
            file.write(body)
            file.flush()
            yield Path(f"/proc/self/fd/{file.fileno()}")
        return
    with tempfile.TemporaryDirectory(prefix="pointpred-") as folder:
        path = Path(folder) / f"{NAME}_samples.{'parquet' if body.startswith(PARQUET) else 'csv'}"
        path.write_bytes(body)
        yield path


def reading_of(query: Mapping[str, str]) -> Reading:
    """What a query says about a table; raises ParameterError for a value that cannot be used."""
    options: dict[str, Any] = {name: query[name] for name in OPTIONS if query.get(name)}
    if "columns" in options:
        options["columns"] = columns_of(options["columns"])
    if "y_up" in options:
        options["y_up"] = _boolean(options["y_up"])
    if "px_per_unit" in options:
        options["px_per_unit"] = _number(options["px_per_unit"])
    return Reading(**options)


def _boolean(text: str) -> bool:
    if text not in ("true", "false"):
        raise ParameterError(f"y_up must be true or false, received {text!r}", field="y_up", value=text)
    return text == "true"


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        sentence = f"px_per_unit must be a number, received {text!r}"
        raise ParameterError(sentence, field="px_per_unit", value=text) from None


def _movement(trial: Trial, table: Any) -> dict[str, Any]:
    has_target = trial.target_x == trial.target_x and trial.target_y == trial.target_y
    width = trial.target_w if trial.target_w == trial.target_w else 0.0
    target = {"x": trial.target_x, "y": trial.target_y, "width": width} if has_target else None
    rows = [[None if value != value else value for value in row] for row in table.tolist()]
    return {"user": trial.user, "name": trial.trial, "target": target, "rows": rows}


def _named(recording: Recording, stem: str) -> Recording:
    """Replace the name of the temporary file where the recording, or its only person, is named after it."""
    if recording.name != stem:
        return recording
    replace = msgspec.structs.replace
    return replace(
        recording,
        name=NAME,
        trials=tuple(replace(one, user=NAME) if one.user == stem else one for one in recording.trials),
        notes=tuple(note.replace(repr(stem), repr(NAME)) for note in recording.notes),
    )
