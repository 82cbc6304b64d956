"""The unit of positions: from a column, from ``Reading``, or pixels if that is plausible."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from pointpred.errors import RecordingError
from pointpred.recordings.reading import Reading
from pointpred.records import METRES_PER_INCH, FloatArray

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


def check_pixels(path: Path, positions: Sequence[FloatArray]) -> list[str]:
    """A note that pixels are assumed; raises RecordingError if the positions are unlikely to be pixels."""
    far = max((float(np.nanmax(np.abs(part), initial=0.0)) for part in positions), default=0.0)
    fractions = any(bool((part != np.round(part)).any()) for part in positions)
    if positions and far < LEAST_PX:
        raise RecordingError(
            f"{path}: no position leaves +-{LEAST_PX:g}, so the unit is hardly pix; say the pixels in the "
            f"experiment's unit: {SIZES['height']}; {SIZES['norm']}; {SIZES['cm']}"
        )
    if positions and far < MOST_DEG and fractions:
        raise RecordingError(
            f"{path}: no position leaves +-{MOST_DEG:g} and some have fractions, which looks like degrees "
            f"or cm; say the pixels in the experiment's unit: {SIZES['deg']}; {SIZES['cm']}; "
            "--px-per-unit 1 for pixels"
        )
    return ["unit of positions: taken as px, for the file does not say it; --px-per-unit says another"]
