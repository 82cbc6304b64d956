"""Absolute devices by the kernel's input events: what a device says of itself, and where its contact is."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

import msgspec

from pointpred.devices.surface import ALWAYS, OWN_UNITS, TOUCH_PAD, Axis, ContactPath, Place, Surface

EV_SYN, EV_KEY, EV_REL, EV_ABS = range(4)
SYN_MT_REPORT = 2
REL_X, REL_Y = 0, 1
ABS_X, ABS_Y = 0, 1
ABS_MT_SLOT, ABS_MT_POSITION_X, ABS_MT_POSITION_Y, ABS_MT_TRACKING_ID = 0x2F, 0x35, 0x36, 0x39
BTN_TOOL_PEN, BTN_TOOL_FINGER, BTN_TOUCH, BTN_STYLUS = 0x140, 0x145, 0x14A, 0x14B
TOOLS = frozenset(range(0x140, 0x148)) - {BTN_TOOL_FINGER}
"""Pens, brushes and lens cursors, which say when they come near and go."""
MICE = frozenset(range(0x110, 0x118))
CONTACT_KEYS = TOOLS | {BTN_TOUCH, BTN_STYLUS}
INPUT_PROP_DIRECT = 1
"""A device whose surface is a screen."""
MOST_SLOTS = 256
UNNUMBERED = 1 << 32
"""The number of a contact whose beginning was not seen."""
NO_POINTER = "its absolute positions are not a pointer's, expected a mouse's buttons, a pen or touch"


def bits_of(first: int, bits: int) -> list[int]:
    """The codes of a bitmap whose lowest bit is ``first``.

    >>> bits_of(0x110, 0b101)
    [272, 274]
    """
    return [first + place for place in range(bits.bit_length()) if bits >> place & 1]


class EvdevAbout(msgspec.Struct):
    """What a device says of itself: ranges of absolute axes; relative axes, keys, properties; or nothing."""

    ranges: dict[int, Axis] = {}
    relative: set[int] = set()
    keys: set[int] = set()
    properties: set[int] = set()

    def add_range(self, code: int, least: int, most: int, resolution: int) -> None:
        """The range of an axis and its units in a mm, 0 where unknown; an empty range says nothing."""
        if least < most:
            self.ranges[code] = Axis(least, most, (most - least) / resolution if resolution > 0 else 0.0)

    def add_codes(self, kind: int, codes: Iterable[int]) -> None:
        """Codes of events of a kind that it has."""
        if kind == EV_KEY:
            self.keys.update(codes)
        elif kind == EV_REL:
            self.relative.update(codes)

    @property
    def counts(self) -> bool:
        """Whether it says that it moves by counts, as a mouse with a touch surface does."""
        return {REL_X, REL_Y} <= self.relative

    @property
    def surface(self) -> Surface:
        """The surface of contacts, or of the pointer where it has no axes for contacts."""
        for x, y in ((ABS_MT_POSITION_X, ABS_MT_POSITION_Y), (ABS_X, ABS_Y)):
            if x in self.ranges and y in self.ranges:
                return Surface(self.ranges[x], self.ranges[y])
        return OWN_UNITS

    @property
    def refusal(self) -> str | None:
        """Why its positions are not those of a pointer; ``None`` where they are, or nothing is known.

        As udev tells touch pads, tablets, touch screens and absolute mice apart.
        """
        if not self.keys and not self.ranges:
            return None
        direct = INPUT_PROP_DIRECT in self.properties
        if BTN_TOOL_FINGER in self.keys and BTN_TOOL_PEN not in self.keys and not direct:
            return TOUCH_PAD
        return None if direct or self.keys & (CONTACT_KEYS | MICE) else NO_POINTER


class _Slot(msgspec.Struct):
    """A contact: its number, ``None`` where it is up; its place, as far as it is known."""

    number: int | None = None
    known: bool = False
    x: int | None = None
    y: int | None = None


class EvdevContacts:
    """The place of the first contact of a device, or of its pointer, from frame to frame.

    Assumes that a pen says when it comes and goes (BTN_TOOL_PEN and others) and a finger when it touches, by
    BTN_TOUCH or by the number of its contact; what says neither is a mouse. A contact is followed until it
    is lifted; then the next one begins. Contacts come in slots or, in old drivers, all in each frame
    (SYN_MT_REPORT). Memory: the slots.
    """

    def __init__(self, about: EvdevAbout) -> None:
        self.about = about
        self._path = ContactPath()
        self._pointer = _Slot()
        self._slots: defaultdict[int, _Slot] = defaultdict(_Slot)
        self._slot = 0
        self._listed: list[_Slot] | None = None
        self._lists = False
        self._keys: dict[int, int] = {}
        self._shown: Place | None = None
        self._surface: Surface | None = None

    def set_pointer(self, x: int | None, y: int | None, pressed: Iterable[int]) -> None:
        """The place and the pressed keys of a device that is opened."""
        self._pointer.x, self._pointer.y = x, y
        self._keys.update((code, 1) for code in pressed if code in CONTACT_KEYS)

    def take(self, kind: int, code: int, value: int) -> None:
        """One event within a frame."""
        if kind == EV_ABS:
            self._take_axis(code, value)
        elif kind == EV_KEY and code in CONTACT_KEYS:
            self._keys[code] = value
        elif kind == EV_SYN and code == SYN_MT_REPORT:
            one = self._slots.pop(0, None)
            self._listed, self._lists = self._listed or [], True
            if one is not None and len(self._listed) < MOST_SLOTS:
                self._listed.append(one)

    def _take_axis(self, code: int, value: int) -> None:
        if code == ABS_X:
            self._pointer.x = value
        elif code == ABS_Y:
            self._pointer.y = value
        elif code == ABS_MT_SLOT:
            self._slot = value % MOST_SLOTS
        elif code in (ABS_MT_POSITION_X, ABS_MT_POSITION_Y, ABS_MT_TRACKING_ID):
            slot = self._slots[self._slot]
            if code == ABS_MT_TRACKING_ID:
                slot.number, slot.known = value if value >= 0 else None, True
            elif code == ABS_MT_POSITION_X:
                slot.x = value
            else:
                slot.y = value
            if not slot.known:
                slot.number = UNNUMBERED

    def end(self, pressed: int, again: bool = False) -> Place | None:
        """The place at the end of a frame, beside the mouse's buttons; ``None`` where nothing is new.

        ``again``: the place is wanted though it is that of before, for a wheel that was turned there.
        """
        if self._lists and self._listed is None and self._keys.get(BTN_TOUCH) != 0:
            return None  # a frame of something else
        there = self._there()
        self._listed = None
        number = self._path.contact
        slot = there.get(number) if number is not None else None
        if slot is None:
            if (released := self._path.lifted()) is not None:
                self._shown = released
                return released
            number, slot = next(iter(there.items()), (None, None))
        if number is None or slot is None or slot.x is None or slot.y is None:
            return None
        touches = self._keys.get(BTN_TOUCH, int(slot is not self._pointer))
        buttons = pressed | (touches > 0) | 2 * (self._keys.get(BTN_STYLUS, 0) > 0)
        surface = self._surface = self._surface or self.about.surface
        place = self._path.at(number, surface.x.share(slot.x), surface.y.share(slot.y), buttons)
        if place == self._shown and not again:
            return None
        self._shown = place._replace(begins=False)
        return place

    def lost(self) -> Place | None:
        """Events were lost: nothing touches until it does anew. The last place, if buttons were pressed."""
        self._slots.clear()
        self._listed = None
        self._keys.update((code, 0) for code in self._keys.keys() - TOOLS)
        return self._path.lifted()

    def _there(self) -> dict[int, _Slot]:
        """The contacts that are there, by their numbers."""
        tools = [value for code, value in self._keys.items() if code in TOOLS]
        touch = self._keys.get(BTN_TOUCH)
        away = not any(tools) if tools else touch == 0
        if self._listed is not None:
            return {one.number or 0: one for one in reversed(self._listed) if one.x is not None}
        if self._slots:
            slots = self._slots.values()
            return {} if away else {one.number: one for one in slots if one.number is not None}
        if away:
            return {}
        return {ALWAYS if touch is None and not tools else 0: self._pointer}
