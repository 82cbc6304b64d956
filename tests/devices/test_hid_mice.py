"""The hidapi wheel and ``HidSource`` against emulated mice with real report descriptors."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator

import pytest

from tests.devices.mice import ENCODERS, SYZBOT, TWO_WHEELS, Encode, Mouse, Plugged, plug
from tests.devices.umockdev import Testbed, missing

READER = """
import json, sys, time
from pointpred.devices.hidraw import HidSource
from pointpred.errors import SourceError

for line in sys.stdin:
    path, wanted, spoilt = json.loads(line)
    try:
        with HidSource(path) as source:
            print(json.dumps([source.name, source.plugged]), flush=True)
            taken, until = [], time.monotonic() + 60
            if spoilt:
                while source.unreadable < spoilt and time.monotonic() < until:
                    taken += source.take(0.02)
                print(json.dumps(source.unreadable), flush=True)
            while len(taken) < wanted and time.monotonic() < until:
                taken += source.take(0.5)
            before = time.monotonic()
            rows = [[r.t, r.dx, r.dy, r.buttons, r.wheel, r.pan] for r in taken]
            print(json.dumps([rows, source.lost, source.unreadable, before]), flush=True)
    except SourceError as error:
        print(json.dumps(str(error)), flush=True)
"""
MOTIONS = [(3, -4, 0, 0, 0), (-1, 1, 1, 0, 0), (0, 0, 1, 1, -1), (100, -100, 5, 0, 0), (0, 0, 0, -2, 3)]
"""dx, dy, buttons as HID numbers them (left, right, middle), wheel, pan."""
W3C = {0: 0, 1: 1, 5: 5}


class Room:
    """All the mice in one machine, and a child that reads those it is told to."""

    def __init__(self, testbed: Testbed) -> None:
        self.mice: dict[str, Plugged] = {}
        for number, mouse in enumerate([*(mouse for mouse, _, _ in ENCODERS), SYZBOT]):
            self.mice[mouse.name] = plug(testbed, mouse, number)
        self.child = testbed.python(READER)

    def ask(self, mouse: Mouse, reports: int, spoilt: int = 0) -> object:
        """Let the child open a mouse and wait for so many reports; first, and saying so, for spoilt ones."""
        assert self.child.stdin is not None
        self.child.stdin.write(json.dumps([self.mice[mouse.name].node, reports, spoilt]) + "\n")
        self.child.stdin.flush()
        return self.answer()

    def answer(self) -> object:
        assert self.child.stdout is not None
        line = self.child.stdout.readline()
        assert line, self.child.communicate()[1]
        return json.loads(line)


@pytest.fixture(scope="module")
def room() -> Iterator[Room]:
    if why := missing():
        pytest.skip(why)
    with Testbed() as testbed:
        room = Room(testbed)
        yield room
        out, err = room.child.communicate(timeout=60)
        assert (out, err) == ("", "")


@pytest.mark.parametrize(("mouse", "encode", "most"), ENCODERS, ids=[m.name for m, _, _ in ENCODERS])
def test_every_mouse_is_read_as_it_was_moved(room: Room, mouse: Mouse, encode: Encode, most: int) -> None:
    motions = [*MOTIONS, (most, -most, 0, 0, 0), (-most, most, 0, 0, 0)]
    reports = [report for motion in motions for report in encode(*motion)]
    assert room.ask(mouse, len(reports)) == [mouse.name, True]
    started = time.monotonic()
    for report in reports:
        room.mice[mouse.name].send(report)
        time.sleep(0.003)  # the emulated node is a stream: one report at a time
    rows, lost, unreadable, ended = room.answer()  # type: ignore[misc]
    assert (lost, unreadable, len(rows)) == (0, 0, len(reports))
    times = [row[0] for row in rows]
    assert times == sorted(times)
    assert started <= times[0]
    assert times[-1] <= ended
    wheels, pans = encode(0, 0, 0, 1, 0) != encode(0, 0, 0, 0, 0), encode(0, 0, 0, 0, 1) != encode(*[0] * 5)
    heard = _joined([row[1:] for row in rows], len(reports) // len(motions))
    said = [
        [x, y, W3C[pressed], wheel if wheels else 0, pan if pans else 0]
        for x, y, pressed, wheel, pan in motions
    ]
    assert heard == said


def _joined(rows: list[list[float]], each: int) -> list[list[float]]:
    """Reports that a mouse spread over several: counts add, the last says what is pressed."""
    joined = []
    for at in range(0, len(rows), each):
        x, y, _, wheel, pan = (sum(column) for column in zip(*rows[at : at + each], strict=True))
        joined.append([x, y, rows[at + each - 1][2], wheel, pan])
    return joined


def test_a_bad_descriptor_says_so(room: Room) -> None:
    answer = room.ask(SYZBOT, 1)
    node = room.mice[SYZBOT.name].node
    assert answer == (
        f"{node} (garbage): report descriptor without x and y of a pointer: "
        "expected those of a mouse, a tablet or a touch screen"
    )


def test_a_report_that_is_too_short_is_counted(room: Room) -> None:
    assert room.ask(TWO_WHEELS, 1, spoilt=1) == [TWO_WHEELS.name, True]
    room.mice[TWO_WHEELS.name].send(bytes(5))
    assert room.answer() == 1  # before the next is sent: the emulated node is a stream
    room.mice[TWO_WHEELS.name].send(bytes([0, 0, 7, 0, 0, 0, 0, 0]))
    rows, lost, unreadable, _ = room.answer()  # type: ignore[misc]
    assert [row[1] for row in rows] == [7]
    assert (lost, unreadable) == (0, 1)


def test_a_path_that_is_no_device_names_those_that_are(room: Room) -> None:
    assert room.child.stdin is not None
    room.child.stdin.write(json.dumps(["/dev/hidraw99", 1, 0]) + "\n")
    room.child.stdin.flush()
    answer = str(room.answer())
    assert answer.startswith("/dev/hidraw99 is no HID device, there are: /dev/hidraw0 (boot-like), ")
    assert "pointpred devices list" in answer
