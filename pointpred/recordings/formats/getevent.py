"""Android's getevent: ``[ seconds] node: type code value``, in hexadecimal or, with -l, by their names."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from pointpred.recording import Recording
from pointpred.recordings.formats.evdev_frames import (
    EV_ABS,
    EV_KEY,
    EV_REL,
    EV_SYN,
    REL_X,
    REL_Y,
    SYN_DROPPED,
    SYN_REPORT,
    DeviceEvent,
    UnreadableLines,
    text_recording,
)
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "Android getevent"
STAMP = r"(?:\[ *(\d{1,10})\.(\d{6})\] +)?"
EVENT = re.compile(
    STAMP + r"(?:(/dev/input/\S+): +)?"
    r"(EV_[A-Z_]+|[0-9a-f]{4}) +([A-Z]\w+|[0-9a-f]{4}) +(DOWN|UP|REPEAT|[0-9a-f]{8})\s*$"
)
LIKELY = re.compile(
    rb"^(?:\[ *\d+\.\d{6}\] +|/dev/input/event\d+: +){1,2}(?:EV_[A-Z_]+ |[0-9a-f]{4} [0-9a-f]{4} [0-9a-f]{8})"
    rb"|^EV_[A-Z_]+ +\w+ +(?:DOWN|UP|[0-9a-f]{8})",
    re.MULTILINE,
)
ADDED = re.compile(r"(?:add|remove) device \d+: (\S+)")
NAME = re.compile(r'\s+name: +"(.*)"')
KINDS = {"EV_SYN": EV_SYN, "EV_KEY": EV_KEY, "EV_REL": EV_REL, "EV_ABS": EV_ABS}
SYNS = {"SYN_REPORT": SYN_REPORT, "SYN_DROPPED": SYN_DROPPED}
AXES = {"REL_X": REL_X, "REL_Y": REL_Y}
BUTTONS = {
    name: 0x110 + at
    for at, name in enumerate(("LEFT", "RIGHT", "MIDDLE", "SIDE", "EXTRA", "FORWARD", "BACK"))
}
CODES = SYNS | AXES | {"BTN_MOUSE": 0x110} | {f"BTN_{name}": code for name, code in BUTTONS.items()}
OTHER = 0xFFFF
"""Any type or code that is not one of these."""
VALUES = {"UP": 0, "DOWN": 1, "REPEAT": 2}


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` holds getevent's events."""
    return LIKELY.search(head) is not None


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read the events of every device that moves, as counts; ``row`` counts the events of the file.

    Events without times, written without ``-t``, are left aside. Raises RecordingError.
    """
    return text_recording(
        path, "getevent", _events, reading, "kernel stamps, us since the start of the system"
    )


def _events(text: str, unreadable: UnreadableLines) -> Iterator[DeviceEvent]:
    """The events, each of the device whose node it names."""
    names: dict[str, str] = {}
    nodes: dict[str, int] = {}
    node = ""
    for number, line in enumerate(text.splitlines(), 1):
        if added := ADDED.match(line):
            node = added[1]
        elif name := NAME.match(line):
            names[node] = name[1]
        elif event := EVENT.match(line):
            seconds, micros, node, kind, code, value = event.groups(default="")
            if not seconds:
                unreadable.add("events without a time (record with: getevent -lt)", number, line)
                continue
            time = int(seconds) * 1_000_000 + int(micros)
            device = (nodes.setdefault(node, len(nodes)), names.get(node, node))
            yield device, (time, _number(kind, KINDS), _number(code, CODES), _number(value, VALUES))
        elif line.strip() and not line[0].isspace() and "driver version" not in line:
            unreadable.add("lines that are no events", number, line)


def _number(word: str, names: dict[str, int]) -> int:
    """A value in hexadecimal, of 32 bits with a sign, or by its name."""
    try:
        return (int(word, 16) + (1 << 31)) % (1 << 32) - (1 << 31) if word not in names else names[word]
    except ValueError:
        return OTHER
