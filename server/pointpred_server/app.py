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
from starlette.routing import Route

import pointpred
from pointpred.errors import ParameterError
from pointpred.registry import RECOMMENDED, REGISTRY, describe
from pointpred_server import samples
from pointpred_server.access import admits_origin, header, origin_advice
from pointpred_server.http_responses import (
    bad_request,
    guard,
    http_error,
    json_response,
    server_error,
)
from pointpred_server.openapi import (
    NOT_READY,
    Health,
    Origin,
    Readiness,
    error_responses,
    text_response,
)
from pointpred_server.page import WEB, page
from pointpred_server.service import Service
from pointpred_server.study import add_study
from pointpred_server.websocket_protocol import NO_DEVICE

SCRIPT = "text/javascript"
UPGRADE = "This path speaks WebSocket, subprotocol pointpred.v1.\n"
CLIENT_MODULE = 'export * from "./web/lib/pointpred.js";\n'
"""The short address of the client; its parts lie beside the module itself, wherever that is served from."""
OPEN, GUARDED = error_responses(403), error_responses(401, 403)


def create_app(service: Service | None = None, announce: Callable[[], None] = lambda: None) -> FastAPI:
    """The application of a service; ``announce`` is called when it begins to answer."""
    serving = service or Service()

    @contextlib.asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        """Write what is recorded at the end."""
        serving.start()
        announce()
        yield
        await asyncio.to_thread(serving.shut_down)

    app = FastAPI(
        title="pointpred",
        version=pointpred.__version__,
        docs_url=None,
        redoc_url=None,
        lifespan=lifespan,
        generate_unique_id_function=lambda route: route.name.strip("_"),
    )
    app.state.service = serving
    app.middleware("http")(guard)
    app.exception_handler(ParameterError)(bad_request)
    app.exception_handler(Exception)(server_error)
    app.exception_handler(HTTPException)(http_error)
    app.exception_handler(RequestValidationError)(bad_request)
    _add_read(app, "/healthz", _health, responses=OPEN, response_model=Health)
    _add_read(app, "/readyz", _ready, responses=OPEN | NOT_READY, response_model=Readiness)
    if serving.study is not None:
        add_study(app)
    else:
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
    app.router.routes.append(Route("/v1/stream", _stream, include_in_schema=False))
    _add_read(app, "/v1/live", _live, responses=GUARDED)
    app.mount("/web", StaticFiles(directory=WEB))
    return app


def _add_read(app: FastAPI, path: str, call: Callable[..., Any], **described: Any) -> None:
    """A route to read from; ``HEAD`` answers like ``GET`` and is not described apart."""
    app.add_api_route(path, call, methods=["GET"], summary=_summary(call), **described)
    app.add_api_route(path, call, methods=["HEAD"], include_in_schema=False)


def _summary(call: Callable[..., Any]) -> str:
    return (call.__doc__ or "").partition("\n")[0]


def _health() -> dict[str, str]:
    """The process answers."""
    return {"status": "ok", "version": pointpred.__version__}


def _ready(request: Request) -> Response:
    """Sessions are served: 200; while the service stops, 503."""
    service: Service = request.app.state.service
    ready = not service.stopping
    return json_response({"ready": ready, "stopping": service.stopping}, 200 if ready else 503)


def _stream(request: Request) -> Response:
    """What is asked for without a WebSocket."""
    return Response(UPGRADE, 426, {"Connection": "upgrade", "Upgrade": "websocket"}, "text/plain")


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
