"""Write the AsyncAPI 3 document of the WebSocket from the message types: part of ``make docs``."""

from __future__ import annotations

from typing import Any, get_type_hints

import msgspec
import numpy as np
import yaml

import pointpred
from evidence.reference import asyncapi_examples as examples
from evidence.reference.asyncapi_live import live_channel, live_messages, live_operations
from pointpred.protocol.client_messages import CLIENT_MESSAGES, SUBPROTOCOL
from pointpred.protocol.frames import EVENT, NO_COUNTS, PREDICTION, pack_predictions
from pointpred.protocol.server_messages import LIVE_MESSAGES, SERVER_MESSAGES
from pointpred.records import PHASES
from pointpred_server.sessions.pointing import PointingSession

CHANNEL = {"$ref": "#/channels/stream"}
PREDICTIONS = ["prediction", "binaryPredictions", "cursor"]
LATER = {"events": PREDICTIONS, "trial": ["score"]}
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
            "description": examples.ABOUT,
            "license": {"name": "Apache-2.0"},
        },
        "defaultContentType": "application/json",
        "servers": {
            "local": {
                "host": "127.0.0.1:8765",
                "protocol": "ws",
                "description": "What `pointpred serve` prints; a token is needed where one is set.",
                "security": [{"$ref": f"#/components/securitySchemes/{name}"} for name in examples.SECURITY],
            }
        },
        "channels": {
            "stream": {
                "address": "/v1/stream",
                "summary": "One pointing session.",
                "messages": {name: {"$ref": f"#/components/messages/{name}"} for name in messages},
                "bindings": {"ws": {"method": "GET", "bindingVersion": "0.1.0"}},
                "x-subprotocol": SUBPROTOCOL,
                "x-close-codes": examples.CLOSES,
                "x-error-codes": examples.CODES,
            },
            "live": live_channel(),
        },
        "operations": {**_operations(), **live_operations()},
        "components": {
            "messages": {**messages, **live_messages()},
            "schemas": {name: _draft7(schema) for name, schema in components.items()},
            "securitySchemes": examples.SECURITY,
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
        shown = examples.MESSAGES.get(key) or (example_of(kind),)
        messages[key] = {
            "name": str(kind.__struct_config__.tag),
            "summary": (kind.__doc__ or "").strip().splitlines()[0],
            "contentType": "application/json",
            "payload": {"$ref": f"#/components/schemas/{kind.__name__}"},
            "examples": [{"payload": msgspec.to_builtins(one)} for one in shown],
        }
    packed = np.array(examples.EVENT_ROWS, dtype=EVENT).tobytes()
    rows = np.array([examples.PREDICTION_ROW, examples.NO_PREDICTION_ROW])
    layout = [(name, EVENT[name].str) for name in EVENT.names or ()]
    messages["binaryEvents"] = _binary(examples.EVENTS.format(none=NO_COUNTS), layout, packed)
    phases = ", ".join(f"{code} {name}" for code, name in enumerate(PHASES))
    messages["binaryPredictions"] = _binary(
        examples.PREDICTIONS.format(phases=phases),
        [(name, "<f8") for name in ("t", "x", "y", "sxx", "sxy", "syy", "remaining_s")]
        + [("phase", PREDICTION["phase"].str), ("tail", PREDICTION["tail"].str)],
        pack_predictions(rows),
    )
    return messages


def _binary(summary: str, fields: list[tuple[str, str]], example: bytes) -> dict[str, Any]:
    layout, offset = [], 0
    for name, kind in fields:
        layout.append({"field": name, "type": kind.lstrip("<|"), "offset": offset})
        offset += np.dtype(kind).itemsize
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
        returned = get_type_hints(PointingSession.handlers[kind])["return"]
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
