"""Errors as HTTP answers them: the status, and the shape that errors have on the WebSocket."""

from __future__ import annotations

import msgspec

from pointpred.errors import ColumnsError, PointpredError
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Code, encode
from pointpred_server.uploads.receiving import UploadError


def refusal_of(error: Exception) -> tuple[int, bytes]:
    """422 and the reason for what cannot be used; an upload that is refused has a status of its own."""
    if isinstance(error, UploadError):
        return error.status, encode(ProtocolError(error.code, str(error)).answer)
    if isinstance(error, ColumnsError):
        shape = msgspec.to_builtins(ProtocolError("columns", str(error)).answer)
        names = ("columns", "guess", "time_unit", "reason")
        return 422, msgspec.json.encode(shape | {name: getattr(error, name) for name in names})
    if not isinstance(error, PointpredError):
        return 422, encode(ProtocolError("bad_field", str(error)).answer)
    code: Code = "unknown_predictor" if error.code == "unknown_predictor" else "bad_field"
    return 422, encode(ProtocolError(code, str(error), field=error.field, value=error.value).answer)
