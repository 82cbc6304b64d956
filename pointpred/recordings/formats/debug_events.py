"""``libinput debug-events``: a line an event, with its device and its time since the start."""

from __future__ import annotations

import re
from pathlib import Path

import msgspec
import numpy as np

from pointpred.recording import Recording
from pointpred.recordings.encodings import read_text
from pointpred.recordings.formats.evdev_frames import (
    BUTTONS,
    Frames,
    UnreadableLines,
    recording_of_devices,
)
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.records import EventColumns

TITLE = "libinput debug-events"
LINE = re.compile(r"[- ]?(event\d+)\s+([A-Z][A-Z0-9_]+)\s+(?:\d+\s+)?(?:\+?(\d+\.\d+)s\s+)?(.*)$")
LIKELY = re.compile(rb"^[- ]?event\d+ +(DEVICE_ADDED|POINTER_[A-Z_]+|KEYBOARD_KEY) ", re.MULTILINE)
PAIR = r"([-+]?\d+\.\d+)/ *([-+]?\d+\.\d+)"
MOTION = re.compile(rf"\s*{PAIR}(?: *\( *{PAIR}\))?")
BUTTON = re.compile(r"\w+ \((\d+)\) (pressed|released)")


class _Device(msgspec.Struct):
    """A device of a file: its name, and its rows of t in s, px across and down, counts, buttons."""

    name: str
    table: list[tuple[float, float, float, float, float, int]] = []
    rows: list[int] = []
    buttons: int = 0
    others: int = 0


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` was written by libinput debug-events."""
    return LIKELY.search(head) is not None


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read the relative motion of every device; ``row`` counts the events of the file.

    Positions are the sums of the accelerated motion, in px; counts are the motion before acceleration, in the
    device's units, where the line has it. Other events are counted in notes. Raises RecordingError.
    """
    devices: list[_Device] = []
    nodes: dict[str, _Device] = {}
    unreadable = UnreadableLines()
    row = -1
    for number, line in enumerate(read_text(path).splitlines(), 1):
        match = LINE.match(line)
        if match is None:
            if line.strip():
                unreadable.add("lines that are no events", number, line)
            continue
        row += 1
        node, kind, stamp, about = match.groups()
        if node not in nodes or (kind == "DEVICE_ADDED" and nodes[node].table):
            nodes[node] = _Device(node)
            devices.append(nodes[node])
        device = nodes[node]
        motion, button = MOTION.match(about), BUTTON.match(about)
        if kind == "DEVICE_ADDED":
            device.name = re.split(r"\s{2,}", about.strip())[0]
        elif kind == "DEVICE_REMOVED":
            device.buttons = 0
        elif kind == "POINTER_MOTION" and stamp and motion:
            values = [float("nan") if number is None else float(number) for number in motion.groups()]
            device.table.append((float(stamp), values[0], values[1], values[2], values[3], device.buttons))
            device.rows.append(row)
        elif kind == "POINTER_BUTTON" and stamp and button:
            bit = BUTTONS.get(int(button[1]), 0)
            device.buttons = device.buttons | bit if button[2] == "pressed" else device.buttons & ~bit
            device.table.append((float(stamp), 0.0, 0.0, 0.0, 0.0, device.buttons))
            device.rows.append(row)
        elif kind in ("POINTER_MOTION", "POINTER_BUTTON"):
            unreadable.add("events that cannot be read", number, line)
        else:
            device.others += 1
    streams = [(device.name, _frames(device)) for device in devices]
    clock = "s since the start, of libinput's events"
    return recording_of_devices(path, "libinput-debug-events", streams, unreadable, reading, clock, "px")


def _frames(device: _Device) -> Frames | str:
    """The events of a device, or a text about its content if nothing moves."""
    table = np.array(device.table).reshape(-1, 6)
    if not table[:, 1:3].any():
        return f"no relative motion in {len(table) + device.others} events, expected POINTER_MOTION"
    table[:, 1:3] = np.cumsum(table[:, 1:3], axis=0)
    if np.isnan(table[:, 3]).any():  # an old version: no motion before acceleration
        table[:, 3:5] = np.nan
    notes = [f"events without motion or button left aside: {device.others}"] if device.others else []
    return Frames(EventColumns(table), np.array(device.rows, dtype=np.int64), {}, notes)
