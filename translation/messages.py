"""What is said in Python of messages and records, for the page: fields, bounds, defaults, packed types."""

from __future__ import annotations

import json
from typing import Any

import msgspec

from pointpred.protocol.client_messages import CLIENT_MESSAGES, VERSION
from pointpred.protocol.frames import NO_COUNTS, PREDICTED
from pointpred.recordings.trials import TRIAL_COLUMNS
from pointpred.records import EVENT_FIELDS, MOTION_FIELDS, Field

LEFT_OUT = ("title", "description")


def fields_text() -> str:
    """The module of the fields of records, and of what is packed."""
    return _module(
        "pointpred/records.py",
        EVENT_FIELDS=[described(one) for one in EVENT_FIELDS],
        MOTION_FIELDS=[described(one) for one in MOTION_FIELDS],
        PREDICTED=[{"name": one.name, "packed": one.packed} for one in PREDICTED],
        NO_COUNTS=NO_COUNTS,
        VERSION=VERSION,
    )


def messages_text() -> str:
    """The module: ``CLIENT_MESSAGES`` by type, each a JSON schema without references.

    The rows of events are checked as tables, by ``EVENT_FIELDS``: their schema is left out.
    """
    schemas, named = msgspec.json.schema_components(CLIENT_MESSAGES, ref_template="{name}")
    messages = {}
    for schema in schemas:
        message = inlined(schema, named)
        messages[message["properties"]["type"]["enum"][0]] = message
    messages["events"]["properties"]["events"]["items"] = {}
    return _module("pointpred/protocol", CLIENT_MESSAGES=messages, TRIAL_COLUMNS=TRIAL_COLUMNS)


def _module(source: str, **constants: Any) -> str:
    """A module of constants."""
    lines = [f"// Written by `make laws` from {source}: change that and run it again."]
    lines += [f"export const {name} = {json.dumps(value)};" for name, value in constants.items()]
    return "\n".join(lines) + "\n"


def described(field: Field) -> dict[str, Any]:
    """What the page checks of a field, or says where it is wrong, and how it is packed."""
    names = ("name", "low", "high", "whole", "optional", "packed")
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
