"""``POST /v1/recording``: a recording in any format in, its movements out; nothing is kept."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import msgspec

from pointpred.errors import ParameterError, PointpredError, RecordingError
from pointpred.recording import Recording, Trial
from pointpred.server.uploads.spooling import NAME, spooled
from pointpred.server.uploads.unpacking import NO_TEXT, PARQUET, check_most, check_unpacked
from pointpred.sources import Reading, read_any
from pointpred.sources.known_formats import format_of
from pointpred.sources.reading import columns_of

MOST_TRIALS = 5000
"""Statistics of many trials take longer than the predictions: so many take some seconds."""
TOLD = ("columns", "time_unit", "y_up", "px_per_unit", "records", "cut")
"""What a query can say of a table, named as on the command line."""


def open_body(body: bytes, told: Mapping[str, str]) -> dict[str, Any]:
    """The movements in a file of any format: rows of t, x, y, dx, dy and buttons, with their targets.

    Raises ColumnsError for a table whose columns are not certain, and what ``recordings_of`` raises.
    """
    found = recordings_of(body, reading_of(told))
    movements = [
        _movement(trial, recording.rows(at).table)
        for recording in found
        for at, trial in enumerate(recording.trials)
    ]
    about = found[0].provenance
    return {
        "version": 1,
        "name": found[0].name,
        "dpi": about.dpi,
        "cpi": about.cpi,
        "simulated": about.simulated,
        "movements": movements,
        "skipped": [
            {"trial": skip.trial, "reason": skip.reason} for recording in found for skip in recording.skipped
        ],
        "notes": [note for recording in found for note in recording.notes],
    }


def recordings_of(body: bytes, reading: Reading) -> list[Recording]:
    """The recordings in an uploaded file.

    Raises RecordingError, without the file's place, for what is no recording, and UploadError for one that is
    too large.
    """
    check_unpacked(body)
    with spooled(body) as path:
        try:
            form = format_of(path, reading)
            if form is not None and form.binary and not body.startswith(PARQUET):
                raise RecordingError(NO_TEXT)  # its first bytes were made to look like text
            found = read_any(path, reading)
        except PointpredError as error:
            said = str(error).replace(f"score {path}", "score FILE").replace(str(path), "the recording")
            error.args = (said,)
            raise
    for recording in found:
        check_most("trials", len(recording.trials) + len(recording.skipped), MOST_TRIALS)
    return [_named(one, path.stem) for one in found]


def reading_of(told: Mapping[str, str]) -> Reading:
    """What a query says of a table; raises ParameterError for a value that cannot be used."""
    options: dict[str, Any] = {name: told[name] for name in TOLD if told.get(name)}
    if "columns" in options:
        options["columns"] = columns_of(options["columns"])
    if "y_up" in options:
        options["y_up"] = _truth(options["y_up"])
    if "px_per_unit" in options:
        options["px_per_unit"] = _number(options["px_per_unit"])
    return Reading(**options)


def _truth(text: str) -> bool:
    if text not in ("true", "false"):
        raise ParameterError(f"y_up must be true or false, received {text!r}")
    return text == "true"


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise ParameterError(f"px_per_unit must be a number, received {text!r}") from None


def _movement(trial: Trial, table: Any) -> dict[str, Any]:
    known = trial.target_x == trial.target_x and trial.target_y == trial.target_y
    width = trial.target_w if trial.target_w == trial.target_w else 0.0
    target = {"x": trial.target_x, "y": trial.target_y, "width": width} if known else None
    rows = [[None if value != value else value for value in row] for row in table.tolist()]
    return {"user": trial.user, "name": trial.trial, "target": target, "rows": rows}


def _named(recording: Recording, stem: str) -> Recording:
    """A recording that says no name of its own has that of its file, which here is a number.

    A person who is named after the file is so too.
    """
    if recording.name != stem:
        return recording
    replace = msgspec.structs.replace
    return replace(
        recording,
        name=NAME,
        trials=tuple(replace(one, user=NAME) if one.user == stem else one for one in recording.trials),
        notes=tuple(note.replace(repr(stem), repr(NAME)) for note in recording.notes),
    )
