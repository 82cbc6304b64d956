"""A mouse that is back the moment anybody hears that it was gone: it is itself, and no twin that stayed."""

from __future__ import annotations

import os
from types import SimpleNamespace
from typing import Any

import pytest

from pointpred.devices import evdev, hidraw
from pointpred.devices.evdev import EvdevSource
from pointpred.devices.hidraw import HidDevice, HidSource


def quick(kind: type, there: list[Any], mouse: Any, back: Any) -> Any:
    """A source of ``mouse``, open, whose device comes ``back`` as soon as it is called unplugged."""

    class Quick(kind):  # type: ignore[misc]
        def __setattr__(self, name: str, value: object) -> None:
            super().__setattr__(name, value)
            if name == "plugged" and not value and mouse not in there:
                there.append(back)

    source = Quick(mouse.path)
    source.plugged = True
    there.remove(mouse)
    return source


def test_of_hidapi(monkeypatch: pytest.MonkeyPatch) -> None:
    mouse, twin, back = (HidDevice(f"/dev/hidraw{i}", "Mouse", 0x46D, 0xC077, "", 0) for i in range(3))
    there, opened = [mouse, twin], []
    monkeypatch.setattr(hidraw, "hid_devices", lambda: list(there))
    source = quick(HidSource, there, mouse, back)
    source._device, source._handle = mouse, SimpleNamespace(close=lambda: None)
    source._open = opened.append
    source._unplug()
    source._wait_for_return()
    assert opened == [back]


def test_of_evdev(monkeypatch: pytest.MonkeyPatch) -> None:
    mouse, twin, back = (
        evdev.Node(f"/dev/input/event{i}", "Mouse", ("Mouse",), "", True, False) for i in range(3)
    )
    there, opened = [mouse, twin], []
    looks = iter(range(3))
    monkeypatch.setattr(evdev, "nodes", lambda: (next(looks), list(there))[1])  # not for ever
    source = quick(EvdevSource, there, mouse, back)
    source._node, source._file = mouse, os.open(os.devnull, os.O_RDONLY)
    source._stopped, writing = os.pipe()
    source._open = opened.append
    source._unplug(1.0)
    assert not source._wait_for_device()
    assert opened == [back.path]
    os.close(source._stopped)
    os.close(writing)
