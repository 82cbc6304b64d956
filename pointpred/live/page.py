"""The page of a live session, which another distribution serves."""

from __future__ import annotations

import threading
from collections.abc import Callable
from importlib.metadata import entry_points
from typing import Protocol

from pointpred.extras import missing_distribution
from pointpred.live.session import LiveSession
from pointpred.protocol.live_messages import Curve


class LivePage(Protocol):
    """A page that shows a session."""

    @property
    def address(self) -> str:
        """Where it is opened, with the token where that is shown."""

    @property
    def watched(self) -> bool:
        """Whether there are viewers."""

    def show_curve(self, curve: Curve) -> None:
        """Show the newest transfer function; from any thread."""

    def fail(self, reason: str) -> None:
        """The device has failed: tell the viewers why; from any thread."""

    def run(self, stopping: threading.Event, *, announce: bool) -> None:
        """Serve until interrupted or until ``stopping`` is set, which it is afterwards.

        ``announce``: print the address once the page can be opened.
        """


OpenPage = Callable[[LiveSession, str, float | None, float], LivePage]
"""Opens the page of a session, from its predictor, counts per inch and dpi."""


def page_opener(host: str | None, port: int | None) -> OpenPage:
    """What opens the page, on an address or port that may be given.

    It is the entry point ``page`` of the group ``pointpred.live``. Raises MissingExtraError where no
    distribution has one, ParameterError for settings that are wrong.
    """
    for entry in entry_points(group="pointpred.live", name="page"):
        opener: OpenPage = entry.load()(host, port)
        return opener
    raise missing_distribution("pointpred-server", "the page of a device")
