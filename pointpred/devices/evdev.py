"""Mice through the kernel's input nodes, ``/dev/input/event*``: which there are, and what they send.

Names and abilities come from sysfs, which anyone may read: a node that is closed to the user has them too.
"""

from __future__ import annotations

import errno
import os
import re
import select
import stat
import struct
import sys
import time
from collections.abc import Callable
from math import inf
from pathlib import Path
from typing import Self

import msgspec

from pointpred.devices.source import MOST_WAITING, DeviceInfo, PlaceReports, ReaderSource, Report
from pointpred.devices.surface import OWN_UNITS, Place
from pointpred.devices.udev import permission_advice
from pointpred.errors import SourceError
from pointpred.recordings.formats.evdev_contacts import (
    ABS_MT_POSITION_X,
    ABS_MT_POSITION_Y,
    ABS_X,
    ABS_Y,
    BTN_TOOL_PEN,
    EV_KEY,
    EV_REL,
    EV_SYN,
    INPUT_PROP_DIRECT,
    MICE,
    NO_POINTER,
    REL_X,
    REL_Y,
    EvdevAbout,
    EvdevContacts,
    bits_of,
)
from pointpred.recordings.formats.evdev_frames import (
    BUTTONS,
    SYN_DROPPED,
    SYN_REPORT,
)

EVIOCSCLOCKID = 0x400445A0
"""_IOW('E', 0xa0, int): the clock that stamps what this file reads."""
CLOCK_MONOTONIC = 1
APART_S = 1.0
"""A stamp further than this from the clock at the read was made after somebody had set the clock."""
MONOTONIC = "the kernel's stamps, monotonic clock"
REAL_TIME = (
    "the kernel's stamps, real-time clock (it refused the steady one): set right at the first report, and "
    "again whenever somebody sets that clock"
)

EVENT = struct.Struct("@llHHi")
"""Seconds, microseconds, type, code, value: ``qqHHi`` where a long has 64 bits."""
REL_HWHEEL, REL_WHEEL, REL_WHEEL_HI_RES, REL_HWHEEL_HI_RES = 6, 8, 11, 12
STEP = 120.0
"""High-resolution wheel units of one step."""
EV_MOST, MICROS = 0x1F, 1_000_000

NODES, CLASS = Path("/dev/input"), Path("/sys/class/input")
BROWSER = "open the live page in a browser instead: it sends the pointer's motion to 'pointpred serve'"

EVIOCGKEY = 0x80604518
"""_IOC(read, 'E', 0x18, 96): the keys pressed, a bit each."""
KEY_BYTES = 96
EVIOCGABS = 0x80184540
"""_IOC(read, 'E', 0x40 + axis, 24): value, least, most, fuzz, flat, units in a mm."""
ABSINFO = struct.Struct("@6i")
AT_ONCE = 256 * EVENT.size
WATCH_S = 0.25
"""How often a node is looked for: one that is gone, or one that should come back."""


class Clock:
    """Stamps in microseconds in, seconds that never run backwards out.

    A node whose kernel refuses the monotonic clock stamps with the real-time clock, which may be set: the
    difference is taken at the first report and made smaller whenever a stamp would lie in the future, so it
    is wrong by the shortest time that a reading took; anew (``steps`` counts) when a stamp runs backwards or
    lies more than 1 s from the expected one.

    >>> clock = Clock()
    >>> clock.seconds(1_700_000_000_000_000, now=50.0), clock.seconds(1_700_000_000_008_000, now=50.0085)
    (50.0, 50.008)
    >>> clock.seconds(1_600_000_000_000_000, now=50.016), clock.steps  # somebody set the clock
    (50.016, 1)
    """

    def __init__(self) -> None:
        self.words, self.steps, self.last = REAL_TIME, 0, -inf
        self._ahead_us: int | None = None
        self._monotonic = False

    def ask(self, file: int) -> None:
        """Ask an open node for the monotonic clock."""
        self._monotonic, self._ahead_us = _granted(file), None
        self.words = MONOTONIC if self._monotonic else REAL_TIME

    def seconds(self, stamp_us: int, now: float) -> float:
        """The time of a stamp that was read at ``now`` s on the monotonic clock."""
        t = stamp_us / 1e6 if self._monotonic else self._moved(stamp_us, now)
        self.last = max(t, self.last)
        return self.last

    def _moved(self, stamp_us: int, now: float) -> float:
        """A stamp of the real-time clock on the monotonic one."""
        if self._ahead_us is not None:
            t = (stamp_us - self._ahead_us) / 1e6
            if t >= self.last and now - APART_S <= t <= now:
                return t
            self.steps += not now < t <= now + APART_S
        self._ahead_us = stamp_us - round(now * 1e6)
        return (stamp_us - self._ahead_us) / 1e6


def _granted(file: int) -> bool:
    """Whether the kernel stamps with the monotonic clock from now on."""
    if sys.platform == "win32":
        return False
    import fcntl

    try:
        fcntl.ioctl(file, EVIOCSCLOCKID, struct.pack("i", CLOCK_MONOTONIC))
    except OSError:
        return False
    return True


class EvdevFrame(msgspec.Struct, frozen=True, gc=False):
    """What happened between two SYN_REPORT, at ``stamp_us`` on the kernel's clock; as in ``Report``."""

    stamp_us: int
    dx: int
    dy: int
    buttons: int
    wheel: float
    pan: float
    place: Place | None = None


class FrameDecoder:
    """Bytes in, as they happen to be cut; whole frames out.

    Assumes that the bytes begin with a record, as the kernel's reads do. After SYN_DROPPED the kernel has
    thrown events away: everything up to the next SYN_REPORT is void, the motion lost with it is not known,
    and the buttons are asked for anew.

    Parameters: ``buttons`` pressed at the beginning; ``ask`` the buttons pressed now, ``None`` where they
    cannot be told (those known then stand); ``contacts`` of an absolute device, whose frames have places.
    Memory: one unfinished frame and less than one record.
    Counts ``resynchronised`` recoveries, ``unreadable`` records that cannot be events (their frame is void),
    and frames left ``aside`` without pointer events (a key of the keyboard).

    >>> decoder = FrameDecoder()
    >>> left = EVENT.pack(5, 250000, EV_REL, REL_X, -3) + EVENT.pack(5, 250000, EV_SYN, SYN_REPORT, 0)
    >>> decoder.feed(left[:30]), decoder.feed(left[30:])
    ([], [EvdevFrame(stamp_us=5250000, dx=-3, dy=0, buttons=0, wheel=0.0, pan=0.0, place=None)])
    """

    def __init__(
        self,
        buttons: int = 0,
        ask: Callable[[], int | None] = lambda: None,
        contacts: EvdevContacts | None = None,
    ) -> None:
        self.buttons, self._ask, self._contacts = buttons, ask, contacts
        self.resynchronised = self.unreadable = self.aside = 0
        self._rest = b""
        self._begin()

    def _begin(self) -> None:
        """Start a frame."""
        self._dx = self._dy = self._steps = self._sideways = self._parts = self._sideways_parts = 0
        self._useful = self._void = self._lost = False

    def feed(self, data: bytes) -> list[EvdevFrame]:
        """Take in some bytes and return the frames that they complete."""
        data = self._rest + data
        whole = len(data) - len(data) % EVENT.size
        self._rest = data[whole:]
        frames: list[EvdevFrame] = []
        for seconds, micros, kind, code, value in EVENT.iter_unpack(data[:whole]):
            if kind > EV_MOST or not 0 <= micros < MICROS:
                self.unreadable += 1
                self._void = True
            elif kind == EV_SYN and code == SYN_REPORT:
                frame = self._end(seconds * MICROS + micros)
                if frame is not None:
                    frames.append(frame)
            elif kind == EV_SYN and code == SYN_DROPPED:
                self._lost = True
            elif not self._lost:
                self._take(kind, code, value)
        return frames

    def _take(self, kind: int, code: int, value: int) -> None:
        """One event within a frame."""
        if self._contacts is not None:
            self._contacts.take(kind, code, value)
        if kind == EV_KEY and code in BUTTONS:
            bit = BUTTONS[code]
            self.buttons = self.buttons | bit if value else self.buttons & ~bit
            self._useful = True
        elif kind == EV_REL:
            self._useful = self._useful or code in RELATIVE
            if code == REL_X:
                self._dx += value
            elif code == REL_Y:
                self._dy += value
            elif code == REL_WHEEL:
                self._steps += value
            elif code == REL_HWHEEL:
                self._sideways += value
            elif code == REL_WHEEL_HI_RES:
                self._parts += value
            elif code == REL_HWHEEL_HI_RES:
                self._sideways_parts += value

    def _end(self, stamp_us: int) -> EvdevFrame | None:
        """The frame that SYN_REPORT ends, if it has pointer events."""
        frame: EvdevFrame | None = None
        if self._lost:
            self.resynchronised += 1
            asked = self._ask()
            self.buttons = self.buttons if asked is None else asked
            place = self._contacts.lost() if self._contacts is not None else None
            frame = EvdevFrame(stamp_us, 0, 0, self.buttons, 0.0, 0.0, place)
        elif self._contacts is not None and not self._void:
            wheel, pan = self._turned()
            place = self._contacts.end(self.buttons, wheel != 0.0 or pan != 0.0)
            if place is not None:
                frame = EvdevFrame(stamp_us, 0, 0, place.buttons, wheel, pan, place)
            else:
                self.aside += 1
        elif self._useful and not self._void:
            frame = EvdevFrame(stamp_us, self._dx, self._dy, self.buttons, *self._turned())
        elif not self._void:
            self.aside += 1
        self._begin()
        return frame

    def _turned(self) -> tuple[float, float]:
        """Steps of both wheels; a whole step beside high-resolution ones of its axis would count twice."""
        wheel = self._parts / STEP if self._parts else float(self._steps)
        return wheel, self._sideways_parts / STEP if self._sideways_parts else float(self._sideways)


RELATIVE = frozenset({REL_X, REL_Y, REL_HWHEEL, REL_WHEEL, REL_WHEEL_HI_RES, REL_HWHEEL_HI_RES})


def pressed(keys: bytes) -> int:
    r"""The buttons of a bitmap of keys, bit n of byte n // 8 as EVIOCGKEY fills it.

    >>> pressed(bytes(0x110 // 8) + b"\x03")
    3
    """
    mask = 0
    for code, bit in BUTTONS.items():
        if code // 8 < len(keys) and keys[code // 8] >> code % 8 & 1:
            mask |= bit
    return mask


class Node(msgspec.Struct, frozen=True):
    """An input node and what makes it the same device when it comes back (``identity``).

    ``relative`` and ``absolute``: whether it moves by counts or tells places; ``None`` where sysfs is silent.
    ``about``: its keys and properties; its ranges are told by the node alone.
    """

    path: str
    name: str
    identity: tuple[str, ...]
    vendor: str
    relative: bool | None
    absolute: bool | None
    about: EvdevAbout = msgspec.field(default_factory=EvdevAbout)

    @property
    def refusal(self) -> str | None:
        """Why its places are not those of a pointer; ``None`` where they are, or where it has counts."""
        if self.relative is not False:
            return None
        keyless = not self.about.keys and INPUT_PROP_DIRECT not in self.about.properties  # a sensor
        return NO_POINTER if keyless else self.about.refusal


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
        _has(_line(device / "capabilities/rel"), (REL_X, REL_Y)),
        _has(_line(device / "capabilities/abs"), (ABS_X, ABS_Y), (ABS_MT_POSITION_X, ABS_MT_POSITION_Y)),
        EvdevAbout(
            keys=set(_codes(_line(device / "capabilities/key")) or ()),
            properties=set(_codes(_line(device / "properties")) or ()),
        ),
    )


def list_evdev() -> list[DeviceInfo]:
    """The nodes of pointing devices; one that cannot be opened says why, and what to do next.

    Left out are nodes that sysfs says move nothing: keyboards, switches, sound jacks.
    """
    return [device_info(each) for each in nodes() if each.relative is not False or each.absolute]


def device_info(each: Node) -> DeviceInfo:
    """One node, tried."""
    if (refusal := each.refusal) is not None:
        return DeviceInfo(each.path, each.name, "evdev", False, refusal, f"{BROWSER}.")
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
    keys = each.about.keys if each.relative is False else set()
    kind = "TABLET" if BTN_TOOL_PEN in keys else "MOUSE" if keys & MICE else "TOUCHSCREEN"
    which = f"ENV{{ID_INPUT_{kind if keys else 'MOUSE'}}}"
    return f'KERNEL=="event*", SUBSYSTEM=="input"{vendor}, {which}=="1", TAG+="uaccess"'


def advice(each: Node, error: OSError) -> str:
    """What to do about an error of opening."""
    if error.errno in (errno.EACCES, errno.EPERM):
        return permission_advice(rule(each))
    if error.errno in (errno.ENOENT, errno.ENODEV, errno.ENXIO):
        return "plug the device in; 'pointpred devices list' shows where it is."
    return f"look at the node ('ls -l {each.path}'), or {BROWSER}."


def check_node(path: str) -> Node:
    """What a node is, before it is opened; raises SourceError where it can be no pointing device."""
    if not sys.platform.startswith("linux"):
        raise SourceError(f"{path}: evdev exists on Linux only, this is {sys.platform}; {BROWSER}.")
    each = node(path)
    if not re.fullmatch(r"event\d+", Path(path).resolve().name):  # mouse0, mice: another protocol
        raise SourceError(
            f"{path}: no node of input events, expected /dev/input/event* as in 'pointpred devices list'."
        )
    if each.relative is False:
        why = each.refusal if each.absolute else "it sends no motion, expected X and Y, relative or absolute"
        if why is not None:
            raise SourceError(f"{path} ({each.name}): {why}; choose another of 'pointpred devices list'.")
    return each


def _why(error: OSError) -> str:
    return error.strerror or str(error)


def _line(path: Path) -> str:
    """The text of an attribute, empty where it is missing or closed."""
    try:
        return path.read_text(encoding="utf-8", errors="replace").strip()
    except OSError:
        return ""


def _codes(words: str) -> list[int] | None:
    """The codes of a bitmap as sysfs writes it: hexadecimal words of a long, the lowest last."""
    long = 8 * struct.calcsize("@l")
    try:
        return bits_of(0, int("".join(word.zfill(long // 4) for word in words.split()), 16))
    except ValueError:
        return None


def _has(words: str, *pairs: tuple[int, int]) -> bool | None:
    """Whether a bitmap has both codes of one of the pairs; ``None`` where there is no bitmap."""
    codes = _codes(words)
    return None if codes is None else any({*pair} <= {*codes} for pair in pairs)


class EvdevSource(ReaderSource):
    """Reports of one input node, stamped by the kernel; the desktop keeps its device.

    Assumes Linux. A node without relative motion tells the places of its contacts or its pointer. Motion that
    the kernel dropped (SYN_DROPPED) is lost: it is counted in ``resynchronised`` and nothing is made up for
    it. The same device is known again by its name, numbers and serial; two alike without a serial are told
    apart by which one stayed.

    Parameters: ``path`` such as ``/dev/input/event5``; ``most`` reports wait, then the oldest goes first.
    Memory: the queue. Entering raises SourceError with what to do next; so does ``take`` before entering.
    """

    def __init__(self, path: str, *, most: int = MOST_WAITING) -> None:
        self.path, self.name, self.plugged = path, "", False
        super().__init__(most)
        self._clock = Clock()
        self._decoder = FrameDecoder()
        self._contacts: EvdevContacts | None = None
        self._places = PlaceReports(OWN_UNITS)
        self._file, self._stop, self._real = -1, -1, path
        self._unreadable = self._resynchronised = 0  # of devices that were here before

    def __enter__(self) -> Self:
        self._check_unused()
        self._node = check_node(self.path)
        self.name = self._node.name
        try:
            self._open(self.path)
        except OSError as error:
            why, next_step = _why(error), advice(self._node, error)
            raise SourceError(f"{self._node.path} ({self._node.name}): {why}; {next_step}") from error
        self._stopped, self._stop = os.pipe()
        self._start()
        return self

    @property
    def clock(self) -> str:
        """Which clock the kernel stamps with."""
        return self._clock.words

    @property
    def counts(self) -> bool:
        """Whether it has relative motion; known once open."""
        return not self.places

    @property
    def places(self) -> bool:
        """Whether it tells positions; known once open."""
        return self._contacts is not None

    @property
    def unreadable(self) -> int:
        """Records that cannot be events; the frame of each is void."""
        return self._unreadable + self._decoder.unreadable

    @property
    def resynchronised(self) -> int:
        """Recoveries after the kernel had dropped events."""
        return self._resynchronised + self._decoder.resynchronised

    @property
    def clock_steps(self) -> int:
        """How often a clock that may be set was set."""
        return self._clock.steps

    def close(self) -> None:
        """Stop reading; may be called twice. What was read can still be taken."""
        if self._thread is None or self._stop < 0:
            return
        os.write(self._stop, b".")
        super().close()
        os.close(self._stop)
        os.close(self._stopped)
        self._stop = -1

    def _open(self, path: str) -> None:
        """Open a node; raises OSError."""
        self._file = open_node(path)
        self.path, self._real = path, os.path.realpath(path)
        self._clock.ask(self._file)
        self._unreadable, self._resynchronised = self.unreadable, self.resynchronised
        absolute = self._node.relative is False and self._node.absolute is True
        self._contacts = self._ask_contacts() if absolute else None
        self._decoder = FrameDecoder(self._pressed() or 0, self._pressed, self._contacts)
        self.plugged = True

    def _ask_contacts(self) -> EvdevContacts:
        """Contacts on the surface whose ranges the kernel tells, with the pointer's place now."""
        about = self._node.about
        values: dict[int, int] = {}
        for axis in (ABS_X, ABS_Y, ABS_MT_POSITION_X, ABS_MT_POSITION_Y):
            if (absinfo := self._ask(EVIOCGABS + axis, ABSINFO.size)) is not None:
                values[axis], least, most, _, _, resolution = ABSINFO.unpack(absinfo)
                about.add_range(axis, least, most, resolution)
        contacts = EvdevContacts(about)
        keys = self._ask(EVIOCGKEY, KEY_BYTES) or b""
        contacts.set_pointer(values.get(ABS_X), values.get(ABS_Y), bits_of(0, int.from_bytes(keys, "little")))
        self._places = PlaceReports(about.surface)
        return contacts

    def _pressed(self) -> int | None:
        """The buttons pressed now; ``None`` where the kernel does not say."""
        keys = self._ask(EVIOCGKEY, KEY_BYTES)
        return None if keys is None else pressed(keys)

    def _ask(self, request: int, size: int) -> bytes | None:
        """The kernel's answer to a request, ``None`` where it has none."""
        import fcntl

        try:
            return fcntl.ioctl(self._file, request, bytes(size))
        except OSError:
            return None

    def _read_all(self) -> None:
        """Read while the device is there, wait while it is not."""
        while not (self._read_device() if self.plugged else self._wait_for_device()):
            pass

    def _close_device(self) -> None:
        if self.plugged:
            os.close(self._file)

    def _read_device(self) -> bool:
        """Read until the device is gone (false) or the source is closed (true)."""
        looked = time.monotonic()
        while True:
            ready, _, _ = select.select([self._file, self._stopped], [], [], WATCH_S)
            if self._stopped in ready:
                return True
            now = time.monotonic()
            try:
                data = os.read(self._file, AT_ONCE) if ready else None
            except BlockingIOError:
                data = None
            except OSError:  # ENODEV, or another error of a vanished device
                data = b""
            if data == b"" or (now - looked >= WATCH_S and not Path(self.path).exists()):
                self._unplug(now)
                return False
            if data:
                self._put(self._decoder.feed(data), now)
            looked = now if now - looked >= WATCH_S else looked

    def _put(self, frames: list[EvdevFrame], now: float) -> None:
        """Queue what was read at ``now``."""
        for frame in frames:
            t = self._clock.seconds(frame.stamp_us, now)
            if self._contacts is not None:
                if frame.place is not None:
                    self._queue.put(self._places.report(t, frame.place, frame.wheel, frame.pan))
                continue
            self._queue.put(Report(t, frame.dx, frame.dy, frame.buttons, frame.wheel, frame.pan))

    def _unplug(self, now: float) -> None:
        """The device has gone: it presses nothing any more.

        The devices like it are listed before the unplugging is reported, so that later arrivals can be told
        apart.
        """
        self._twins = self._alike() - {self._real}
        os.close(self._file)
        self.plugged = False
        if self._contacts is not None:
            if (place := self._contacts.lost()) is not None:
                self._queue.put(self._places.report(max(now, self._clock.last), place))
        elif self._decoder.buttons:
            self._queue.put(Report(max(now, self._clock.last), 0, 0))

    def _alike(self) -> set[str]:
        """The nodes of devices that cannot be told from this one."""
        return {each.path for each in nodes() if each.identity == self._node.identity}

    def _wait_for_device(self) -> bool:
        """Look for the device until it is back (false) or the source is closed (true)."""
        while not select.select([self._stopped], [], [], WATCH_S)[0]:
            present = self._alike()
            self._twins &= present
            for path in sorted(present - self._twins):
                try:
                    self._open(path)
                except OSError:  # not there any more, or not opened to us yet: udev comes later
                    continue
                return False
        return True
