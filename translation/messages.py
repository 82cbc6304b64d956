"""The messages that a client may send, for the page: their fields, bounds and defaults, from the schema."""

from __future__ import annotations

import json
from typing import Any

import msgspec

from pointpred.protocol.client_messages import CLIENT_MESSAGES
from pointpred.records import EVENT_FIELDS, MOTION_FIELDS, Field

LEFT_OUT = ("title", "description")


def messages_text() -> str:
    """The module: ``CLIENT_MESSAGES`` by type, each a JSON schema without references; the fields of records.

    The rows of events are checked as tables, by ``EVENT_FIELDS``: their schema is left out.
    """
    schemas, named = msgspec.json.schema_components(CLIENT_MESSAGES, ref_template="{name}")
    messages = {}
    for schema in schemas:
        message = inlined(schema, named)
        messages[message["properties"]["type"]["enum"][0]] = message
    messages["events"]["properties"]["events"]["items"] = {}
    lines = [
        "// Written by `make laws` from the messages in pointpred/protocol: change these and run it again."
    ]
    lines += [
        f"export const {name} = {json.dumps(value)};"
        for name, value in (
            ("CLIENT_MESSAGES", messages),
            ("EVENT_FIELDS", [described(one) for one in EVENT_FIELDS]),
            ("MOTION_FIELDS", [described(one) for one in MOTION_FIELDS]),
        )
    ]
    return "\n".join(lines) + "\n"


def described(field: Field) -> dict[str, Any]:
    """What the page checks of a field, or says where it is wrong."""
    names = ("name", "low", "high", "whole", "optional")
    return {name: getattr(field, name) for name in names}


def inlined(schema: Any, named: dict[str, Any]) -> Any:
    """A schema whose references are replaced by what they name."""
    if isinstance(schema, list):
        return [inlined(one, named) for one in schema]
    if not isinstance(schema, dict):
        return schema
    if "$ref" in schema:
        return inlined(named[schema["$ref"]], named)
    return {key: inlined(value, named) for key, value in schema.items() if key not in LEFT_OUT}
