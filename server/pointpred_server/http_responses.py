"""HTTP responses: the headers of all, who may ask, and errors in one shape."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import msgspec
from fastapi import Request, Response
from starlette.exceptions import HTTPException

from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Code, encode
from pointpred_server.access import HOST_REFUSED, TOKEN_NEEDED

if TYPE_CHECKING:
    from pointpred_server.service import Service

SECURITY_HEADERS = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-cache",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Embedder-Policy": "require-corp",
}
"""Headers of every response: nothing is loaded from elsewhere, a new version is used at once, and the page is
isolated, which lets the browser stamp events to 5 us instead of 100."""

SHARED_HEADERS = {"Access-Control-Allow-Origin": "*", "Cross-Origin-Resource-Policy": "cross-origin"}
"""Any page may load the client and its parts, and ask whether its origin may connect."""
CLIENT = ("/pointpred.js", "/web/lib/", "/v1/origin")
READ = ["GET", "HEAD"]
OPEN = ("/healthz", "/readyz", "/web/", "/pointpred.js", "/v1/origin", "/study/", "/v1/study/")
"""Paths that need no token: they hold nothing of anybody, or have a secret of their own."""


def json_response(value: Any, status: int = 200) -> Response:
    """A value as JSON."""
    return Response(msgspec.json.encode(value), status, media_type="application/json")


def error_response(
    code: Code, message: str, status: int, *, field: str = "", value: object = None
) -> Response:
    """An error in the shape that errors have on the WebSocket."""
    error = ProtocolError(code, message, field=field, value=value).answer
    return Response(encode(error), status, media_type="application/json")


def crosses_sites(request: Request) -> bool:
    """Whether another site's page asks; somebody who follows its link to our page does not."""
    followed = request.method in READ and request.headers.get("sec-fetch-mode") == "navigate"
    return request.headers.get("sec-fetch-site") == "cross-site" and not followed


def is_open(service: Service, path: str) -> bool:
    """Whether a path needs no token; at the root of a study is the way to its page."""
    return path.startswith(OPEN) or (path == "/" and service.study is not None)


async def guard(request: Request, forward: Any) -> Response:
    """Check the host name, the site that asks, and the token; add the headers."""
    service, path = request.app.state.service, request.url.path
    if not service.hosts.admits(request.scope):
        response = error_response("unauthorized", HOST_REFUSED, 403)
    elif crosses_sites(request) and not path.startswith(CLIENT):
        response = error_response("unauthorized", "pages of another site may not ask for this", 403)
    elif not is_open(service, path) and not service.has_token(request.scope):
        response = error_response("unauthorized", TOKEN_NEEDED, 401)
    else:
        response = await forward(request)
    if response.status_code in (401, 403):
        service.count_refusal("unauthorized")
    response.headers.update(
        SECURITY_HEADERS | SHARED_HEADERS if request.url.path.startswith(CLIENT) else SECURITY_HEADERS
    )
    return response


async def server_error(request: Request, error: Exception) -> Response:
    """500: something broke on this side; the server logs where."""
    response = error_response("internal", "the server failed", 500)
    response.headers.update(SECURITY_HEADERS)  # made outside the middleware that adds them
    return response


async def bad_request(request: Request, error: Exception) -> Response:
    """422 for what cannot be used; 404 where a sample of that name is not there."""
    missing = request.url.path.startswith("/v1/samples/")
    return error_response("bad_field", str(error), 404 if missing else 422)


async def http_error(request: Request, error: Exception) -> Response:
    """A path that does not exist, or a method that it does not have."""
    assert isinstance(error, HTTPException)
    path, headers = request.url.path, dict(error.headers or {})
    if error.status_code == 405:
        allowed = headers.get("Allow", "GET")
        headers["Allow"] = ", ".join(READ) if allowed in READ else allowed
        sentence = f"{path} answers {headers['Allow']}, received {request.method}"
        response = error_response("out_of_place", sentence, 405)
    elif error.status_code == 404:
        response = error_response(
            "bad_field", f"there is nothing at {path}; /openapi.json lists the paths", 404
        )
    else:
        response = error_response("bad_field", str(error.detail), error.status_code)
    response.headers.update(headers)
    return response
