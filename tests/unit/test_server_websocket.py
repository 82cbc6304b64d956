"""The socket's side: short messages, which are read by hand, and what a client's close frame means."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from uvicorn.config import Config
from uvicorn.server import ServerState
from websockets.frames import Frame, Opcode
from websockets.protocol import State
from websockets.server import ServerProtocol

from pointpred_server.service import Service
from pointpred_server.websocket_protocol import SHORT_BYTES, WebSocketProtocol
from tests.server.listener import soon
from tests.server.running import running

PROTOCOL = WebSocketProtocol(Service(), Config(None), ServerState(), {})
payload = st.text(max_size=SHORT_BYTES).map(str.encode) | st.binary(max_size=3 * SHORT_BYTES)
frames = st.builds(Frame, st.sampled_from([Opcode.CONT, Opcode.TEXT, Opcode.BINARY]), payload, st.booleans())
masked = frames.map(lambda frame: frame.serialize(mask=True))
sent = st.lists(masked, max_size=2).map(b"".join) | st.binary(max_size=12)


@given(sent, sent, st.integers(0, 400))
def test_a_short_message_is_the_one_that_websockets_reads(before: bytes, data: bytes, cut: int) -> None:
    """``before`` is what the last read left in the buffer."""
    read, whole = PROTOCOL.get_buffer(0), data[: max(cut, 1)]
    read[: len(before)] = before
    read[: len(whole)] = whole
    message = PROTOCOL._short_message(len(whole)) if whole else None
    if message is None:
        return
    checked = ServerProtocol(state=State.OPEN)
    checked.receive_data(whole)
    (frame,) = checked.events_received()
    assert isinstance(frame, Frame)
    assert frame.fin
    assert bytes(frame.data) == (message.encode() if isinstance(message, str) else message)
    assert frame.opcode is (Opcode.TEXT if isinstance(message, str) else Opcode.BINARY)


def test_short_messages_are_read_by_hand() -> None:
    for opcode, data, message in (
        (Opcode.TEXT, b"", ""),
        (Opcode.TEXT, "ü".encode() * 62, "ü" * 62),
        (Opcode.BINARY, bytes(range(SHORT_BYTES)), bytes(range(SHORT_BYTES))),
        (Opcode.BINARY, bytes(range(256)) * 7, bytes(range(256)) * 7),
    ):
        frame = Frame(opcode, data).serialize(mask=True)
        PROTOCOL.get_buffer(0)[: len(frame)] = frame
        assert PROTOCOL._short_message(len(frame)) == message
    assert PROTOCOL._short_message(1) is None


def test_what_the_last_read_left_is_not_taken_for_a_length() -> None:
    PROTOCOL.get_buffer(0)[:2] = b"\x81\x7b"  # 123 is what a payload of -5 bytes would have
    assert PROTOCOL._short_message(1) is None


@pytest.mark.parametrize(("code", "counted"), [(1000, "1000"), (1001, "1001"), (4321, "1006")])
def test_a_client_that_leaves_in_order_is_counted_as_that(code: int, counted: str) -> None:
    """Codes of its own are no labels of metrics."""
    with running() as here:
        with here.connect() as socket:
            socket.close(code)
            assert socket.close_code == code
        soon(lambda: not here.service.metrics.sessions._value.get(), "the session has ended")
        (ended,) = here.service.metrics.ended.collect()
        codes = {one.labels["code"]: one.value for one in ended.samples if one.name.endswith("_total")}
        assert codes == {counted: 1.0}
