"""A column of buttons, in numbers or words, as pressed buttons."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa

from pointpred.errors import RecordingError
from pointpred.recordings import arrow_tables
from pointpred.recordings.columns.names import VAGUE, words_of
from pointpred.recordings.trials import MOST_BUTTONS, codes_of
from pointpred.records import FloatArray

RELEASED = frozenset(("false", "no", "none", "up", "released", "release", "mouseup", "move", "mousemove"))
DOWN = ("true", "yes", "down", "pressed", "press", "mousedown", "click", "left", "drag", "primary")
PRESSED = {
    **dict.fromkeys(DOWN, 1.0),
    "right": 2.0,
    "secondary": 2.0,
    "middle": 4.0,
}
BUTTON_WORDS = {*RELEASED, *PRESSED} - {"true", "false", "yes", "no", "none", "move"}
"""Words that mark a column named ``state`` as the buttons' state."""


def buttons_of(path: Path, name: str, column: Any, explicit: bool) -> FloatArray | None:
    """Pressed buttons as W3C pointer events number them, 0 for an empty cell.

    A column that the user named (``told``) must hold buttons, else RecordingError names the wrong cell; for a
    column with a usual name the answer is then ``None``; ``state`` must hold words for buttons.
    """
    if not explicit and words_of(name) in [[vague] for vague in VAGUE] and not _has_words(column):
        return None
    if pa.types.is_boolean(column.type) or not arrow_tables.is_words(column):
        values = np.nan_to_num(arrow_tables.numbers(column)[0])
        bad = np.flatnonzero((values < 0) | (values > MOST_BUTTONS) | (values != np.floor(values)))
        cell = str(values[bad[0]]) if len(bad) else ""
    else:
        codes, cells = codes_of(arrow_tables.words(column).fill_null(""))
        numbers = np.array([_pressed(cell) for cell in cells] or [0.0])
        values = numbers[codes]
        bad = np.flatnonzero(np.isnan(values))
        cell = cells[codes[bad[0]]] if len(bad) else ""
    if not len(bad):
        return values
    if not explicit:
        return None
    raise RecordingError(
        f"{path}: data row {bad[0]}: {name} is {arrow_tables.short(cell)!r}, expected buttons: "
        f"a whole number, or one of {', '.join(sorted((*PRESSED, *RELEASED)))}"
    )


def _has_words(column: Any) -> bool:
    """Whether cells are words used only for buttons."""
    if not arrow_tables.is_words(column):
        return False
    _, cells = codes_of(arrow_tables.words(column).fill_null(""))
    return any(_word(cell) in BUTTON_WORDS for cell in cells)


def _word(cell: str) -> str:
    return cell.strip().lower().replace("_", "").replace(" ", "")


def _pressed(cell: str) -> float:
    """The buttons of a cell, NaN if it is not a value of buttons."""
    word = _word(cell)
    if not word or word in RELEASED:
        return 0.0
    if word in PRESSED:
        return PRESSED[word]
    try:
        number = float(word)
    except ValueError:
        return float("nan")
    return number if 0 <= number <= MOST_BUTTONS and number == int(number) else float("nan")
