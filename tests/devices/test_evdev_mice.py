"""Recordings of real mice through the whole evdev path, on nodes that umockdev emulates."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pointpred.devices.evdev import FrameDecoder
from pointpred.recordings.formats.evdev_frames import Frames, frames
from pointpred.records import EventColumns
from tests.devices import evdev_mice
from tests.devices.evdev_mice import Mouse, Reader, described, events_of, plug, unplug
from tests.devices.umockdev import Testbed

pytestmark = pytest.mark.recordings
NAMES = ("PS2 Generic Mouse", "Saitek Cyborg R.A.T.5 Mouse", "Ultrathin Touch Mouse")
PACED_S = 1.2
UNMOVED_S = 1e-7
"""Stamps are whole microseconds; a float of seconds since the start is not exact after months of them."""
DROPPED, PRESSED = (0, 3, 0), (1, 0x110, 1)


def mouse_of(folder: Path, name: str) -> Mouse:
    beside = folder / f"{name}.desc"
    return described(beside if beside.exists() else folder / f"{name}.events")


def expected(path: Path, events: list[evdev_mice.InputEvent]) -> EventColumns:
    """The reports of a recording, as the importer of evemu files sees them: another implementation."""
    stream = frames(path, [(s * 1_000_000 + us, *rest) for s, us, *rest in events])
    assert isinstance(stream, Frames)
    return stream.events


def reports_in(events: list[evdev_mice.InputEvent]) -> int:
    """How many reports to wait for: more than are ``expected``, which leaves out those of the wheel."""
    return len(FrameDecoder().feed(evdev_mice.packed(events)))


def with_motion(rows: list[list[float]]) -> np.ndarray:
    """Reports as t, dx, dy, buttons; left out, as by the importer, are those that only turn the wheel."""
    kept, before = [], 0
    for t, dx, dy, buttons, wheel, pan in rows:
        if not (wheel or pan) or dx or dy or buttons != before:
            kept.append((t, dx, dy, buttons))
        before = int(buttons)
    return np.array(kept)


@pytest.mark.parametrize("name", NAMES)
def test_a_whole_recording_arrives_count_by_count(testbed: Testbed, recordings: Path, name: str) -> None:
    folder = recordings / "evemu_mice"
    path = folder / f"{name}.events"
    events = events_of(path)
    wanted = expected(path, events)
    node = plug(testbed, 3, mouse_of(folder, name))
    with Reader(testbed, node) as reader:
        opened = reader.ask()
        assert opened["name"] == mouse_of(folder, name).name
        assert "real-time" in opened["clock"]  # this emulation refuses the monotonic clock
        half = next(i for i in range(len(events) // 2, len(events)) if events[i][2:4] == (0, 0)) + 1
        evdev_mice.write(testbed, node, events[:half])
        rows = reader.ask(reports=reports_in(events[:half]))["reports"]
        evdev_mice.write(testbed, node, events[half:])
        told = reader.ask(reports=reports_in(events) - len(rows))
        rows += told["reports"]
    assert (told["lost"], told["unreadable"], told["resynchronised"]) == (0, 0, 0)
    assert with_motion(rows)[:, 1:] == pytest.approx(wanted.table[:, 3:6], abs=0)
    assert (np.diff([row[0] for row in rows]) >= 0).all()


def test_at_the_recording_s_own_pace_the_stamps_are_the_recording_s(
    testbed: Testbed, recordings: Path
) -> None:
    path = recordings / "evemu_mice" / f"{NAMES[1]}.events"
    events = events_of(path)
    seconds = [s - events[0][0] + (us - events[0][1]) / 1e6 for s, us, *_ in events]
    last = max(i for i, e in enumerate(events) if e[2:4] == (0, 0) and seconds[i] < PACED_S) + 1
    wanted = expected(path, events[:last])
    node = plug(testbed, 3, mouse_of(path.parent, NAMES[1]))
    with Reader(testbed, node) as reader:
        reader.ask()
        evdev_mice.play(testbed, node, events[:last])
        told = reader.ask(reports=len(wanted))
    told_rows = with_motion(told["reports"])
    assert len(told_rows) > 80
    assert told["clock_steps"] == 0
    off = told_rows[:, 0] - told_rows[0, 0] - (wanted.t - wanted.t[0])
    assert (np.abs(np.diff(off)) < UNMOVED_S).mean() > 0.8
    assert (np.diff(off) < UNMOVED_S).all()  # a quicker reading tells the clocks' difference better
    assert told_rows[:, 1:] == pytest.approx(wanted.table[:, 3:6], abs=0)


def test_unplugged_in_the_middle_it_waits_and_goes_on(testbed: Testbed, recordings: Path) -> None:
    path = recordings / "evemu_mice" / f"{NAMES[0]}.events"
    mouse, events = mouse_of(path.parent, NAMES[0]), events_of(path)
    half = next(i for i in range(len(events) // 2, len(events)) if events[i][2:4] == (0, 0)) + 1
    first, second = (expected(path, part) for part in (events[:half], events[half:]))
    node = plug(testbed, 3, mouse)
    twin = plug(testbed, 4, mouse)
    with Reader(testbed, node) as reader:
        reader.ask()
        dropped, press = ([(*events[0][:2], *kind), (*events[0][:2], 0, 0, 0)] for kind in (DROPPED, PRESSED))
        evdev_mice.write(testbed, node, [*dropped, *press, *events[:half]])
        rows = reader.ask(reports=2 + len(first))["reports"]
        assert [row[1:3] for row in rows[2:]] == first.table[:, 3:5].tolist()
        unplug(testbed, 3)
        gone = reader.ask(plugged=False, reports=1)
        assert gone["plugged"] is False
        assert gone["reports"][0][1:4] == [0, 0, 0]  # what is not there presses nothing
        again = plug(testbed, 7, mouse)
        back = reader.ask(plugged=True)
        assert (back["plugged"], back["path"]) == (True, again)
        evdev_mice.write(testbed, again, events[half:])
        evdev_mice.write(testbed, twin, events[:9])  # its twin stayed where it was
        told = reader.ask(reports=len(second))
    rows = told["reports"]
    assert told["resynchronised"] == 1  # what was lost before it went is not forgotten
    assert [row[1:4] for row in rows] == second.table[:, 3:6].tolist()
    assert rows[0][0] >= gone["reports"][0][0]
