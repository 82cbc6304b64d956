"""Pages of other sites that are refused: how each is told which flag admits it, and the log once."""

from __future__ import annotations

import logging
import re

from msgspec import Struct

log = logging.getLogger("pointpred.service")

FLAG = "--allow-origin"
MOST = 64
"""Origins that are remembered as logged: anybody can invent more."""
ORIGIN = re.compile(r"https?://[a-z0-9._~%:\[\]-]{1,300}")
FILE = "a page opened as a file has no origin that could be allowed: serve it over http"


class OriginAnswer(Struct):
    """Whether the page that asks may connect, and if not, what to do about it."""

    origin: str | None
    allowed: bool
    message: str | None = None


class RefusedOrigins:
    """Logs the first refusal of each origin; memory is bounded."""

    def __init__(self) -> None:
        self._logged: set[str] = set()

    def note(self, origin: str | None) -> None:
        """A page of this origin was refused."""
        words = advice(origin)
        if words in self._logged or len(self._logged) == MOST:
            return
        self._logged.add(words)
        log.warning("a page was refused: %s", words)


def advice(origin: str | None) -> str:
    """What admits pages of an origin, as its ``Origin`` header has it.

    >>> advice("https://a.example")
    'pages of https://a.example may not connect; pointpred serve --allow-origin https://a.example allows them'
    """
    if origin == "null":
        return FILE
    if not well_formed(origin):
        return f"the origin is none that could be allowed; {FLAG} takes one such as https://page.example"
    return f"pages of {origin} may not connect; pointpred serve {FLAG} {origin} allows them"


def well_formed(origin: str | None) -> bool:
    """Whether an origin is written as browsers write it; what is not, is never quoted."""
    return origin is not None and ORIGIN.fullmatch(origin) is not None
