"""jsPsych mouse-tracking: JSON, or JSON in the cells of a CSV file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec

from pointpred.errors import RecordingError
from pointpred.recording import UNKNOWN, Provenance, Recording, Skip, Trial
from pointpred.sources import tables
from pointpred.sources.decoding import read_text, stem_of
from pointpred.sources.lists import Lists
from pointpred.sources.reading import AS_IS, Reading

TITLE = "jsPsych mouse-tracking (JSON or CSV)"
DATA, TARGETS = "mouse_tracking_data", "mouse_tracking_targets"
USERS = ("subject_id", "subject", "participant_id", "participant", "PROLIFIC_PID", "run_id")


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` holds jsPsych mouse tracks."""
    return DATA.encode() in head


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read an experiment; rows without mouse tracking are other plugins' and counted in a note.

    The only target of a trial gives its centre and, as width, the smaller side of its rectangle; among
    several the file does not say which one was meant, so none is taken. Buttons follow mousedown and mouseup.
    A trial is named after ``trial_index``, ``row`` counts the experiment's trials. Raises RecordingError.
    """
    text = read_text(path)
    rows = _json(path, text) if text.lstrip()[:1] in "[{" else _csv(path)
    lists = Lists(path)
    others = 0
    for row, cells in enumerate(rows):
        if cells.get(DATA) in (None, ""):
            others += 1
            continue
        name = str(cells.get("trial_index", row))
        samples, targets = cells[DATA], cells.get(TARGETS) or {}
        if not isinstance(samples, list) or not all(isinstance(sample, dict) for sample in samples):
            lists.skip(Skip(name, f"{DATA} is no list of samples", row))
            continue
        if not isinstance(targets, dict):
            lists.skip(Skip(name, f"{TARGETS} is no object", row))
            continue
        user = next((str(cells[word]) for word in USERS if cells.get(word) not in (None, "")), "unknown")
        x, y, width, target = _target(targets)
        condition: dict[str, str | float] = {"targets": float(len(targets))} | (
            {"target": target} if target else {}
        )
        lists.add(
            Trial(user, name, x, y, width, condition=condition),
            row,
            [sample.get("t") for sample in samples],
            [sample.get("x") for sample in samples],
            [sample.get("y") for sample in samples],
            buttons=_held([sample.get("event") for sample in samples]),
            scale=0.001,
        )
    if others:
        lists.notes.append(
            f"{others} of {others + len(lists.trials) + len(lists.skipped)} rows track no mouse"
        )
    provenance = Provenance(
        "jspsych",
        origin="top left of the page's visible area",
        clock="milliseconds from the trial's start, rounded to 1 ms",
        dpi=reading.dpi,
    )
    return lists.recording(stem_of(path), provenance)


def _json(path: Path, text: str) -> list[dict[str, Any]]:
    """The trials of a JSON file: a list of objects, or one object."""
    try:
        trials = msgspec.json.decode(text)
    except (msgspec.DecodeError, RecursionError) as error:
        raise RecordingError(f"{path}: no JSON: {error}") from error
    rows = trials if isinstance(trials, list) else [trials]
    for row, cells in enumerate(rows):
        if not isinstance(cells, dict):
            raise RecordingError(f"{path}: row {row} is {str(cells)[:40]!r}, expected an object")
    return rows


def _csv(path: Path) -> list[dict[str, Any]]:
    """The trials of a CSV file with the tracking columns decoded; what is no JSON stays a word."""
    table, _ = tables.read_table(path, lambda column: True)
    tables.need_columns(path, table.column_names, (DATA,), table.column_names)
    rows: list[dict[str, Any]] = table.to_pylist()
    for cells in rows:
        for name in (DATA, TARGETS):
            if cells.get(name):
                try:
                    cells[name] = msgspec.json.decode(cells[name])
                except (msgspec.DecodeError, RecursionError):
                    cells[name] = str(cells[name])
    return rows


def _target(targets: dict[str, Any]) -> tuple[float, float, float, str]:
    """Centre, width and selector of the only target; unknown where there are several or no rectangle."""
    if len(targets) == 1:
        selector, rectangle = next(iter(targets.items()))
        try:
            x, y, width, height = (float(rectangle[side]) for side in ("x", "y", "width", "height"))
        except (KeyError, TypeError, ValueError):
            return UNKNOWN, UNKNOWN, UNKNOWN, str(selector)
        return x + width / 2, y + height / 2, min(width, height), str(selector)
    return UNKNOWN, UNKNOWN, UNKNOWN, ""


def _held(events: list[Any]) -> list[float]:
    """1.0 from a mousedown up to before the mouseup."""
    held, answer = 0.0, []
    for event in events:
        held = {"mousedown": 1.0, "mouseup": 0.0}.get(str(event), held)
        answer.append(held)
    return answer
