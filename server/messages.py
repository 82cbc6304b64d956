"""The messages of ``pointpred.v1``: what a client may say, and what it hears."""

from __future__ import annotations

from typing import Any, Literal

import msgspec
from msgspec import UNSET, Struct, UnsetType

from pointpred.server.assisted_messages import Assist, Cursor
from pointpred.server.fields import Bounded, Buttons, Cpi, Dpi, Extent, Moment, Name, Positive, Share, Weight

VERSION = 1
SUBPROTOCOL = "pointpred.v1"

Reply = Literal["frame", "event"]
Encoding = Literal["json", "binary"]
Code = Literal[
    "bad_json",
    "bad_field",
    "unknown_type",
    "unknown_predictor",
    "out_of_order",
    "out_of_place",
    "too_large",
    "too_fast",
    "too_many",
    "idle",
    "slow",
    "unauthorized",
    "stopping",
    "internal",
]

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
    """First message of a session: which predictor, on what device and screen, and how to answer."""

    version: int
    predictor: str
    parameters: dict[str, Setting] = {}
    device: Device | None = None
    screen: Screen | None = None
    reply: Reply = "frame"
    encoding: Encoding = "json"
    assist: Assist | None = None


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


class Bye(Struct, tag="bye", forbid_unknown_fields=True):
    """The end of a session; the server says why."""

    reason: str = ""


ClientMessage = Hello | Events | Targets | TrialMark | Configure | Reset | Bye
KNOWN = ("hello", "events", "targets", "trial", "configure", "reset", "bye")
"""What a client may say."""


class Limits(Struct, frozen=True):
    """What a session may do."""

    max_frame_bytes: int = 65536
    max_events_per_frame: int = 1024
    max_events_per_s: int = 20000
    max_targets: int = 1000
    max_sessions: int = 64
    idle_s: float = 60.0


class Welcome(Struct, tag="welcome"):
    """The answer to ``hello``."""

    version: int
    session: str
    predictor: str
    limits: Limits


class Region(Struct):
    """Covariance of the endpoint, px^2."""

    sxx: float
    sxy: float
    syy: float


class Likely(Struct):
    """How likely a target is: its share of one, with the other targets and none of them."""

    id: str
    p: float


class PredictionMessage(Struct, tag="prediction"):
    """Where the movement will end as seen at ``t``; null fields where nothing is justified.

    ``targets``: the likeliest five, best first; absent from a session without targets.
    """

    t: float
    x: float | None = None
    y: float | None = None
    region: Region | None = None
    phase: Literal["still", "ballistic", "corrective"] | None = None
    remaining_s: float | None = None
    targets: list[Likely] | UnsetType = UNSET


class Choice(Struct, tag="choice"):
    """A target is proposed, or no longer; ``p`` is its share at ``t``, the time of the event that decided."""

    id: str
    p: float
    action: Literal["propose", "retract"]
    t: float | None = None


class TargetsTaken(Struct, tag="targets"):
    """The set of targets now holds so many."""

    count: int


class Score(Struct, tag="score"):
    """How good the predictions of the trial were, px; ``skill`` is 1 - error / error of no prediction.

    With targets, and the trial's own known: ``fired`` proposals; ``hit``, whether one of the trial's target
    stood when the cursor entered it, ``lead_s`` after it was made; ``wasted`` proposals of other targets.
    """

    events: int
    time_averaged_px: float | None = None
    hold_px: float | None = None
    skill: float | None = None
    by_time: dict[str, float] = {}
    by_path: dict[str, float] = {}
    reason: str | None = None
    """Why there is no score, where there is none."""
    fired: int | None = None
    hit: bool | None = None
    wasted: int | None = None
    lead_s: float | None = None


class ErrorMessage(Struct, tag="error"):
    """What was wrong, where, and whether the session goes on."""

    code: Code
    message: str
    path: str | None = None
    recoverable: bool = True


ServerMessage = Welcome | PredictionMessage | Cursor | Choice | TargetsTaken | Score | ErrorMessage | Bye

# Laws that run as plain Python answer in numpy's floats.
encode = msgspec.json.Encoder(enc_hook=float).encode


def schemas() -> tuple[dict[str, Any], dict[str, Any]]:
    """JSON schemas of the messages from the client and from the server, with their components."""
    (client, server), components = msgspec.json.schema_components(
        (ClientMessage, ServerMessage), ref_template="#/components/schemas/{name}"
    )
    return {"client": client, "server": server}, components
