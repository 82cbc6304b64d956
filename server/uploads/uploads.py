"""The body of an upload: bounded in bytes, in time, and in how many come at once."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Protocol

from fastapi import Request
from starlette.requests import ClientDisconnect

from pointpred.protocol.server_messages import Code

MOST_BYTES = 16 * 2**20
"""A larger recording is scored by ``pointpred score``."""
READ_S = 30.0
"""A body has come whole within this time."""
MOST_AT_ONCE = 4
"""Uploads that are received, wait to be scored or are scored; each holds its body."""


class UploadError(Exception):
    """Why an upload is not taken, and the status that says so."""

    def __init__(self, code: Code, message: str, status: int) -> None:
        super().__init__(message)
        self.code = code
        self.status = status


class Counting(Protocol):
    """Where the uploads under way are counted."""

    uploads: int


@asynccontextmanager
async def received(request: Request, counting: Counting) -> AsyncIterator[bytes]:
    """The body of a request, while it is needed; raises UploadError."""
    if counting.uploads >= MOST_AT_ONCE:
        raise UploadError("too_many", f"{MOST_AT_ONCE} recordings are under way, which is the most", 503)
    counting.uploads += 1
    try:
        yield await _in_time(request)
    finally:
        counting.uploads -= 1


async def _in_time(request: Request) -> bytes:
    try:
        async with asyncio.timeout(READ_S):
            return await _read(request)
    except TimeoutError:
        raise UploadError("slow", f"a recording comes whole within {READ_S:g} s", 408) from None
    except ClientDisconnect:
        raise UploadError("slow", "the connection was lost before the recording had come", 400) from None


async def _read(request: Request) -> bytes:
    said = request.headers.get("content-length", "")
    body = bytearray()
    _check(int(said) if said.isdecimal() else 0)
    async for part in request.stream():
        body += part
        _check(len(body))
    return bytes(body)


def _check(size: int) -> None:
    if size > MOST_BYTES:
        raise UploadError("too_large", f"a recording holds at most {MOST_BYTES} bytes here", 413)
