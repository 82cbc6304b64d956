"""Reports of a HID mouse: which bits hold x, y, the wheels and the buttons, and their values."""

from __future__ import annotations

import msgspec

from pointpred.errors import RecordingError

Decoded = tuple[int, int, int, int, int, int]
"""dx, dy, pressed buttons, the mask of buttons the report speaks about, wheel, horizontal wheel."""


class Field(msgspec.Struct, frozen=True):
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


class Layout(msgspec.Struct, frozen=True):
    """The fields of one report; ``buttons`` by their bit in W3C pointer events; ``size`` in bytes."""

    size: int
    x: Field | None = None
    y: Field | None = None
    wheel: Field | None = None
    pan: Field | None = None
    buttons: dict[int, Field] = {}

    @property
    def points(self) -> bool:
        """Whether it speaks about motion or buttons, not of wheels alone."""
        return bool(self.x or self.y or self.buttons)


class ReportDescriptor:
    """Layouts by report ID (0 where reports carry none); ``numbered`` when the first byte is the ID.

    ``longest`` is the size in bytes of the longest input report of the device, the mouse's or another's.
    """

    __slots__ = ("_plans", "layouts", "longest", "numbered")

    def __init__(self, numbered: bool, layouts: dict[int, Layout], longest: int) -> None:
        self.numbered, self.layouts, self.longest = numbered, layouts, longest
        self._plans = {number: _plan(layout) for number, layout in layouts.items()}

    def layout_of(self, report: bytes) -> Layout | None:
        """The layout of a report; ``None`` for reports without motion, wheel and button."""
        return self.layouts.get(report[0] if self.numbered and report else 0)

    def decode(self, report: bytes) -> Decoded | None:
        """What a report says; ``None`` for reports without motion, wheel and button.

        Fields the report does not have are 0. Longer reports than described are read as described.
        Raises RecordingError when the report is shorter than its descriptor says.
        """
        plan = self._plans.get(report[0] if self.numbered and report else 0)
        if plan is None:
            return None
        size, x, y, wheel, pan, runs, mask = plan
        if len(report) < size:
            raise RecordingError(f"report of {len(report)} bytes, expected {size}")
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
        return dx, dy, pressed, mask, turned, (whole >> s & m ^ g) - g


_Parts = tuple[int, int, int]
_Plan = tuple[int, _Parts, _Parts, _Parts, _Parts, tuple[tuple[int, int, tuple[int, ...]], ...], int]


def _plan(layout: Layout) -> _Plan:
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
