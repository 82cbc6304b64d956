"""HID report descriptors: where relative x, y, the wheels and the buttons lie in a mouse's reports."""

from __future__ import annotations

from typing import NamedTuple

from pointpred.devices.hid.descriptor_items import GLOBAL, LOCAL, MAIN, Item, bad_descriptor, short_items
from pointpred.devices.hid.report_decoder import Field, ReportDecoder, ReportLayout
from pointpred.errors import RecordingError

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
        self.axes: dict[int, dict[str, Field]] = {}
        self.buttons: dict[int, dict[int, Field]] = {}

    def set_global(self, item: Item) -> None:
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

    def set_local(self, item: Item) -> None:
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

    def main(self, item: Item) -> None:
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

    def _add_fields(self, item: Item) -> None:
        """Add the fields of an input item that are relative axes or buttons."""
        at = self.reached[self.report]
        index = 0
        for page, first, last, _ in self._paged():
            for usage in (*AXES, *BUTTONS):
                place = index + (usage & 0xFFFF) - first
                if usage >> 16 != page or not first <= usage & 0xFFFF <= last or place >= self.count:
                    continue
                field = Field(at + place * self.size, self.size, self.minimum < 0)
                if usage in BUTTONS and self.size == 1:
                    field = Field(field.first, 1, signed=False)
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
    def _within(item: Item, what: str, of: str, most: int) -> int:
        if item.unsigned > most:
            raise bad_descriptor(
                f"{what} with {item.unsigned} {of} at byte {item.at}, expected at most {most}", item.at
            )
        return item.unsigned
