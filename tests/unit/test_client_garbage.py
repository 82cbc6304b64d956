"""What the Python client does with frames that no service of this protocol sends."""

from __future__ import annotations

import pytest

from pointpred.client.session import ClientSession, ServiceError, hello_message
from pointpred.errors import SourceError
from pointpred.protocol.client_messages import VERSION
from pointpred.protocol.frames import PREDICTION


@pytest.mark.parametrize(
    "frame",
    [
        "",
        "no JSON",
        '{"type":""}',
        '{"type":7}',
        '{"type":"prediction"}',
        '{"type":"prediction","t":1,"x":2,"y":3,"region":null,"phase":null,"remaining_s":null}',
        "[" * 100_000,
        b"",
        b"\0" * (PREDICTION[VERSION].itemsize + 1),
        bytes(56) + b"\xff" + bytes(18),
    ],
    ids=[
        "empty",
        "no JSON",
        "empty type",
        "no type",
        "a field missing",
        "phase missing",
        "deep",
        "no record",
        "half a record",
        "no phase",
    ],
)
def test_what_is_no_message_is_a_source_error(frame: str | bytes) -> None:
    client = ClientSession(hello_message())
    with pytest.raises(SourceError, match="does a service of this version"):
        client.receive(frame)
    assert client.take() is None


def test_what_a_newer_service_sends_is_ignored() -> None:
    """docs/reference/compatibility.md: further messages, fields and codes of errors."""
    client = ClientSession(hello_message())
    assert client.receive('{"type":"weather","sky":"blue"}') is None
    client.receive('{"type":"prediction","t":1,"x":2,"y":3,"phase":"still","confidence":{"of":1}}')
    message = client.take()
    assert message is not None
    assert message.t == 1
    with pytest.raises(ServiceError, match="too_hot: it is") as caught:
        client.receive('{"type":"error","code":"too_hot","message":"it is","recoverable":true,"degrees":40}')
    assert (caught.value.code, caught.value.recoverable) == ("too_hot", True)
