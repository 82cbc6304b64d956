"""The messages that a client may send, for the page: their fields, bounds and defaults, from the schema."""

from __future__ import annotations

import json
from typing import Any

import msgspec

from pointpred.protocol.client_messages import CLIENT_MESSAGES
from pointpred.records import EVENT_FIELDS

LEFT_OUT = ("title", "description")


def messages_text() -> str:
    """The module: ``CLIENT_MESSAGES`` by type, each a JSON schema without references; ``EVENT_FIELDS``.

    The rows of events are checked as tables, by ``EVENT_FIELDS``: their schema is left out.
    """
    schemas, named = msgspec.json.schema_components(CLIENT_MESSAGES, ref_template="{name}")
    messages = {}
    for schema in schemas:
        message = inlined(schema, named)
        messages[message["properties"]["type"]["enum"][0]] = message
    messages["events"]["properties"]["events"]["items"] = {}
    fields = [
        {"name": one.name, "low": one.low, "high": one.high, "whole": one.whole, "optional": one.optional}
        for one in EVENT_FIELDS
    ]
    lines = [
        "// Written by `make page` from the messages in pointpred/protocol: change these and run it again."
    ]
    lines += [
        f"export const {name} = {json.dumps(value)};"
        for name, value in (("CLIENT_MESSAGES", messages), ("EVENT_FIELDS", fields))
    ]
    return "\n".join(lines) + "\n"


def inlined(schema: Any, named: dict[str, Any]) -> Any:
    """A schema whose references are replaced by what they name."""
    if isinstance(schema, list):
        return [inlined(one, named) for one in schema]
    if not isinstance(schema, dict):
        return schema
    if "$ref" in schema:
        return inlined(named[schema["$ref"]], named)
    return {key: inlined(value, named) for key, value in schema.items() if key not in LEFT_OUT}
