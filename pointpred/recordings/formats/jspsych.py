"""jsPsych mouse-tracking: JSON, one JSON array a line (JATOS), or JSON in the cells of a CSV file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import RecordingError
from pointpred.recording import UNKNOWN, Provenance, Recording, Skip, Trial
from pointpred.recordings import arrow_tables
from pointpred.recordings.encodings import holds, read_text, stem_of
from pointpred.recordings.formats.trial_rows import row_conditions
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.trials import Lists

TITLE = "jsPsych mouse-tracking (JSON or CSV)"
DATA, TARGETS = "mouse_tracking_data", "mouse_tracking_targets"
MARKS = (b'"trial_type"', b'"time_elapsed"')
"""A key in every trial of jsPsych."""
FARTHEST = 1 << 26
"""Bytes of jsPsych's JSON that are searched for a first mouse track."""
USERS = ("subject_id", "subject", "participant_id", "participant", "PROLIFIC_PID", "run_id")
SHOWN = 5

Cells = dict[str, Any]
Target = tuple[float, float, float]


class _Row(msgspec.Struct, frozen=True):
    """One trial of an experiment: its place, the name of its trial, its user, its cells."""

    place: int
    name: str
    user: str
    cells: Cells


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` holds jsPsych mouse tracks."""
    return DATA.encode() in head


def recognises_further(path: Path, head: bytes) -> bool:
    """Whether jsPsych JSON that begins with ``head`` has its first mouse track beyond it."""
    json = head.lstrip()[:1] in (b"[", b"{") and all(mark in head for mark in MARKS)
    return json and holds(path, DATA.encode(), FARTHEST)


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read an experiment; rows of other plugins, without mouse tracking, are counted in a note.

    The file names rectangles of the page by selectors but not the goal: the target of a trial is the
    rectangle of ``reading.target``, its centre and the smaller side. It is unknown without a selector, if the
    trial has no such rectangle, and if the movement begins inside it (a container). Buttons follow mousedown
    and mouseup. A trial is named by ``trial_index``, after its line number if each line is a person's JSON
    array (JATOS); ``row`` counts the experiment's trials. The other short cells of a trial are its
    conditions. Raises RecordingError.
    """
    text = read_text(path)
    lists = Lists(reading.sort)
    rows = list(_json(path, text, lists) if text.lstrip()[:1] in "[{" else _csv(path))
    tracked = [row for row in rows if row.cells.get(DATA) not in (None, "")]
    conditions, column_notes = row_conditions(
        [row.cells for row in tracked], (DATA, TARGETS, "trial_index", *USERS)
    )
    matched: Counter[str] = Counter()
    unknown: Counter[str] = Counter()
    for row, condition in zip(tracked, conditions, strict=True):
        samples, targets = row.cells[DATA], row.cells.get(TARGETS) or {}
        if not isinstance(samples, list) or not all(isinstance(sample, dict) for sample in samples):
            lists.skip(Skip(row.name, f"{DATA} is no list of samples", row.place))
            continue
        if not isinstance(targets, dict):
            lists.skip(Skip(row.name, f"{TARGETS} is no object", row.place))
            continue
        matched.update(list(targets))
        place, why = _target(targets, reading.target, samples)
        unknown[why] += 1
        lists.add(
            Trial(row.user, row.name, *place, condition=condition | {"targets": float(len(targets))}),
            row.place,
            [sample.get("t") for sample in samples],
            [sample.get("x") for sample in samples],
            [sample.get("y") for sample in samples],
            buttons=_held([sample.get("event") for sample in samples]),
            scale=0.001,
        )
    if len(tracked) < len(rows):
        lists.notes.append(f"{len(rows) - len(tracked)} of {len(rows)} rows track no mouse")
    lists.notes += [*column_notes, *_about_targets(matched, unknown, reading.target)]
    provenance = Provenance(
        "jspsych",
        origin="top left of the page's visible area",
        clock="milliseconds from the trial's start, rounded to 1 ms",
        dpi=reading.dpi,
    )
    return lists.recording(stem_of(path), provenance)


def _json(path: Path, text: str, lists: Lists) -> Iterator[_Row]:
    """The trials of a JSON file: a list of objects, one object, or such a list on each line."""
    try:
        yield from _rows(path, 0, _experiment(msgspec.json.decode(text)))
        return
    except (msgspec.DecodeError, RecursionError) as error:
        lines = [(number, line) for number, line in enumerate(text.splitlines(), 1) if line.strip()]
        if len(lines) < 2:
            raise RecordingError(f"{path}: no JSON: {error}") from error
        whole = error
    place = readable = 0
    for number, line in lines:
        try:
            experiment = _experiment(msgspec.json.decode(line))
        except (msgspec.DecodeError, RecursionError) as error:
            lists.skip(Skip(f"line {number}", f"no JSON: {error}", place))
            continue
        readable += 1
        for row in _rows(path, place, experiment, str(number)):
            yield row
            place = row.place + 1
    if not readable:
        raise RecordingError(f"{path}: no JSON: {whole}")


def _experiment(content: Any) -> list[Any]:
    """Decoded JSON as a list of trials."""
    return content if isinstance(content, list) else [content]


def _rows(path: Path, first: int, experiment: list[Any], line: str = "") -> Iterator[_Row]:
    """The trials of one experiment, ``first``: place of its first; ``line``: its person's number."""
    for place, cells in enumerate(experiment, first):
        if not isinstance(cells, dict):
            raise RecordingError(f"{path}: row {place} is {str(cells)[:40]!r}, expected an object")
    person = next((user for user in map(_user, experiment) if user), line or "unknown")
    for place, cells in enumerate(experiment, first):
        name = str(cells.get("trial_index", place))
        yield _Row(place, f"{line} {name}" if line else name, _user(cells) or person, cells)


def _csv(path: Path) -> Iterator[_Row]:
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
        yield _Row(place, str(cells.get("trial_index", place)), _user(cells) or "unknown", cells)


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
