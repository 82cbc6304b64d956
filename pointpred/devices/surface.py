"""Absolute devices: where on its surface a pen, a finger or an absolute mouse is, and what that is in px."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

import msgspec

DEFAULT_PX = (1920.0, 1080.0)
"""What a surface of unknown size is drawn over where no screen is known either."""
MM_PER_INCH = 25.4
SHORTEST_MM, LONGEST_MM = 10.0, 10_000.0
"""Bounds of a side that is believed: devices that do not know their size state it by the metre or the um."""
TOUCH_PAD = (
    "it is a touch pad: its positions are those of fingers on the pad, not of the pointer on the screen"
)
"""Why the positions of a touch pad are refused."""
MISSED, MOST_CONTACTS = 8, 256
"""A contact is gone after so many reports of another; so many are told apart between two reports of one."""
ALWAYS = -1
"""The contact of a device that is always there, as an absolute mouse is: its motion never begins anew."""


class Axis(msgspec.Struct, frozen=True):
    """The range of an absolute axis in the device's units, and its length in mm, 0 where unknown."""

    least: int
    most: int
    mm: float = 0.0

    def share(self, value: float) -> float:
        """Where a value lies in the range, 0 at the least and 1 at the most.

        >>> Axis(-100, 100).share(-50)
        0.25
        """
        return (value - self.least) / (self.most - self.least)


class Scale(NamedTuple):
    """The px of a surface across and down, and how they are known."""

    width: float
    height: float
    words: str


class Surface(msgspec.Struct, frozen=True):
    """The axes across and down of an absolute device."""

    x: Axis
    y: Axis

    @property
    def size_mm(self) -> tuple[float, float] | None:
        """Width and height; ``None`` where a side is unknown or not from 1 cm to 10 m."""
        believed = all(SHORTEST_MM <= axis.mm <= LONGEST_MM for axis in (self.x, self.y))
        return (self.x.mm, self.y.mm) if believed else None

    def scale(self, dpi: float, screen: tuple[float, float] | None = None, *, whole: bool = False) -> Scale:
        """The px of the surface: of its size, else those of a screen, else ``DEFAULT_PX``.

        ``whole``: those of the screen though the size is known.

        >>> Surface(Axis(0, 100, 254.0), Axis(0, 100, 127.0)).scale(96.0)
        Scale(width=960.0, height=480.0, words='px of the surface, 254 x 127 mm at 96 px per inch')
        """
        if self == OWN_UNITS:
            return Scale(1.0, 1.0, "units of the device taken as px, for their range is not known")
        if (size := self.size_mm) is not None and not whole:
            words = f"px of the surface, {size[0]:.4g} x {size[1]:.4g} mm at {dpi:g} px per inch"
            return Scale(size[0] * dpi / MM_PER_INCH, size[1] * dpi / MM_PER_INCH, words)
        width, height = screen or DEFAULT_PX
        which = "the screen's" if screen else "an assumed"
        of = "the surface" if self.size_mm else "a surface of unknown size"
        words = f"px of {of}, drawn over {which} {width:g} x {height:g} px"
        return Scale(width, height, words)


OWN_UNITS = Surface(Axis(0, 1), Axis(0, 1))
"""The surface of a device whose range is not known: positions stay in its units."""


class Place(NamedTuple):
    """Where a contact is, in shares of the surface from its top left, and the pressed buttons (W3C bits).

    ``begins``: it is the first place of a contact, and the way there from the place before is no motion.
    """

    x: float
    y: float
    buttons: int
    begins: bool


class ContactPath:
    """The places of one contact after another, each from where it begins to where it is lifted.

    >>> path = ContactPath()
    >>> path.at(7, 0.5, 0.5, 1).begins, path.at(7, 0.6, 0.5, 1).begins, path.lifted(), path.lifted()
    (True, False, Place(x=0.6, y=0.5, buttons=0, begins=False), None)
    """

    def __init__(self) -> None:
        self.contact: int | None = None
        """The contact that is followed."""
        self._last = Place(0.0, 0.0, 0, False)

    def at(self, contact: int, x: float, y: float, buttons: int) -> Place:
        """The place of a contact that is there."""
        begins = contact not in (self.contact, ALWAYS)
        self.contact, self._last = contact, Place(x, y, buttons, begins)
        return self._last

    def lifted(self) -> Place | None:
        """Nothing is there: the last place without buttons, where some were pressed."""
        last, there = self._last, self.contact is not None
        self.contact = None
        return Place(last.x, last.y, 0, False) if there and last.buttons else None


class ReportContact(NamedTuple):
    """One of the contacts in a report: its number, its shares of the surface, whether it is there, its tip.

    The number is ``ALWAYS`` for a mouse, and 0 where contacts have none.
    """

    number: int
    x: float
    y: float
    there: bool
    tip: int


class ContactReports:
    """Places of the reports of an absolute device: one contact is followed until it is lifted.

    Buttons on reports of their own are those of the contact where the device has no counts. Other contacts
    are passed over, in the same report or in others between; the one that is followed is given up when
    another one was passed over ``MISSED`` times since its last report.
    """

    def __init__(self) -> None:
        self._path = ContactPath()
        self._followed = (0, 0)
        self._passed: Counter[tuple[int, int]] = Counter()
        self._x = self._y = 0.0
        self._buttons = 0

    def press(self, pressed: int, mask: int) -> Place | None:
        """The place with the buttons of a report without contacts, which has those of ``mask``."""
        path = self._path
        self._buttons = self._buttons & ~mask | pressed
        return None if path.contact is None else path.at(path.contact, self._x, self._y, self._buttons)

    def take(self, report: int, contacts: Sequence[ReportContact], pressed: int, mask: int) -> Place | None:
        """The place that a report of this ID with some contacts tells, ``None`` where it tells none."""
        path = self._path
        there = [one for one in contacts if one.there]
        if path.contact is not None:
            own = [one for one in there if (report, one.number) == self._followed]
            if not own and self._is_lifted(report, contacts):
                return self.lifted()
            there = own or self._again(report, there)
        if not there:
            return None
        contact = there[0]
        self._passed.clear()
        self._followed = report, contact.number
        self._x, self._y = contact.x, contact.y
        self._buttons = self._buttons & ~mask | pressed | contact.tip
        return path.at(contact.number, self._x, self._y, self._buttons)

    def lifted(self) -> Place | None:
        """Nothing is there any more: the last place without buttons, where some were pressed."""
        self._passed.clear()
        self._buttons = 0
        return self._path.lifted()

    def _is_lifted(self, report: int, contacts: Sequence[ReportContact]) -> bool:
        """Whether a report says that the contact that is followed is up; empty slots say nothing."""
        if report != self._followed[0]:
            return False
        own = [place for place, one in enumerate(contacts) if one.number == self._followed[1]]
        filled = [place for place, one in enumerate(contacts) if one.x or one.y]
        nothing = len(contacts) > 1 and not filled and not any(one.number for one in contacts)
        return 0 in own or any(place in filled for place in own) or nothing

    def _again(self, report: int, there: list[ReportContact]) -> list[ReportContact]:
        """The contact that has come so often since the one that is followed that that one must be gone."""
        again = [one for one in there if self._passed[report, one.number] >= MISSED]
        if again:
            self._path.lifted()
        elif len(self._passed) < MOST_CONTACTS:
            self._passed.update((report, one.number) for one in there)
        return again
