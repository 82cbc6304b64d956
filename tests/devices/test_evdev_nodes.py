"""Lists, refusals, dropped events and a forged clock, on emulated input evdev."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from pointpred.devices import evdev
from pointpred.devices.evdev import EvdevSource
from pointpred.errors import SourceError
from tests.devices import evdev_mice
from tests.devices.evdev_mice import ACCELEROMETER, KEYBOARD, PLAIN, TOUCHPAD, Reader, plug
from tests.devices.umockdev import Testbed


def test_the_list_names_what_points_and_says_why_one_is_closed(testbed: Testbed) -> None:
    open_one, _, touchpad, closed = (
        plug(testbed, i, mouse) for i, mouse in ((4, PLAIN), (5, KEYBOARD), (6, TOUCHPAD), (12, PLAIN))
    )
    if os.getuid() != 0:
        pytest.skip("only root can close a node to others")
    Path(testbed.root, closed[1:]).chmod(0o600)
    Path(testbed.root, open_one[1:]).chmod(0o666)
    for answering in filter(Path.is_socket, Path(testbed.root).rglob("*")):
        answering.chmod(0o666)
    with Reader(testbed) as reader:
        listed = reader.ask(as_nobody=True)
    assert [found["path"] for found in listed] == [open_one, touchpad, closed]
    assert listed[0]["name"] == PLAIN.name
    assert [found["openable"] for found in listed] == [True, False, False]
    assert "it is a touch pad" in listed[1]["why"]
    assert "browser" in listed[1]["advice"]
    assert listed[2]["why"] == "Permission denied"
    for part in ('KERNEL=="event*"', 'ATTRS{id/vendor}=="046d"', 'TAG+="uaccess"', "udevadm trigger"):
        assert part in listed[2]["advice"]


def test_a_keyboard_and_a_missing_node_say_what_to_do(testbed: Testbed) -> None:
    for node, said in (
        (plug(testbed, 5, KEYBOARD), "it sends no motion"),
        (plug(testbed, 6, TOUCHPAD), "it is a touch pad"),
        (plug(testbed, 7, ACCELEROMETER), "are not a pointer's"),
        ("/dev/input/event99", "plug the device in"),
    ):
        with Reader(testbed, node) as reader:
            told = reader.ask()
        assert said in told
        assert "pointpred devices list" in told


@pytest.mark.parametrize("name", ["mouse0", "mice", "session.csv"])
def test_what_is_no_node_of_events_is_refused_by_its_name(tmp_path: Path, name: str) -> None:
    (tmp_path / name).touch()
    with pytest.raises(SourceError, match=r"expected /dev/input/event\*"), EvdevSource(str(tmp_path / name)):
        raise AssertionError("it opened")


def test_what_only_has_a_node_s_name_is_refused(tmp_path: Path) -> None:
    file, folder = tmp_path / "event3", tmp_path / "event4"
    file.write_bytes(bytes(24))
    folder.mkdir()
    for path in (str(file), str(folder)):
        with pytest.raises(SourceError, match="no character device"), EvdevSource(path):
            raise AssertionError("it opened")
        listed = evdev.device_info(evdev.node(path))
        assert (listed.openable, listed.why) == (False, "it is no character device, expected an input node")


def test_a_link_to_a_node_of_events_is_followed(testbed: Testbed) -> None:
    plug(testbed, 4, PLAIN)
    link = Path(testbed.root, "dev/input/by-id/some-mouse")
    link.parent.mkdir()
    link.symlink_to("../event4")
    with Reader(testbed, "/dev/input/by-id/some-mouse") as reader:
        assert "clock" in reader.ask()


def test_dropped_events_are_counted_and_the_buttons_asked_for(testbed: Testbed) -> None:
    held = bytearray(96)
    held[0x111 // 8] |= 1 << 0x111 % 8  # the right button
    node = plug(testbed, 4, PLAIN, bytes(held))
    now = (1000, 0)
    frame = [(*now, 2, 0, 5), (*now, 0, 0, 0)]
    dropped = [(*now, 2, 0, 7), (*now, 0, 3, 0), (*now, 1, 0x110, 1), (*now, 0, 0, 0)]
    with Reader(testbed, node) as reader:
        reader.ask()
        evdev_mice.write(testbed, node, [*frame, *dropped, *frame])
        told = reader.ask(reports=3)
    assert [row[1:4] for row in told["reports"]] == [[5, 0, 2], [0, 0, 2], [5, 0, 2]]
    assert told["resynchronised"] == 1
