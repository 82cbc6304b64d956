"""Log entries of the service, one JSON object a line or plain text; movement data never reach them."""

from __future__ import annotations

import json
import logging
import sys
from datetime import UTC, datetime
from typing import Literal

FIELDS = ("session", "code", "events", "error")
"""What an entry may carry beside its message; nothing that a pointer did."""


class JsonLines(logging.Formatter):
    """An entry as one JSON object."""

    def format(self, record: logging.LogRecord) -> str:
        """Time, level, logger, message, the known fields, and the traceback where there is one."""
        entry: dict[str, object] = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": record.getMessage(),
        }
        entry |= {name: record.__dict__[name] for name in FIELDS if name in record.__dict__}
        if record.exc_info:
            entry["traceback"] = self.formatException(record.exc_info)
        return json.dumps(entry)


def set_up(style: Literal["json", "text"]) -> None:
    """Send the entries of pointpred and its web server to stderr."""
    handler = logging.StreamHandler(sys.stderr)
    plain = logging.Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s")
    handler.setFormatter(JsonLines() if style == "json" else plain)
    for name, level in {"pointpred": logging.INFO, "uvicorn": logging.WARNING}.items():
        logger = logging.getLogger(name)
        logger.handlers[:] = [handler]
        logger.setLevel(level)
        logger.propagate = False
