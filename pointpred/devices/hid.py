"""HID report descriptors and reports: where motion or positions, wheels and buttons lie, and their values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import msgspec

from pointpred.devices.surface import (
    ALWAYS,
    TOUCH_PAD,
    Axis,
    ContactReports,
    Place,
    ReportContact,
    Surface,
)
from pointpred.errors import RecordingError

MAIN, GLOBAL, LOCAL = 0, 1, 2
"""Types of items; the fourth is reserved."""
LONG_ITEM = 0xFE

GENERIC_DESKTOP, BUTTON, CONSUMER, DIGITIZER = 0x01, 0x09, 0x0C, 0x0D
AXES = {
    GENERIC_DESKTOP << 16 | 0x30: "x",
    GENERIC_DESKTOP << 16 | 0x31: "y",
    GENERIC_DESKTOP << 16 | 0x38: "wheel",
    CONSUMER << 16 | 0x238: "pan",
}
"""Usages of the relative axes that are read; the last is AC Pan, the horizontal wheel."""
BUTTONS = {BUTTON << 16 | usage: bit for usage, bit in {1: 1, 2: 2, 3: 4, 4: 8, 5: 16}.items()}
"""HID buttons 1 (primary), 2 (secondary), 3 (middle), 4, 5 -> bits of W3C pointer events."""
TIP, IN_RANGE, BARREL, CONTACT = "tip", "in range", "barrel", "contact"
POSITIONS = {
    GENERIC_DESKTOP << 16 | 0x30: "x",
    GENERIC_DESKTOP << 16 | 0x31: "y",
    DIGITIZER << 16 | 0x32: IN_RANGE,
    DIGITIZER << 16 | 0x42: TIP,
    DIGITIZER << 16 | 0x44: BARREL,
    DIGITIZER << 16 | 0x51: CONTACT,
}
"""Usages that are read of an absolute device; the last is the number of a contact."""
POINTERS = frozenset(
    {
        *(GENERIC_DESKTOP << 16 | usage for usage in (0x01, 0x02)),
        *(DIGITIZER << 16 | usage for usage in (0x01, 0x02, 0x03, 0x04, 0x06, 0x0C)),
    }
)
"""Applications whose absolute x and y are a pointer's: pointer, mouse; digitizer, pen, light pen, touch
screen, white board, multiple point digitizer."""
PAD, SCREEN, FINGER = DIGITIZER << 16 | 0x05, DIGITIZER << 16 | 0x04, DIGITIZER << 16 | 0x22
INPUT, COLLECTION, END_COLLECTION = 0x8, 0xA, 0xC
APPLICATION = 1
CONSTANT, VARIABLE, RELATIVE, NULL_STATE = 1, 2, 4, 64
LENGTHS_MM = {0x11: 10.0, 0x13: 25.4}
"""Units of length: centimetre and inch."""
LONGEST, MOST_BITS, MOST_FIELDS = 4096, 256, 12288
"""Bounds of the Linux kernel on a descriptor (bytes), a field (bits) and the fields of an item."""
LONGEST_REPORT = 16384
WIDEST = 32
"""Bits of the widest field that is read."""
MOST_EXPONENT = 127
"""Bound on a unit's power of ten."""


def bad_descriptor(message: str, at: int) -> RecordingError:
    """The error about a descriptor whose byte ``at`` is wrong."""
    return RecordingError(message, code="bad_descriptor", field="report_descriptor", value=at)


class DescriptorItem(NamedTuple):
    """A short item: the byte where it begins, its tag and type, its value both ways, its bytes of data."""

    at: int
    tag: int
    kind: int
    unsigned: int
    signed: int
    size: int


def short_items(data: bytes) -> Iterator[DescriptorItem]:
    """Every short item of a descriptor; long items are skipped.

    Raises RecordingError, naming the byte, when the descriptor ends inside an item.
    Reference: USB HID 1.11, sections 6.2.2.1 to 6.2.2.3.

    >>> [(item.tag, item.kind, item.signed) for item in short_items(bytes([0x15, 0x81]))]
    [(1, 1, -127)]
    """
    at = 0
    while at < len(data):
        prefix = data[at]
        long = prefix == LONG_ITEM
        size = (0, 1, 2, 4)[prefix & 3]
        if long:  # its size, a long tag, and so many bytes
            size = 2 + data[at + 1] if at + 1 < len(data) else 2
        value = data[at + 1 : at + 1 + size]
        if len(value) < size:
            raise bad_descriptor(f"report descriptor ends inside the item at byte {at}", at)
        if not long:
            unsigned, signed = int.from_bytes(value, "little"), int.from_bytes(value, "little", signed=True)
            yield DescriptorItem(at, prefix >> 4, prefix >> 2 & 3, unsigned, signed, size)
        at += 1 + size


class ReportValues(NamedTuple):
    """Values of a report: counts moved, pressed buttons (W3C bits), and steps of the two wheels.

    ``mask`` holds the bits of every button that the report has a field for; the others are unchanged.
    """

    dx: int
    dy: int
    buttons: int
    mask: int
    wheel: int
    pan: int


class PositionValues(NamedTuple):
    """Values of a report of an absolute device: its ID, its contacts, and the rest as in ``ReportValues``."""

    report: int
    contacts: tuple[ReportContact, ...]
    buttons: int
    mask: int
    wheel: int
    pan: int


class ReportField(msgspec.Struct, frozen=True):
    """``bits`` bits from bit ``first`` of a report (its ID byte included), two's complement where signed."""

    first: int
    bits: int
    signed: bool

    def value(self, report: int) -> int:
        """The field's value in a report read as one little-endian number."""
        shift, mask, sign = self.parts()
        return (report >> shift & mask ^ sign) - sign

    def parts(self) -> tuple[int, int, int]:
        """Shift s, mask m and sign bit g: the value is ``(report >> s & m ^ g) - g``."""
        return self.first, (1 << self.bits) - 1, 1 << (self.bits - 1) if self.signed else 0


ABSENT = (0, 0, 0)


class ContactLayout(msgspec.Struct, frozen=True):
    """Where a contact lies in a report.

    ``surface``: the ranges of x and y; ``bounded``: values outside them say that nothing is there.
    ``finger``: it is there while it touches, by its tip switch; another contact while it is in range.
    """

    x: ReportField
    y: ReportField
    surface: Surface
    bounded: bool
    finger: bool
    tip: ReportField | None
    in_range: ReportField | None
    number: ReportField | None

    def of(self, report: int) -> ReportContact:
        """The contact in a report read as one little-endian number."""
        x, y, axes = self.x.value(report), self.y.value(report), self.surface
        tip = 1 if self.tip and self.tip.value(report) else 0
        there = True
        if self.finger and self.tip:
            there = tip == 1
        elif self.in_range:
            there = tip == 1 or self.in_range.value(report) != 0
        if self.bounded:
            there = there and axes.x.least <= x <= axes.x.most and axes.y.least <= y <= axes.y.most
        number = ALWAYS
        if self.tip or self.in_range:
            number = self.number.value(report) if self.number else 0
        return ReportContact(number, axes.x.share(x), axes.y.share(y), there, tip)


class ReportLayout(msgspec.Struct, frozen=True):
    """The fields of one report; ``buttons`` by their bit in W3C pointer events; ``size`` in bytes."""

    size: int
    x: ReportField | None = None
    y: ReportField | None = None
    wheel: ReportField | None = None
    pan: ReportField | None = None
    buttons: dict[int, ReportField] = {}
    contacts: tuple[ContactLayout, ...] = ()

    @property
    def points(self) -> bool:
        """Whether the report has motion, a position or buttons, not wheels alone."""
        return bool(self.x or self.y or self.buttons or self.contacts)


class ReportDecoder:
    """Decodes the input reports of one device.

    ``layouts`` by report ID (0 where reports have none); ``numbered`` when the first byte is the ID;
    ``longest`` is the size in bytes of the longest input report of the device, the mouse's or another's.
    ``counts``: it has relative motion. ``surface`` is that of its positions, ``None`` where it tells none.
    """

    __slots__ = ("_plans", "counts", "layouts", "longest", "numbered", "surface")

    def __init__(self, numbered: bool, layouts: dict[int, ReportLayout], longest: int) -> None:
        self.numbered, self.layouts, self.longest = numbered, layouts, longest
        self._plans = {number: _plan(layout) for number, layout in layouts.items()}
        self.counts = any(layout.x or layout.y for layout in layouts.values())
        surfaces = [layout.contacts[0].surface for layout in layouts.values() if layout.contacts]
        self.surface = next((one for one in surfaces if one.size_mm), surfaces[0] if surfaces else None)

    def layout_of(self, report: bytes) -> ReportLayout | None:
        """The layout of a report; ``None`` for reports without motion, wheel and button."""
        return self.layouts.get(report[0] if self.numbered and report else 0)

    def decode(self, report: bytes) -> ReportValues | PositionValues | None:
        """The values of a report; ``None`` for reports without motion, position, wheel and button.

        Fields the report does not have are 0. Longer reports than described are read as described.
        Raises RecordingError when the report is shorter than its descriptor says.
        """
        number = report[0] if self.numbered and report else 0
        plan = self._plans.get(number)
        if plan is None:
            return None
        size, x, y, wheel, pan, runs, mask, contacts = plan
        if len(report) < size:
            raise RecordingError(
                f"report of {len(report)} bytes, expected {size}", code="short_report", value=len(report)
            )
        whole = int.from_bytes(report, "little")
        pressed = 0
        for shift, bits, table in runs:
            pressed |= table[whole >> shift & bits]
        if contacts:
            (s, m, g), (u, n, h) = wheel, pan
            wheels = (whole >> s & m ^ g) - g, (whole >> u & n ^ h) - h
            return PositionValues(number, tuple(one.of(whole) for one in contacts), pressed, mask, *wheels)
        s, m, g = x
        dx = (whole >> s & m ^ g) - g
        s, m, g = y
        dy = (whole >> s & m ^ g) - g
        s, m, g = wheel
        turned = (whole >> s & m ^ g) - g
        s, m, g = pan
        return ReportValues(dx, dy, pressed, mask, turned, (whole >> s & m ^ g) - g)


_Parts = tuple[int, int, int]
_Runs = tuple[tuple[int, int, tuple[int, ...]], ...]
_Plan = tuple[int, _Parts, _Parts, _Parts, _Parts, _Runs, int, tuple[ContactLayout, ...]]


def _plan(layout: ReportLayout) -> _Plan:
    """A layout as plain numbers, and its buttons as a table for each run of neighbouring bits."""
    axes = (layout.x, layout.y, layout.wheel, layout.pan)
    x, y, wheel, pan = (field.parts() if field else ABSENT for field in axes)
    mask = 1 if any(contact.tip for contact in layout.contacts) else 0
    runs: list[tuple[int, list[int]]] = []
    for bit, field in sorted(layout.buttons.items(), key=lambda item: item[1].first):
        mask |= bit
        if runs and runs[-1][0] + len(runs[-1][1]) == field.first:
            runs[-1][1].append(bit)
        else:
            runs.append((field.first, [bit]))
    tables = tuple((first, (1 << len(bits)) - 1, _table(bits)) for first, bits in runs)
    return layout.size, x, y, wheel, pan, tables, mask, layout.contacts


def _table(bits: list[int]) -> tuple[int, ...]:
    """Pressed W3C bits for every value of neighbouring one-bit buttons, the lowest bit first."""
    return tuple(
        sum(bit for place, bit in enumerate(bits) if value >> place & 1) for value in range(1 << len(bits))
    )


def place_of(contacts: ContactReports, values: ReportValues | PositionValues) -> Place | None:
    """The place that a report of an absolute device tells, which may be one of buttons alone."""
    if isinstance(values, ReportValues):
        return contacts.press(values.buttons, values.mask)
    return contacts.take(values.report, values.contacts, values.buttons, values.mask)


def parse_descriptor(data: bytes) -> ReportDecoder:
    """Read a report descriptor: where x, y, the wheels and the buttons lie in the reports.

    Assumes variable input fields of up to 32 bits; a field is signed when its logical minimum is negative.
    A report has relative x or y, or the absolute ones of a mouse, a pen or a touch screen. Array buttons are
    not taken. Output and feature reports lie apart and are skipped, the resolution multiplier of a wheel
    among them: wheels count the device's own steps.
    Raises RecordingError: code ``not_a_mouse`` for a descriptor without such x and y, a touch pad's among
    them, else ``bad_descriptor`` with the place of the wrong byte as ``value``.
    Reference: USB HID 1.11, section 6.2.2; HID Usage Tables 1.4, section 16.

    >>> head = "05010902a1010901a100"
    >>> three_buttons = "05091901290315002501950375018102950175058101"
    >>> two_bytes = "0501093009311581257f750895028106c0c0"
    >>> parse_descriptor(bytes.fromhex(head + three_buttons + two_bytes)).decode(bytes([1, 5, 0xFF]))
    ReportValues(dx=5, dy=-1, buttons=1, mask=7, wheel=0, pan=0)
    """
    if len(data) > LONGEST:
        raise bad_descriptor(f"report descriptor of {len(data)} bytes, expected at most {LONGEST}", LONGEST)
    state = _State()
    for item in short_items(data):
        if item.kind == MAIN:
            state.main(item)
        elif item.kind == GLOBAL:
            state.set_global(item)
        elif item.kind == LOCAL:
            state.set_local(item)
    if state.collections:
        left_open = len(state.collections)
        raise bad_descriptor(
            f"report descriptor ends at byte {len(data)}, {left_open} collections open", len(data)
        )
    sizes = {number: (bits + 7) // 8 for number, bits in state.reached.items()}
    if state.numbered:  # where reports are numbered, those without a number never come
        for fields in (state.axes, state.buttons, state.positions):
            fields.pop(0, None)
    relative = {number for number, axes in state.axes.items() if {"x", "y"} & axes.keys()}
    found = {number: each.layouts() for number, each in state.positions.items()}
    contacts = {number: some for number, some in found.items() if some and number not in relative}
    if not relative and not contacts:
        why = TOUCH_PAD if state.pad else "expected those of a mouse, a tablet or a touch screen"
        raise RecordingError(f"report descriptor without x and y of a pointer: {why}", code="not_a_mouse")
    layouts = {}
    for number in state.axes.keys() | state.buttons.keys() | contacts.keys():
        axes, buttons = state.axes.get(number, {}), state.buttons.get(number, {})
        x, y, wheel, pan = (axes.get(name) for name in AXES.values())
        if number in contacts and (barrel := state.positions[number].barrel):
            buttons = {2: barrel, **buttons}
        layouts[number] = ReportLayout(sizes[number], x, y, wheel, pan, buttons, contacts.get(number, ()))
    return ReportDecoder(state.numbered, layouts, max(sizes.values()))


class _Range(NamedTuple):
    """Usages ``first`` to ``last`` of a page; ``own`` where the item carried the page itself."""

    page: int
    first: int
    last: int
    own: bool


class _Contact(msgspec.Struct):
    """The absolute fields of a collection, the first of each usage, and the ranges of x and y."""

    fields: dict[str, ReportField] = {}
    axes: dict[str, Axis] = {}
    bounded: bool = False
    finger: bool = False


class _Positions(msgspec.Struct):
    """The absolute fields of a report by the collections in their application; 0: directly in that."""

    contacts: dict[int, _Contact] = {}
    barrel: ReportField | None = None

    def layouts(self) -> tuple[ContactLayout, ...]:
        """The contacts that have both x and y."""
        outside, layouts = self.contacts[0].fields if 0 in self.contacts else {}, []
        for one in self.contacts.values():
            if {"x", "y"} <= one.axes.keys():
                fields, surface = outside | one.fields, Surface(one.axes["x"], one.axes["y"])
                others = (fields.get(name) for name in (TIP, IN_RANGE, CONTACT))
                place = fields["x"], fields["y"], surface
                layouts.append(ContactLayout(*place, one.bounded, one.finger, *others))
        return tuple(layouts)


class _State:
    """The item state table of HID 1.11, and the fields read so far."""

    def __init__(self) -> None:
        self.page = self.minimum = self.maximum = self.size = self.count = self.report = 0
        self.low = self.high = self.exponent = self.unit = 0  # the physical range
        self.pushed: list[tuple[int, ...]] = []
        self.collections: list[tuple[int, int, int]] = []
        self.opened = 0
        self.positions: dict[int, _Positions] = {}
        self.pad = False
        self.numbered = False
        self.branch = 0
        self.usages: list[_Range] = []
        self.lowest: tuple[int, int, bool] | None = None
        self.reached: dict[int, int] = {0: 0}
        self.axes: dict[int, dict[str, ReportField]] = {}
        self.buttons: dict[int, dict[int, ReportField]] = {}

    def set_global(self, item: DescriptorItem) -> None:
        """Usage page, logical and physical range with its unit, report size, ID and count, push and pop."""
        if item.tag == 0x0:
            self.page = item.unsigned & 0xFFFF
        elif item.tag == 0x1:
            self.minimum = item.signed
        elif item.tag == 0x2:
            self.maximum = item.signed if self.minimum < 0 else item.unsigned
        elif item.tag == 0x3:
            self.low = item.signed
        elif item.tag == 0x4:
            self.high = item.signed if self.low < 0 else item.unsigned
        elif item.tag == 0x5:  # of 4 bits, or of a whole byte as some devices have it
            self.exponent = (item.unsigned ^ 8) - 8 if 0 <= item.signed < 16 else item.signed
        elif item.tag == 0x6:
            self.unit = item.unsigned
        elif item.tag == 0x7:
            self.size = self._within(item, "a field", "bits", MOST_BITS)
        elif item.tag == 0x8:
            if not 0 < item.unsigned < 256:
                raise bad_descriptor(
                    f"report ID {item.unsigned} at byte {item.at}, expected 1 to 255", item.at
                )
            self.report, self.numbered = item.unsigned, True
            self.reached.setdefault(self.report, 8)
        elif item.tag == 0x9:
            self.count = self._within(item, "an item", "fields", MOST_FIELDS)
        elif item.tag == 0xA:
            physical = self.low, self.high, self.exponent, self.unit
            fields = self.page, self.minimum, self.maximum, self.size, self.count, self.report
            self.pushed.append((*fields, *physical))
        elif item.tag == 0xB:
            if not self.pushed:
                raise bad_descriptor(f"report descriptor pops more than it pushes at byte {item.at}", item.at)
            popped = self.pushed.pop()
            self.page, self.minimum, self.maximum, self.size, self.count, self.report = popped[:6]
            self.low, self.high, self.exponent, self.unit = popped[6:]

    def set_local(self, item: DescriptorItem) -> None:
        """Usages, one by one or as a range; 4-byte ones carry their page; the first alternative counts."""
        own = item.size == 4
        page, usage = (item.unsigned >> 16, item.unsigned & 0xFFFF) if own else (self.page, item.unsigned)
        if item.tag == 0xA:
            self.branch += 1 if item.unsigned else 0
        elif self.branch > 1:
            return
        elif item.tag == 0x0:
            self.usages.append(_Range(page, usage, usage, own))
        elif item.tag == 0x1:
            self.lowest = page, usage, own
        elif item.tag == 0x2 and self.lowest is not None:
            self.usages.append(_Range(self.lowest[0], self.lowest[1], usage, self.lowest[2]))
            self.lowest = None

    def main(self, item: DescriptorItem) -> None:
        """Input fields and collections; every main item clears the usages."""
        if item.tag == INPUT:
            bits = self.size * self.count
            if not item.unsigned & CONSTANT and item.unsigned & VARIABLE and 0 < self.size <= WIDEST:
                self._add_fields(item)
            self.reached[self.report] += bits
            if self.reached[self.report] > 8 * LONGEST_REPORT:
                raise bad_descriptor(f"report of more than {LONGEST_REPORT} bytes at byte {item.at}", item.at)
        elif item.tag == COLLECTION:
            usage = next((each.page << 16 | each.first for each in self._paged()), 0)
            self.opened += 1
            self.collections.append((item.unsigned, usage, self.opened))
        elif item.tag == END_COLLECTION:
            if not self.collections:
                raise bad_descriptor(f"a collection ends at byte {item.at} that never began", item.at)
            self.collections.pop()
        self.usages, self.lowest, self.branch = [], None, 0

    def _add_fields(self, item: DescriptorItem) -> None:
        """Add the fields of an input item that are axes or buttons."""
        at = self.reached[self.report]
        application = self._application()[0]
        self.pad |= application == PAD
        relative = bool(item.unsigned & RELATIVE)
        axes = AXES if relative else POSITIONS if application in POINTERS else {}
        index = 0
        for page, first, last, _ in self._paged():
            for usage in (*axes, *BUTTONS):
                place = index + (usage & 0xFFFF) - first
                if usage >> 16 != page or not first <= usage & 0xFFFF <= last or place >= self.count:
                    continue
                field = ReportField(at + place * self.size, self.size, self.minimum < 0)
                if usage in BUTTONS and self.size == 1:
                    field = ReportField(field.first, 1, signed=False)
                    self.buttons.setdefault(self.report, {}).setdefault(BUTTONS[usage], field)
                elif usage in axes and not relative:
                    self._add_position(POSITIONS[usage], field, item)
                elif usage in axes:
                    if self.maximum < self.minimum:
                        raise bad_descriptor(
                            f"field from {self.minimum} to {self.maximum} at byte {item.at} is no range",
                            item.at,
                        )
                    self.axes.setdefault(self.report, {}).setdefault(AXES[usage], field)
            index += max(0, last - first + 1)

    def _application(self) -> tuple[int, int]:
        """The usage of the innermost application, and the number of the collection in it, 0 where none is."""
        usage = inside = 0
        for kind, of, number in self.collections:
            if kind == APPLICATION:
                usage, inside = of, 0
            else:
                inside = inside or number
        return usage, inside

    def _add_position(self, name: str, field: ReportField, item: DescriptorItem) -> None:
        """Add an absolute field."""
        application, inside = self._application()
        report = self.positions.setdefault(self.report, _Positions())
        one = report.contacts.setdefault(inside, _Contact())
        if name in ("x", "y"):
            if self.minimum >= self.maximum or name in one.axes:
                return
            one.axes[name] = Axis(self.minimum, self.maximum, self._length_mm())
            one.bounded |= bool(item.unsigned & NULL_STATE)
            one.finger |= application == SCREEN or any(usage == FINGER for _, usage, _ in self.collections)
        elif field.bits > 1 and name != CONTACT:
            return
        if name == BARREL:
            report.barrel = report.barrel or field
        one.fields.setdefault(name, field)

    def _length_mm(self) -> float:
        """The length of the physical range, 0 where it is none."""
        if self.high <= self.low or self.unit not in LENGTHS_MM or abs(self.exponent) > MOST_EXPONENT:
            return 0.0
        return (self.high - self.low) * LENGTHS_MM[self.unit] * 10.0**self.exponent

    def _paged(self) -> list[_Range]:
        """The usages; a page declared after the last of them holds for those that did not carry their own."""
        ranges = list(self.usages)
        stale = ranges[-1].page if ranges else self.page
        for place in reversed(range(len(ranges))):
            if ranges[place].own or ranges[place].page != stale:
                break
            ranges[place] = ranges[place]._replace(page=self.page)
        return ranges

    @staticmethod
    def _within(item: DescriptorItem, what: str, of: str, most: int) -> int:
        if item.unsigned > most:
            raise bad_descriptor(
                f"{what} with {item.unsigned} {of} at byte {item.at}, expected at most {most}", item.at
            )
        return item.unsigned
