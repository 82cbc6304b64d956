"""What the OpenAPI document says about the HTTP part beyond names and parameters."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import BaseModel, Field

from pointpred.protocol.server_messages import Code


class Error(BaseModel):
    """Why a request is refused: one shape for all errors."""

    type: Literal["error"]
    code: Code
    message: str = Field(description="What was wrong, the bound, the value received.")
    path: str | None = Field(description="Where in a message it was; null over HTTP.")
    recoverable: bool
    field: str | None = Field(None, description="The name of the parameter or field that is wrong.")
    value: bool | int | float | str | None = Field(None, description="What was received there.")


class Readiness(BaseModel):
    """Whether sessions are served."""

    ready: bool = Field(description="False while the service stops.")
    stopping: bool


class Origin(BaseModel):
    """Whether the page that asks may connect."""

    origin: str | None = Field(description="As the request's Origin header has it.")
    allowed: bool
    message: str | None = Field(description="The flag that would allow it; null where it is allowed.")


class Health(BaseModel):
    """The process answers."""

    status: Literal["ok"]
    version: str


Responses = dict[int | str, dict[str, Any]]

_DESCRIPTIONS = {
    401: "The token is missing or another.",
    403: "The host name is not served here.",
    404: "There is nothing of this name.",
    422: "A parameter cannot be used.",
    500: "The server failed.",
}


def error_responses(*statuses: int) -> Responses:
    """The responses to refused requests, each in the shape of errors."""
    return {status: {"model": Error, "description": _DESCRIPTIONS[status]} for status in (*statuses, 500)}


def text_response(kind: str) -> Responses:
    """A response that is not JSON."""
    return {200: {"description": "As text.", "content": {kind: {"schema": {"type": "string"}}}}}


NOT_READY: Responses = {503: {"model": Readiness, "description": "The service stops."}}
