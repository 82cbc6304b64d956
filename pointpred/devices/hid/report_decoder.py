"""Input reports of a HID mouse: which bits hold x, y, the wheels and the buttons, and their values."""

from __future__ import annotations

from typing import NamedTuple

import msgspec

from pointpred.errors import RecordingError


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


class ReportLayout(msgspec.Struct, frozen=True):
    """The fields of one report; ``buttons`` by their bit in W3C pointer events; ``size`` in bytes."""

    size: int
    x: Field | None = None
    y: Field | None = None
    wheel: Field | None = None
    pan: Field | None = None
    buttons: dict[int, Field] = {}

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
