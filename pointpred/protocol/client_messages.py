"""What a client may send in ``pointpred.v1``: one struct a message, whose fields carry their bounds.

A new message is a subclass of ``ClientMessage`` here, and a handler in the session of the server: decoding,
checks, schemas and the documentation follow from the subclass, its docstring and its fields.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Literal

from msgspec import Meta, Struct

from pointpred.person import LARGEST as LARGEST_PERSON
from pointpred.records import CPI, DPI, EVENT_FIELDS, LARGEST
from pointpred.registry import RECOMMENDED
from pointpred.targets.rectangles import SMALLEST_PX, Target

VERSIONS = (1, 2)
VERSION = VERSIONS[-1]
"""The versions of the wire that a service speaks, and the one that the clients here send. Version 2 adds
fields to packed predictions."""
SUBPROTOCOL = "pointpred.v1"

Bounded = Annotated[float, Meta(ge=-LARGEST, le=LARGEST)]
Positive = Annotated[float, Meta(gt=0.0, le=LARGEST)]
Extent = Annotated[float, Meta(ge=SMALLEST_PX, le=LARGEST)]
Weight = Annotated[float, Meta(ge=0.0, le=LARGEST)]
Share = Annotated[float, Meta(ge=0.0, le=1.0)]
Cpi = Annotated[float, Meta(ge=CPI[0], le=CPI[1])]
Dpi = Annotated[float, Meta(ge=DPI[0], le=DPI[1])]
Name = Annotated[str, Meta(min_length=1, max_length=128)]
Knowledge = Annotated[str, Meta(max_length=LARGEST_PERSON)]
"""What is known of a person, as ``Pipeline.person`` gives it."""
WindowKey = Annotated[str, Meta(max_length=1024, examples=["editor"])]
"""The name of a window or page, in the client's own words."""
ConditionName = Annotated[str, Meta(max_length=64, pattern=r'^(?!.*[\r\n])[^\s,"]+( [^\s,"]+)*$')]
Condition = Annotated[str, Meta(max_length=256, pattern=r"^(?!.*[\r\n])")] | float
Conditions = Annotated[dict[ConditionName, Condition], Meta(max_length=32)]
"""What a trial was: block, participant, distance, ... by name, in texts of one line or finite numbers."""
Rho = Annotated[float, Meta(ge=0.0, le=1e4)]
Gain = Annotated[float, Meta(ge=0.0, le=1e3)]

Reply = Literal["frame", "event"]
Encoding = Literal["json", "binary"]

if TYPE_CHECKING:
    EventRow = tuple[float, float, float, float | None, float | None, int]
else:
    EventRow = tuple[tuple(field.json for field in EVENT_FIELDS)]
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


class Assist(Struct, forbid_unknown_fields=True):
    """The service moves the cursor: counts through ``function``, helped towards the predicted endpoint.

    ``strength``: longest help as a share of the hand's own motion, 0 is the function alone; ``rho`` 1/s;
    ``gain`` of the constant function, the sigmoid one has its own.
    """

    strength: Share = 0.5
    rho: Rho = 8.0
    function: Literal["constant", "sigmoid"] = "constant"
    gain: Gain = 4.0


class ClientMessage(Struct, forbid_unknown_fields=True):
    """A message from the client; its type on the wire is the subclass's tag."""


class Hello(ClientMessage, tag="hello"):
    """First message of a session: which predictor, on what device and screen, and how to answer.

    ``person``: what another session said that it knows of the person; "" knows nobody. ``places``: propose
    places where the person went before, while there are no targets; targets that they went to weigh more.
    """

    version: int
    predictor: str = RECOMMENDED
    parameters: dict[str, Setting] = {}
    device: Device | None = None
    screen: Screen | None = None
    reply: Reply = "frame"
    encoding: Encoding = "json"
    assist: Assist | None = None
    person: Knowledge = ""
    places: bool = False


def cpi_of(hello: Hello) -> float | None:
    """Counts per inch of the client's device; ``None`` where the hello has none."""
    return hello.device.cpi if hello.device else None


def dpi_of(hello: Hello) -> float:
    """Pixels per inch of the client's screen."""
    return hello.screen.dpi if hello.screen else Screen().dpi


class Events(ClientMessage, tag="events"):
    """Pointer events in the order of their times."""

    events: list[EventRow]


class Rectangle(Target, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """A target as it is sent: its upper left corner and its size, px.

    ``weight`` is how likely it is before anything is seen, relative to the other targets.
    """

    id: Name
    x: Bounded
    y: Bounded
    width: Extent
    height: Extent
    weight: Weight = 1.0


class Targets(ClientMessage, tag="targets"):
    """Replaces the set of targets."""

    targets: list[Rectangle]


class Goal(Struct, forbid_unknown_fields=True):
    """The true target of a trial: centre and width, px."""

    x: Bounded
    y: Bounded
    width: Positive


class TrialMark(ClientMessage, tag="trial"):
    """Ground truth: a movement starts here, or it has ended; ``target`` where it is known.

    ``conditions`` are columns of recorded trials; those of the end add to those of the start. A session's
    trials have the names of its first one, and none of a column that tables of trials have anyway.
    """

    action: Literal["start", "end"]
    target: Goal | None = None
    conditions: Conditions = {}


class Configure(ClientMessage, tag="configure"):
    """Changes what is given and leaves the rest; another predictor begins without memory."""

    predictor: str | None = None
    parameters: dict[str, Setting] = {}
    reply: Reply | None = None
    precision: Share | None = None
    assist: Assist | None = None
    places: bool | None = None


class Enter(ClientMessage, tag="enter"):
    """The next movement is in this window or page, whose origin is at ``x`` and ``y`` px.

    Places are remembered for each ``key``, relative to the origin; "" is the screen. Finishes the movement.
    """

    key: WindowKey
    x: Bounded = 0.0
    y: Bounded = 0.0


class Forget(ClientMessage, tag="forget"):
    """Forget the person and the movement that goes on; the answer is ``person`` with ""."""


class Reset(ClientMessage, tag="reset"):
    """Forget every event: the next one starts a movement."""


class Person(ClientMessage, tag="person"):
    """Asks what finished movements taught of the person; with ``person``, begins anew knowing that."""

    person: Knowledge | None = None


class Bye(ClientMessage, tag="bye"):
    """The end of a session; the server says why."""

    reason: str = ""


CLIENT_MESSAGES: tuple[type[ClientMessage], ...] = tuple(ClientMessage.__subclasses__())
CLIENT_TYPES: tuple[str, ...] = tuple(str(kind.__struct_config__.tag) for kind in CLIENT_MESSAGES)
"""The types of message that a client may send, as they stand on the wire."""
