"""The routes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec
from fastapi import FastAPI, Request, Response
from fastapi.responses import FileResponse
from fastapi.staticfiles import StaticFiles

import pointpred
from pointpred.errors import ParameterError
from pointpred.server import samples
from pointpred.server.hosts import HostGuard, HostRule

WEB = Path(__file__).with_name("web")
SAFE = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-cache",
}
"""Headers of every answer: nothing is loaded from elsewhere, and an upgrade is seen at once."""

READ = ["GET", "HEAD"]


def create_app(hosts: HostRule | None = None) -> FastAPI:
    """The application; ``hosts`` says which ``Host`` headers are answered, the loopback names by default."""
    app = FastAPI(title="pointpred", version=pointpred.__version__, docs_url=None, redoc_url=None)
    app.middleware("http")(_harden)
    app.add_middleware(HostGuard, rule=hosts or HostRule())
    app.exception_handler(ParameterError)(_refuse)
    app.add_api_route("/healthz", _health, methods=READ)
    app.add_api_route("/", _page, methods=READ, response_class=FileResponse)
    app.add_api_route("/v1/samples", _samples, methods=["GET"])
    app.add_api_route("/v1/samples/{name}", _sample, methods=["GET"])
    app.mount("/web", StaticFiles(directory=WEB))
    return app


def _health() -> dict[str, str]:
    """The process answers."""
    return {"status": "ok", "version": pointpred.__version__}


def _page() -> FileResponse:
    return FileResponse(WEB / "index.html")


def _samples() -> Response:
    """The trials of the embedded sample."""
    return _json(samples.listing())


def _sample(name: str, predictors: str = "switched,hold") -> Response:
    """One trial with the predictions of the predictors named, separated by commas."""
    chosen = tuple(dict.fromkeys(part.strip() for part in predictors.split(",") if part.strip()))
    return _json(samples.trial(name, chosen))


def _json(value: Any, status: int = 200) -> Response:
    return Response(msgspec.json.encode(value), status, media_type="application/json")


async def _harden(request: Request, forward: Any) -> Response:
    response: Response = await forward(request)
    response.headers.update(SAFE)
    return response


async def _refuse(request: Request, error: Exception) -> Response:
    return _json({"type": "error", "code": "bad_field", "message": str(error)}, 404)
