"""jsPsych mouse-tracking: JSON, one JSON array a line (JATOS), or JSON in the cells of a CSV file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import RecordingError
from pointpred.recording import UNKNOWN, Provenance, Skip
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable, Known
from pointpred.recordings.encodings import holds, read_text
from pointpred.recordings.nested_records import RecordTable
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.trials import TARGET

TITLE = "jsPsych mouse-tracking (JSON or CSV)"
DATA, TARGETS = "mouse_tracking_data", "mouse_tracking_targets"
MARKS = (b'"trial_type"', b'"time_elapsed"')
"""A key in every trial of jsPsych."""
FARTHEST = 1 << 26
"""Bytes of jsPsych's JSON that are searched for a first mouse track."""
USERS = ("subject_id", "subject", "participant_id", "participant", "PROLIFIC_PID", "run_id")
TRIAL, USER = "trial of jsPsych", "user of jsPsych"
ASIDE = (DATA, TARGETS, "trial_index", *USERS)
FIELDS = {field: f"{field} of jsPsych" for field in ("t", "x", "y", "buttons", *TARGET)}
FIELDS |= {"user": USER, "trial": TRIAL}
SHOWN = 5

Cells = dict[str, Any]
Target = tuple[float, float, float]


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` holds jsPsych mouse tracks."""
    return DATA.encode() in head


def recognises_further(path: Path, head: bytes) -> bool:
    """Whether jsPsych JSON that begins with ``head`` has its first mouse track beyond it."""
    json = head.lstrip()[:1] in (b"[", b"{") and all(mark in head for mark in MARKS)
    return json and holds(path, DATA.encode(), FARTHEST)


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read an experiment; rows of other plugins, without mouse tracking, are counted in a note.

    The file names rectangles of the page by selectors but not the goal: the target of a trial is the
    rectangle of ``reading.target``, its centre and the smaller side. It is unknown without a selector, if the
    trial has no such rectangle, and if the movement begins inside it (a container). Buttons follow mousedown
    and mouseup. A trial is named by ``trial_index``, after its line number if each line is a person's JSON
    array (JATOS); ``row`` counts the experiment's trials. The other short cells of a trial are its
    conditions. Raises RecordingError.
    """
    text = read_text(path)
    skipped: list[Skip] = []
    rows = list(_json(path, text, skipped) if text.lstrip()[:1] in "[{" else _csv(path))
    tracks, places = RecordTable(), []
    matched: Counter[str] = Counter()
    unknown: Counter[str] = Counter()
    untracked = 0
    for row, cells in enumerate(rows):
        samples, targets = cells.get(DATA), cells.get(TARGETS) or {}
        if samples in (None, ""):
            untracked += 1
        elif not isinstance(samples, list) or not all(isinstance(sample, dict) for sample in samples):
            skipped.append(Skip(cells[TRIAL], f"{DATA} is no list of samples", row))
        elif not isinstance(targets, dict):
            skipped.append(Skip(cells[TRIAL], f"{TARGETS} is no object", row))
        else:
            matched.update(list(targets))
            place, why = _target(targets, reading.target, samples)
            unknown[why] += 1
            series = {field: [sample.get(field) for sample in samples] for field in ("t", "x", "y")}
            held = _held([sample.get("event") for sample in samples])
            about = {name: cell for name, cell in cells.items() if name not in ASIDE}
            tracks.add(
                about
                | {FIELDS[field]: items for field, items in series.items()}
                | dict(zip((FIELDS[field] for field in TARGET), place, strict=True))
                | {FIELDS["buttons"]: held, "targets": float(len(targets))}
            )
            places.append(row)
    notes = [f"{untracked} of {len(rows)} rows track no mouse"] if untracked else []
    notes += _about_targets(matched, unknown, reading.target)
    provenance = Provenance(
        "jspsych",
        origin="top left of the page's visible area",
        clock="milliseconds from the trial's start, rounded to 1 ms",
    )
    known = Known(fields=FIELDS, time_unit="ms", provenance=provenance)
    columns = tracks.finish().columns or {name: [] for name in FIELDS.values()}
    return ColumnTable(columns, TITLE, tuple(notes), tuple(skipped), places, known=known)


def _json(path: Path, text: str, skipped: list[Skip]) -> Iterator[Cells]:
    """The trials of a JSON file: a list of objects, one object, or such a list on each line."""
    try:
        yield from _rows(path, _experiment(msgspec.json.decode(text)))
        return
    except (msgspec.DecodeError, RecursionError) as error:
        lines = [(number, line) for number, line in enumerate(text.splitlines(), 1) if line.strip()]
        if len(lines) < 2:
            raise RecordingError(f"{path}: no JSON: {error}") from error
        whole = error
    readable = place = 0
    for number, line in lines:
        try:
            experiment = _experiment(msgspec.json.decode(line))
        except (msgspec.DecodeError, RecursionError) as error:
            skipped.append(Skip(f"line {number}", f"no JSON: {error}", place))
            continue
        readable += 1
        place += len(experiment)
        yield from _rows(path, experiment, str(number))
    if not readable:
        raise RecordingError(f"{path}: no JSON: {whole}")


def _experiment(content: Any) -> list[Any]:
    """Decoded JSON as a list of trials."""
    return content if isinstance(content, list) else [content]


def _rows(path: Path, experiment: list[Any], line: str = "") -> Iterator[Cells]:
    """The trials of one experiment, with a name and a user each; ``line``: its person's number."""
    for place, cells in enumerate(experiment):
        if not isinstance(cells, dict):
            raise RecordingError(f"{path}: row {place} is {str(cells)[:40]!r}, expected an object")
    person = next((user for user in map(_user, experiment) if user), line or "unknown")
    for place, cells in enumerate(experiment):
        name = str(cells.get("trial_index", place))
        yield cells | {TRIAL: f"{line} {name}" if line else name, USER: _user(cells) or person}


def _csv(path: Path) -> Iterator[Cells]:
    """The trials of a CSV file with the tracking columns decoded; cells that are not JSON stay text."""
    table, _ = arrow_tables.read_table(path, lambda column: True)
    arrow_tables.need_columns(path, table.column_names, (DATA,), table.column_names)
    for place, cells in enumerate(table.to_pylist()):
        for name in (DATA, TARGETS):
            if cells.get(name):
                try:
                    cells[name] = msgspec.json.decode(cells[name])
                except (msgspec.DecodeError, RecursionError):
                    cells[name] = str(cells[name])
        yield cells | {TRIAL: str(cells.get("trial_index", place)), USER: _user(cells) or "unknown"}


def _user(cells: Cells) -> str:
    """The user of a trial; empty if the trial has none."""
    return next((str(cells[word]) for word in USERS if cells.get(word) not in (None, "")), "")


def _target(targets: Cells, selector: str | None, samples: list[Cells]) -> tuple[Target, str]:
    """Centre and width of the selected rectangle, or unknown and why."""
    nowhere = (UNKNOWN, UNKNOWN, UNKNOWN)
    if selector is None or selector not in targets:
        return nowhere, "absent"
    try:
        sides = [float(targets[selector][side]) for side in ("x", "y", "width", "height")]
        begins = [float(samples[0][axis]) for axis in ("x", "y")] if samples else [UNKNOWN, UNKNOWN]
    except (KeyError, TypeError, ValueError, OverflowError):
        return nowhere, "no rectangle"
    x, y, width, height = sides
    if not (np.isfinite(sides).all() and min(width, height) > 0):
        return nowhere, "no rectangle"
    if x <= begins[0] <= x + width and y <= begins[1] <= y + height:
        return nowhere, "inside"
    return (x + width / 2, y + height / 2, min(width, height)), ""


def _about_targets(matched: Counter[str], unknown: Counter[str], selector: str | None) -> list[str]:
    """Notes on the selectors of a file, and on the trials with an unknown target."""
    named = ", ".join(f"{name} ({count})" for name, count in matched.most_common(SHOWN))
    named += f" and {len(matched) - SHOWN} more" if len(matched) > SHOWN else ""
    if selector is None:
        return (
            [f"targets are unknown; selectors (trials): {named}; name one with --target"] if matched else []
        )
    reasons = {
        "absent": f"they have no {selector} (selectors: {named or 'none'})",
        "no rectangle": f"{selector} is no rectangle with an area",
        "inside": f"the movement begins inside {selector}",
    }
    return [
        f"target unknown in {unknown[why]} of {unknown.total()} trials: {words}"
        for why, words in reasons.items()
        if unknown[why]
    ]


def _held(events: list[Any]) -> list[float]:
    """1.0 from a mousedown until before the mouseup."""
    pressed, answer = 0.0, []
    for event in events:
        pressed = {"mousedown": 1.0, "mouseup": 0.0}.get(str(event), pressed)
        answer.append(pressed)
    return answer
