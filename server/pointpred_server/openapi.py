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
    columns: list[str] | None = Field(None, description="With the code columns: those of the table.")
    guess: dict[str, str] | None = Field(
        None, description="A field, such as t, and the column that may be it."
    )
    time_unit: str | None = Field(None, description="The unit of time as far as it is known.")
    reason: str | None = Field(None, description="What is not certain, in a few words.")


class Readiness(BaseModel):
    """Whether sessions are served."""

    ready: bool = Field(description="False while the service stops.")
    stopping: bool


class Compiled(BaseModel):
    """Every predictor is ready; earlier versions said here what their first start had compiled."""

    done: int = Field(description="All predictors.")
    of: int = Field(description="All predictors.")
    next: str | None = Field(description="Always null.")
    ready: list[str] = Field(description="The names of all predictors.")
    recommended: str = Field(description="The name of the recommended predictor.")


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
    400: "The connection was lost before the recording had come.",
    401: "The token is missing or another.",
    403: "The host name is not served here, or pages of this origin may not post.",
    404: "There is nothing of this name.",
    408: "The recording did not come whole in time; the connection is closed.",
    413: "It is too large: bytes, rows, columns, trials, or what it unpacks to.",
    422: "It is no recording, or a parameter cannot be used.",
    500: "The server failed.",
    503: "As many recordings as are taken at a time are under way.",
}


def error_responses(*statuses: int) -> Responses:
    """The responses to refused requests, each in the shape of errors."""
    return {status: {"model": Error, "description": _DESCRIPTIONS[status]} for status in (*statuses, 500)}


TABLE_PARAMETERS: list[dict[str, Any]] = [
    {"name": name, "in": "query", "required": False, "schema": {"type": kind}, "description": words}
    for name, kind, words in (
        (
            "columns",
            "string",
            "Which column is which, as t=NAME,x=NAME,y=NAME,user=NAME,trial=NAME.",
        ),
        ("time_unit", "string", "Unit of t: s, ms, us, ns, or iso."),
        ("y_up", "boolean", "y grows upwards."),
        ("px_per_unit", "number", "Pixels in one unit of x, y and the target."),
        ("records", "string", "Path to the rows in nested JSON."),
        ("cut", "string", "How a stream is cut: clicks, bursts or whole."),
    )
]
"""What a query may say about any table that is uploaded."""


def text_response(kind: str) -> Responses:
    """A response that is not JSON."""
    return {200: {"description": "As text.", "content": {kind: {"schema": {"type": "string"}}}}}


NOT_READY: Responses = {503: {"model": Readiness, "description": "Not yet, or no more."}}
PARQUET = "application/vnd.apache.parquet"
UPLOAD: dict[str, Any] = {
    "parameters": TABLE_PARAMETERS,
    "requestBody": {
        "required": True,
        "description": "A recording in any format of text, or Parquet, told by its content.",
        "content": {
            "text/csv": {"schema": {"type": "string"}},
            PARQUET: {"schema": {"type": "string", "format": "binary"}},
        },
    },
}
