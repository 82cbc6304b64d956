"""evemu recordings 1.x: ``E: seconds.microseconds type code value``, type and code in hexadecimal."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from pointpred.recording import Recording
from pointpred.recordings.formats.evdev_contacts import bits_of
from pointpred.recordings.formats.evdev_frames import (
    Abouts,
    DeviceEvent,
    UnreadableLines,
    text_recording,
)
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "evemu 1.x"
EVENT = re.compile(
    r"E: (\d{1,10})\.(\d{6}) ([0-9a-fA-F]{1,4}) ([0-9a-fA-F]{1,4}) (-?\d{1,10})(?:\s*#.*)?\s*$"
)
LIKELY = re.compile(rb"^E: \d+\.\d{6} [0-9a-fA-F]{4} [0-9a-fA-F]{4} -?\d+\s*(#|$)", re.MULTILINE)
NAME = re.compile(r"N: (.*)$")
BITS = re.compile(r"(?:P:|B: ([0-9a-fA-F]{2}))((?: [0-9a-fA-F]{2})+)\s*$")
RANGE = re.compile(r"A: ([0-9a-fA-F]{1,2}) (-?\d{1,10}) (-?\d{1,10}) -?\d+ -?\d+(?: (-?\d{1,10}))?\s*$")
OTHERS = "IPBALS#"


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` holds evemu events."""
    return LIKELY.search(head) is not None


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read counts or places; ``row`` counts the E lines that can be read; the others are in a note.

    A line N: begins another device, and lines P:, B: and A: say what it is. Raises RecordingError.
    """
    return text_recording(path, "evemu", _events, reading, "kernel stamps, us; which clock is not said")


def _events(text: str, unreadable: UnreadableLines, abouts: Abouts) -> Iterator[DeviceEvent]:
    """The events of the E lines."""
    device = (0, "")
    filled = {"": 0}
    for number, line in enumerate(text.splitlines(), 1):
        if name := NAME.match(line):
            device = (device[0] + 1, name[1].strip())
            filled = {"": 0}
            continue
        if bits := BITS.match(line):
            of, data = bits[1] or "", bytes.fromhex(bits[2])
            codes = bits_of(8 * filled.get(of, 0), int.from_bytes(data, "little"))
            filled[of] = filled.get(of, 0) + len(data)
            if of:
                abouts[device].add_codes(int(of, 16), codes)
            else:
                abouts[device].properties.update(codes)
        elif extent := RANGE.match(line):
            code, least, most, resolution = extent.groups(default="0")
            abouts[device].add_range(int(code, 16), int(least), int(most), int(resolution))
        if not line.strip() or line[0] in OTHERS:
            continue
        match = EVENT.match(line)
        if not match:
            unreadable.add("events that cannot be read", number, line)
            continue
        seconds, micros, kind, code, value = match.groups()
        time = int(seconds) * 1_000_000 + int(micros)
        yield device, (time, int(kind, 16), int(code, 16), int(value))
