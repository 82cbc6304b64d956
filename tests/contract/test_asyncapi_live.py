"""The AsyncAPI document says what viewers of ``/v1/live`` hear, and nothing else is sent to them."""

from __future__ import annotations

import json
from typing import Any

import msgspec
import pytest

from pointpred.protocol.server_messages import LIVE_MESSAGES, Attached, Curve, Status
from pointpred_server.websocket_protocol import NO_DEVICE
from tests.contract.test_asyncapi import DOCUMENT, MESSAGES, OPERATIONS, at, refs
from tests.server.live_attached import attached
from tests.server.test_live_stream import hear, look

CHANNEL = DOCUMENT["channels"]["live"]
KINDS: dict[str, Any] = {"device": Attached, "status": Status, "transfer": Curve}


def test_every_kind_of_message_is_in_the_channel_and_said_or_heard() -> None:
    tags = {kind.__struct_config__.tag for kind in LIVE_MESSAGES}
    assert {MESSAGES[key]["name"] for key in CHANNEL["messages"]} == tags

    def told(operation: dict[str, Any]) -> list[str]:
        return refs(operation["messages"])

    ours = [one for one in OPERATIONS.values() if one["channel"]["$ref"] == "#/channels/live"]
    named = {
        action: {
            ref.rpartition("/")[2] for one in ours if one["action"] == action for ref in refs(one["messages"])
        }
        for action in ("send", "receive")
    }
    assert named["receive"] == {"bye"}
    assert named["send"] | named["receive"] == CHANNEL["messages"].keys()


@pytest.mark.parametrize("key", KINDS)
def test_examples_are_what_is_encoded_and_show_every_field(key: str) -> None:
    shown = [example["payload"] for example in MESSAGES[key]["examples"]]
    for one in shown:
        assert json.loads(msgspec.json.encode(msgspec.json.decode(json.dumps(one), type=KINDS[key]))) == one
    for field in msgspec.structs.fields(KINDS[key]):
        assert any(one[field.encode_name] != field.default for one in shown), field.name


def test_what_is_sent_has_the_fields_of_the_document() -> None:
    with attached() as (here, made), look(here) as socket:
        for kind in ("device", "status", "events", "prediction"):
            if kind == "events":
                made.move(1.0)
            schema = at(MESSAGES[kind]["payload"]["$ref"])
            fields = hear(socket, kind).keys()
            assert set(schema["required"]) <= fields <= schema["properties"].keys(), kind


def test_it_says_what_happens_without_a_device() -> None:
    assert NO_DEVICE in " ".join(CHANNEL["description"].split())
