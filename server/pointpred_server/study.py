"""The page of a study for its participants: each opens a secret link, and reaches nothing of the others."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import msgspec
from fastapi import Request, Response
from starlette.responses import RedirectResponse
from starlette.routing import Route

from pointpred.errors import ParameterError, SourceError
from pointpred.studies.folder import ConflictError, Participant
from pointpred.studies.messages import MOST_BYTES, MOST_ROWS, Message, decode
from pointpred_server.access import admits_origin
from pointpred_server.http_responses import error_response, json_response
from pointpred_server.page import study_page

if TYPE_CHECKING:
    from fastapi import FastAPI

    from pointpred_server.service import Service

FOREIGN = "pages of another site may not send here; a proxy in between must pass the Host of the page on"
UNKNOWN = "this link belongs to no participant; ask who gave it to you for a new one"
NO_LINK = "each participant has a link of their own; open yours, or ask who runs this study for it"


def add_study(app: FastAPI) -> None:
    """Add the page and what it talks to. The links are the participants' tokens: no other is asked for."""
    app.router.routes.append(Route("/", _lead, methods=["GET"]))
    app.router.routes.append(Route("/study/", _page, methods=["GET"]))
    app.router.routes.append(Route("/study/{link}", _page, methods=["GET"]))
    app.router.routes.append(Route("/v1/study/", _state, methods=["GET"]))
    app.router.routes.append(Route("/v1/study/{link}", _state, methods=["GET"]))
    app.router.routes.append(Route("/v1/study/{link}", _take, methods=["POST"]))


async def _lead(request: Request) -> Response:
    """To the page, which asks for the link."""
    return RedirectResponse("study/")


async def _page(request: Request) -> Response:
    """The page, the same for every link: what it shows comes with the state."""
    return Response(study_page(), media_type="text/html")


async def _state(request: Request) -> Response:
    """What the study is, and how far the participant is; nothing is stored."""
    if (one := await _participant(request)) is None:
        return error_response("unauthorized", UNKNOWN if request.path_params else NO_LINK, 404)
    return json_response(await asyncio.to_thread(lambda: _described(one) | one.state()))


async def _take(request: Request) -> Response:
    """Store what the page sends; the answer is how far the participant is then."""
    service: Service = request.app.state.service
    if not admits_origin(request.scope, service.settings.allow_origin):
        return error_response("unauthorized", FOREIGN, 403)
    if (one := await _participant(request)) is None:
        return error_response("unauthorized", UNKNOWN, 404)
    body = bytearray()
    async for part in request.stream():
        body += part
        if len(body) > MOST_BYTES:
            return error_response("too_large", f"more than {MOST_BYTES} bytes, which is the most", 413)
    try:
        return json_response(await asyncio.to_thread(_store, service, one, bytes(body)))
    except ConflictError as error:
        return error_response("out_of_place", str(error), 409)
    except ParameterError as error:
        return error_response("bad_field", str(error), 422, field=error.field)
    except (msgspec.MsgspecError, UnicodeError) as error:
        return error_response("bad_field", str(error), 422)
    except SourceError as error:
        return error_response("internal", str(error), 507)


def _store(service: Service, one: Participant, body: bytes) -> dict[str, Any]:
    message: Message = decode(body)
    one.take(message)
    return one.state()


async def _participant(request: Request) -> Participant | None:
    service: Service = request.app.state.service
    assert service.study is not None
    return await asyncio.to_thread(service.study.find, request.path_params.get("link", ""))


def _described(one: Participant) -> dict[str, Any]:
    """What the page needs of the design."""
    design = one.study.design
    return {
        "title": design.title,
        "consent": design.consent,
        "instructions": design.instructions,
        "thanks": design.thanks,
        "asked": design.questions,
        "on_error": design.on_error,
        "break_s": design.break_s,
        "most_rows": MOST_ROWS,
        "plan": one.plan,
    }
