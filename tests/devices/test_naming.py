"""Devices by what people type."""

from __future__ import annotations

from pathlib import Path

import pytest

from pointpred.devices import selection
from pointpred.devices.selection import device_path
from pointpred.devices.source import DeviceInfo
from pointpred.errors import SourceError

MICE = [
    DeviceInfo("/dev/input/event4", "Logitech G Pro", "evdev", True),
    DeviceInfo("/dev/input/event5", "Trackball", "evdev", False, "Permission denied"),
    DeviceInfo("/dev/input/event6", "Logitech G502", "evdev", True),
    DeviceInfo("/dev/hidraw0", "G Pro", "hid", True),
    DeviceInfo("/dev/hidraw1", "Trackball", "hid", True),
]


@pytest.mark.parametrize(
    ("name", "path"),
    [
        ("event12", "/dev/input/event12"),
        ("hidraw3", "/dev/hidraw3"),
        ("/dev/input/event4", "/dev/input/event4"),
        ("/dev/nowhere", "/dev/nowhere"),
        ("logitech g pro", "/dev/input/event4"),
        ("g pro", "/dev/hidraw0"),
        ("G5", "/dev/input/event6"),
        ("trackball", "/dev/hidraw1"),
    ],
)
def test_short_names_and_parts_of_names(name: str, path: str) -> None:
    assert device_path(name, MICE) == path


@pytest.mark.parametrize(("name", "said"), [("logitech", "event6"), ("wacom", "event5"), ("", "event5")])
def test_what_fits_none_or_several_names_what_there_is(name: str, said: str) -> None:
    with pytest.raises(SourceError, match=said):
        device_path(name, MICE)
    with pytest.raises(SourceError, match="none"):
        device_path(name, [])


def test_links_are_followed_where_udev_makes_them(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "hidraw7").touch()
    (tmp_path / "my-mouse").symlink_to("hidraw7")
    (tmp_path / "event4").touch()
    (tmp_path / "usb-Some_Mouse-event-mouse").symlink_to("event4")
    monkeypatch.setattr(selection, "LINKS", (tmp_path,))
    assert device_path(str(tmp_path / "my-mouse"), MICE) == str(tmp_path / "hidraw7")
    link = str(tmp_path / "usb-Some_Mouse-event-mouse")
    assert device_path("usb-Some_Mouse-event-mouse", MICE) == device_path(link, MICE) == link
