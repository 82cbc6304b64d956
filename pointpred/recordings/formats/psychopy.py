"""PsychoPy: a table with one trial per row, a mouse component's track as Python lists in its cells."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Skip
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable, Known
from pointpred.recordings.columns.list_cells import split
from pointpred.recordings.columns.names import user_column
from pointpred.recordings.encodings import head_of
from pointpred.recordings.nested_records import RecordTable
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.records import METRES_PER_INCH

TITLE = "PsychoPy CSV"
SEPARATORS = (",", ";", "\t")
USERS = ("participant",)
FIELDS = ("x", "y", "buttons", "trial")
BUTTONS = {"left": 1, "right": 2, "mid": 4}
CLICKS_S = 0.1
"""Samples that all have a button pressed and lie farther apart than this are clicks, not a track."""
CLICKS_ONLY = "only clicks were saved (the mouse saves its state 'on click'), expected 'every frame'"
Unit = Literal["pix", "height", "norm", "cm", "m", "deg"]
LEAST_PX = 2.0
MOST_DEG = 40.0
"""Fractional positions that all lie closer to the centre than this are unlikely to be pixels."""
NAMES = ("units", "unit", "winunits", "win_units")
SPELLINGS: dict[str, Unit] = {
    **{unit: unit for unit in get_args(Unit)},
    "pixels": "pix",
    "px": "pix",
    "degflat": "deg",
    "degflatpos": "deg",
}
SIZES = {
    "height": "--px-per-unit 1080 for height, the screen's height in px",
    "norm": "--px-per-unit 960,540 for norm, half its width and height",
    "cm": "--px-per-unit 37.8 for cm, the pixels per inch / 2.54",
    "deg": "--px-per-unit 38 for deg, the distance to the screen in px times tan 1 deg",
}
"""What says how many pixels are in a unit, by example."""


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a PsychoPy table with a mouse component."""
    return _separator(head) is not None


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read a table; a trial is ``<row>``, or ``<row> <mouse>`` with several mouse components.

    Assumes s, the origin in the centre of the screen and y up; y is negated, the origin stays. The unit has
    ``reading.px_per_unit``; by default it is the one in a column ``units``, by ``reading.dpi`` for cm and m,
    else pixels, with a note.
    Cells are separated by commas, semicolons or tabs. Without a column of users, a file has one user.
    Trials of which only clicks were saved are skipped. The other short cells of a row are conditions.
    Raises RecordingError, also if pixels would have to be assumed and are implausible.
    """
    separator = _separator(head_of(path)) or ","
    table, _ = arrow_tables.read_table(path, lambda column: True, separator)
    names = table.column_names
    mice = _mice(names)
    arrow_tables.need_columns(path, names, [f"{mouse}.time" for mouse in mice or ["mouse"]], names)
    rows = table.to_pylist()
    people = user_column(names, USERS)
    unit, notes = unit_of(rows)
    across, down = gain_of(path, unit or "pix", reading)
    tracks, places, skipped = RecordTable(), [], []
    for row, cells in enumerate(rows):
        about = {
            name: cell for name, cell in cells.items() if not name.startswith(tuple(f"{m}." for m in mice))
        }
        for mouse in mice:
            series = {part: split(cells[f"{mouse}.{part}"]) for part in ("time", "x", "y")}
            trial = str(row) if len(mice) == 1 else f"{row} {mouse}"
            buttons = _held(cells, mouse, len(series["time"]))
            user = str(cells.get(people.get("user", "")) or "") or None
            if buttons is None:
                skipped.append(Skip(trial, "buttons are not 0 or 1 for each time", row, user))
            elif _are_clicks(series["time"], buttons):
                skipped.append(Skip(trial, CLICKS_ONLY, row, user))
            else:
                own: dict[str, Any] = {f"mouse.{part}": items for part, items in series.items()}
                own |= {"mouse.buttons": buttons, "mouse.trial": trial, "mouse": mouse}
                tracks.add(about | own)
                places.append(row)
    fields = {"t": "mouse.time"} | {part: f"mouse.{part}" for part in FIELDS} | people
    columns = tracks.finish().columns or {name: [] for name in fields.values()}
    if unit is None and reading.px_per_unit is None:
        notes = check_pixels(path, [items for part in "xy" for items in columns[f"mouse.{part}"]])
    told = "px" if reading.px_per_unit is None else "told"
    provenance = Provenance(
        "psychopy",
        unit="px" if unit == "pix" else unit or told,
        origin="centre of the screen",
        y_axis="up",
        clock="the component's clock, s",
    )
    known = Known(
        fields=fields,
        time_unit="s",
        provenance=provenance,
        gain=(across, -down),
    )
    return ColumnTable(columns, TITLE, tuple(notes), tuple(skipped), places, known=known)


def _separator(head: bytes) -> str | None:
    """The column separator of a table with a mouse component; ``None`` without one."""
    try:
        first = head.split(b"\n", 1)[0].decode("utf-8-sig")
        for separator in SEPARATORS:
            if _mice(next(csv.reader([first], delimiter=separator), [])):
                return separator
    except (UnicodeDecodeError, csv.Error):
        pass
    return None


def _mice(names: Sequence[str]) -> list[str]:
    """The mouse components among the columns: those with a time, an x and a y."""
    parts = [name.removesuffix(".time") for name in names if name.endswith(".time")]
    return [part for part in parts if f"{part}.x" in names and f"{part}.y" in names]


def _held(cells: dict[str, Any], mouse: str, count: int) -> list[float] | None:
    """The buttons of each sample as in W3C pointer events; ``None`` if they do not match the times."""
    buttons = [0.0] * count
    for name, bit in BUTTONS.items():
        pressed = split(cells.get(f"{mouse}.{name}Button"))
        if not pressed:
            continue
        if len(pressed) != count or any(word not in ("0", "1") for word in pressed):
            return None
        buttons = [sum_ + bit * int(word) for sum_, word in zip(buttons, pressed, strict=True)]
    return buttons


def _are_clicks(t: Sequence[str], buttons: Sequence[float]) -> bool:
    """Whether the samples of a trial are only clicks: all with a button pressed, and far apart."""
    if not buttons or not all(buttons):
        return False
    try:
        intervals = np.diff([float(cell) for cell in t])
    except ValueError:
        return False
    return not len(intervals) or float(np.median(intervals)) > CLICKS_S


def unit_of(rows: Sequence[dict[str, Any]]) -> tuple[Unit | None, list[str]]:
    """The unit from a column with one unit in every row, and a note; or ``None``."""
    for name in dict.fromkeys(name for row in rows for name in row):
        cells = {str(row.get(name) or "").strip().lower() for row in rows} - {""}
        if name.lower().rpartition(".")[2] in NAMES and len(cells) == 1:
            cell = cells.pop()
            unit = SPELLINGS.get(cell)
            if unit is not None:
                return unit, [f"unit of positions: {unit}, as the column {name} says"]
    return None, []


def gain_of(path: Path, unit: Unit, reading: Reading) -> tuple[float, float]:
    """Pixels per unit, across and down; raises RecordingError if ``reading`` has to say it."""
    if reading.px_per_unit is not None or unit == "pix":
        return reading.gain
    if unit in ("cm", "m"):
        gain = reading.dpi / (100.0 * METRES_PER_INCH if unit == "cm" else METRES_PER_INCH)
        return gain, gain
    raise RecordingError(f"{path}: positions in {unit} need the pixels in a unit: {SIZES[unit]}")


def check_pixels(path: Path, positions: Sequence[Sequence[str]]) -> list[str]:
    """A note that pixels are assumed; raises RecordingError if the positions are unlikely to be pixels."""
    numbers, _ = arrow_tables.numbers(arrow_tables.as_arrow([cell for cells in positions for cell in cells]))
    finite = numbers[np.isfinite(numbers)]
    far, fractions = float(np.max(np.abs(finite), initial=0.0)), bool((finite != np.round(finite)).any())
    if len(finite) and far < LEAST_PX:
        raise RecordingError(
            f"{path}: no position leaves +-{LEAST_PX:g}, so the unit is hardly pix; say the pixels in the "
            f"experiment's unit: {SIZES['height']}; {SIZES['norm']}; {SIZES['cm']}"
        )
    if len(finite) and far < MOST_DEG and fractions:
        raise RecordingError(
            f"{path}: no position leaves +-{MOST_DEG:g} and some have fractions, which looks like degrees "
            f"or cm; say the pixels in the experiment's unit: {SIZES['deg']}; {SIZES['cm']}; "
            "--px-per-unit 1 for pixels"
        )
    return ["unit of positions: taken as px, for the file does not say it; --px-per-unit says another"]
