"""The response to an upload, made in the process that opens and scores it."""

from __future__ import annotations

from typing import Any

import msgspec
import pyarrow.parquet  # noqa: F401 - loaded before the memory is bounded

from pointpred.errors import PointpredError
from pointpred.server.logs import place_of
from pointpred.server.uploads.process import TOO_LARGE, Order
from pointpred.server.uploads.receiving import UploadError
from pointpred.server.uploads.recordings import open_body, score_body
from pointpred.server.uploads.refusals import refusal_of


def answer(order: Order, body: bytes) -> tuple[int, bytes, str | None]:
    """The status, the response, and where it failed, ``None`` where it did not."""
    try:
        result: Any = (
            open_body(body, order.query)
            if order.task == "open"
            else score_body(body, order.predictors, order.query)
        )
        return 200, msgspec.json.encode(result), None
    except (PointpredError, UploadError) as error:
        return *refusal_of(error), None
    except MemoryError:
        return *refusal_of(UploadError("too_large", TOO_LARGE, 413)), None
    except Exception as error:
        return 500, b"", place_of(error)
