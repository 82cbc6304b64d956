"""Which device is read: the one that a name means, or the first mouse that moves."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from pointpred.devices.evdev import EvdevSource, list_evdev
from pointpred.devices.first_moving import Candidate, FirstMoving
from pointpred.devices.hidraw import HidSource, list_hid
from pointpred.devices.lsl import LslInlet
from pointpred.devices.screen_cursor import NAME, CursorSource, system_cursor
from pointpred.devices.source import BROWSER, DeviceInfo, DeviceSource
from pointpred.errors import SourceError

LINKS = (Path("/dev/input/by-id"), Path("/dev/input/by-path"))
"""Where udev keeps links to input nodes."""
STREAM = "lsl:"
"""Before the name of a stream of Lab Streaming Layer."""
Warn = Callable[[str], None]


def choose(name: str | None, warn: Warn | None = None) -> DeviceSource:
    """The device that a name means, or the first that moves of those that can be read; not yet open.

    ``cursor`` is the screen's cursor, the only choice on systems that let no program read a mouse;
    ``lsl:NAME`` is a stream of Lab Streaming Layer. ``warn`` is told where only some kinds of devices can be
    listed. Raises SourceError that says what to do next.
    """
    if name is not None and name.startswith(STREAM):
        return LslInlet(name.removeprefix(STREAM))
    if name == NAME or (name is None and sys.platform != "linux"):
        return CursorSource(system_cursor)
    if name is not None:
        return _source(device_path(name, [] if _is_path(name) else list_mice(warn=warn)))
    mice = list_mice(warn=warn)
    if not any(one.openable for one in mice):
        raise SourceError(_nothing_openable(mice), code="no_device")
    devices = [mice]  # the first call of candidates need not list them again

    def candidates() -> list[Candidate]:
        return [
            Candidate(one.path, partial(_source, one.path))
            for one in once_each(devices.pop() if devices else list_mice())
        ]

    source = FirstMoving(candidates)
    source.closed = tuple(one for one in mice if not one.openable)
    return source


def list_mice(everything: bool = False, warn: Warn | None = None) -> list[DeviceInfo]:
    """Mice by evdev, then by hidraw; ``everything``: also HID devices that are no mice.

    Without hidapi those by evdev alone, and ``warn`` is told. Raises SourceError on systems on which no
    program can read mice.
    """
    try:
        mice = list_hid(everything)
    except SourceError as error:
        if sys.platform != "linux":
            raise
        if warn is not None:
            warn(str(error))
        mice = []
    return [*list_evdev(), *mice]


def once_each(devices: Sequence[DeviceInfo]) -> list[DeviceInfo]:
    """The devices that can be opened; of a mouse listed by evdev and by hidraw, the former."""
    openable = [one for one in devices if one.openable]
    nodes = [_sysfs("input", one) for one in openable if one.kind == "evdev"]
    return [
        one
        for one in openable
        if one.kind == "evdev" or not any(_sysfs("hidraw", one) in node.parents for node in nodes)
    ]


def device_path(name: str, devices: Sequence[DeviceInfo]) -> str:
    """The path of the device that ``name`` means among those ``listed``.

    ``event3`` and ``hidraw0`` are nodes of /dev; a link is followed, one of /dev/input/by-id also without its
    folder. Anything else is a part of a device's name, in any case of letters; a whole name goes before a
    part, a device that can be opened before one that cannot, and of one device's two nodes evdev is taken.
    Raises SourceError, which names the devices there are, where none or more than one fits.

    >>> mice = [DeviceInfo("/dev/input/event4", "Plain Mouse", "evdev", True)]
    >>> device_path("event7", mice), device_path("plain", mice)
    ('/dev/input/event7', '/dev/input/event4')
    """
    if re.fullmatch(r"event\d+", name):
        return f"/dev/input/{name}"
    if re.fullmatch(r"hidraw\d+", name):
        return f"/dev/{name}"
    if any(one.path == name for one in devices):
        return name
    for link in (Path(name), *(folder / name for folder in LINKS)):
        if name and link.is_absolute() and (link.exists() or link == Path(name)):
            return _follow_link(link)
    matches = _matches(name.casefold(), devices)
    if len(matches) == 1:
        return matches[0].path
    if matches:
        raise SourceError(
            f"{name!r} names {len(matches)} devices: {_names(matches)}; give the path of one of them",
            code="ambiguous_device",
            value=name,
        )
    raise SourceError(
        f"{name!r} names no device; there are: {_names(devices) or 'none'}; see 'pointpred devices list'",
        code="unknown_device",
        value=name,
    )


def _is_path(name: str) -> bool:
    """Whether a name can be understood without a list of devices, which not every system has."""
    return name.startswith("/") or name.rstrip("0123456789") in ("event", "hidraw")


def _source(path: str) -> DeviceSource:
    return EvdevSource(path) if "/input/" in path else HidSource(path)


def _sysfs(kind: str, one: DeviceInfo) -> Path:
    """Where the kernel describes the HID device of a hidraw node, or an input node, which lies below it."""
    node = Path("/sys/class", kind, Path(one.path).name)
    return (node / "device" if kind == "hidraw" else node).resolve()


def _nothing_openable(mice: Sequence[DeviceInfo]) -> str:
    """Why no device can be read, and what to do next."""
    if not mice:
        return f"no mouse was found; plug one in and see 'pointpred devices list'. Otherwise {BROWSER}"
    reasons = [f"{one.path} ({one.name}): {one.why}; {one.advice or BROWSER}" for one in mice]
    return "\n  ".join(["no mouse can be read:", *reasons])


def _follow_link(link: Path) -> str:
    """The node that a link leads to; links to input nodes stay, they name the same device when it returns."""
    node = link.resolve()
    return str(node) if re.fullmatch(r"hidraw\d+", node.name) else str(link)


def _matches(name: str, devices: Sequence[DeviceInfo]) -> list[DeviceInfo]:
    """The devices whose names fit best: whole before part, openable before closed, evdev before hidraw."""
    whole = [one for one in devices if one.name.casefold() == name]
    matches = whole or [one for one in devices if name and name in one.name.casefold()]
    matches = [one for one in matches if one.openable] or matches
    return [one for one in matches if one.kind == "evdev"] or matches


def _names(devices: Sequence[DeviceInfo]) -> str:
    return ", ".join(f"{one.path} ({one.name})" for one in devices)
