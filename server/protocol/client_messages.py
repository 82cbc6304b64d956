"""What a client may say in ``pointpred.v1``."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from pointpred.registry import RECOMMENDED
from pointpred.server.protocol.assisted_messages import Assist
from pointpred.server.protocol.fields import (
    Bounded,
    Buttons,
    Cpi,
    Dpi,
    Extent,
    Known,
    Moment,
    Name,
    Positive,
    Share,
    Weight,
)

VERSION = 1
SUBPROTOCOL = "pointpred.v1"

Reply = Literal["frame", "event"]
Encoding = Literal["json", "binary"]

EventRow = tuple[Moment, Bounded, Bounded, Bounded | None, Bounded | None, Buttons]
"""t in s, x and y in px, dx and dy in counts or null, buttons."""


Setting = bool | int | float | str | list[float]
"""The value of a parameter of a predictor or a differentiator."""


class Device(Struct, forbid_unknown_fields=True):
    """The pointing device: counts per inch, and reports a second as the client knows it."""

    cpi: Cpi | None = None
    rate_hz: Positive | None = None


class Screen(Struct, forbid_unknown_fields=True):
    """The screen: its size in px, and px per inch."""

    width_px: Positive | None = None
    height_px: Positive | None = None
    dpi: Dpi = 96.0


class Hello(Struct, tag="hello", forbid_unknown_fields=True):
    """First message of a session: which predictor, on what device and screen, and how to answer.

    ``person``: what another session said that it knows of the person; "" knows nobody.
    """

    version: int
    predictor: str = RECOMMENDED
    parameters: dict[str, Setting] = {}
    device: Device | None = None
    screen: Screen | None = None
    reply: Reply = "frame"
    encoding: Encoding = "json"
    assist: Assist | None = None
    person: Known = ""


class Events(Struct, tag="events", forbid_unknown_fields=True):
    """Pointer events in the order of their times."""

    events: list[EventRow]


class Target(Struct, forbid_unknown_fields=True, omit_defaults=True):
    """A rectangle that may be pointed at: its upper left corner and its size, px.

    ``weight`` is how likely it is before anything is seen, relative to the other targets.
    """

    id: Name
    x: Bounded
    y: Bounded
    width: Extent
    height: Extent
    weight: Weight = 1.0


class Targets(Struct, tag="targets", forbid_unknown_fields=True):
    """Replaces the set of targets."""

    targets: list[Target]


class Goal(Struct, forbid_unknown_fields=True):
    """The true target of a trial: centre and width, px."""

    x: Bounded
    y: Bounded
    width: Positive


class TrialMark(Struct, tag="trial", forbid_unknown_fields=True):
    """Ground truth: a movement starts here, or it has ended; ``target`` where it is known."""

    action: Literal["start", "end"]
    target: Goal | None = None


class Configure(Struct, tag="configure", forbid_unknown_fields=True):
    """Changes what is given and leaves the rest; another predictor begins without memory."""

    predictor: str | None = None
    parameters: dict[str, Setting] = {}
    reply: Reply | None = None
    precision: Share | None = None
    assist: Assist | None = None


class Reset(Struct, tag="reset", forbid_unknown_fields=True):
    """Forget every event: the next one starts a movement."""


class Person(Struct, tag="person", forbid_unknown_fields=True):
    """Asks what finished movements taught of the person; with ``person``, begins anew knowing that."""

    person: Known | None = None


class Bye(Struct, tag="bye", forbid_unknown_fields=True):
    """The end of a session; the server says why."""

    reason: str = ""


ClientMessage = Hello | Events | Targets | TrialMark | Configure | Reset | Person | Bye
KNOWN = ("hello", "events", "targets", "trial", "configure", "reset", "person", "bye")
"""What a client may say."""
