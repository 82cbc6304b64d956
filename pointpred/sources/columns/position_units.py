"""The unit of positions: from ``Reading``, from a column, or pixels if that is plausible."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any, get_args

import numpy as np

from pointpred.errors import RecordingError
from pointpred.records import METRES_PER_INCH, FloatArray
from pointpred.sources.reading import Reading, Unit

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


def unit_of(rows: Sequence[dict[str, Any]], reading: Reading) -> tuple[Unit | None, list[str]]:
    """The unit from ``reading`` or from a column with one unit in every row, and a note; or ``None``."""
    if reading.unit is not None:
        return reading.unit, []
    for name in dict.fromkeys(name for row in rows for name in row):
        cells = {str(row.get(name) or "").strip().lower() for row in rows} - {""}
        if name.lower().rpartition(".")[2] in NAMES and len(cells) == 1:
            cell = cells.pop()
            unit = SPELLINGS.get(cell)
            if unit is not None:
                return unit, [f"unit of positions: {unit}, as the column {name} says"]
    return None, []


def gain_of(path: Path, unit: Unit, reading: Reading) -> tuple[float, float]:
    """Pixels per unit, horizontally and vertically; raises RecordingError if an option is missing."""
    if reading.px_per_unit is not None:
        return reading.px_per_unit, reading.px_per_unit
    if unit == "pix":
        return 1.0, 1.0
    if unit in ("cm", "m"):
        gain = reading.dpi / (100.0 * METRES_PER_INCH if unit == "cm" else METRES_PER_INCH)
        return gain, gain
    if unit == "deg":
        raise RecordingError(
            f"{path}: positions in deg need the pixels in a degree: --unit deg --px-per-unit PIXELS "
            "(distance to the screen in px times tan 1 deg)"
        )
    if reading.screen is None:
        raise RecordingError(
            f"{path}: the unit {unit} needs the screen's size in px: --unit {unit} --screen 1920x1080"
        )
    width, height = reading.screen
    return (height, height) if unit == "height" else (width / 2, height / 2)


def check_pixels(path: Path, positions: Sequence[FloatArray]) -> list[str]:
    """A note that pixels are assumed; raises RecordingError if the positions are unlikely to be pixels."""
    far = max((float(np.nanmax(np.abs(part), initial=0.0)) for part in positions), default=0.0)
    fractions = any(bool((part != np.round(part)).any()) for part in positions)
    if positions and far < LEAST_PX:
        raise RecordingError(
            f"{path}: no position leaves +-{LEAST_PX:g}, so the unit is hardly pix; say the experiment's "
            "unit and the screen's size: --unit height --screen 1920x1080 (or norm; or --unit cm)"
        )
    if positions and far < MOST_DEG and fractions:
        raise RecordingError(
            f"{path}: no position leaves +-{MOST_DEG:g} and some have fractions, which looks like degrees "
            "or cm; say the experiment's unit: --unit deg --px-per-unit PIXELS, --unit cm, or --unit pix"
        )
    return ["unit of positions: taken as px, for the file does not say it; --unit says another"]
