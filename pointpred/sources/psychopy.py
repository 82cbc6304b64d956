"""PsychoPy: CSV with a row a trial, a mouse component's track as Python lists in its cells."""

from __future__ import annotations

import csv
from pathlib import Path

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.sources import tables
from pointpred.sources.decoding import stem_of
from pointpred.sources.lists import Lists, split
from pointpred.sources.reading import AS_IS, Reading

TITLE = "PsychoPy CSV"
LEAST_PX = 2.0


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a PsychoPy table with a mouse component."""
    try:
        names = next(csv.reader([head.split(b"\n", 1)[0].decode("utf-8-sig")]))
    except (UnicodeDecodeError, StopIteration, csv.Error):
        return False
    return bool(_mice(names))


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read a table; a trial is ``<row>``, or ``<row> <mouse>`` where there are several mouse components.

    Assumes s, the origin in the centre of the screen and y up; y is turned, the origin stays. The file does
    not say the unit: ``reading.unit`` does, with ``reading.screen`` for height and norm and ``reading.dpi``
    for cm and m.
    Raises RecordingError, also where "pix" cannot be the unit because no position leaves +-2.
    """
    table, _ = tables.read_table(path, lambda column: True)
    names = table.column_names
    mice = _mice(names)
    tables.need_columns(path, names, [f"{mouse}.time" for mouse in mice or ["mouse"]], names)
    gain = _gain(path, reading)
    lists = Lists(path)
    empty = 0
    for row, cells in enumerate(table.to_pylist()):
        user = str(cells.get("participant") or "unknown")
        for mouse in mice:
            t, x, y = (split(cells[f"{mouse}.{part}"]) for part in ("time", "x", "y"))
            trial = str(row) if len(mice) == 1 else f"{row} {mouse}"
            if not (t or x or y):
                empty += 1
                continue
            held = _held(cells, mouse, len(t))
            if held is None:
                lists.skip(Skip(trial, "buttons are not 0 or 1 for each time", row))
                continue
            condition: dict[str, str | float] = {"mouse": mouse}
            about = Trial(user, trial, condition=condition)
            lists.add(about, row, t, x, y, held, scale=1.0, gain=(gain[0], -gain[1]))
    if empty:
        lists.notes.append(f"{empty} cells hold no track")
    if (
        reading.unit == "pix"
        and lists.tables
        and all(abs(part[:, 1:3]).max(initial=0) < LEAST_PX for part in lists.tables)
    ):
        raise RecordingError(
            f"{path}: no position leaves +-{LEAST_PX:g}, so the unit is hardly pix; "
            "say the experiment's unit (height, norm or cm) and the screen's size"
        )
    provenance = Provenance(
        "psychopy",
        unit="px" if reading.unit == "pix" else reading.unit,
        origin="centre of the screen",
        y_axis="up",
        clock="the component's clock, s",
        dpi=reading.dpi,
    )
    return lists.recording(stem_of(path), provenance)


def _mice(names: list[str]) -> list[str]:
    """The mouse components among the columns: those with a time, an x and a y."""
    parts = [name.removesuffix(".time") for name in names if name.endswith(".time")]
    return [part for part in parts if f"{part}.x" in names and f"{part}.y" in names]


def _gain(path: Path, reading: Reading) -> tuple[float, float]:
    """Pixels a unit, horizontally and vertically."""
    if reading.unit == "pix":
        return 1.0, 1.0
    if reading.unit in ("cm", "m"):
        gain = reading.dpi / (2.54 if reading.unit == "cm" else 0.0254)
        return gain, gain
    if reading.screen is None:
        raise RecordingError(f"{path}: the unit {reading.unit} needs the screen's size in px")
    width, height = reading.screen
    return (height, height) if reading.unit == "height" else (width / 2, height / 2)


def _held(cells: dict[str, str | None], mouse: str, count: int) -> list[float] | None:
    """The buttons of each sample as in W3C pointer events; ``None`` where they do not fit the times."""
    held = [0.0] * count
    for name, bit in (("left", 1), ("right", 2), ("mid", 4)):
        pressed = split(cells.get(f"{mouse}.{name}Button"))
        if not pressed:
            continue
        if len(pressed) != count or any(word not in ("0", "1") for word in pressed):
            return None
        held = [sum_ + bit * int(word) for sum_, word in zip(held, pressed, strict=True)]
    return held
