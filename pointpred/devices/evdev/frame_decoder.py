"""Bytes of a kernel input node to reports: records of one event each, frames ended by SYN_REPORT."""

from __future__ import annotations

import struct
from collections.abc import Callable

import msgspec

from pointpred.recordings.formats.evdev_frames import (
    BUTTONS,
    EV_KEY,
    EV_REL,
    EV_SYN,
    REL_X,
    REL_Y,
    SYN_DROPPED,
    SYN_REPORT,
)

EVENT = struct.Struct("@llHHi")
"""Seconds, microseconds, type, code, value: ``qqHHi`` where a long has 64 bits."""
REL_HWHEEL, REL_WHEEL, REL_WHEEL_HI_RES, REL_HWHEEL_HI_RES = 6, 8, 11, 12
STEP = 120.0
"""High-resolution wheel units of one step."""
EV_MOST, MICROS = 0x1F, 1_000_000


class Frame(msgspec.Struct, frozen=True, gc=False):
    """What happened between two SYN_REPORT, at ``stamp_us`` on the kernel's clock; as in ``Report``."""

    stamp_us: int
    dx: int
    dy: int
    buttons: int
    wheel: float
    pan: float


class FrameDecoder:
    """Bytes in, as they happen to be cut; whole frames out.

    Assumes that the bytes begin with a record, as the kernel's reads do. After SYN_DROPPED the kernel has
    thrown events away: everything up to the next SYN_REPORT is void, the motion lost with it is not known,
    and the buttons are asked for anew.

    Parameters: ``buttons`` pressed at the beginning; ``ask`` the buttons pressed now, ``None`` where they
    cannot be told (those known then stand). Memory: one unfinished frame and less than one record.
    Counts ``resynchronised`` recoveries, ``unreadable`` records that cannot be events (their frame is void),
    and frames left ``aside`` without pointer events (a key of the keyboard).

    >>> decoder = FrameDecoder()
    >>> left = EVENT.pack(5, 250000, EV_REL, REL_X, -3) + EVENT.pack(5, 250000, EV_SYN, SYN_REPORT, 0)
    >>> decoder.feed(left[:30]), decoder.feed(left[30:])
    ([], [Frame(stamp_us=5250000, dx=-3, dy=0, buttons=0, wheel=0.0, pan=0.0)])
    """

    def __init__(self, buttons: int = 0, ask: Callable[[], int | None] = lambda: None) -> None:
        self.buttons, self._ask = buttons, ask
        self.resynchronised = self.unreadable = self.aside = 0
        self._rest = b""
        self._fine = False  # the wheel reports high-resolution steps: whole steps would count twice
        self._begin()

    def _begin(self) -> None:
        """Start a frame."""
        self._dx = self._dy = self._steps = self._sideways = self._parts = self._sideways_parts = 0
        self._useful = self._void = self._lost = False

    def feed(self, data: bytes) -> list[Frame]:
        """Take in some bytes and return the frames that they complete."""
        data = self._rest + data
        whole = len(data) - len(data) % EVENT.size
        self._rest = data[whole:]
        frames: list[Frame] = []
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
                self._parts, self._fine = self._parts + value, True
            elif code == REL_HWHEEL_HI_RES:
                self._sideways_parts, self._fine = self._sideways_parts + value, True

    def _end(self, stamp_us: int) -> Frame | None:
        """The frame that SYN_REPORT ends, if it has pointer events."""
        frame: Frame | None = None
        if self._lost:
            self.resynchronised += 1
            pressed = self._ask()
            self.buttons = self.buttons if pressed is None else pressed
            frame = Frame(stamp_us, 0, 0, self.buttons, 0.0, 0.0)
        elif self._useful and not self._void:
            wheel = self._parts / STEP if self._fine else float(self._steps)
            pan = self._sideways_parts / STEP if self._fine else float(self._sideways)
            frame = Frame(stamp_us, self._dx, self._dy, self.buttons, wheel, pan)
        elif not self._void:
            self.aside += 1
        self._begin()
        return frame


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
