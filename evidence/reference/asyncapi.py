"""Write the AsyncAPI 3 document of the WebSocket from the message types: part of ``make docs``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, get_type_hints

import msgspec
import numpy as np
import yaml
from msgspec import Struct

import pointpred
from pointpred.protocol.client_messages import (
    CLIENT_MESSAGES,
    SUBPROTOCOL,
    VERSION,
    Assist,
    Bye,
    Configure,
    Device,
    Enter,
    Events,
    Forget,
    Goal,
    Hello,
    Person,
    Rectangle,
    Reset,
    Screen,
    Targets,
    TrialMark,
)
from pointpred.protocol.frames import (
    NO_COUNTS,
    PREDICTED,
    PREDICTION,
    Likeliest,
    pack_events,
    pack_predictions,
)
from pointpred.protocol.server_messages import (
    LIVE_MESSAGES,
    SERVER_MESSAGES,
    Attached,
    ChoiceMessage,
    Cursor,
    Curve,
    EndpointLaw,
    ErrorMessage,
    KnownPerson,
    Likely,
    Limits,
    PlaceSquare,
    PredictionMessage,
    Score,
    Status,
    TargetsTaken,
    Welcome,
)
from pointpred.records import EVENT_FIELDS, PHASES, Field
from pointpred.registry import RECOMMENDED
from pointpred.targets.decision import NOBODY
from pointpred.transfer import GainCurve
from pointpred.transfer.curve import Comparison
from pointpred_server.sessions.pointing import PointingSession
from pointpred_server.websocket_protocol import NO_DEVICE

ABOUT = f"""One pointing session over a WebSocket: pointer events in, predictions of the endpoint out.

The session goes connecting -> greeted -> streaming -> closed. The client speaks first, with `hello`; anything
else before it is answered by an error. Every JSON message is one object with `type` in a text frame; unknown
fields are errors. With `encoding: binary` in `hello`, events and predictions go as binary frames of packed
records instead; everything else stays JSON. `version` in `hello` is 1 or 2: it is that of packed
predictions, `welcome` repeats it, and all else is the same in both. Positions are px with y growing
downwards, times are seconds on the client's clock. A client that reads slowly gets the newest prediction
only, and the number of those dropped. Proposals among targets (`choice`) go as text in either encoding; if
more than 64 wait to be read, the client gets a summary: the end of the proposal it was sent, and the current
one.

With `assist` in `hello` the service moves the cursor: events carry counts, the first one has the position of
the cursor before it, and before each prediction `cursor`, as text in either encoding, has its current
position. Positions in later events are ignored. `configure` may replace `assist`, but not add it.

Subprotocol: `{SUBPROTOCOL}`. A page of another origin or a foreign `Host` is refused with HTTP 403 before the
upgrade. A token is needed where one is set; one is generated for an address that is not loopback."""
CLOSES = {
    1000: "after `bye`",
    1001: "the server stops, after its `bye`",
    1002: "a frame that breaks a rule of WebSockets",
    1007: "a text that is not UTF-8",
    1008: "no `hello` within 10 s, nothing heard for `idle_s`, too many events or messages a second of the "
    "session or of its address, no valid token",
    1009: "a frame over `max_frame_bytes` or with more than `max_events_per_frame` events",
    1011: "something failed in the server, or nothing came for 40 s, not even the answer to a ping",
    1013: "more sessions than `max_sessions` or than one address may have, or the answers are not read",
}
CODES = {
    "bad_json": "the text is not JSON; the frame is dropped",
    "bad_field": "a field is missing, unknown, of another type or out of range; the frame is dropped",
    "unknown_type": "no message of this type; the frame is dropped",
    "unknown_predictor": "no predictor of this name; the message names the known ones",
    "out_of_order": "events before the last one were dropped, the rest of the frame was used",
    "out_of_place": "the message cannot come now; it was ignored",
    "too_large": "a frame has too many bytes or events; the session ends",
    "too_fast": "too many events or other messages a second; the session ends",
    "too_many": "too many targets (the set stays as it was) or sessions (the session ends)",
    "idle": "no hello in time, or nothing was heard; the session ends",
    "slow": "predictions or choices gave way to newer ones; not recoverable: nothing is read",
    "unauthorized": "no valid token; the session ends",
    "stopping": "the server stops; the session ends",
    "internal": "something failed in the server; the session ends",
}
NEEDED = "Needed where one is set; one is generated for an address that is not loopback."
SECURITY = {
    "token": {"type": "httpApiKey", "in": "query", "name": "token", "description": NEEDED},
    "bearer": {"type": "http", "scheme": "bearer", "description": f"The same token as a header. {NEEDED}"},
}
EVENTS = (
    "Pointer events as packed little-endian records without padding, in a session with `encoding: binary`; "
    "{none} in dx or dy: no counts."
)
PREDICTIONS = (
    "Predictions as packed little-endian records without padding, one for the newest event or, with "
    "`reply: event`, one for each. NaN where a field is null; all NaN but t, and phase 0, where there is "
    "no prediction. Phases: {phases}. A region with tail NaN is that of a normal law. target: the place of "
    "the likeliest among the registered targets in the order sent, from 0; {nobody}: none of them. In a "
    "session of version 1 a record ends after {first} bytes."
)

PERSON = "1.AvcZJo2qP2MdoSQMBXCMPw"
"""How a person begins; a whole one has some 1,700 characters and changes with the law."""

NONE = float("nan")
HELLO = Hello(
    VERSION,
    RECOMMENDED,
    device=Device(cpi=800.0, rate_hz=1000.0),
    screen=Screen(width_px=1920.0, height_px=1080.0, dpi=96.0),
    reply="frame",
    encoding="json",
)
MESSAGES: dict[str, tuple[Struct, ...]] = {
    "hello": (
        HELLO,
        Hello(VERSION, "hold", reply="event", encoding="binary"),
        Hello(VERSION, RECOMMENDED, device=Device(cpi=800.0), assist=Assist(0.4, 6.0, "constant", 3.0)),
        Hello(VERSION, RECOMMENDED, person=PERSON, places=True),
    ),
    "events": (Events([(0.5, 640.0, 360.0, None, None, 0), (0.508, 643.0, 359.0, 4.0, -1.0, 0)]),),
    "targets": (Targets([Rectangle("save", 900.0, 20.0, 80.0, 24.0, weight=2.0)]), Targets([])),
    "trial": (
        TrialMark("start", Goal(940.0, 32.0, 24.0), {"block": 2.0, "participant": "p7"}),
        TrialMark("end"),
    ),
    "configure": (
        Configure(predictor="kalman"),
        Configure(reply="event"),
        Configure(assist=Assist(0.25, function="sigmoid")),
        Configure(places=True),
    ),
    "enter": (Enter("editor", 300.0, 100.0), Enter("")),
    "forget": (Forget(),),
    "reset": (Reset(),),
    "person": (Person(), Person(PERSON), Person("")),
    "bye": (Bye("done"),),
    "welcome": (Welcome(VERSION, "k3x9Qw", RECOMMENDED, Limits()),),
    "prediction": (
        PredictionMessage(
            0.508, 871.5, 251.0, EndpointLaw(220.5, -12.0, 180.25, 4.5), "ballistic", 0.35, 0.25
        ),
        PredictionMessage(0.5),
        PredictionMessage(
            0.508, 871.5, 251.0, None, "ballistic", 0.35, target="save", targets=[Likely("save", 0.8125)]
        ),
    ),
    "cursor": (Cursor(0.508, 652.0, 356.0, 4.0),),
    "choice": (
        ChoiceMessage("save", 0.8125, "propose", 0.508, "predicted"),
        ChoiceMessage("save", 0.25, "retract", 0.75),
        ChoiceMessage("print", 0.375, "propose", 0.758, "entered"),
        ChoiceMessage("place 7", 0.625, "propose", 0.508, "predicted", PlaceSquare(871.0, 248.0, 32.0)),
    ),
    "targetsTaken": (TargetsTaken(1),),
    "knownPerson": (KnownPerson(PERSON), KnownPerson("")),
    "score": (
        Score(
            182, 41.5, 120.25, 0.655, {"0.5": 60.0}, {"0.5": 72.5}, None, 1, hit=True, wasted=0, lead_s=0.31
        ),
        Score(90, 55.0, 110.0, 0.5, fired=2, hit=False, wasted=2),
        Score(1, reason="one sample, expected at least two"),
    ),
    "error": (
        ErrorMessage("bad_field", "Expected `float`, got `str`", "$.events[0][0]"),
        ErrorMessage(
            "bad_field",
            "degree must lie in [2, 4], received 9",
            "$.parameters.degree",
            field="degree",
            value=9,
        ),
        ErrorMessage("idle", "expected 'hello' within 10 s", recoverable=False),
        ErrorMessage("slow", "12 predictions gave way to newer ones because they were not read in time"),
    ),
    "goodbye": (Bye("the server stops"),),
}
"""The examples of each message by its key in the document."""

EVENT_ROWS = [(0.5, 640.0, 360.0, NONE, NONE, 0), (0.508, 643.0, 359.0, 4, -1, 1)]
PREDICTION_ROW = (0.508, 871.5, 251.0, 220.5, -12.0, 180.25, 0.35, 1.0, 4.5, 0.25)
"""A row of ``PredictionColumns``."""
NO_PREDICTION_ROW = (0.5, *(NONE,) * 6, 0.0, NONE, NONE)


CHANNEL = {"$ref": "#/channels/stream"}
LATER = {"events": ["prediction", "binaryPredictions", "cursor"], "trial": ["score"]}
"""Replies that a handler does not return, because they are made elsewhere."""
NO_CHOICES = ("hello", "bye")
"""All other messages may change which target is proposed."""


def document() -> dict[str, Any]:
    """The whole description."""
    components = schemas()
    messages = _messages()
    return {
        "asyncapi": "3.0.0",
        "info": {
            "title": "pointpred",
            "version": pointpred.__version__,
            "description": ABOUT,
            "license": {"name": "Apache-2.0"},
        },
        "defaultContentType": "application/json",
        "servers": {
            "local": {
                "host": "127.0.0.1:8765",
                "protocol": "ws",
                "description": "What `pointpred serve` prints; a token is needed where one is set.",
                "security": [{"$ref": f"#/components/securitySchemes/{name}"} for name in SECURITY],
            }
        },
        "channels": {
            "stream": {
                "address": "/v1/stream",
                "summary": "One pointing session.",
                "messages": {name: {"$ref": f"#/components/messages/{name}"} for name in messages},
                "bindings": {"ws": {"method": "GET", "bindingVersion": "0.1.0"}},
                "x-subprotocol": SUBPROTOCOL,
                "x-close-codes": CLOSES,
                "x-error-codes": CODES,
            },
            "live": live_channel(),
        },
        "operations": {**_operations(), **live_operations()},
        "components": {
            "messages": {**messages, **live_messages()},
            "schemas": {name: _draft7(schema) for name, schema in components.items()},
            "securitySchemes": SECURITY,
        },
    }


def render() -> str:
    """The document as YAML."""
    text: str = yaml.dump(document(), Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=110)
    return text


class _Dumper(yaml.SafeDumper):
    """YAML without anchors, with texts of several lines as they are."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


def _text(dumper: yaml.SafeDumper, text: str) -> yaml.ScalarNode:
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style="|" if "\n" in text else None)


_Dumper.add_representer(str, _text)


def schemas() -> dict[str, Any]:
    """The components of all messages as JSON schemas."""
    components: dict[str, Any] = {}
    for kinds in (CLIENT_MESSAGES + SERVER_MESSAGES, LIVE_MESSAGES):
        ref = "#/components/schemas/{name}"
        components |= msgspec.json.schema_components(dict.fromkeys(kinds), ref_template=ref)[1]
    return components


def keys() -> tuple[dict[str, type[msgspec.Struct]], dict[str, type[msgspec.Struct]]]:
    """The messages of the client and of the server by their keys: the type on the wire, where it is free."""
    client = {str(kind.__struct_config__.tag): kind for kind in CLIENT_MESSAGES}
    server: dict[str, type[msgspec.Struct]] = {}
    for kind in SERVER_MESSAGES:
        tag, name = str(kind.__struct_config__.tag), kind.__name__
        server[tag if tag not in client else f"{name[0].lower()}{name[1:]}"] = kind
    server["goodbye"] = server.pop("bye")
    return client, server


def example_of(kind: type[msgspec.Struct]) -> msgspec.Struct:
    """A message of which nobody wrote an example: each field as the first of its ``Meta(examples=...)``."""
    fields = msgspec.json.schema_components([kind])[1][kind.__name__]
    shown = {
        name: field["examples"][0] for name, field in fields["properties"].items() if "examples" in field
    }
    return msgspec.convert(shown | {"type": kind.__struct_config__.tag}, kind)


def _messages() -> dict[str, Any]:
    messages: dict[str, Any] = {}
    client, server = keys()
    for key, kind in (client | server).items():
        shown = MESSAGES.get(key) or (example_of(kind),)
        messages[key] = {
            "name": str(kind.__struct_config__.tag),
            "summary": (kind.__doc__ or "").strip().splitlines()[0],
            "contentType": "application/json",
            "payload": {"$ref": f"#/components/schemas/{kind.__name__}"},
            "examples": [{"payload": msgspec.to_builtins(one)} for one in shown],
        }
    packed = pack_events(np.array(EVENT_ROWS))
    rows, aims = np.array([PREDICTION_ROW, NO_PREDICTION_ROW]), [Likeliest(0, []), Likeliest(NOBODY, [])]
    messages["binaryEvents"] = _binary(EVENTS.format(none=NO_COUNTS), EVENT_FIELDS, packed)
    phases = ", ".join(f"{code} {name}" for code, name in enumerate(PHASES))
    words = PREDICTIONS.format(phases=phases, nobody=NOBODY, first=PREDICTION[1].itemsize)
    messages["binaryPredictions"] = _binary(words, PREDICTED, pack_predictions(rows, aims))
    return messages


def _binary(summary: str, fields: Sequence[Field], example: bytes) -> dict[str, Any]:
    layout, offset = [], 0
    for field in fields:
        layout.append({"field": field.name, "type": field.packed.lstrip("<"), "offset": offset})
        offset += np.dtype(field.packed).itemsize
    return {
        "summary": summary,
        "contentType": "application/octet-stream",
        "payload": {"type": "string", "contentEncoding": "base16", "description": f"{offset} bytes a record"},
        "examples": [{"summary": "two records, in hexadecimal", "payload": example.hex()}],
        "x-record-bytes": offset,
        "x-layout": layout,
    }


def replies() -> dict[str, list[str]]:
    """The keys of the messages that answer each message: those that its handler returns, and later ones."""
    client, server = keys()
    key_of = {kind: key for key, kind in server.items()}
    by_message: dict[str, list[str]] = {}
    for key, kind in client.items():
        handler = PointingSession.handlers.get(kind)  # events have none
        returned = get_type_hints(handler)["return"] if handler else None
        answers = [key_of[returned]] if returned in key_of else []
        choices = [] if key in NO_CHOICES else ["choice"]
        by_message[key] = answers + LATER.get(key, []) + choices
        if key == "events":
            by_message["binaryEvents"] = by_message[key]
    return by_message


def _operations() -> dict[str, Any]:
    def refs(names: list[str]) -> list[dict[str, str]]:
        return [{"$ref": f"#/channels/stream/messages/{name}"} for name in names]

    operations: dict[str, Any] = {}
    for name, answers in replies().items():
        operation = {"action": "receive", "channel": CHANNEL, "messages": refs([name])}
        if answers:
            operation["reply"] = {"channel": CHANNEL, "messages": refs([*answers, "error"])}
        operations[f"hear{name[0].upper()}{name[1:]}"] = operation
    for name in ("error", "goodbye"):
        operations[f"say{name.capitalize()}"] = {
            "action": "send",
            "channel": CHANNEL,
            "messages": refs([name]),
        }
    return operations


def _draft7(schema: Any) -> Any:
    """Tuples as JSON Schema draft 7, on which AsyncAPI stands, writes them."""
    if isinstance(schema, list):
        return [_draft7(one) for one in schema]
    if not isinstance(schema, dict):
        return schema
    changed = {key: _draft7(value) for key, value in schema.items()}
    if "prefixItems" in changed:
        changed["additionalItems"] = changed.pop("items", True)
        changed["items"] = changed.pop("prefixItems")
    return changed


LIVE_ABOUT = f"""Read only: events and predictions of the mouse attached to the machine of the service
(`pointpred live --serve`). The server speaks first: `device`, `status` and, where something is known of it,
`transfer`. Then `events` come with the newest `prediction`, at most 120 times a second, `status` once a
second, and `transfer` when it is new. Times are those of the clock that `device` names. A viewer need not
send anything; `bye` ends the session, everything else is answered by an error. One that reads slowly gets the
newest frame, and `slow` gives the number of predictions dropped. Origin, host, token and the number of
sessions are checked as for `/v1/stream`.

Where no device is attached the upgrade is answered with HTTP 404 and an `error`: {NO_DEVICE}.
`GET /v1/live` shows without an upgrade whether one is attached."""

CURVE = GainCurve(
    words="identified between 0.025 and 0.250 m/s of the hand, from 4100 displacements",
    speeds=[0.025, 0.25],
    gains=[4.02, 3.98],
    excited=(0.025, 0.25),
    measured_speeds=[0.03, 0.2],
    measured_gains=[4.05, 3.99],
    measured_errors=[0.04, 0.01],
    coefficients=[0.0, 4.0],
    compared=[Comparison("constant", {"gain": 4.0}, 0.004, 0.0125, [4.0, 4.0])],
    closest="constant",
    samples=4100,
    skipped=3,
    edges=12,
    fast=0,
)
NOTE = "nothing moves. Listening to /dev/input/event5 (Some mouse). Move the mouse that is to be followed"
EXAMPLES = {
    "device": (
        Attached("Some mouse", "the kernel's stamps", "screen", "the cursor", RECOMMENDED, 800.0, 110.0),
        Attached("Some mouse", "at the read", "motor", "prediction in motor space", RECOMMENDED),
    ),
    "status": (Status(True, 61250, 998.0, 2, 1, 3, 4, 5e-05, 0.00038), Status(False, 0, 0.0, note=NOTE)),
    "transfer": (Curve(CURVE.words, CURVE), Curve("nothing learnt yet: move the mouse")),
}
"""Messages of this stream only."""
SHARED = ("events", "prediction", "error", "goodbye")
"""Messages that both streams have."""


def live_messages() -> dict[str, Any]:
    """The messages that only this stream has."""
    return {
        name: {
            "name": name,
            "summary": (type(shown[0]).__doc__ or "").strip().splitlines()[0],
            "contentType": "application/json",
            "payload": {"$ref": f"#/components/schemas/{type(shown[0]).__name__}"},
            "examples": [{"payload": msgspec.to_builtins(one)} for one in shown],
        }
        for name, shown in EXAMPLES.items()
    }


def live_channel() -> dict[str, Any]:
    """The channel."""
    return {
        "address": "/v1/live",
        "summary": "The device attached to the machine of the service.",
        "description": LIVE_ABOUT,
        "messages": {name: {"$ref": f"#/components/messages/{name}"} for name in (*EXAMPLES, *SHARED, "bye")},
        "bindings": {"ws": {"method": "GET", "bindingVersion": "0.1.0"}},
        "x-subprotocol": SUBPROTOCOL,
    }


def live_operations() -> dict[str, Any]:
    """The messages sent to viewers, and the one received from them."""
    channel = {"$ref": "#/channels/live"}

    def one(action: str, name: str) -> dict[str, Any]:
        messages = [{"$ref": f"#/channels/live/messages/{name}"}]
        return {"action": action, "channel": channel, "messages": messages}

    operations = {f"show{name.capitalize()}": one("send", name) for name in (*EXAMPLES, *SHARED)}
    return {**operations, "hearViewerLeave": one("receive", "bye")}
