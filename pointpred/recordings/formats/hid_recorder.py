"""hid-recorder: ``R:`` the report descriptor, ``E: S.UUUUUU n hex..`` the reports, of one or more devices."""

from __future__ import annotations

import re
from pathlib import Path

import msgspec

from pointpred.devices.hid import PositionValues, ReportDecoder, parse_descriptor, place_of
from pointpred.devices.surface import ContactReports, Place
from pointpred.errors import RecordingError
from pointpred.recording import Recording
from pointpred.recordings.encodings import read_text
from pointpred.recordings.formats.evdev_frames import (
    Frames,
    UnreadableLines,
    frames_of_counts,
    frames_of_places,
    recording_of_devices,
)
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "hid-recorder"
REPORT = re.compile(r"(\d{1,10})\.(\d{6}) (\d{1,5})((?: [0-9a-fA-F]{2})*)")
BYTES = re.compile(r"(\d{1,5})((?: [0-9a-fA-F]{2})*)")
CLOCK = "hid-recorder's own stamps, us from the first report"


class _Device(msgspec.Struct):
    """One device of a file: its name, its descriptor, and its pointer events and places so far."""

    name: str = ""
    descriptor: ReportDecoder | None = None
    contacts: ContactReports = msgspec.field(default_factory=ContactReports)
    events: list[tuple[int, int, int, int]] = []
    rows: list[int] = []
    places: list[tuple[int, Place]] = []
    place_rows: list[int] = []
    aside: int = 0
    why: str = "no report descriptor"


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` was written by hid-recorder."""
    return re.search(rb"^R: \d+ [0-9a-fA-F]{2} ", head, re.MULTILINE) is not None


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read every mouse, as counts, pen and touch screen, as places; ``row`` counts the E lines of the file.

    Reports without x, y and button, unreadable reports and lines of other kinds (``P:``, ``B:``) are ignored
    and counted in notes, as are the places of a device that has moved by counts; devices without a pointer's
    x and y are named in a note.
    Raises RecordingError, naming the line of a descriptor that cannot be read.
    """
    devices: list[_Device] = []
    numbers: dict[int, _Device] = {}
    current, row = 0, 0
    unreadable = UnreadableLines()
    for number, line in enumerate(read_text(path).splitlines(), 1):
        letter, _, rest = (part.strip() for part in line.partition(":"))
        if current not in numbers or (letter == "R" and (numbers[current].events or numbers[current].places)):
            numbers[current] = _Device()  # the number of a device in another recording, too
            devices.append(numbers[current])
        device = numbers[current]
        if letter == "D":
            if not re.fullmatch(r"\d{1,3}", rest):
                raise RecordingError(f"{path}: line {number} is {line[:60]!r}, expected D: and a number")
            current = int(rest)
        elif letter == "N":
            device.name = rest
        elif letter == "R":
            _describe(path, number, rest, device)
        elif letter == "E":
            why = _report(rest, device, row)
            if why:
                unreadable.add(f"reports that cannot be read ({why})", number, line)
            row += 1
        elif line.strip() and letter != "I" and line[0] != "#":
            unreadable.add("lines that are neither R:, N:, I:, E: nor D:", number, line)
    streams = [(device.name, _frames(device)) for device in devices if device.name or device.descriptor]
    return recording_of_devices(path, "hid-recorder", streams, unreadable, reading, CLOCK)


def _frames(device: _Device) -> Frames | str:
    """The frames of a device, or a text about its content if nothing moves."""
    aside = [f"reports without motion or button left aside: {device.aside}"] if device.aside else []
    if any(event[1] or event[2] for event in device.events):
        if device.places:
            aside.append(f"positions of a device that moves by counts left aside: {len(device.places)}")
        return frames_of_counts(device.events, device.rows, aside)
    decoder = device.descriptor
    if decoder and decoder.surface and len({place[:2] for _, place in device.places}) > 1:
        return frames_of_places(device.places, device.place_rows, aside, decoder.surface)
    reports = len(device.events) + len(device.places)
    return device.why or f"no motion in {reports} reports, expected a mouse that moves"


def _describe(path: Path, number: int, rest: str, device: _Device) -> None:
    """Store a device's report descriptor, or the reason why it is not a mouse's."""
    match = BYTES.fullmatch(rest)
    data = bytes.fromhex(match.group(2)) if match else b""
    if not match or int(match.group(1)) != len(data):
        raise RecordingError(f"{path}: line {number}: {len(data)} bytes, expected as many as R: says")
    try:
        device.descriptor, device.why = parse_descriptor(data), ""
        device.contacts = ContactReports()
    except RecordingError as error:
        device.why = str(error)


def _report(rest: str, device: _Device, row: int) -> str:
    """Process one report of a device; returns why it cannot be read, or an empty text."""
    match = REPORT.fullmatch(rest)
    if not match:
        return "expected E: s.us, a size and its bytes"
    data = bytes.fromhex(match.group(4))
    if int(match.group(3)) != len(data):
        return "not as many bytes as they say"
    if device.descriptor is None:
        device.aside += 1
        return ""
    try:
        decoded = device.descriptor.decode(data)
    except RecordingError:
        return "shorter than the report descriptor says"
    layout = device.descriptor.layout_of(data)
    if decoded is None or layout is None or not layout.points:
        device.aside += 1
        return ""
    time = int(match.group(1)) * 1_000_000 + int(match.group(2))
    if isinstance(decoded, PositionValues) or not device.descriptor.counts:
        place = place_of(device.contacts, decoded)
        if place is None:
            device.aside += 1
        else:
            device.places.append((time, place))
            device.place_rows.append(row)
        return ""
    dx, dy, pressed, mask, _, _ = decoded
    before = device.events[-1][3] if device.events else 0
    device.events.append((time, dx, dy, (before & ~mask) | pressed))
    device.rows.append(row)
    return ""
