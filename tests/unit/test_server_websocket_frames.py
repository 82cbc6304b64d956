"""Whole messages in received bytes, and frames to send, against the parser of ``websockets``."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as some
from websockets.frames import Frame, Opcode
from websockets.protocol import Protocol, Side

from pointpred_server.websocket_frames import frame_end, framed, whole_message

SIZES = some.one_of(
    some.integers(0, 130), some.sampled_from([125, 126, 127, 1023, 1024, 65535, 65536, 70_000])
)


@given(SIZES, some.binary(max_size=20), some.binary(max_size=20), some.booleans())
def test_a_whole_message_is_read_where_it_stands(
    size: int, before: bytes, behind: bytes, is_text: bool
) -> None:
    payload = (b"0123456789" * (size // 10 + 1))[:size]
    opcode = Opcode.TEXT if is_text else Opcode.BINARY
    sent = Frame(opcode, payload).serialize(mask=True)
    received, at = before + sent + behind, len(before)
    end = frame_end(received, at)
    assert end == at + len(sent)
    assert whole_message(received, at, end) == (payload.decode() if is_text else payload)
    for cut in range(min(len(sent), 14)):
        assert frame_end(received[: at + cut], at) in (0, end)


@given(some.binary(min_size=2, max_size=40))
def test_bytes_that_are_no_whole_message_are_left_to_the_parser(received: bytes) -> None:
    end = frame_end(received, 0)
    assert end == 0 or end >= 2
    if 0 < end <= len(received) and (message := whole_message(received, 0, end)) is not None:
        reader = Protocol(Side.SERVER)
        reader.receive_data(received[:end])
        (frame,) = reader.events_received()
        assert isinstance(frame, Frame)
        assert frame.data == (message.encode() if isinstance(message, str) else message)


@given(SIZES, some.booleans())
def test_clients_read_what_is_sent(size: int, is_text: bool) -> None:
    reader = Protocol(Side.CLIENT)
    reader.receive_data(framed("x" * size if is_text else b"x" * size))
    (frame,) = reader.events_received()
    assert isinstance(frame, Frame)
    assert (frame.opcode, frame.fin, frame.data) == (
        Opcode.TEXT if is_text else Opcode.BINARY,
        True,
        b"x" * size,
    )
