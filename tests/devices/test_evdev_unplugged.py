"""A mouse that goes away and comes back, of made-up frames on emulated input nodes."""

from __future__ import annotations

from tests.devices.evdev_mice import PLAIN, InputEvent, Reader, plug, unplug, write
from tests.devices.umockdev import Testbed

NOW = (1000, 0)
SYN, KEY, REL = 0, 1, 2
END: InputEvent = (*NOW, SYN, 0, 0)
DROPPED: InputEvent = (*NOW, SYN, 3, 0)


def moved(dx: int, dy: int) -> list[InputEvent]:
    return [(*NOW, REL, 0, dx), (*NOW, REL, 1, dy), END]


def test_it_is_waited_for_known_again_and_its_counts_go_on(testbed: Testbed) -> None:
    node = plug(testbed, 3, PLAIN)
    twin = plug(testbed, 4, PLAIN)
    with Reader(testbed, node) as reader:
        reader.ask()
        gap = [*moved(90, 90)[:2], DROPPED, END]
        write(testbed, node, [*moved(1, 2), *gap, (*NOW, KEY, 0x110, 1), *moved(3, 4)])
        here = reader.ask(reports=3)
        assert [row[1:4] for row in here["reports"]] == [[1, 2, 0], [0, 0, 0], [3, 4, 1]]
        assert (here["resynchronised"], here["path"]) == (1, node)
        unplug(testbed, 3)
        gone = reader.ask(plugged=False, reports=1)
        assert [row[1:4] for row in gone["reports"]] == [[0, 0, 0]]  # what is not there presses nothing
        assert (gone["plugged"], gone["resynchronised"]) == (False, 1)
        again = plug(testbed, 7, PLAIN)
        assert reader.ask(plugged=True)["path"] == again
        write(testbed, twin, moved(50, 50))  # its twin stayed where it was
        write(testbed, again, moved(5, 6))
        back = reader.ask(reports=1)
    assert [row[1:4] for row in back["reports"]] == [[5, 6, 0]]
    assert back["resynchronised"] == 1  # of the device that was here before
    assert (back["lost"], back["unreadable"]) == (0, 0)
    assert back["reports"][0][0] >= gone["reports"][0][0]
