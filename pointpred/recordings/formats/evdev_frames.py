"""Kernel input events (evdev) as pointer events: SYN_REPORT ends a frame of motion and buttons."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

import msgspec
import numpy as np

from pointpred.devices.surface import Place, Surface
from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording
from pointpred.recordings.arrow_tables import IntArray
from pointpred.recordings.encodings import read_text, stem_of
from pointpred.recordings.formats.evdev_contacts import (
    BTN_TOOL_FINGER,
    CONTACT_KEYS,
    EV_ABS,
    EV_KEY,
    EV_REL,
    EV_SYN,
    REL_X,
    REL_Y,
    SYN_MT_REPORT,
    EvdevAbout,
    EvdevContacts,
)
from pointpred.recordings.reading import Reading
from pointpred.recordings.samples import Samples, recording_of
from pointpred.recordings.trials import join
from pointpred.records import EventColumns

SHOWN = 60
SYN_REPORT, SYN_DROPPED = 0, 3
BUTTONS = {0x110: 1, 0x111: 2, 0x112: 4, 0x113: 8, 0x114: 16, 0x115: 16, 0x116: 8}
"""Kernel codes from BTN_LEFT on -> bits of W3C pointer events (left, right, middle, back, forward)."""
LARGEST = 1 << 31
DROPPED = "the kernel dropped events (SYN_DROPPED)"
RawEvent = tuple[int, int, int, int]
"""Time in microseconds, type, code, value."""
DeviceKey = tuple[int, str]
"""The number and the name of a device, "" where the file does not say it."""
DeviceEvent = tuple[DeviceKey, RawEvent]
Abouts = defaultdict[DeviceKey, EvdevAbout]
"""What a file says of each device, before its events."""


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
            words += "" if surface.size_mm else "; --px-per-unit says another"
        else:
            (across, down), x, y = reading.gain, surface.x, surface.y
            width, height = across * (x.most - x.least), down * (y.most - y.least)
            words = f"{across:g} px across and {down:g} px down in a unit of the device"
        table = self.events.table.copy()
        table[:, 1:3] *= width, height
        notes = [*self.notes, f"positions: {words}"]
        if len(self.breaks) > 1:
            notes.append(f"contacts, each a movement of its own or several: {len(self.breaks)}")
        unit = "mm" if surface.size_mm and reading.px_per_unit is None else "units of the device"
        return msgspec.structs.replace(self, events=EventColumns(table), notes=notes), unit


def text_recording(
    path: Path,
    form: str,
    events: Callable[[str, UnreadableLines, Abouts], Iterable[DeviceEvent]],
    reading: Reading,
    clock: str,
) -> Recording:
    """The recording of the devices of a text, whose raw events ``events`` extracts; raises RecordingError."""
    unreadable = UnreadableLines()
    abouts: Abouts = defaultdict(EvdevAbout)
    builders: dict[DeviceKey, FrameBuilder] = {}
    for row, (device, event) in enumerate(events(read_text(path), unreadable, abouts)):
        if device not in builders:
            builders[device] = FrameBuilder(path, abouts[device])
        builders[device].add(row, event)
    devices = [(name or stem_of(path), builder.finish()) for (_, name), builder in builders.items()]
    return recording_of_devices(path, form, devices, unreadable, reading, clock)


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

    A device that has none has the places of its contacts or its pointer, on the surface that it is ``about``.
    Frames without motion and button (the wheel) are ignored and counted in a note. SYN_DROPPED means that the
    kernel lost events: the frame up to it is discarded, and counts as a fault; whatever was pressed counts as
    released after it, since the release may be among what was lost.
    """

    def __init__(self, path: Path, about: EvdevAbout | None = None) -> None:
        self.path = path
        self.about = about or EvdevAbout()
        self.contacts = EvdevContacts(self.about)
        self.places: list[tuple[int, Place]] = []
        self.place_rows: list[int] = []
        self.place_faults: dict[int, str] = {}
        self.without_place = 0
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
        elif self._lost:
            pass  # the rest of a frame of which the beginning is lost
        elif kind == EV_ABS:
            self.absolute = True
            self.contacts.take(kind, code, value)
        elif (kind == EV_SYN and code == SYN_MT_REPORT) or (kind == EV_KEY and code in CONTACT_KEYS):
            self.contacts.take(kind, code, value)
        elif kind == EV_KEY and code == BTN_TOOL_FINGER:
            self.about.keys.add(code)
        elif kind == EV_REL and code in (REL_X, REL_Y):
            self._dx += value * (code == REL_X)
            self._dy += value * (code == REL_Y)
            self._useful = True
        elif kind == EV_KEY and code in BUTTONS:
            self.buttons = self.buttons | BUTTONS[code] if value else self.buttons & ~BUTTONS[code]
            self._useful = True

    def _end(self, time: int) -> None:
        """End a frame."""
        place = self.contacts.lost() if self._lost else self.contacts.end(self.buttons)
        if self._lost:
            self.faults[len(self.table)] = self.place_faults[len(self.places)] = DROPPED
        if place is not None:
            self.places.append((time, place))
            self.place_rows.append(self._begins)
        else:
            self.without_place += 1
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
            return self._finish_places()
        notes = [f"frames without motion or button left aside: {self.aside}"] if self.aside else []
        if self.released:
            notes.append(f"buttons taken as released after SYN_DROPPED: {self.released}")
        if self._useful:
            notes.append(f"the last frame, from event {self._begins}, is not complete and left aside")
        return frames_of_counts(self.table, self.rows, notes, self.faults)

    def _finish_places(self) -> Frames | str:
        """The places of a device without relative motion."""
        if not self.absolute or self.about.counts:
            return f"no relative motion in {self.count} events, expected REL_X or REL_Y in a complete frame"
        if (refusal := self.about.refusal) is not None:
            return refusal
        if len({place[:2] for _, place in self.places}) < 2:
            return f"no motion in {self.count} events, expected X and Y of a contact or a pointer"
        aside = self.without_place
        notes = [f"frames without motion or button left aside: {aside}"] if aside else []
        if self._begins >= 0:
            notes.append(f"the last frame, from event {self._begins}, is not complete and left aside")
        faults = {place: words for place, words in self.place_faults.items() if place < len(self.places)}
        return frames_of_places(self.places, self.place_rows, notes, self.about.surface, faults)


def frames(path: Path, raw: Iterable[RawEvent], about: EvdevAbout | None = None) -> Frames | str:
    """The frames of one device, or a text about its content if nothing moves; raises RecordingError."""
    builder = FrameBuilder(path, about)
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
    elif reading.px_per_unit is not None and unit == "counts":
        stream.notes.append(f"px_per_unit has no effect: {device} moves by counts")
    samples = Samples(
        name=stem_of(path),
        table=stream.events.table,
        row_of=stream.rows,
        provenance=Provenance(
            form,
            unit=unit,
            origin="top left" if absolute else "where the stream began",
            y_axis="down",
            clock=clock,
            dpi=reading.dpi,
            cpi=reading.cpi,
        ),
        one_user="unknown",
        cut="bursts",
        parts=np.searchsorted(stream.breaks, np.arange(len(stream.events)), side="right"),
        condition={"device": device},
        faults=stream.faults,
        notes=stream.notes,
    )
    return recording_of(samples, reading)
