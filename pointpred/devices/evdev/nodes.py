"""Which input nodes there are, what they are called, and what to do where one cannot be opened.

Names and abilities come from sysfs, which anyone may read: a node that is closed to the user has them too.
"""

from __future__ import annotations

import errno
import os
import re
import stat
import sys
from pathlib import Path

import msgspec

from pointpred.devices.source import DeviceInfo
from pointpred.devices.udev import permission_advice
from pointpred.errors import SourceError
from pointpred.recordings.formats.evdev_frames import REL_X, REL_Y

NODES, CLASS = Path("/dev/input"), Path("/sys/class/input")
BOTH = 1 << REL_X | 1 << REL_Y
BROWSER = "open the live page in a browser instead: it sends the pointer's motion to 'pointpred serve'"


class Node(msgspec.Struct, frozen=True):
    """An input node and what makes it the same device when it comes back (``identity``).

    ``relative`` and ``absolute``: whether it moves by counts or tells places; ``None`` where sysfs is silent.
    """

    path: str
    name: str
    identity: tuple[str, ...]
    vendor: str
    relative: bool | None
    absolute: bool | None


def nodes() -> list[Node]:
    """Every ``/dev/input/event*`` in the order of its number."""
    try:
        names = [path.name for path in NODES.iterdir() if re.fullmatch(r"event\d+", path.name)]
    except OSError:
        return []
    return [node(str(NODES / name)) for name in sorted(names, key=lambda name: int(name[5:]))]


def node(path: str) -> Node:
    """The sysfs description of one node; a link such as those of ``/dev/input/by-id`` is followed."""
    device = CLASS / Path(path).resolve().name / "device"
    name, *ids = (
        _line(device / part)
        for part in ("name", "id/bustype", "id/vendor", "id/product", "id/version", "uniq")
    )
    return Node(
        path,
        name or Path(path).name,
        (name, *ids),
        ids[1],
        _has_both(_line(device / "capabilities/rel")),
        _has_both(_line(device / "capabilities/abs")),
    )


def list_evdev() -> list[DeviceInfo]:
    """The nodes of pointing devices; one that cannot be opened says why, and what to do next.

    Left out are nodes that sysfs says move nothing: keyboards, switches, sound jacks.
    """
    return [device_info(each) for each in nodes() if each.relative is not False or each.absolute]


def device_info(each: Node) -> DeviceInfo:
    """One node, tried."""
    if each.relative is False:
        why = "it tells absolute positions (a touchpad, tablet or touch screen), no counts"
        return DeviceInfo(each.path, each.name, "evdev", False, why, f"{BROWSER}.")
    try:
        os.close(open_node(each.path))
    except OSError as error:
        return DeviceInfo(each.path, each.name, "evdev", False, _why(error), advice(each, error))
    return DeviceInfo(each.path, each.name, "evdev", True)


def open_node(path: str) -> int:
    """A descriptor that reads a node without waiting; raises OSError, also where there is no device."""
    file = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
    if not stat.S_ISCHR(os.fstat(file).st_mode):
        os.close(file)
        raise OSError(errno.ENOTTY, "it is no character device, expected an input node", path)
    return file


def rule(each: Node) -> str:
    """The udev rule that gives the user at the screen access to this device."""
    vendor = f', ATTRS{{id/vendor}}=="{each.vendor}"' if each.vendor else ""
    return f'KERNEL=="event*", SUBSYSTEM=="input"{vendor}, ENV{{ID_INPUT_MOUSE}}=="1", TAG+="uaccess"'


def advice(each: Node, error: OSError) -> str:
    """What to do about an error of opening."""
    if error.errno in (errno.EACCES, errno.EPERM):
        return permission_advice(rule(each))
    if error.errno in (errno.ENOENT, errno.ENODEV, errno.ENXIO):
        return "plug the device in; 'pointpred devices list' shows where it is."
    return f"look at the node ('ls -l {each.path}'), or {BROWSER}."


def refusal(each: Node, error: OSError) -> SourceError:
    """The error of a node that cannot be opened."""
    return SourceError(f"{each.path} ({each.name}): {_why(error)}; {advice(each, error)}")


def check(path: str) -> Node:
    """What a node is, before it is opened; raises SourceError where it can be no pointing device."""
    if not sys.platform.startswith("linux"):
        raise SourceError(f"{path}: evdev exists on Linux only, this is {sys.platform}; {BROWSER}.")
    each = node(path)
    if not re.fullmatch(r"event\d+", Path(path).resolve().name):  # mouse0, mice: another protocol
        raise SourceError(
            f"{path}: no node of input events, expected /dev/input/event* as in 'pointpred devices list'."
        )
    if each.relative is False:
        raise SourceError(
            f"{path} ({each.name}): it sends no relative motion, expected REL_X and REL_Y; choose another of "
            "'pointpred devices list'."
        )
    return each


def _why(error: OSError) -> str:
    return error.strerror or str(error)


def _line(path: Path) -> str:
    """The text of an attribute, empty where it is missing or closed."""
    try:
        return path.read_text(encoding="utf-8", errors="replace").strip()
    except OSError:
        return ""


def _has_both(words: str) -> bool | None:
    """Whether a bitmap, hexadecimal words with the lowest last, has both bits 0 and 1."""
    try:
        return int(words.split()[-1], 16) & BOTH == BOTH
    except (IndexError, ValueError):
        return None
