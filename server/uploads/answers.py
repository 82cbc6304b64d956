"""The response to an upload, made in the process that opens and scores it."""

from __future__ import annotations

from typing import Any

import msgspec
import pyarrow.parquet  # noqa: F401 - loaded before the memory is bounded

from pointpred.errors import PointpredError
from pointpred_server.logs import place_of
from pointpred_server.uploads.process import TOO_LARGE, Order, Outcome
from pointpred_server.uploads.receiving import UploadError
from pointpred_server.uploads.recordings import open_body, score_body
from pointpred_server.uploads.refusals import refusal_of


def answer(order: Order, body: bytes) -> tuple[Outcome, bytes]:
    """What came of an upload, and the response to it."""
    try:
        result: Any = (
            open_body(body, order.query)
            if order.task == "open"
            else score_body(body, order.predictors, order.query)
        )
        response = msgspec.json.encode(result)
    except Exception as error:
        if _is_out_of_memory(error):
            status, response = refusal_of(UploadError("too_large", TOO_LARGE, 413))
            return Outcome(status, len(response), exhausted=True), response
        if not isinstance(error, PointpredError | UploadError):
            return Outcome(500, 0, place_of(error)), b""
        status, response = refusal_of(error)
        return Outcome(status, len(response)), response
    return Outcome(200, len(response)), response


def _is_out_of_memory(error: BaseException | None) -> bool:
    """Whether memory ran out, perhaps where a reader took that for a damaged file."""
    while error is not None and not isinstance(error, MemoryError):
        error = error.__context__
    return error is not None
