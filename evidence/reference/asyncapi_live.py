"""The part of the AsyncAPI document for ``/v1/live``: the stream of the attached device."""

from __future__ import annotations

from typing import Any

import msgspec

from pointpred.protocol.client_messages import SUBPROTOCOL
from pointpred.protocol.server_messages import Attached, Curve, Status
from pointpred.registry import RECOMMENDED
from pointpred.transfer import GainCurve
from pointpred.transfer.curve import Comparison
from pointpred_server.endpoints import NO_DEVICE

ABOUT = f"""Read only: events and predictions of the mouse attached to the machine of the service
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
        "description": ABOUT,
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
