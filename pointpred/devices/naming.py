"""Which device is meant by what a person types: a path, a short name, a link, or a part of its name."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from pointpred.devices.source import Found
from pointpred.errors import SourceError

LINKS = (Path("/dev/input/by-id"), Path("/dev/input/by-path"))
"""Where udev keeps links to input nodes."""


def path_of(name: str, listed: Sequence[Found]) -> str:
    """The path of the device that ``name`` means among those ``listed``.

    ``event3`` and ``hidraw0`` are nodes of /dev; a link is followed, one of /dev/input/by-id also without its
    folder. Anything else is a part of a device's name, in any case of letters; a whole name goes before a
    part, a device that can be opened before one that cannot, and of one device's two nodes evdev is taken.
    Raises SourceError, which names what there is, where no device or more than one fits.

    >>> mice = [Found("/dev/input/event4", "Plain Mouse", "evdev", True)]
    >>> path_of("event7", mice), path_of("plain", mice)
    ('/dev/input/event7', '/dev/input/event4')
    """
    if re.fullmatch(r"event\d+", name):
        return f"/dev/input/{name}"
    if re.fullmatch(r"hidraw\d+", name):
        return f"/dev/{name}"
    if any(one.path == name for one in listed):
        return name
    for link in (Path(name), *(folder / name for folder in LINKS)):
        if name and link.is_absolute() and (link.exists() or link == Path(name)):
            return _followed(link)
    fit = _meant(name.casefold(), listed)
    if len(fit) == 1:
        return fit[0].path
    if fit:
        raise SourceError(f"{name!r} names {len(fit)} devices: {_told(fit)}; give the path of one of them")
    raise SourceError(
        f"{name!r} names no device; there are: {_told(listed) or 'none'}; see 'pointpred devices list'"
    )


def _followed(link: Path) -> str:
    """The node that a link leads to; links to input nodes stay, they name the same device when it returns."""
    node = link.resolve()
    return str(node) if re.fullmatch(r"hidraw\d+", node.name) else str(link)


def _meant(name: str, listed: Sequence[Found]) -> list[Found]:
    """The devices whose names fit, of the best kind of fit that there is."""
    whole = [one for one in listed if one.name.casefold() == name]
    fit = whole or [one for one in listed if name and name in one.name.casefold()]
    fit = [one for one in fit if one.openable] or fit
    return [one for one in fit if one.kind == "evdev"] or fit


def _told(devices: Sequence[Found]) -> str:
    return ", ".join(f"{one.path} ({one.name})" for one in devices)
