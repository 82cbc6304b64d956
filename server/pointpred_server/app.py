"""The routes."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Callable
from typing import Any

from fastapi import FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from fastapi.staticfiles import StaticFiles
from starlette.exceptions import HTTPException
from starlette.routing import Route, WebSocketRoute

import pointpred
from pointpred.errors import ParameterError
from pointpred.registry import RECOMMENDED, REGISTRY, describe
from pointpred_server import samples
from pointpred_server.access import HostGuard, HostRule, admits_origin, header, origin_advice
from pointpred_server.endpoints import NO_DEVICE, LiveEndpoint, StreamEndpoint
from pointpred_server.http_responses import (
    SECURITY_HEADERS,
    bad_request,
    error_response,
    guard,
    http_error,
    json_response,
    server_error,
)
from pointpred_server.openapi import (
    METRICS,
    NO_METRICS,
    NOT_READY,
    Health,
    Origin,
    Readiness,
    error_responses,
    text_response,
)
from pointpred_server.page import WEB, page
from pointpred_server.service import Service

SCRIPT = "text/javascript"
CLIENT_MODULE = 'export * from "./web/pointpred.js";\n'
"""The short address of the client; its parts lie beside the module itself, wherever that is served from."""
OPEN, GUARDED = error_responses(403), error_responses(401, 403)


def create_app(hosts: HostRule | None = None, service: Service | None = None) -> FastAPI:
    """The application; ``hosts`` says which ``Host`` headers are answered, the loopback names by default."""
    serving = service or Service()
    app = FastAPI(
        title="pointpred",
        version=pointpred.__version__,
        docs_url=None,
        redoc_url=None,
        lifespan=_lifespan,
        generate_unique_id_function=lambda route: route.name.strip("_"),
    )
    app.state.service = serving
    app.middleware("http")(guard)
    count = serving.metrics.connections_refused.labels("unauthorized").inc
    app.add_middleware(HostGuard, rule=hosts or HostRule(), headers=SECURITY_HEADERS, on_refusal=count)
    app.exception_handler(ParameterError)(bad_request)
    app.exception_handler(Exception)(server_error)
    app.exception_handler(HTTPException)(http_error)
    app.exception_handler(RequestValidationError)(bad_request)
    _add_read(app, "/healthz", _health, responses=OPEN, response_model=Health)
    _add_read(app, "/readyz", _ready, responses=OPEN | NOT_READY, response_model=Readiness)
    _add_read(
        app,
        "/metrics",
        _metrics,
        responses=GUARDED | NO_METRICS | text_response(METRICS),
        response_class=Response,
    )
    _add_read(app, "/", _page, responses=GUARDED | text_response("text/html"), response_class=Response)
    _add_read(
        app,
        "/pointpred.js",
        _client,
        responses=OPEN | text_response("text/javascript"),
        response_class=Response,
    )
    _add_read(app, "/v1/origin", _origin, responses=OPEN, response_model=Origin)
    _add_read(app, "/v1/predictors", _predictors, responses=GUARDED)
    _add_read(app, "/v1/samples", _samples, responses=GUARDED)
    _add_read(app, "/v1/samples/{name}", _sample, responses=error_responses(401, 403, 404, 422))
    stream = StreamEndpoint(serving)
    app.router.routes.append(WebSocketRoute("/v1/stream", stream))
    app.router.routes.append(
        Route("/v1/stream", stream, include_in_schema=False)
    )  # answers that it speaks WebSocket
    _add_read(app, "/v1/live", _live, responses=GUARDED)
    app.router.routes.append(WebSocketRoute("/v1/live", LiveEndpoint(serving)))
    app.mount("/web", StaticFiles(directory=WEB))
    return app


def _add_read(app: FastAPI, path: str, call: Callable[..., Any], **described: Any) -> None:
    """A route to read from; ``HEAD`` answers like ``GET`` and is not described apart."""
    app.add_api_route(path, call, methods=["GET"], summary=_summary(call), **described)
    app.add_api_route(path, call, methods=["HEAD"], include_in_schema=False)


def _summary(call: Callable[..., Any]) -> str:
    return (call.__doc__ or "").partition("\n")[0]


@contextlib.asynccontextmanager
async def _lifespan(app: FastAPI) -> AsyncIterator[None]:
    """Write what is recorded at the end."""
    service: Service = app.state.service
    service.start()
    yield
    service.stop()
    await asyncio.to_thread(service.shut_down)


def _health() -> dict[str, str]:
    """The process answers."""
    return {"status": "ok", "version": pointpred.__version__}


def _ready(request: Request) -> Response:
    """Sessions are served: 200; while workers start, or the service stops, 503."""
    service: Service = request.app.state.service
    return json_response(
        {"ready": service.ready, "stopping": service.stopping}, 200 if service.ready else 503
    )


async def _metrics(request: Request) -> Response:
    """Counters and histograms for Prometheus."""
    service: Service = request.app.state.service
    try:
        text = await service.metrics_text()  # on the loop: sessions come and go
    except TimeoutError:
        return error_response("slow", "the metrics of all workers did not come in time: ask again", 503)
    return Response(text, media_type=METRICS)


def _page() -> Response:
    """The live page."""
    return Response(page(), media_type="text/html")


def _client() -> Response:
    """The browser client, an ES module."""
    return Response(CLIENT_MODULE, media_type=SCRIPT)


def _origin(request: Request) -> Response:
    """Whether the page that asks may connect: a browser hides from it why a WebSocket was refused."""
    service: Service = request.app.state.service
    origin = header(request.scope, b"origin")
    allowed = admits_origin(request.scope, service.settings.allow_origin)
    return json_response(
        {"origin": origin, "allowed": allowed, "message": None if allowed else origin_advice(origin)}
    )


def _predictors(request: Request) -> Response:
    """Every predictor with its parameters, units, bounds and reference, and the recommended one."""
    service: Service = request.app.state.service
    return json_response(
        {
            "version": 1,
            "recommended": RECOMMENDED,
            "coefficients": sorted(service.settings.coefficients),
            "predictors": [describe(name) for name in REGISTRY],
        }
    )


def _samples() -> Response:
    """The trials of the embedded sample."""
    return json_response(samples.listing())


async def _sample(name: str) -> Response:
    """The events of one trial, as columns."""
    return json_response(await asyncio.to_thread(samples.trial, name))


def _live(request: Request) -> Response:
    """The device attached to this machine, if any; a WebSocket at the same path shows what it does."""
    service: Service = request.app.state.service
    if (feed := service.live) is None:
        return json_response({"version": 1, "attached": None, "message": NO_DEVICE})
    return json_response({"version": 1, "attached": feed.attached, "message": feed.attached.words})
