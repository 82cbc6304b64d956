"""Kernel input events (evdev) as pointer events: SYN_REPORT ends a frame of motion and buttons."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

import msgspec
import numpy as np

from pointpred.devices.surface import Place, Surface
from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording
from pointpred.recordings.arrow_tables import IntArray
from pointpred.recordings.encodings import read_text, stem_of
from pointpred.recordings.reading import Reading
from pointpred.recordings.segmentation import trials_of_stream
from pointpred.recordings.trials import join
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
DeviceEvent = tuple[tuple[int, str], RawEvent]
"""A raw event of a device: its number and its name, "" where the file does not say it."""


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
    """Pointer events and the number of each one's first raw event; notes and faults as in ``assemble``.

    ``surface``: that of an absolute device, in shares of which the positions are; ``breaks``: the events at
    which another contact begins.
    """

    events: EventColumns
    rows: IntArray
    faults: dict[int, str]
    notes: list[str]
    surface: Surface | None = None
    breaks: IntArray = np.empty(0, dtype=np.int64)

    def in_px(self, reading: Reading) -> tuple[Frames, str]:
        """The same with the positions of an absolute device in px, and the unit they had."""
        surface = self.surface
        if surface is None:
            return self, "counts"
        if reading.px_per_unit is None:
            width, height, words = surface.scale(reading.dpi)
        else:
            (across, down), x, y = reading.gain, surface.x, surface.y
            width, height = across * (x.most - x.least), down * (y.most - y.least)
            words = f"its own units, {across:g} across and {down:g} px down in a unit"
        table = self.events.table.copy()
        table[:, 1:3] *= width, height
        notes = [*self.notes, f"positions are px of {words}"]
        if len(self.breaks) > 1:
            notes.append(f"movements end where a pen or finger is lifted: contacts {len(self.breaks)}")
        unit = "mm" if surface.size_mm and reading.px_per_unit is None else "units of the device"
        return msgspec.structs.replace(self, events=EventColumns(table), notes=notes), unit


def devices_of_text(
    path: Path, events: Callable[[str, UnreadableLines], Iterable[DeviceEvent]], unreadable: UnreadableLines
) -> list[tuple[str, Frames | str]]:
    """The name and the frames of each device of a text, whose raw events ``events`` extracts."""
    builders: dict[tuple[int, str], FrameBuilder] = {}
    for row, (device, event) in enumerate(events(read_text(path), unreadable)):
        builders.setdefault(device, FrameBuilder(path)).add(row, event)
    return [(name or stem_of(path), builder.finish()) for (_, name), builder in builders.items()]


def recording_of_devices(
    path: Path,
    form: str,
    devices: Iterable[tuple[str, Frames | str]],
    unreadable: UnreadableLines,
    reading: Reading,
    clock: str,
    unit: str = "counts",
) -> Recording:
    """The recording of all devices that move; the others and lines that cannot be read are in notes.

    Raises RecordingError if nothing moves.
    """
    parts: list[Recording] = []
    still: list[str] = []
    for name, stream in devices:
        if isinstance(stream, str):
            still.append(f"device {name}: {stream}")
        else:
            parts.append(_recording(path, form, name, stream, reading, clock, unit))
    notes = [*still, *unreadable.notes]
    if not parts:
        why = "; ".join(notes) or "no devices, expected one that moves"
        raise RecordingError(f"{path}: {why}", code="no_motion")
    return join(stem_of(path), parts, [str(index) for index in range(len(parts))], notes)


class FrameBuilder:
    """Sums the relative motion of each frame of a device; x and y are the summed counts, 1 count = 1 px.

    Frames without motion and button (the wheel) are ignored and counted in a note. SYN_DROPPED means that the
    kernel lost events: the frame up to it is discarded, and counts as a fault; whatever was pressed counts as
    released after it, since the release may be among what was lost.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.table: list[tuple[int, int, int, int]] = []
        self.rows: list[int] = []
        self.faults: dict[int, str] = {}
        self.aside = self.count = self.released = 0
        self.buttons, self.absolute = 0, False
        self._begin()

    def _begin(self) -> None:
        self._dx = self._dy = 0
        self._begins, self._useful, self._lost = -1, False, False

    def add(self, row: int, event: RawEvent) -> None:
        """One event, which is number ``row`` in the file; raises RecordingError for an impossible value."""
        time, kind, code, value = event
        self.count += 1
        if self._begins < 0:
            self._begins = row
        if not (abs(value) < LARGEST and 0 <= time < 1 << 52):
            raise RecordingError(f"{self.path}: event {row}: time {time} us, value {value}, expected 31 bits")
        if kind == EV_SYN and code == SYN_REPORT:
            self._end(time)
        elif kind == EV_SYN and code == SYN_DROPPED:
            self._dx, self._dy, self._useful, self._lost = 0, 0, True, True
        elif kind == EV_ABS:
            self.absolute = True
        elif self._lost:
            pass  # the rest of a frame of which the beginning is lost
        elif kind == EV_REL and code in (REL_X, REL_Y):
            self._dx += value * (code == REL_X)
            self._dy += value * (code == REL_Y)
            self._useful = True
        elif kind == EV_KEY and code in BUTTONS:
            self.buttons = self.buttons | BUTTONS[code] if value else self.buttons & ~BUTTONS[code]
            self._useful = True

    def _end(self, time: int) -> None:
        """End a frame."""
        if self._lost:
            self.faults[len(self.table)] = "the kernel dropped events (SYN_DROPPED)"
        if self._useful:
            self.table.append((time, self._dx, self._dy, self.buttons))
            self.rows.append(self._begins)
        else:
            self.aside += 1
        if self._lost:
            self.released += self.buttons > 0
            self.buttons = 0
        self._begin()

    def finish(self) -> Frames | str:
        """The frames, or a text about the content if nothing moves."""
        if not any(move[1] or move[2] for move in self.table):
            what = "absolute positions only" if self.absolute else "no relative motion"
            return f"{what} in {self.count} events, expected REL_X or REL_Y in a complete frame"
        notes = [f"frames without motion or button left aside: {self.aside}"] if self.aside else []
        if self.released:
            notes.append(f"buttons taken as released after SYN_DROPPED: {self.released} times")
        if self._useful:
            notes.append(f"the last frame, from event {self._begins}, is not complete and left aside")
        return frames_of_counts(self.table, self.rows, notes, self.faults)


def frames(path: Path, raw: Iterable[RawEvent]) -> Frames | str:
    """The frames of one device, or a text about its content if nothing moves; raises RecordingError."""
    builder = FrameBuilder(path)
    for row, event in enumerate(raw):
        builder.add(row, event)
    return builder.finish()


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
    events = EventColumns(np.column_stack([seconds, x, y, whole[:, 1:]]))
    return Frames(events, np.array(rows, dtype=np.int64), faults or {}, notes)


def frames_of_places(
    places: Sequence[tuple[int, Place]],
    rows: Sequence[int],
    notes: list[str],
    surface: Surface,
    faults: dict[int, str] | None = None,
) -> Frames:
    """Frames from times in us and places on a surface."""
    whole = np.array([(time, *place) for time, place in places], dtype=np.float64)
    counts = np.full(len(whole), np.nan)
    seconds = (np.array([time for time, _ in places]) - places[0][0]) / 1e6
    events = EventColumns(np.column_stack([seconds, whole[:, 1:3], counts, counts, whole[:, 3]]))
    breaks = np.flatnonzero(whole[:, 4])
    return Frames(events, np.array(rows, dtype=np.int64), faults or {}, notes, surface, breaks)


def _recording(
    path: Path, form: str, device: str, stream: Frames, reading: Reading, clock: str, unit: str
) -> Recording:
    """The recording of one device's frames, by default cut into bursts."""
    absolute = stream.surface is not None
    if absolute:
        stream, unit = stream.in_px(reading)
    return trials_of_stream(
        stem_of(path),
        stream.events,
        reading.cut or "bursts",
        reading,
        user="unknown",
        provenance=Provenance(
            form,
            unit=unit,
            origin="top left" if absolute else "where the stream began",
            y_axis="down",
            clock=clock,
            dpi=reading.dpi,
            cpi=reading.cpi,
        ),
        condition={"device": device},
        faults=stream.faults,
        row_of=stream.rows,
        breaks=stream.breaks.tolist(),
        notes=stream.notes,
    )
