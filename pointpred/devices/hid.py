"""HID report descriptors and reports: where a mouse's motion, wheels and buttons lie, and their values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import msgspec

from pointpred.errors import RecordingError

MAIN, GLOBAL, LOCAL = 0, 1, 2
"""Types of items; the fourth is reserved."""
LONG_ITEM = 0xFE

GENERIC_DESKTOP, BUTTON, CONSUMER = 0x01, 0x09, 0x0C
AXES = {
    GENERIC_DESKTOP << 16 | 0x30: "x",
    GENERIC_DESKTOP << 16 | 0x31: "y",
    GENERIC_DESKTOP << 16 | 0x38: "wheel",
    CONSUMER << 16 | 0x238: "pan",
}
"""Usages of the relative axes that are read; the last is AC Pan, the horizontal wheel."""
BUTTONS = {BUTTON << 16 | usage: bit for usage, bit in {1: 1, 2: 2, 3: 4, 4: 8, 5: 16}.items()}
"""HID buttons 1 (primary), 2 (secondary), 3 (middle), 4, 5 -> bits of W3C pointer events."""
INPUT, COLLECTION, END_COLLECTION = 0x8, 0xA, 0xC
CONSTANT, VARIABLE, RELATIVE = 1, 2, 4
LONGEST, MOST_BITS, MOST_FIELDS = 4096, 256, 12288
"""Bounds of the Linux kernel on a descriptor (bytes), a field (bits) and the fields of an item."""
LONGEST_REPORT = 16384
WIDEST = 32
"""Bits of the widest field that is read."""


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


class ReportLayout(msgspec.Struct, frozen=True):
    """The fields of one report; ``buttons`` by their bit in W3C pointer events; ``size`` in bytes."""

    size: int
    x: ReportField | None = None
    y: ReportField | None = None
    wheel: ReportField | None = None
    pan: ReportField | None = None
    buttons: dict[int, ReportField] = {}

    @property
    def points(self) -> bool:
        """Whether the report has motion or buttons, not wheels alone."""
        return bool(self.x or self.y or self.buttons)


class ReportDecoder:
    """Decodes the input reports of one device.

    ``layouts`` by report ID (0 where reports have none); ``numbered`` when the first byte is the ID;
    ``longest`` is the size in bytes of the longest input report of the device, the mouse's or another's.
    """

    __slots__ = ("_plans", "layouts", "longest", "numbered")

    def __init__(self, numbered: bool, layouts: dict[int, ReportLayout], longest: int) -> None:
        self.numbered, self.layouts, self.longest = numbered, layouts, longest
        self._plans = {number: _plan(layout) for number, layout in layouts.items()}

    def layout_of(self, report: bytes) -> ReportLayout | None:
        """The layout of a report; ``None`` for reports without motion, wheel and button."""
        return self.layouts.get(report[0] if self.numbered and report else 0)

    def decode(self, report: bytes) -> ReportValues | None:
        """The values of a report; ``None`` for reports without motion, wheel and button.

        Fields the report does not have are 0. Longer reports than described are read as described.
        Raises RecordingError when the report is shorter than its descriptor says.
        """
        plan = self._plans.get(report[0] if self.numbered and report else 0)
        if plan is None:
            return None
        size, x, y, wheel, pan, runs, mask = plan
        if len(report) < size:
            raise RecordingError(
                f"report of {len(report)} bytes, expected {size}", code="short_report", value=len(report)
            )
        whole = int.from_bytes(report, "little")
        pressed = 0
        for shift, bits, table in runs:
            pressed |= table[whole >> shift & bits]
        s, m, g = x
        dx = (whole >> s & m ^ g) - g
        s, m, g = y
        dy = (whole >> s & m ^ g) - g
        s, m, g = wheel
        turned = (whole >> s & m ^ g) - g
        s, m, g = pan
        return ReportValues(dx, dy, pressed, mask, turned, (whole >> s & m ^ g) - g)


_Parts = tuple[int, int, int]
_Plan = tuple[int, _Parts, _Parts, _Parts, _Parts, tuple[tuple[int, int, tuple[int, ...]], ...], int]


def _plan(layout: ReportLayout) -> _Plan:
    """A layout as plain numbers, and its buttons as a table for each run of neighbouring bits."""
    axes = (layout.x, layout.y, layout.wheel, layout.pan)
    x, y, wheel, pan = (field.parts() if field else ABSENT for field in axes)
    mask = 0
    runs: list[tuple[int, list[int]]] = []
    for bit, field in sorted(layout.buttons.items(), key=lambda item: item[1].first):
        mask |= bit
        if runs and runs[-1][0] + len(runs[-1][1]) == field.first:
            runs[-1][1].append(bit)
        else:
            runs.append((field.first, [bit]))
    tables = tuple((first, (1 << len(bits)) - 1, _table(bits)) for first, bits in runs)
    return layout.size, x, y, wheel, pan, tables, mask


def _table(bits: list[int]) -> tuple[int, ...]:
    """Pressed W3C bits for every value of neighbouring one-bit buttons, the lowest bit first."""
    return tuple(
        sum(bit for place, bit in enumerate(bits) if value >> place & 1) for value in range(1 << len(bits))
    )


def parse_descriptor(data: bytes) -> ReportDecoder:
    """Read a report descriptor: where relative x, y, the wheels and the buttons lie in the reports.

    Assumes variable input fields of up to 32 bits; a field is signed when its logical minimum is negative.
    Absolute x and y (tablets, touch) and array buttons are not taken. Output and feature reports lie apart
    and are skipped, the resolution multiplier of a wheel among them: wheels count the device's own steps.
    Raises RecordingError: code ``not_a_mouse`` for a descriptor without relative x or y, else
    ``bad_descriptor`` with the place of the wrong byte as ``value``.
    Reference: USB HID 1.11, section 6.2.2.

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
    if state.depth:
        raise bad_descriptor(
            f"report descriptor ends at byte {len(data)}, {state.depth} collections open", len(data)
        )
    sizes = {number: (bits + 7) // 8 for number, bits in state.reached.items()}
    layouts = {}
    for number in state.axes.keys() | state.buttons.keys():
        if number or not state.numbered:  # where reports are numbered, those without a number never come
            axes = state.axes.get(number, {})
            x, y, wheel, pan = (axes.get(name) for name in AXES.values())
            layouts[number] = ReportLayout(sizes[number], x, y, wheel, pan, state.buttons.get(number, {}))
    if not any(layout.x or layout.y for layout in layouts.values()):
        raise RecordingError(
            "report descriptor without relative x or y, expected a mouse's", code="not_a_mouse"
        )
    return ReportDecoder(state.numbered, layouts, max(sizes.values()))


class _Range(NamedTuple):
    """Usages ``first`` to ``last`` of a page; ``own`` where the item carried the page itself."""

    page: int
    first: int
    last: int
    own: bool


class _State:
    """The item state table of HID 1.11, and the fields read so far."""

    def __init__(self) -> None:
        self.page = self.minimum = self.maximum = self.size = self.count = self.report = 0
        self.pushed: list[tuple[int, int, int, int, int, int]] = []
        self.numbered = False
        self.depth = self.branch = 0
        self.usages: list[_Range] = []
        self.lowest: tuple[int, int, bool] | None = None
        self.reached: dict[int, int] = {0: 0}
        self.axes: dict[int, dict[str, ReportField]] = {}
        self.buttons: dict[int, dict[int, ReportField]] = {}

    def set_global(self, item: DescriptorItem) -> None:
        """Usage page, logical range, report size, ID and count, push and pop."""
        if item.tag == 0x0:
            self.page = item.unsigned & 0xFFFF
        elif item.tag == 0x1:
            self.minimum = item.signed
        elif item.tag == 0x2:
            self.maximum = item.signed if self.minimum < 0 else item.unsigned
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
            self.pushed.append((self.page, self.minimum, self.maximum, self.size, self.count, self.report))
        elif item.tag == 0xB:
            if not self.pushed:
                raise bad_descriptor(f"report descriptor pops more than it pushes at byte {item.at}", item.at)
            self.page, self.minimum, self.maximum, self.size, self.count, self.report = self.pushed.pop()

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
            self.depth += 1
        elif item.tag == END_COLLECTION:
            self.depth -= 1
            if self.depth < 0:
                raise bad_descriptor(f"a collection ends at byte {item.at} that never began", item.at)
        self.usages, self.lowest, self.branch = [], None, 0

    def _add_fields(self, item: DescriptorItem) -> None:
        """Add the fields of an input item that are relative axes or buttons."""
        at = self.reached[self.report]
        index = 0
        for page, first, last, _ in self._paged():
            for usage in (*AXES, *BUTTONS):
                place = index + (usage & 0xFFFF) - first
                if usage >> 16 != page or not first <= usage & 0xFFFF <= last or place >= self.count:
                    continue
                field = ReportField(at + place * self.size, self.size, self.minimum < 0)
                if usage in BUTTONS and self.size == 1:
                    field = ReportField(field.first, 1, signed=False)
                    self.buttons.setdefault(self.report, {}).setdefault(BUTTONS[usage], field)
                elif usage in AXES and item.unsigned & RELATIVE:
                    if self.maximum < self.minimum:
                        raise bad_descriptor(
                            f"field from {self.minimum} to {self.maximum} at byte {item.at} is no range",
                            item.at,
                        )
                    self.axes.setdefault(self.report, {}).setdefault(AXES[usage], field)
            index += max(0, last - first + 1)

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
