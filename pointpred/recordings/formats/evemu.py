"""evemu recordings 1.x: ``E: seconds.microseconds type code value``, type and code in hexadecimal."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from pointpred.recording import Recording
from pointpred.recordings.formats.evdev_frames import (
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
OTHERS = "IPBALS#"


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` holds evemu events."""
    return LIKELY.search(head) is not None


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read a recording as counts; ``row`` counts the E lines that can be read; the others are in a note.

    A line N: begins another device. Raises RecordingError.
    """
    return text_recording(path, "evemu", _events, reading, "kernel stamps, us; which clock is not said")


def _events(text: str, unreadable: UnreadableLines) -> Iterator[DeviceEvent]:
    """The events of the E lines."""
    device = (0, "")
    for number, line in enumerate(text.splitlines(), 1):
        if name := NAME.match(line):
            device = (device[0] + 1, name[1].strip())
            continue
        if not line.strip() or line[0] in OTHERS:
            continue
        match = EVENT.match(line)
        if not match:
            unreadable.add("events that cannot be read", number, line)
            continue
        seconds, micros, kind, code, value = match.groups()
        time = int(seconds) * 1_000_000 + int(micros)
        yield device, (time, int(kind, 16), int(code, 16), int(value))
