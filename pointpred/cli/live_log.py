"""Log entries while a view stands in the terminal: a line of it, and what was wrong once it is gone."""

from __future__ import annotations

import logging
from collections import deque

from pointpred.server.logs import OWN, PlainLines

KEPT = 20


class ViewLog(logging.Handler):
    """Keeps the newest entry for the view, and the newest warnings and errors for afterwards."""

    def __init__(self) -> None:
        super().__init__()
        self.setFormatter(PlainLines())
        self.newest = ""
        self.wrong: deque[str] = deque(maxlen=KEPT)

    def emit(self, record: logging.LogRecord) -> None:
        """Keep one entry."""
        self.newest = self.format(record)
        if record.levelno >= logging.WARNING:
            self.wrong.append(self.newest)

    def take_over(self) -> None:
        """Hear every entry of this process in place of stderr."""
        logging.basicConfig(handlers=[self], level=logging.WARNING, force=True)
        logging.getLogger(OWN).setLevel(logging.INFO)
