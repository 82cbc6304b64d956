"""What stands around every answer: headers, who may ask, and how failures are told."""

from __future__ import annotations

from typing import Any

import msgspec
from fastapi import Request, Response
from starlette.exceptions import HTTPException

from pointpred.errors import ColumnsError
from pointpred.server.endpoint import SHOW_TOKEN, shows_token
from pointpred.server.hosts import admits_origin, header
from pointpred.server.origins import advice
from pointpred.server.uploads.uploads import UploadError

SAFE = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-cache",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Embedder-Policy": "require-corp",
}
"""Headers of every answer: nothing is loaded from elsewhere, an upgrade is seen at once, and the page is
isolated, which lets the browser stamp events to 5 us instead of 100."""

SHARED = {"Access-Control-Allow-Origin": "*", "Cross-Origin-Resource-Policy": "cross-origin"}
"""Any page may load the client and its parts, and ask whether its origin may connect."""
CLIENT = ("/pointpred.js", "/web/client/", "/v1/origin")
READ = ["GET", "HEAD"]
OPEN = ("/healthz", "/readyz", "/web/", "/pointpred.js", "/v1/origin")
"""Paths that need no token: they hold nothing of anybody."""


def answer(value: Any, status: int = 200) -> Response:
    """A value as JSON."""
    return Response(msgspec.json.encode(value), status, media_type="application/json")


def error_answer(code: str, message: str, status: int, **known: Any) -> Response:
    """An error in the one shape that errors have, with what else is ``known`` of it."""
    error = {"type": "error", "code": code, "message": message, "path": None, "recoverable": True}
    return answer(error | known, status)


async def harden(request: Request, forward: Any) -> Response:
    """Ask for the token, and posts for their origin; add the headers."""
    service = request.app.state.service
    token, allowed = service.settings.token, service.settings.allow_origin
    if not request.url.path.startswith(OPEN) and not shows_token(request.scope, token):
        response = _turn_away(request, SHOW_TOKEN, 401)
    elif request.method not in READ and not admits_origin(request.scope, allowed):
        origin = header(request.scope, b"origin")
        service.refuse_origin(origin)
        response = error_answer("unauthorized", advice(origin), 403)
    else:
        response = await forward(request)
    response.headers.update(SAFE | SHARED if request.url.path.startswith(CLIENT) else SAFE)
    return response


def _turn_away(request: Request, message: str, status: int) -> Response:
    request.app.state.service.metrics.turned_away.labels("unauthorized").inc()
    return error_answer("unauthorized", message, status)


async def fail(request: Request, error: Exception) -> Response:
    """Something broke on this side; the server logs where."""
    response = error_answer("internal", "the server failed", 500)
    response.headers.update(SAFE)  # made outside everything that would add them
    return response


async def refuse(request: Request, error: Exception) -> Response:
    """What was asked for cannot be used, or is not there."""
    if isinstance(error, ColumnsError):
        names = ("columns", "guess", "time_unit", "reason")
        known = {name: getattr(error, name) for name in names}
        return error_answer("columns", str(error), 422, **known)
    unknown = "unknown predictor" in str(error)
    found = request.url.path.startswith("/v1/samples/")
    return error_answer("unknown_predictor" if unknown else "bad_field", str(error), 404 if found else 422)


async def miss(request: Request, error: Exception) -> Response:
    """A path that is not there, or a method that is not for it."""
    assert isinstance(error, HTTPException)
    path, headers = request.url.path, dict(error.headers or {})
    if error.status_code == 405:
        allowed = headers.get("Allow", "GET")
        headers["Allow"] = ", ".join(READ) if allowed in READ else allowed
        words = f"{path} answers {headers['Allow']}, received {request.method}"
        response = error_answer("out_of_place", words, 405)
    elif error.status_code == 404:
        response = error_answer("bad_field", f"nothing is at {path}; /openapi.json says what is", 404)
    else:
        response = error_answer("bad_field", str(error.detail), error.status_code)
    response.headers.update(headers)
    return response


async def turn_down(request: Request, error: Exception) -> Response:
    """An upload that is not taken; what of it still comes is not waited for."""
    assert isinstance(error, UploadError)
    response = error_answer(error.code, str(error), error.status)
    if error.status == 408:
        response.headers["Connection"] = "close"
    return response
