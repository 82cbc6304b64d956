"""``libinput record``: YAML with the kernel's events of one or more devices, read line by line."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import groupby, takewhile
from operator import itemgetter
from pathlib import Path
from typing import Any

import yaml

from pointpred.errors import RecordingError
from pointpred.recording import Recording
from pointpred.recordings.encodings import open_text
from pointpred.recordings.formats.evdev_contacts import EV_KEY, EV_REL, EvdevAbout
from pointpred.recordings.formats.evdev_frames import (
    Frames,
    RawEvent,
    UnreadableLines,
    frames,
    recording_of_devices,
)
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "libinput record YAML"
LOADER: Any = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
EVENTS = re.compile(r" +events:\s*(?:#.*)?$")
ENTRY = re.compile(r" +- (\w+):")
ROW = re.compile(r" +- \[ *(\d{1,10}), *(\d{1,6}), *(\d{1,5}), *(\d{1,5}), *(-?\d{1,10}) *\]\s*(?:#.*)?$")
NUMBER = re.compile(r"-?\d{1,10}")
ABSINFO = ("minimum", "maximum", "fuzz", "flat", "resolution")
MOST_ABOUT = 1 << 20
"""Most characters of a device's description before its events; a touchpad has some 10,000."""

Line = tuple[int, int, str]
"""The device a line belongs to, the line's number, and the line."""


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` was written by libinput record."""
    return b"\ndevices:" in head and (b"libinput:" in head or b"evdev:" in head or b"ndevices:" in head)


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read the evdev events of every device that moves, counts or places; ``row`` counts a device's events.

    Assumes libinput's layout of one event per line. Raw HID reports (``hid``) repeat the evdev events and are
    ignored; devices that never move and lines that cannot be read are named in notes.
    Memory: one device's frames. Raises RecordingError when no device moves or the YAML is broken.
    """
    unreadable = UnreadableLines()
    clock = "kernel stamps, us from the recording's start, monotonic"
    with open_text(path) as file:
        lines = groupby(_lines(file), itemgetter(0))
        devices = (_device(path, index, some, unreadable) for index, some in lines)
        return recording_of_devices(path, "libinput", devices, unreadable, reading, clock)


def _lines(file: Iterable[str]) -> Iterator[Line]:
    """The lines of the list under ``devices:``."""
    device, in_devices = -1, False
    for number, line in enumerate(file, 1):
        if line[0] not in " #\n":
            device += in_devices and line[0] == "-"
            in_devices = line.startswith("devices:") or (in_devices and line[0] == "-")
        if in_devices and device >= 0:
            yield device, number, line


def _device(
    path: Path, index: int, lines: Iterator[Line], unreadable: UnreadableLines
) -> tuple[str, Frames | str]:
    """The name of a device and its frames, or a text about its content if nothing moves."""
    name, about = _about(path, index, takewhile(lambda line: not EVENTS.match(line[2]), lines))
    return name, frames(path, _events(lines, unreadable), about)


def _about(path: Path, index: int, lines: Iterable[Line]) -> tuple[str, EvdevAbout]:
    """The device's name and what else it says of itself before its events."""
    text, first = "", 0
    for _, number, line in lines:
        first = first or number
        text += line
        if len(text) > MOST_ABOUT:
            raise RecordingError(f"{path}: no events: in the {MOST_ABOUT} characters from line {first} on")
    try:
        device = yaml.load(text, Loader=LOADER)[0]
    except (yaml.YAMLError, ValueError, TypeError, LookupError, RecursionError) as error:
        words = " ".join(str(error).split())
        raise RecordingError(f"{path}: no YAML in the device from line {first} on: {words}") from error
    said = device.get("evdev") if isinstance(device, dict) else None
    about = EvdevAbout()
    if not isinstance(said, dict):
        return str(index), about
    codes, ranges = (
        part if isinstance(part := said.get(name), dict) else {} for name in ("codes", "absinfo")
    )
    for kind in (EV_KEY, EV_REL):
        about.add_codes(kind, _numbers(codes.get(str(kind))))
    about.properties.update(_numbers(said.get("properties")))
    for code, row in ranges.items():
        numbers = _numbers([code, *row] if isinstance(row, list) else None)
        if len(numbers) == 1 + len(ABSINFO):
            about.add_range(numbers[0], numbers[1], numbers[2], numbers[-1])
    return str(said.get("name", index)), about


def _numbers(items: Any) -> list[int]:
    """The whole numbers of a list of words."""
    words = items if isinstance(items, list) else []
    return [int(word) for word in words if isinstance(word, str) and NUMBER.fullmatch(word)]


def _events(lines: Iterable[Line], unreadable: UnreadableLines) -> Iterator[RawEvent]:
    """The evdev events of one device."""
    inside = False
    for _, number, line in lines:
        row = ROW.match(line) if inside else None
        if row:
            seconds, micros, kind, code, value = row.groups()
            yield int(seconds) * 1_000_000 + int(micros), int(kind), int(code), int(value)
        elif entry := ENTRY.match(line):
            inside = entry.group(1) == "evdev"
        elif inside and line.strip() and line.lstrip()[0] != "#":
            unreadable.add("events that cannot be read", number, line)
