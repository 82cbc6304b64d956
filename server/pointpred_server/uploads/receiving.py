"""Receives the body of an upload: bounded in bytes, in time, and in how many are received at once."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Awaitable
from contextlib import asynccontextmanager
from typing import Any, Protocol

from fastapi import Request
from starlette.requests import ClientDisconnect

from pointpred.protocol.server_messages import Code

MOST_BYTES = 16 * 2**20
"""Larger recordings are for ``pointpred score``."""
READ_S = 30.0
"""So long a body may take."""
MOST_AT_ONCE = 4
"""Uploads that are received, wait or are scored; each has its body in memory."""


class UploadError(Exception):
    """An upload is refused, with this HTTP status."""

    def __init__(self, code: Code, message: str, status: int) -> None:
        super().__init__(message)
        self.code = code
        self.status = status


class UploadCount(Protocol):
    """Where the current uploads are counted."""

    uploads: int


@asynccontextmanager
async def received_body(request: Request, counting: UploadCount) -> AsyncIterator[bytes]:
    """The body of a request, counted until the block ends; raises UploadError."""
    if counting.uploads >= MOST_AT_ONCE:
        raise UploadError(
            "too_many", f"{MOST_AT_ONCE} recordings are being processed, which is the most", 503
        )
    counting.uploads += 1
    try:
        yield await _in_time(request)
    finally:
        counting.uploads -= 1


async def while_connected(request: Request, waiting: Awaitable[Any]) -> None:
    """Wait as long as the client is there; raises UploadError where it leaves. The body has been read."""
    doing, leaving = asyncio.ensure_future(waiting), asyncio.ensure_future(_disconnected(request))
    try:
        await asyncio.wait({doing, leaving}, return_when=asyncio.FIRST_COMPLETED)
        if not doing.done():
            raise UploadError("slow", "the connection was lost before the recording was processed", 400)
        doing.result()  # raises what went wrong
    finally:
        leaving.cancel()
        doing.cancel()


async def _disconnected(request: Request) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass


async def _in_time(request: Request) -> bytes:
    try:
        async with asyncio.timeout(READ_S):
            return await _read(request)
    except TimeoutError:
        raise UploadError("slow", f"a recording must be received within {READ_S:g} s", 408) from None
    except ClientDisconnect:
        raise UploadError("slow", "the connection was lost before the recording was received", 400) from None


async def _read(request: Request) -> bytes:
    length = request.headers.get("content-length", "")
    body = bytearray()
    _check_size(int(length) if length.isdecimal() else 0)
    async for part in request.stream():
        body += part
        _check_size(len(body))
    return bytes(body)


def _check_size(size: int) -> None:
    if size > MOST_BYTES:
        raise UploadError("too_large", f"a recording holds at most {MOST_BYTES} bytes here", 413)
