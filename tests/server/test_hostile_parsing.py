"""Requests that cost the HTTP parser much: others have their turn meanwhile, and most are refused."""

from __future__ import annotations

import asyncio
from typing import ClassVar

import httptools
import pytest
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol
from websockets.frames import Frame, Opcode

from pointpred_server.http_protocol import CHUNKS, HEADER_LINES, PIECE_BYTES
from tests.server.listener import soon
from tests.server.running import HELLO, running
from tests.server.test_hostile_connections import half, refused
from tests.server.test_hostile_requests import LINE, TOKEN, UPGRADE, answer, answer_or_reset

CHUNKED = b"POST /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nTransfer-Encoding: chunked\r\n\r\n"
CHUNK = b"1\r\nx\r\n"
LAST = b"GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n"


@pytest.mark.parametrize(
    ("sent", "status", "code", "said"),
    [
        (CHUNKED + CHUNK + b"0\r\na: b\r\n\r\n", 400, "bad_field", "trailers"),
        (CHUNKED + CHUNK + b"0\r\n" + b"a:b\r\n" * 100_000, 400, "bad_field", "trailers"),
        (CHUNKED + CHUNK * CHUNKS + b"0\r\n\r\n", 413, "too_large", "16384 chunks"),
        (b"GET / HTTP/1.1\r\n" + b"a:\r\n" * 60_000, 431, "too_large", "256 lines"),
    ],
    ids=["a trailer", "trailers without an end", "short chunks", "short headers"],
)
@pytest.mark.parametrize("token", [None, TOKEN])
def test_what_costs_the_parser_much_is_refused(
    token: str | None, sent: bytes, status: int, code: str, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without a token, too: the answer to a request that needs one does not end its body."""
    kept: list[bytes] = []
    keep = HttpToolsProtocol.on_header

    def counted(self: HttpToolsProtocol, name: bytes, value: bytes) -> None:
        kept.append(name)
        keep(self, name, value)

    monkeypatch.setattr(HttpToolsProtocol, "on_header", counted)
    monkeypatch.setattr("pointpred_server.http_protocol.DRAIN_S", 0.3)
    with running(token=token) as here, half(here, sent) as opened:
        heard = answer(opened)
        assert b"HTTP/1.1 %d " % status in heard
        assert said in heard.decode()
        assert refused(here, code) == 1.0
        assert len(kept) <= HEADER_LINES
        soon(lambda: not here.server.server_state.connections, "it is closed")


def test_a_body_of_many_chunks_is_read() -> None:
    """The empty one at its end is one of them."""
    with running() as here, half(here, CHUNKED + CHUNK * (CHUNKS - 1) + b"0\r\n\r\n" + LAST) as opened:
        assert answer(opened).count(b"HTTP/1.1 200 ") == 1


class PiecewiseParser(httptools.HttpRequestParser):  # type: ignore[misc]
    """Has the lengths of what it was given, and whether the loop had a turn in between."""

    lengths: ClassVar[list[int]] = []
    turns: ClassVar[list[bool]] = []
    had_turn: ClassVar[bool] = True

    @classmethod
    def take_turn(cls) -> None:
        cls.had_turn = True

    def feed_data(self, data: bytes) -> None:
        self.lengths.append(len(data))
        self.turns.append(PiecewiseParser.had_turn)
        PiecewiseParser.had_turn = False
        asyncio.get_running_loop().call_soon(self.take_turn)
        super().feed_data(data)


@pytest.fixture
def pieces(monkeypatch: pytest.MonkeyPatch) -> type[PiecewiseParser]:
    monkeypatch.setattr(httptools, "HttpRequestParser", PiecewiseParser)
    monkeypatch.setattr(PiecewiseParser, "lengths", [])
    monkeypatch.setattr(PiecewiseParser, "turns", [])
    return PiecewiseParser


def test_others_have_their_turn_while_much_is_parsed(pieces: type[PiecewiseParser]) -> None:
    words = b"x" * 1000
    body = b"%x\r\n%b\r\n" % (len(words), words) * 1000
    sent = CHUNKED + body + b"0\r\n\r\n" + LAST
    with running() as here, half(here, sent) as opened:
        assert answer(opened).count(b"HTTP/1.1 200 ") == 1
    assert sum(pieces.lengths) == len(sent)
    assert max(pieces.lengths) == PIECE_BYTES
    few = len(pieces.turns) / 2  # the last piece of one read may be followed by the first of the next
    assert sum(pieces.turns) > few


def test_a_body_of_a_given_length_is_not_cut_into_pieces(pieces: type[PiecewiseParser]) -> None:
    """It costs the parser the same as a short one."""
    head = CHUNKED.replace(b"Transfer-Encoding: chunked", b"Content-Length: 4000000")
    sent = head + b"x" * 4_000_000 + LAST
    with running() as here, half(here, sent) as opened:
        assert answer(opened).count(b"HTTP/1.1 200 ") == 1
    assert sum(pieces.lengths) == len(sent)
    assert max(pieces.lengths) > PIECE_BYTES
    assert len(pieces.lengths) < len(sent) / PIECE_BYTES / 2


def test_what_follows_a_body_is_cut_into_pieces(pieces: type[PiecewiseParser]) -> None:
    head = CHUNKED.replace(b"Transfer-Encoding: chunked", b"Content-Length: 100000")
    sent = head + b"x" * 100_000 + b"GET / HTTP/1.1\r\n" + b"a:\r\n" * 20_000
    with running() as here, half(here, sent) as opened:
        answer_or_reset(opened)
        assert refused(here, "too_large") == 1.0
    behind = sum(pieces.lengths) - len(head) - 100_000
    assert behind <= 2 * PIECE_BYTES, "it is refused in the first piece"


def test_frames_behind_the_pieces_of_a_request_are_read() -> None:
    hello = Frame(Opcode.TEXT, HELLO.encode()).serialize(mask=True)
    sent = LINE + UPGRADE + b"Cookie: " + b"x" * 60_000 + b"\r\n\r\n" + hello
    with running() as here, half(here, sent) as opened:
        heard = b""
        while b'"type":"welcome"' not in heard:
            part = opened.recv(4096)
            assert part, heard
            heard += part
