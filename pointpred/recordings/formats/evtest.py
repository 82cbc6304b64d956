"""evtest's text: ``Event: time S.UUUUUU, type 2 (EV_REL), code 0 (REL_X), value n``."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from pointpred.recording import Recording
from pointpred.recordings.formats.evdev_contacts import EV_ABS, EV_SYN
from pointpred.recordings.formats.evdev_frames import (
    SYN_DROPPED,
    SYN_REPORT,
    Abouts,
    DeviceEvent,
    UnreadableLines,
    text_recording,
)
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "evtest text"
STAMP = r"Event: time (\d{1,10})\.(\d{6}), "
EVENT = re.compile(
    STAMP + r"type (\d{1,2}) \([^)]*\), code (\d{1,4}) \([^)]*\), value (-?[0-9a-fA-F]{1,10})\s*$"
)
MARK = re.compile(STAMP + r"[-+>]+ ?([A-Za-z_ ?]+?) ?[-+<]+\s*$")
NAME = re.compile(r'Input device name: "(.*)"$')
KIND = re.compile(r"  Event type (\d{1,2}) ")
CODE = re.compile(r"    (?:Event code|Key) (\d{1,4}) ")
LIMIT = re.compile(r"      (Min|Max|Resolution) +(-?\d{1,10})\s*$")
PROPERTY = re.compile(r"  Property type (\d{1,2}) ")
WHOLE = re.compile(r"-?\d+")
UNREAD = "events that cannot be read"
REPORTS = ("SYN_REPORT", "Report Sync")
MARKS = {"SYN_MT_REPORT": 2, "Config Sync": 1, "SYN_CONFIG": 1, "SYN_DROPPED": SYN_DROPPED}


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` holds evtest's events."""
    return re.search(rb"^Event: time \d+\.\d{6}, ", head, re.MULTILINE) is not None


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read counts or places; ``row`` counts the Event lines that can be read; the others are in a note.

    A header with a name begins another device, and says what it is. Raises RecordingError.
    """
    return text_recording(path, "evtest", _events, reading, "kernel stamps, us, usually the real-time clock")


def _events(text: str, unreadable: UnreadableLines, abouts: Abouts) -> Iterator[DeviceEvent]:
    """The events of the lines that begin with Event; a header says what the device is."""
    device = (0, "")
    kind_of, code_of, limits = -1, -1, dict[str, int]()
    for number, line in enumerate(text.splitlines(), 1):
        if name := NAME.match(line):
            device = (device[0] + 1, name[1].strip())
        if not line.startswith("Event: "):
            if about := KIND.match(line):
                kind_of = int(about[1])
            elif about := CODE.match(line):
                code_of, limits = int(about[1]), {}
                abouts[device].add_codes(kind_of, [code_of])
            elif about := PROPERTY.match(line):
                abouts[device].properties.add(int(about[1]))
            elif (about := LIMIT.match(line)) and kind_of == EV_ABS:
                limits[about[1]] = int(about[2])
                abouts[device].add_range(
                    code_of, limits.get("Min", 0), limits.get("Max", 0), limits.get("Resolution", 0)
                )
            continue
        event, mark = EVENT.match(line), MARK.match(line)
        if event:
            seconds, micros, kind, code, value = event.groups()
            time = int(seconds) * 1_000_000 + int(micros)
            if int(kind) > EV_ABS:  # of which the values are of other kinds
                yield device, (time, int(kind), int(code), 0)
            elif WHOLE.fullmatch(value):
                yield device, (time, int(kind), int(code), int(value))
            else:
                unreadable.add(UNREAD, number, line)
        elif mark and (mark.group(3) in REPORTS or mark.group(3) in MARKS):
            time = int(mark.group(1)) * 1_000_000 + int(mark.group(2))
            yield device, (time, EV_SYN, MARKS.get(mark.group(3), SYN_REPORT), 0)
        else:
            unreadable.add(UNREAD, number, line)
