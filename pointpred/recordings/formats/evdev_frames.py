"""Kernel input events (evdev) as pointer events: SYN_REPORT ends a frame of motion and buttons."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

import msgspec
import numpy as np

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording
from pointpred.recordings.arrow_tables import IntArray
from pointpred.recordings.encodings import read_text, stem_of
from pointpred.recordings.reading import Reading
from pointpred.recordings.segmentation import trials_of_stream
from pointpred.records import EventColumns

SHOWN = 60
EV_SYN, EV_KEY, EV_REL, EV_ABS = range(4)
SYN_REPORT, SYN_DROPPED = 0, 3
REL_X, REL_Y = 0, 1
BUTTONS = {0x110: 1, 0x111: 2, 0x112: 4, 0x113: 8, 0x114: 16, 0x115: 16, 0x116: 8}
"""Kernel codes from BTN_LEFT on -> bits of W3C pointer events (left, right, middle, back, forward)."""
LARGEST = 1 << 31
RawEvent = tuple[int, int, int, int]
"""Time in microseconds, type, code, value."""


class UnreadableLines:
    """Counts the lines of a file that are skipped, by kind."""

    def __init__(self) -> None:
        self._kinds: dict[str, tuple[int, str]] = {}

    def add(self, kind: str, number: int, line: str) -> None:
        """Count line ``number`` (from 1) as one of a kind, such as "reports that cannot be read"."""
        count, first = self._kinds.get(kind, (0, f"line {number} ({line.strip()[:SHOWN]!r})"))
        self._kinds[kind] = count + 1, first

    @property
    def notes(self) -> list[str]:
        """A note for each kind, in order of appearance."""
        return [
            f"{kind}, left aside: {count}, the first is {first}"
            for kind, (count, first) in self._kinds.items()
        ]


class Frames(msgspec.Struct):
    """Pointer events and the number of each one's first raw event; notes and faults as in ``assemble``."""

    events: EventColumns
    rows: IntArray
    faults: dict[int, str]
    notes: list[str]


def text_recording(
    path: Path,
    form: str,
    name: re.Pattern[str],
    events: Callable[[str, UnreadableLines], Iterable[RawEvent]],
    reading: Reading,
    clock: str,
) -> Recording:
    """The recording of a text about the one device ``name``; ``events`` extracts its raw events.

    Lines that cannot be read are counted in notes. Raises RecordingError if nothing moves.
    """
    text = read_text(path)
    match = name.search(text)
    device = match.group(1).strip() if match else stem_of(path)
    unreadable = UnreadableLines()
    stream = frames(path, events(text, unreadable))
    if isinstance(stream, str):
        raise RecordingError(f"{path}: {'; '.join([stream, *unreadable.notes])}", code="no_motion")
    stream.notes += unreadable.notes
    return recording(path, form, device, stream, reading, clock)


def frames(path: Path, raw: Iterable[RawEvent]) -> Frames | str:
    """Sum the relative motion of each frame; x and y are the summed counts, 1 count = 1 px.

    Frames without motion and button (the wheel) are ignored and counted in a note. SYN_DROPPED means that the
    kernel lost events: the frame up to it is discarded, and counts as a fault. If nothing moves it returns a
    text about the content; raises RecordingError for an impossible value.
    """
    table: list[tuple[int, int, int, int]] = []
    rows: list[int] = []
    faults: dict[int, str] = {}
    dx = dy = buttons = aside = count = 0
    begins, useful, lost, absolute = 0, False, False, False
    for row, (time, kind, code, value) in enumerate(raw):
        count = row + 1
        if not (abs(value) < LARGEST and 0 <= time < 1 << 52):
            raise RecordingError(f"{path}: event {row}: time {time} us, value {value}, expected 31 bits")
        if kind == EV_REL and code in (REL_X, REL_Y):
            dx, dy = (dx + value, dy) if code == REL_X else (dx, dy + value)
            useful = True
        elif kind == EV_KEY and code in BUTTONS:
            buttons = buttons | BUTTONS[code] if value else buttons & ~BUTTONS[code]
            useful = True
        elif kind == EV_ABS:
            absolute = True
        elif kind == EV_SYN and code == SYN_DROPPED:
            dx, dy, useful, lost = 0, 0, True, True
        elif kind == EV_SYN and code == SYN_REPORT:
            if lost:
                faults[len(table)] = "the kernel dropped events (SYN_DROPPED)"
            if useful:
                table.append((time, dx, dy, buttons))
                rows.append(begins)
            else:
                aside += 1
            dx, dy, begins, useful, lost = 0, 0, row + 1, False, False
    if not any(move[1] or move[2] for move in table):
        what = "absolute positions only" if absolute else "no relative motion"
        return f"{what} in {count} events, expected REL_X or REL_Y in a complete frame"
    notes = [f"frames without motion or button left aside: {aside}"] if aside else []
    if useful:
        notes.append(f"the last frame, from event {begins}, is not complete and left aside")
    return frames_of_counts(table, rows, notes, faults)


def frames_of_counts(
    table: Sequence[tuple[int, int, int, int]],
    rows: Sequence[int],
    notes: list[str],
    faults: dict[int, str] | None = None,
) -> Frames:
    """Frames from rows of time in us, dx, dy, buttons; x and y are the summed counts."""
    whole = np.array(table, dtype=np.int64)
    x, y = np.cumsum(whole[:, 1]), np.cumsum(whole[:, 2])
    seconds = (whole[:, 0] - whole[0, 0]) / 1e6
    events = EventColumns.of(seconds, x, y, whole[:, 1], whole[:, 2], whole[:, 3])
    return Frames(events, np.array(rows, dtype=np.int64), faults or {}, notes)


def recording(path: Path, form: str, device: str, stream: Frames, reading: Reading, clock: str) -> Recording:
    """The recording of one device's frames, by default cut into bursts."""
    return trials_of_stream(
        stem_of(path),
        stream.events,
        reading.cut or "bursts",
        reading,
        user="unknown",
        provenance=Provenance(
            form,
            unit="counts",
            origin="where the stream began",
            y_axis="down",
            clock=clock,
            dpi=reading.dpi,
            cpi=reading.cpi,
        ),
        condition={"device": device},
        faults=stream.faults,
        row_of=stream.rows,
        notes=stream.notes,
    )
