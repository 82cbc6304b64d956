"""The AsyncAPI document says what the server does: its examples go through the real decoders."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any, get_args

import msgspec
import numpy as np
import pytest
import yaml

from evidence import ROOT
from evidence.reference.asyncapi import EVENT_ROWS, EXAMPLES, document, keys, schemas
from pointpred.protocol import client_messages, server_messages
from pointpred.protocol.client_messages import CLIENT_MESSAGES, CLIENT_TYPES, ClientMessage
from pointpred.protocol.decoding import decode_client_message, rows_of_bytes
from pointpred.protocol.frames import EVENT, PREDICTION
from pointpred.protocol.server_messages import SERVER_MESSAGES, Code, ServerMessage

DOCUMENT: dict[str, Any] = yaml.safe_load((ROOT / "docs/reference/asyncapi.yaml").read_text(encoding="utf-8"))
CHANNEL = DOCUMENT["channels"]["stream"]
MESSAGES = DOCUMENT["components"]["messages"]
OPERATIONS = DOCUMENT["operations"]
CLIENT, SERVER = keys()


def refs(value: Any) -> list[str]:
    """Every reference inside the document."""
    if isinstance(value, dict):
        own = [value["$ref"]] if isinstance(value.get("$ref"), str) else []
        return own + [found for one in value.values() for found in refs(one)]
    return [found for one in value for found in refs(one)] if isinstance(value, list) else []


def at(path: str) -> Any:
    found: Any = DOCUMENT
    for step in path.removeprefix("#/").split("/"):
        found = found[step]
    return found


def test_every_reference_leads_somewhere() -> None:
    found = refs(DOCUMENT)
    assert len(found) > 50
    for path in found:
        assert at(path)


def test_every_message_the_code_knows_is_described() -> None:
    assert [MESSAGES[key]["name"] for key in CLIENT] == list(CLIENT_TYPES)
    ours = {*CLIENT, *SERVER, "binaryEvents", "binaryPredictions"}
    assert ours | EXAMPLES.keys() == MESSAGES.keys()
    assert CHANNEL["messages"].keys() == ours


@pytest.mark.parametrize(
    ("module", "parent", "listed"),
    [(client_messages, ClientMessage, CLIENT_MESSAGES), (server_messages, ServerMessage, SERVER_MESSAGES)],
)
def test_every_message_stands_above_the_list_of_messages(module: Any, parent: type, listed: Any) -> None:
    structs = {one for one in vars(module).values() if isinstance(one, type) and issubclass(one, parent)}
    assert structs - {parent} <= set(listed)


def test_every_message_is_heard_or_said() -> None:
    def named(operation: dict[str, Any]) -> set[str]:
        return {ref.rpartition("/")[2] for ref in refs(operation.get("messages", []))}

    ours = [one for one in OPERATIONS.values() if one["channel"]["$ref"] == "#/channels/stream"]
    heard = [named(one) for one in ours if one["action"] == "receive"]
    replies = [named(one["reply"]) for one in ours if "reply" in one]
    said = [named(one) for one in ours if one["action"] == "send"]
    assert set().union(*heard) == {*CLIENT, "binaryEvents"}
    assert set().union(*replies, *said) == {*SERVER, "binaryPredictions"}


@pytest.mark.parametrize("key", CLIENT)
def test_what_a_client_says_is_decoded_by_the_server(key: str) -> None:
    for example in MESSAGES[key]["examples"]:
        assert isinstance(decode_client_message(json.dumps(example["payload"])), CLIENT[key])
        assert example["payload"]["type"] == MESSAGES[key]["name"]


@pytest.mark.parametrize("key", SERVER)
def test_what_the_server_says_is_what_it_encodes(key: str) -> None:
    for example in MESSAGES[key]["examples"]:
        back = msgspec.json.decode(json.dumps(example["payload"]), type=SERVER[key])
        assert msgspec.to_builtins(back) == example["payload"]


def test_every_kind_of_field_is_shown() -> None:
    """An example that leaves a field at its default teaches nothing: each is set somewhere."""
    for key, kind in (CLIENT | SERVER).items():
        shown = [example["payload"] for example in MESSAGES[key]["examples"]]
        defaults = dict(
            zip(kind.__struct_encode_fields__[::-1], kind.__struct_defaults__[::-1], strict=False)
        )
        for name in kind.__struct_encode_fields__:
            if name not in ("parameters", "precision"):
                assert any(name in one and one[name] != defaults.get(name) for one in shown), (key, name)


def test_packed_events_decode_to_the_numbers_they_stand_for() -> None:
    message = MESSAGES["binaryEvents"]
    events = rows_of_bytes(bytes.fromhex(message["examples"][0]["payload"]))
    none = float("nan")
    expected = [[none if value == -32768 else value for value in row] for row in EVENT_ROWS]
    np.testing.assert_array_equal(events, expected)
    assert message["x-record-bytes"] == EVENT.itemsize == 30
    assert [(one["field"], one["offset"]) for one in message["x-layout"]] == [
        (name, (EVENT.fields or {})[name][1]) for name in EVENT.names or ()
    ]


def test_packed_predictions_read_by_the_layout_are_the_numbers() -> None:
    """Read field by field as the document says, by nothing but the standard library."""
    import struct

    message = MESSAGES["binaryPredictions"]
    data = bytes.fromhex(message["examples"][0]["payload"])
    assert message["x-record-bytes"] == PREDICTION[2].itemsize == 75
    codes = {"f8": "<d", "u1": "<B", "i2": "<h"}
    first, second = (
        {
            one["field"]: struct.unpack_from(codes[one["type"]], data, start + one["offset"])[0]
            for one in message["x-layout"]
        }
        for start in (0, 75)
    )
    assert first == {
        "t": 0.508, "x": 871.5, "y": 251.0, "sxx": 220.5, "sxy": -12.0, "syy": 180.25, "remaining_s": 0.35,
        "phase": 1, "tail": 4.5, "remaining_spread": 0.25, "target": 0,
    }  # fmt: skip
    assert (second.pop("t"), second.pop("phase"), second.pop("target")) == (0.5, 0, -1)
    assert all(value != value for value in second.values())


def test_error_codes_and_close_codes_are_those_of_the_code() -> None:
    assert list(CHANNEL["x-error-codes"]) == list(get_args(Code))
    source = "".join(
        path.read_text(encoding="utf-8") for path in (ROOT / "server/pointpred_server").rglob("*.py")
    )
    used = {int(code) for code in re.findall(r"\b(10[01]\d)\b", source)}
    never_sent = {1005, 1006}  # what a close without a code, and a lost connection, are called
    assert used - never_sent - {1024, 1000} <= set(CHANNEL["x-close-codes"])


def test_schemas_are_those_of_the_messages() -> None:
    components = schemas()
    assert DOCUMENT["components"]["schemas"].keys() == components.keys()
    row = DOCUMENT["components"]["schemas"]["Events"]["properties"]["events"]["items"]
    assert "prefixItems" not in json.dumps(DOCUMENT)
    assert (len(row["items"]), row["additionalItems"]) == (6, False)


def test_it_is_valid_asyncapi(tmp_path: Path) -> None:
    """Against the official schema, where ASYNCAPI_SPECS names a folder that holds it."""
    folder = os.environ.get("ASYNCAPI_SPECS")
    if not folder or not shutil.which("node"):
        pytest.skip("ASYNCAPI_SPECS names no folder with the npm packages @asyncapi/specs and ajv")
    script = (
        "const fs=require('fs');const Ajv=require('ajv');"
        "const s=require('@asyncapi/specs/schemas/3.0.0-without-$id.json');"
        "const a=new Ajv({strict:false,allErrors:true,validateFormats:false});const v=a.compile(s);"
        "if(!v(JSON.parse(fs.readFileSync(0)))){console.log(JSON.stringify(v.errors));process.exit(1)}"
    )
    run = subprocess.run(
        ["node", "-e", script], input=json.dumps(document()), cwd=folder, capture_output=True, text=True
    )
    assert run.returncode == 0, run.stdout + run.stderr
