"""A mouse that is pulled out in the middle, comes back elsewhere, and is read on."""

from __future__ import annotations

import json
import subprocess
import time

from tests.devices.mice import TWO_WHEELS, WHEEL, Mouse, plug
from tests.devices.umockdev import Testbed

FOLLOWER = """
import json, sys, threading, time
from pointpred.devices.hidraw import HidSource

with HidSource() as source:
    print("open", flush=True)
    state = None
    until = time.monotonic() + 300
    ended = threading.Event()
    threading.Thread(target=lambda: (sys.stdin.read(), ended.set()), daemon=True).start()
    while not ended.is_set() and time.monotonic() < until:
        for r in source.take(0.05):
            print(json.dumps([r.dx, r.dy, r.buttons]), flush=True)
        if (source.plugged, source.path) != state:
            state = source.plugged, source.path
            print(json.dumps(state), flush=True)
    print(json.dumps([source.lost, source.unreadable]), flush=True)
"""


def said(child: subprocess.Popen[str]) -> str:
    """The next line of a follower; one that has ended tells why."""
    assert child.stdout is not None
    line = child.stdout.readline()
    assert line, f"the follower has left with {child.wait(60)}: {child.communicate()[1]}"
    return line.strip()


def report(dx: int, dy: int, buttons: int = 0) -> bytes:
    return bytes([buttons, dx & 0xFF, dy & 0xFF, 0])


def test_unplugged_in_the_middle_and_back_at_another_port(testbed: Testbed) -> None:
    other = plug(testbed, TWO_WHEELS, 1)
    mouse = plug(testbed, Mouse("the mouse", WHEEL.descriptor, 0x46D, 0xC077, "A1"), 0)
    child = testbed.python(FOLLOWER)

    def heard() -> object:
        line = said(child)
        return line if line == "open" else json.loads(line)

    assert heard() == "open"
    assert heard() == [True, "/dev/hidraw0"]
    mouse.send(report(1, 2, 1))
    assert heard() == [1, 2, 1]
    mouse.unplug()
    told = [heard(), heard()]
    assert [0, 0, 0] in told, "a mouse that is gone presses nothing"
    assert [False, "/dev/hidraw0"] in told
    twin = plug(testbed, Mouse("the mouse", WHEEL.descriptor, 0x46D, 0xC077, "B2"), 2)
    time.sleep(0.6)  # another of its kind comes first, and is not taken for it
    back = plug(testbed, Mouse("the mouse", WHEEL.descriptor, 0x46D, 0xC077, "A1"), 3)
    assert heard() == [True, "/dev/hidraw3"]
    twin.send(report(9, 9))
    other.send(bytes(8))
    back.send(report(-3, 4))
    assert heard() == [-3, 4, 0]
    out, err = child.communicate("", timeout=60)
    assert (json.loads(out), err) == ([0, 0], "")


def test_closing_while_unplugged_ends_at_once(testbed: Testbed) -> None:
    mouse = plug(testbed, WHEEL)
    child = testbed.python(FOLLOWER)
    assert said(child) == "open"
    mouse.unplug()
    while json.loads(said(child)) != [False, "/dev/hidraw0"]:
        pass
    _, err = child.communicate("", timeout=60)  # by itself it would go on for minutes
    assert err == ""


def test_of_two_alike_the_one_that_stays_is_not_taken_for_the_other(testbed: Testbed) -> None:
    stays, mouse = plug(testbed, WHEEL, 1), plug(testbed, WHEEL, 0)
    child = testbed.python(FOLLOWER)
    assert [said(child) for _ in range(2)] == ["open", '[true, "/dev/hidraw0"]']
    mouse.unplug()
    assert said(child) == '[false, "/dev/hidraw0"]'
    time.sleep(0.6)
    stays.send(report(9, 9))
    back = plug(testbed, WHEEL, 2)
    assert said(child) == '[true, "/dev/hidraw2"]'
    back.send(report(-3, 4))
    assert said(child) == "[-3, 4, 0]"
    assert child.communicate("", timeout=60) == ("[0, 0]\n", "")
