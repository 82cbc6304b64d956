"""What the Python client does with frames that no service of this protocol sends."""

from __future__ import annotations

import pytest

from pointpred.client.session import ClientSession, hello_message
from pointpred.errors import SourceError
from pointpred.protocol.records import PREDICTION


@pytest.mark.parametrize(
    "frame",
    [
        "",
        "no JSON",
        '{"type":"unknown"}',
        '{"type":"prediction"}',
        '{"type":"prediction","t":1,"x":2,"y":3,"region":null,"phase":null,"remaining_s":null}',
        "[" * 100_000,
        b"",
        b"\0" * (PREDICTION.itemsize + 1),
        bytes(56) + b"\xff" + bytes(8),
    ],
    ids=[
        "empty",
        "no JSON",
        "unknown",
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
