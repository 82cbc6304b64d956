"""A request that is refused before the application sees it: its status, the code it counts as, the reason."""

from __future__ import annotations

from http import HTTPStatus
from typing import NamedTuple

from pointpred.protocol.server_messages import Code, ErrorMessage, encode


class Refusal(NamedTuple):
    """An HTTP status, the code of an error message, and its sentence."""

    status: int
    code: Code
    message: str

    def response(self) -> bytes:
        """The whole response; the connection closes after it."""
        body = encode(ErrorMessage(self.code, self.message))
        allow = "Allow: GET\r\n" if self.status == HTTPStatus.METHOD_NOT_ALLOWED else ""
        head = (
            f"HTTP/1.1 {self.status} {HTTPStatus(self.status).phrase}\r\n{allow}"
            "Content-Type: application/json\r\nX-Content-Type-Options: nosniff\r\n"
            f"Content-Length: {len(body)}\r\nConnection: close\r\n\r\n"
        )
        return head.encode() + body
