"""What the server sends: in ``pointpred.v1``, and on ``/v1/live`` about the device of this machine."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

import msgspec
from msgspec import UNSET, Meta, Struct, UnsetType

from pointpred.protocol.client_messages import Bye, Events
from pointpred.records import NORMAL, Phase
from pointpred.regions import Region, probability, region_of
from pointpred.transfer import GainCurve

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
ReceivedCode = Annotated[str, Meta(extra_json_schema={"enum": sorted(get_args(Code))})]
"""A code as a client reads it: a newer service may send further ones."""


Scalar = bool | int | float | str | None


class Limits(Struct, frozen=True):
    """What a session may do."""

    max_frame_bytes: int = 65536
    max_events_per_frame: int = 64
    max_events_per_s: int = 20000
    max_targets: int = 256
    max_sessions: int = 64
    idle_s: float = 60.0


class ServerMessage(Struct):
    """A message from the server; its type on the wire is the subclass's tag."""


class Welcome(ServerMessage, tag="welcome"):
    """The answer to ``hello``."""

    version: int
    session: str
    predictor: str
    limits: Limits


class EndpointLaw(Struct, gc=False):
    """The law of the endpoint: scale matrix, px^2, and the degrees of freedom of a bivariate Student law.

    ``tail`` null: the law is normal and the matrix is its covariance.
    """

    sxx: float
    sxy: float
    syy: float
    tail: float | None = None


class Likely(Struct):
    """How likely a target is: its share of one, with the other targets and none of them."""

    id: str
    p: float


class PredictionMessage(ServerMessage, tag="prediction", gc=False):
    """Where the movement will end as seen at ``t``; null fields where nothing is justified.

    ``remaining_spread``: standard deviation of the logarithm of ``remaining_s``. ``target``: the registered
    target that is likeliest of all, null where none of them is; ``targets``: the likeliest five, best first.
    Both are absent from a session without targets.
    """

    t: float
    x: float | None = None
    y: float | None = None
    scale: EndpointLaw | None = msgspec.field(default=None, name="region")
    phase: Phase | None = None
    remaining_s: float | None = None
    remaining_spread: float | None = None
    target: str | UnsetType | None = UNSET
    targets: list[Likely] | UnsetType = UNSET

    def region(self, level: float) -> Region | None:
        """The ellipse of this law that holds the endpoint with a probability, as ``Prediction.region``."""
        level = probability(level)
        if self.scale is None or self.x is None or self.y is None:
            return None
        scale, tail = self.scale, NORMAL if self.scale.tail is None else self.scale.tail
        return region_of(level, self.x, self.y, scale.sxx, scale.sxy, scale.syy, tail)


class Cursor(ServerMessage, tag="cursor"):
    """Where the cursor is after the events up to ``t``, px, in a session that asked for assistance.

    ``added_px``: the length of all that help has added since the session began.
    """

    t: float
    x: float
    y: float
    added_px: float


class PlaceSquare(Struct):
    """A place where the person went before: the centre and side of the square of its visits, px."""

    x: float
    y: float
    size: float


class ChoiceMessage(ServerMessage, tag="choice"):
    """A target is proposed, or no longer; ``p`` is its share at ``t``, the time of the event that decided.

    ``reason``: why it is proposed. *predicted*: the movement heads for it; *entered*: the cursor has gone
    into it, and it was not predicted before. At most one target of each reason is proposed at a time.
    ``place``: where it is, for a place that nobody registered; absent for a target.
    """

    id: str
    p: float
    action: Literal["propose", "retract"]
    t: float | None = None
    reason: Literal["predicted", "entered"] | None = None
    place: PlaceSquare | UnsetType = UNSET


class TargetsTaken(ServerMessage, tag="targets"):
    """The set of targets now holds so many."""

    count: int


class KnownPerson(ServerMessage, tag="person"):
    """What finished movements taught of the person, for ``hello`` of another session; "" for nobody."""

    person: str


class Score(ServerMessage, tag="score"):
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


class ErrorMessage(ServerMessage, tag="error"):
    """What was wrong, where, and whether the session goes on.

    ``field``: the name of the field or parameter that is wrong; ``value``: what was received there, cut short
    where it is a long text. Both are absent where they are not known.
    """

    code: ReceivedCode
    message: str
    path: str | None = None
    recoverable: bool = True
    field: str | UnsetType = UNSET
    value: Scalar | UnsetType = UNSET


SERVER_MESSAGES: tuple[type[Struct], ...] = (*ServerMessage.__subclasses__(), Bye)
SERVER_TYPES: tuple[str, ...] = tuple(str(kind.__struct_config__.tag) for kind in SERVER_MESSAGES)
"""The types of message that the server may send, as they stand on the wire."""


class Attached(Struct, tag="device"):
    """First message: the device, which clock stamps it, what its positions are, and what predicts.

    ``space``: ``screen`` the cursor, ``transfer`` where a transfer function puts it, ``motor`` the hand's own
    way; ``words`` says the same for people. ``cpi`` counts per inch, null where nobody knows it.
    """

    name: str
    clock: str
    space: Literal["screen", "transfer", "motor"]
    words: str
    predictor: str
    cpi: float | None = None
    dpi: float = 96.0


class Status(Struct, tag="status"):
    """How the reading goes, once a second.

    ``lost`` reports nobody took in time, ``unreadable`` ones that could not be decoded, ``resynchronised``
    recoveries after the kernel dropped events, ``refused`` events the pipeline did not take; delays from a
    report to its prediction, null where the stamps are of another clock. ``note``: what a person should know
    of the device now, such as that nothing moves and what to try; null where there is nothing to say.
    """

    plugged: bool
    reports: int
    rate_hz: float
    lost: int = 0
    unreadable: int = 0
    resynchronised: int = 0
    refused: int = 0
    delay_p50_s: float | None = None
    delay_p99_s: float | None = None
    note: str | None = None


class Curve(Struct, tag="transfer"):
    """The system's transfer function as learnt so far: why there is no curve, or what the curve rests on.

    Speeds are the hand's in m/s; ``excited`` is the range that the person has shown, beyond it nothing is
    known. ``compared``: simpler functions on the same measurements, ``closest`` the simplest that fits.
    """

    words: str
    curve: GainCurve | None = None


LIVE_MESSAGES = (Attached, Events, PredictionMessage, Status, Curve, ErrorMessage, Bye)
"""What the server sends to a viewer; ``events`` in the shape that clients of ``/v1/stream`` send."""

# Laws that run as plain Python answer in numpy's floats.
encode = msgspec.json.Encoder(enc_hook=float).encode
