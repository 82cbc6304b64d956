"""A column of buttons: as numbers, or as the words that programs write for them."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.errors import RecordingError
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import IntArray
from pointpred.recordings.columns.names import VAGUE, words_of
from pointpred.recordings.trials import MOST_BUTTONS, codes_of
from pointpred.records import BoolArray, FloatArray

WHICH = {
    **dict.fromkeys(("left", "primary"), 1.0),
    **dict.fromkeys(("right", "secondary"), 2.0),
    **dict.fromkeys(("middle", "mid"), 4.0),
    **dict.fromkeys(("side", "back", "x1"), 8.0),
    **dict.fromkeys(("extra", "forward", "x2"), 16.0),
}
"""The bits of W3C pointer events."""
_DEVICE = "(mouse|pointer|touch|cursor|pen|button|btn|click)"
_BUTTON = f"({'|'.join(WHICH)})?"
_RELEASE = "up|released?|un(click|press)(ed)?|end|cancel"
_UP = f"{_RELEASE}|mov(ed?|ing)|motion|hover|enter|leave|over|out|(scroll|wheel)(ed)?(up|down)?"
_DOWN = "down|press(ed)?|(dbl|double)click(ed)?|clicked|drag(ged|ging)?|start|held"
WORD = re.compile(
    f"{_DEVICE}*(?P<which>{_BUTTON}){_DEVICE}*((?P<up>{_UP})|(?P<down>{_DOWN}))?{_DEVICE}*(?P<last>{_BUTTON})"
)
"""A device, its button and what happened to it, each of which may be missing."""
LONGEST = 60
"""A longer text is no word for buttons; matching takes time with the third power of the length."""
RELEASE, GONE = re.compile(_RELEASE), re.compile(f"{_RELEASE}|leave|out")
"""What releases a button, and what else leaves none pressed."""
YES, NO = ("true", "yes"), ("false", "no", "none", "")
CERTAIN = re.compile(f"{_DEVICE}|up|release|down|press|drag|left|right|middle|primary|secondary")
"""Words that mark a column named ``state`` as the buttons' state."""


def pressed(cell: str) -> float:
    """The buttons of a cell, NaN if it is not a value of buttons.

    >>> [pressed(cell) for cell in ("3", "mouseup", "click_pressed", "Button.right", "BTN_LEFT", "target")]
    [3.0, 0.0, 1.0, 2.0, 1.0, nan]
    """
    try:
        number = float(cell)
        return number if 0 <= number <= MOST_BUTTONS and number == int(number) else float("nan")
    except ValueError:
        word = _plain(cell)
    if word in (*YES, *NO):
        return float(word in YES)
    found = _match(word)
    if found is None:
        return float("nan")
    which = found["which"] or found["last"]
    if found["up"]:
        return 0.0
    return WHICH[which or "left"] if found["down"] or which or "click" in word else float("nan")


def buttons_of(path: Path, name: str, column: Any, explicit: bool, placed: BoolArray) -> FloatArray | None:
    """Pressed buttons as W3C pointer events number them, 0 for an empty cell.

    A column that the user named (``explicit``) must hold buttons in the rows ``placed`` that have a position,
    else RecordingError names the wrong cell; for a column with a usual name the answer is then ``None``;
    ``state`` must hold words for buttons.
    """
    if not explicit and words_of(name) in [[vague] for vague in VAGUE] and not _is_certain(column):
        return None
    if pa.types.is_boolean(column.type) or not arrow_tables.is_words(column):
        values = np.nan_to_num(arrow_tables.numbers(column)[0])
        bad = np.flatnonzero((values < 0) | (values > MOST_BUTTONS) | (values != np.floor(values)))
        cell = str(values[bad[0]]) if len(bad) else ""
    else:
        codes, cells = codes_of(arrow_tables.words(column).fill_null(""))
        values = np.array([pressed(cell) for cell in cells] or [0.0])[codes]
        bad = np.flatnonzero(np.isnan(values) & placed)
        cell = cells[codes[bad[0]]] if len(bad) else ""
    if not len(bad):
        return np.nan_to_num(values)
    if not explicit:
        return None
    raise RecordingError(
        f"{path}: data row {bad[0]}: {name} is {arrow_tables.short(cell)!r}, expected buttons: "
        "a whole number, or words such as down, mouseup, right, Button.left, BTN_LEFT, click_pressed"
    )


def held(
    column: Any, values: FloatArray, user: IntArray, trial: IntArray, times: FloatArray, late_s: float
) -> FloatArray:
    """The buttons that are down at each row: where releases are told, a press lasts until its release.

    ``values`` are those of the cells by themselves, as it stays where no release is told. Nothing is down
    where the rows of another ``user`` or ``trial`` begin, or ``times`` go back by over ``late_s``; within,
    rows count in the order of time.
    """
    changes = _changes(column, values)
    if not any(np.isnan(change).any() for change in changes):
        return values
    order = np.argsort(user, kind="stable")
    with np.errstate(over="ignore", invalid="ignore"):
        anew = np.diff(times[order]) < -late_s
    anew |= (np.diff(user[order]) != 0) | (np.diff(trial[order]) != 0)
    part = np.concatenate([[0], np.cumsum(anew)])
    order = order[np.lexsort((times[order], part))]
    begins = np.flatnonzero(np.diff(part, prepend=-1))
    answer = np.zeros(len(values))
    for change in changes:
        change = change[order]
        change[begins] = np.nan_to_num(change[begins])
        last = np.maximum.accumulate(np.where(np.isnan(change), 0, np.arange(len(change))))
        answer[order] += change[last]
    return answer


def _changes(column: Any, values: FloatArray) -> list[FloatArray]:
    """The bits that each row presses, 0 where it releases them, NaN where it does neither: a button each."""
    if not tells_release(column):
        empty = np.asarray(pc.is_null(column, nan_is_null=True))
        if arrow_tables.is_words(column):
            empty = empty | np.asarray(pc.equal(pc.utf8_trim_whitespace(column), "").fill_null(True))
        told = empty.any() and values.any() and not values[~empty].all() and not _found(column)
        return [np.where(empty, np.nan, values) if told else values]
    codes, cells = codes_of(arrow_tables.words(column).fill_null(""))
    found = [_match(_plain(cell)) for cell in cells]
    downs = {one["down"] for one in found if one and one["down"]}
    if any(word.startswith("drag") for word in downs):
        return [values]
    presses = downs & {"down", "press", "pressed", "start", "held"} or downs
    bits = {WHICH[one["which"] or one["last"] or "left"] for one in found if one}
    return [np.array([_change(one, bit, presses) for one in found])[codes] for bit in bits]


def _change(found: re.Match[str] | None, bit: float, presses: set[str]) -> float:
    """What a word does to a button: its bit presses it, 0 releases it, NaN neither."""
    which = found and (found["which"] or found["last"])
    if found is None or (WHICH[which or "left"] != bit and (which or found["down"])):
        return float("nan")
    if found["down"] in presses:
        return bit
    return 0.0 if GONE.fullmatch(found["up"] or "") else float("nan")


def names_only(column: Any) -> bool:
    """Whether the words of a column name buttons, and none says whether they are pressed or released."""
    found = _found(column)
    return bool(found) and all(
        (one["which"] or one["last"]) and not one["up"] and not one["down"] for one in found
    )


def tells_release(column: Any) -> bool:
    """Whether the words of a column say that buttons are pressed, and that they are released."""
    found = _found(column)
    return any(one["down"] for one in found) and any(RELEASE.fullmatch(one["up"] or "") for one in found)


def _plain(cell: str) -> str:
    """The letters and digits of a word, small."""
    return re.sub(r"[\W_]+", "", cell.lower())


def _match(word: str) -> re.Match[str] | None:
    """What a word says of buttons."""
    return WORD.fullmatch(word) if len(word) <= LONGEST else None


def _found(column: Any) -> list[re.Match[str]]:
    """What the words of a column say of buttons."""
    if not arrow_tables.is_words(column):
        return []
    _, cells = codes_of(arrow_tables.words(column).fill_null(""))
    return [found for word in map(_plain, cells) if word not in (*YES, *NO) and (found := _match(word))]


def _is_certain(column: Any) -> bool:
    """Whether cells are words used only for buttons."""
    if not arrow_tables.is_words(column):
        return False
    _, cells = codes_of(arrow_tables.words(column).fill_null(""))
    return any(pressed(cell) == pressed(cell) and CERTAIN.match(cell.strip().lower()) for cell in cells)
