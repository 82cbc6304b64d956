"""Emulated input nodes from recordings of real mice, and a child process that reads them."""

from __future__ import annotations

import json
import os
import re
import struct
import subprocess
import sys
import threading
import time
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import msgspec

from tests.devices.umockdev import Testbed

EVENT = struct.Struct("@llHHi")
CHILD = "from tests.devices.evdev_mice import child; child()"
PATIENCE_S = 60.0

InputEvent = tuple[int, int, int, int, int]
"""Seconds, microseconds, type, code, value."""


class Mouse(msgspec.Struct, frozen=True):
    """What evemu says of a device: its name, bus, vendor, product and version, and a bitmap for each type."""

    name: str
    numbers: str
    bitmaps: dict[int, int]
    properties: int = 0
    ranges: dict[int, tuple[int, int, int]] = {}


PLAIN = Mouse("Plain Mouse", "0003 046d c077 0111", {0: 7, 1: 0x70000 << 256, 2: 0x103})
ACCELEROMETER = Mouse("Some Accelerometer", "0019 0000 0000 0000", {0: 9, 3: 0x7}, 1 << 6)
KEYBOARD = Mouse("Some Keyboard", "0011 0001 0001 ab41", {0: 3, 1: 0xFFFFFFFE})
TOUCHPAD = Mouse("Some Touchpad", "0011 0002 0007 01b1", {0: 11, 1: 0x420 << 320, 3: 0x3})


def described(path: Path) -> Mouse:
    """The device at the head of an evemu recording or in a description beside it."""
    text = path.read_text()
    bitmaps: dict[int, int] = {}
    filled: dict[int, int] = {}
    for kind, data in re.findall(r"^B: ([0-9a-f]{2})((?: [0-9a-f]{2}){8})", text, re.MULTILINE):
        at = filled.get(int(kind, 16), 0)
        part = int.from_bytes(bytes.fromhex(data), "little") << 8 * at
        bitmaps[int(kind, 16)] = bitmaps.get(int(kind, 16), 0) | part
        filled[int(kind, 16)] = at + 8
    name, numbers = (re.search(rf"^{letter}: (.*)$", text, re.MULTILINE) for letter in "NI")
    assert name
    assert numbers
    return Mouse(name.group(1).strip(), numbers.group(1).strip(), bitmaps)


def events_of(path: Path) -> list[InputEvent]:
    """The E lines of a recording."""
    lines = re.findall(
        r"^E: (\d+)\.(\d{6}) ([0-9a-f]{4}) ([0-9a-f]{4}) (-?\d+)", path.read_text(), re.MULTILINE
    )
    return [(int(s), int(us), int(kind, 16), int(code, 16), int(value)) for s, us, kind, code, value in lines]


def packed(events: list[InputEvent]) -> bytes:
    """Events as the kernel hands them out."""
    return b"".join(EVENT.pack(*event) for event in events)


def words_of(bitmap: int) -> str:
    """A bitmap as sysfs writes it: words of 64 bits, the highest first."""
    words = [bitmap >> at & (1 << 64) - 1 for at in range(0, max(bitmap.bit_length(), 1), 64)]
    return " ".join(f"{word:x}" for word in reversed(words))


def plug(bed: Testbed, number: int, mouse: Mouse, pressed: bytes | None = None) -> str:
    """Make ``/dev/input/event<number>``; ``pressed`` answers EVIOCGKEY, else it is refused."""
    above, node = f"/devices/virtual/input/input{number}", f"/dev/input/event{number}"
    attributes = {"name": mouse.name, "uniq": ""}
    ids = zip(("bustype", "vendor", "product", "version"), mouse.numbers.split(), strict=True)
    attributes |= {f"id/{key}": value for key, value in ids}
    for kind, name in enumerate(("ev", "key", "rel", "abs")):
        attributes[f"capabilities/{name}"] = words_of(mouse.bitmaps.get(kind, 0))
    attributes["properties"] = words_of(mouse.properties)
    answers = f"EVIOCGKEY 96 {pressed.hex().upper()}\n" if pressed else ""
    for code, (least, most, resolution) in mouse.ranges.items():
        absinfo = struct.pack("@6i", 0, least, most, 0, 0, resolution)
        answers += f"EVIOCGABS({code}) 0 {absinfo.hex().upper()}\n"
    lines = [f"P: {above}", "E: SUBSYSTEM=input", *(f"A: {key}={value}" for key, value in attributes.items())]
    lines += ["", f"P: {above}/event{number}", f"N: {node[5:]}", f"E: DEVNAME={node}", "E: SUBSYSTEM=input"]
    lines += [f"L: device=../../input{number}", f"A: dev=13:{64 + number}", "", ""]
    bed.add("\n".join(lines), {node: answers} if answers else None)
    return node


def unplug(bed: Testbed, number: int) -> None:
    """Take a node away."""
    above = f"/sys/devices/virtual/input/input{number}"
    bed.remove(f"{above}/event{number}")
    bed.remove(above)


def play(bed: Testbed, node: str, events: list[InputEvent]) -> None:
    """Let a node report events at the pace of their stamps, never early.

    umockdev's own player cuts every wait to whole milliseconds and reads .067 s as an octal number.
    """
    first, start = events[0], time.monotonic()
    for event in events:
        late = start + event[0] - first[0] + (event[1] - first[1]) / 1e6 - time.monotonic()
        time.sleep(max(late, 0.0))
        write(bed, node, [event])


def write(bed: Testbed, node: str, events: list[InputEvent]) -> None:
    """Let a node report events at once; the reader's pace holds the writer back."""
    data, hand = packed(events), bed.hand(node)
    while data:
        data = data[os.write(hand, data[: 64 * EVENT.size]) :]


def told(child: subprocess.Popen[str]) -> Any:
    """The next line of a child, as JSON; one that says nothing for too long is ended."""
    assert child.stdout
    end = threading.Timer(2.0 * PATIENCE_S, child.kill)
    end.start()
    line = child.stdout.readline()
    end.cancel()
    if not line:
        raise AssertionError(f"the child has ended: {child.communicate()[1]}")
    return json.loads(line)


class Reader:
    """A child that reads a node through ``EvdevSource`` and answers what it is asked."""

    def __init__(self, bed: Testbed, *arguments: str) -> None:
        self._child = bed.python(CHILD, *arguments)

    def ask(self, **question: Any) -> Any:
        """The child's answer to one question."""
        assert self._child.stdin
        self._child.stdin.write(json.dumps(question) + "\n")
        self._child.stdin.flush()
        return told(self._child)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            _, said = self._child.communicate(timeout=PATIENCE_S)
        except subprocess.TimeoutExpired:
            self._child.kill()
            raise
        assert self._child.returncode == 0, said


def child() -> None:
    """What the child does: questions come as lines of JSON, the end of them closes the source."""
    from pointpred.devices.evdev import EvdevSource, list_evdev
    from pointpred.errors import SourceError

    def answer(said: Any) -> None:
        sys.stdout.write(json.dumps(said) + "\n")
        sys.stdout.flush()

    if len(sys.argv) == 1:
        for line in sys.stdin:
            if "as_nobody" in line:
                os.setresuid(65534, 65534, 65534)
            answer(msgspec.to_builtins(list_evdev()))
        return
    sys.stdin.readline()
    try:
        source = EvdevSource(sys.argv[1]).__enter__()
    except SourceError as error:
        answer(str(error))
        return
    answer({"name": source.name, "clock": source.clock})
    for line in sys.stdin:
        question = json.loads(line)
        until, reports = time.monotonic() + PATIENCE_S, []
        while time.monotonic() < until and len(reports) < question.get("reports", 0):
            reports += source.take(0.1)
        while time.monotonic() < until and source.plugged != question.get("plugged", source.plugged):
            time.sleep(0.01)
        counts = {
            key: getattr(source, key) for key in ("lost", "unreadable", "resynchronised", "clock_steps")
        }
        rows = [msgspec.structs.astuple(report) for report in reports]
        answer(counts | {"reports": rows, "plugged": source.plugged, "path": source.path})
    source.close()
