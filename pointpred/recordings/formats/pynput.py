"""Logs of pynput's listeners, as its manual writes them: ``time: Mouse moved to (x, y)``."""

from __future__ import annotations

import re
from pathlib import Path

from pointpred.errors import RecordingError
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.columns.buttons import WHICH
from pointpred.recordings.encodings import read_text
from pointpred.recordings.formats.evdev_frames import UnreadableLines
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "log of pynput"
STAMP = r"\d{4}-\d{2}-\d{2}[T ]\d{2}:\d{2}:\d{2}(?:[.,]\d{1,9})?|\d+(?:\.\d+)?"
COORDINATE = r"-?\d+(?:\.\d+)?"
LINE = re.compile(
    rf"^(?:({STAMP})\b)?([^\n(]*\b(?:moved to|(?:clicked|pressed|released|scrolled)[^\n(]*?\bat)) *"
    rf"\(({COORDINATE}), *({COORDINATE})\)([^\n]*)$",
    re.IGNORECASE | re.MULTILINE,
)
LIKELY = re.compile(LINE.pattern.encode(), re.IGNORECASE | re.MULTILINE)
RELEASED = re.compile(r"\breleased?\b|\bfalse\b")
BUTTON = re.compile(rf"\b({'|'.join(WHICH)})\b")


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is such a log."""
    return LIKELY.search(head) is not None


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """The columns t, x, y and buttons, a row a line; scrolling and other lines are counted in notes.

    Where no release is logged, as in the manual's example, a press lasts for its row. Raises RecordingError,
    also for a log without times.
    """
    unreadable = UnreadableLines()
    places: list[tuple[str, str, str]] = []
    changes: list[tuple[int, bool] | None] = []
    scrolled = 0
    for number, line in enumerate(read_text(path).splitlines(), 1):
        match = LINE.match(line)
        if match is None:
            if line.strip():
                unreadable.add("lines without a position", number, line)
            continue
        stamp, what, x, y, rest = match.groups()
        if stamp is None:
            raise RecordingError(f"{path}: line {number} has no time; log it, as by %(asctime)s")
        words = f"{what} {rest}".lower()
        if "scrolled" in words:
            scrolled += 1
            continue
        places.append((stamp, x, y))
        changes.append(None if "moved" in words else (_button(words), RELEASED.search(words) is None))
    if not places:
        raise RecordingError(f"{path}: no position but where it scrolled")
    t, x, y = map(list, zip(*places, strict=True))
    columns = {"t": t, "x": x, "y": y, "buttons": _held(changes)}
    notes = [f"scrolling left aside: {scrolled}"] if scrolled else []
    return ColumnTable(columns, "pynput", (*notes, *unreadable.notes))


def _button(words: str) -> int:
    """The bit of the button in a message, the primary where none is named."""
    found = BUTTON.search(words)
    return int(WHICH[found[1]]) if found else 1


def _held(changes: list[tuple[int, bool] | None]) -> list[int]:
    """The buttons after each line, which presses or releases one or neither."""
    releases = any(change is not None and not change[1] for change in changes)
    held, answer = 0, []
    for change in changes:
        if change is not None:
            held = held | change[0] if change[1] else held & ~change[0]
        answer.append(held)
        held = held if releases else 0
    return answer
