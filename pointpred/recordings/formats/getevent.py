"""Android's getevent: ``[ seconds] node: type code value``, in hexadecimal or, with -l, by their names."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from pointpred.recording import Recording
from pointpred.recordings.formats.evdev_contacts import (
    ABS_MT_POSITION_X,
    ABS_MT_POSITION_Y,
    ABS_MT_SLOT,
    ABS_MT_TRACKING_ID,
    ABS_X,
    ABS_Y,
    BTN_STYLUS,
    BTN_TOOL_PEN,
    BTN_TOUCH,
    EV_ABS,
    EV_KEY,
    EV_REL,
    EV_SYN,
    INPUT_PROP_DIRECT,
    REL_X,
    REL_Y,
    SYN_MT_REPORT,
)
from pointpred.recordings.formats.evdev_frames import (
    SYN_DROPPED,
    SYN_REPORT,
    Abouts,
    DeviceEvent,
    UnreadableLines,
    text_recording,
)
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "Android getevent"
STAMP = r"(?:\[ *(\d{1,10})\.(\d{6})\] +)?"
EVENT = re.compile(
    STAMP + r"(?:(/dev/input/\S+): +)?"
    r"(EV_[A-Z_]+|[0-9a-f]{4}) +([A-Z]\w+|[0-9a-f]{4}) +(DOWN|UP|REPEAT|MT_TOOL_[A-Z]+|[0-9a-f]{8})\s*$"
)
LIKELY = re.compile(
    rb"^(?:\[ *\d+\.\d{6}\] +|/dev/input/event\d+: +){1,2}(?:EV_[A-Z_]+ |[0-9a-f]{4} [0-9a-f]{4} [0-9a-f]{8})"
    rb"|^EV_[A-Z_]+ +\w+ +(?:DOWN|UP|[0-9a-f]{8})",
    re.MULTILINE,
)
ADDED = re.compile(r"(?:add|remove) device \d+: (\S+)")
NAME = re.compile(r'\s+name: +"(.*)"')
RANGE = re.compile(
    r"\s+(?:ABS +\(0003\): +)?([A-Z]\w+|[0-9a-f]{4}) +: value -?\d+, min (-?\d{1,10}), max (-?\d{1,10}), "
    r"fuzz -?\d+, flat -?\d+, resolution (-?\d{1,10})"
)
KINDS = {"EV_SYN": EV_SYN, "EV_KEY": EV_KEY, "EV_REL": EV_REL, "EV_ABS": EV_ABS}
SYNS = {"SYN_REPORT": SYN_REPORT, "SYN_MT_REPORT": SYN_MT_REPORT, "SYN_DROPPED": SYN_DROPPED}
AXES = {"REL_X": REL_X, "REL_Y": REL_Y, "ABS_X": ABS_X, "ABS_Y": ABS_Y}
CONTACTS = {
    "ABS_MT_SLOT": ABS_MT_SLOT,
    "ABS_MT_POSITION_X": ABS_MT_POSITION_X,
    "ABS_MT_POSITION_Y": ABS_MT_POSITION_Y,
    "ABS_MT_TRACKING_ID": ABS_MT_TRACKING_ID,
    "BTN_TOOL_PEN": BTN_TOOL_PEN,
    "BTN_TOUCH": BTN_TOUCH,
    "BTN_STYLUS": BTN_STYLUS,
}
BUTTONS = {
    name: 0x110 + at
    for at, name in enumerate(("LEFT", "RIGHT", "MIDDLE", "SIDE", "EXTRA", "FORWARD", "BACK"))
}
CODES = (
    SYNS | AXES | CONTACTS | {"BTN_MOUSE": 0x110} | {f"BTN_{name}": code for name, code in BUTTONS.items()}
)
OTHER = 0xFFFF
"""Any type or code that is not one of these."""
VALUES = {"UP": 0, "DOWN": 1, "REPEAT": 2}


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` holds getevent's events."""
    return LIKELY.search(head) is not None


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read the events of every device that moves, counts or places; ``row`` counts the events of the file.

    Assumes that a surface for fingers is a screen, as nearly all are on Android. Without the ranges that
    ``getevent -p`` prints, a unit of the device is a px. Events without times, written without ``-t``, are
    left aside. Raises RecordingError.
    """
    return text_recording(
        path, "getevent", _events, reading, "kernel stamps, us since the start of the system"
    )


def _events(text: str, unreadable: UnreadableLines, abouts: Abouts) -> Iterator[DeviceEvent]:
    """The events, each of the device whose node it names."""
    names: dict[str, str] = {}
    nodes: dict[str, int] = {}
    node = ""
    for number, line in enumerate(text.splitlines(), 1):
        if added := ADDED.match(line):
            node = added[1]
        elif name := NAME.match(line):
            names[node] = name[1]
        elif extent := RANGE.match(line):
            device = (nodes.setdefault(node, len(nodes)), names.get(node, node))
            code, *numbers = extent.groups()
            abouts[device].add_range(_number(code, CODES), *map(int, numbers))
        elif event := EVENT.match(line):
            seconds, micros, node, kind, code, value = event.groups(default="")
            if not seconds:
                unreadable.add("events without a time (record with: getevent -lt)", number, line)
                continue
            time = int(seconds) * 1_000_000 + int(micros)
            device = (nodes.setdefault(node, len(nodes)), names.get(node, node))
            abouts[device].properties.add(INPUT_PROP_DIRECT)
            yield device, (time, _number(kind, KINDS), _number(code, CODES), _number(value, VALUES))
        elif line.strip() and not line[0].isspace() and "driver version" not in line:
            unreadable.add("lines that are no events", number, line)


def _number(word: str, names: dict[str, int]) -> int:
    """A value in hexadecimal, of 32 bits with a sign, or by its name."""
    try:
        return (int(word, 16) + (1 << 31)) % (1 << 32) - (1 << 31) if word not in names else names[word]
    except ValueError:
        return OTHER
