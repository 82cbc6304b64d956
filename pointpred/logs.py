"""Entries of the log as lines for people; movement data never reach them.

The sentence of an error may quote what a client sent, ours as well as a library's: an error is logged by its
types and places, and an entry of a library without its arguments.
"""

from __future__ import annotations

import logging
import traceback
from datetime import datetime
from pathlib import Path
from typing import Any

OWN = "pointpred"
FIELDS = {
    "session": "the random name of the session, which its recording has too; tells nothing of who it was",
    "code": "why a session was closed (the close code) or a request refused (the error code)",
    "events": "how many events the session has sent, when it closes",
    "error": "types and places of an error, without its sentence, which may quote what a client sent",
}
"""What an entry may hold beside its message, with its meaning; nothing that a pointer did."""


def place_of(error: BaseException) -> str:
    """Types and places of an error and of those that led to it, without their sentences."""
    frames = traceback.extract_tb(error.__traceback__)
    places = " > ".join(f"{Path(frame.filename).name}:{frame.lineno}" for frame in frames)
    name = type(error).__name__
    described = f"{name} at {places}" if places else name
    before = error.__cause__ or (None if error.__suppress_context__ else error.__context__)
    return f"{described}, after {place_of(before)}" if before is not None else described


def message_of(record: logging.LogRecord) -> str:
    """The message of an entry of ours; of a library's, its first line without arguments."""
    if record.name.partition(".")[0] == OWN:
        return record.getMessage()
    message = record.msg if isinstance(record.msg, str) and not record.exc_info else "an error in a library"
    return message.partition("\n")[0]


class PlainLines(logging.Formatter):
    """An entry as a line for people."""

    def format(self, record: logging.LogRecord) -> str:
        """Time, level, message, and the known fields."""
        time = datetime.fromtimestamp(record.created).astimezone().strftime("%H:%M:%S")
        more = "".join(f" {name}={value}" for name, value in fields_of(record).items())
        return f"{time} {record.levelname.lower()}: {message_of(record)}{more}"


def fields_of(record: logging.LogRecord) -> dict[str, Any]:
    """What an entry holds beside its message."""
    fields = {name: record.__dict__[name] for name in FIELDS if name in record.__dict__}
    error = record.exc_info[1] if record.exc_info else None
    return fields if error is None else {**fields, "error": place_of(error)}
