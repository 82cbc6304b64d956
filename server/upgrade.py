"""The upgrade of an HTTP request to a WebSocket: who may ask, and the request as ``websockets`` has it.

The HTTP parser has read the header of the request, so that it is not written out and parsed again. The parser
of ``websockets`` has bounds of its own on lines and headers, and where it refuses a request uvicorn neither
answers nor closes.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence

from websockets.datastructures import Headers
from websockets.http11 import Request
from websockets.protocol import Protocol
from websockets.server import ServerProtocol

from pointpred_server.request_refusal import Refusal

Fields = Sequence[tuple[bytes, bytes]]
"""Names in lower case, and values."""


def check_upgrade(method: bytes, version: str, url: bytes, fields: Fields) -> Refusal | None:
    """Why a request cannot open a WebSocket; ``None`` where its other headers decide."""
    if method != b"GET":
        return Refusal(405, "out_of_place", "a WebSocket is opened with GET")
    if version != "1.1":
        return Refusal(400, "out_of_place", "a WebSocket is opened with HTTP/1.1")
    if not url.isascii():
        return Refusal(400, "bad_field", "the path of a WebSocket is ASCII")
    lengths = [value for name, value in fields if name == b"content-length"]
    if any(name == b"transfer-encoding" for name, _ in fields) or any(value != b"0" for value in lengths):
        return Refusal(400, "bad_field", "a request for a WebSocket has no body")
    return None


def upgrade_request(url: bytes, fields: Fields) -> Request:
    """The request, with the values of its headers as ``websockets`` has them."""
    headers = Headers()
    for name, value in fields:
        headers[name.decode("ascii")] = value.decode("ascii", "surrogateescape")
    return Request(url.decode("ascii"), headers)


class FrameReader(ServerProtocol):
    """The server's side of a WebSocket whose request has been read elsewhere: parses frames only."""

    def parse(self) -> Generator[None]:
        """Parse frames from the beginning."""
        yield from Protocol.parse(self)
