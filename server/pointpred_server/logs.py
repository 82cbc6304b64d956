"""Log entries of the service, one JSON object a line or plain text; movement data never reach them."""

from __future__ import annotations

import json
import logging
import sys
from datetime import UTC, datetime
from typing import Literal

from pointpred.logs import OWN, PlainLines, fields_of, message_of

EVERY_ENTRY = {
    "time": "when it was written: UTC, ISO 8601, to the millisecond",
    "level": "`info`, `warning` or `error`",
    "logger": "the part that wrote it; those of the service begin with `pointpred.`",
    "message": "what happened, for people; the sentence may change",
}
"""What each entry holds."""


class JsonLines(logging.Formatter):
    """An entry as one JSON object."""

    def format(self, record: logging.LogRecord) -> str:
        """Time, level, logger, message, and the known fields."""
        entry: dict[str, object] = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": message_of(record),
        }
        return json.dumps(entry | fields_of(record))


def set_up(style: Literal["json", "text"] | None = None) -> Literal["json", "text"]:
    """Send every entry of this process to stderr: ours from info on, others' from warning on.

    Without a style it is text where stderr is a terminal, JSON elsewhere. Returns the style.
    """
    style = style or ("text" if sys.stderr.isatty() else "json")
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(JsonLines() if style == "json" else PlainLines())
    logging.basicConfig(handlers=[handler], level=logging.WARNING, force=True)
    logging.getLogger(OWN).setLevel(logging.INFO)
    return style
