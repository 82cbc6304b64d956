"""HTTP hosts on ports of their own: of a folder's files, or of answers that a test makes."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from functools import partial
from http.server import BaseHTTPRequestHandler, SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any


class Silent:
    """A handler that does not log requests."""

    def log_message(self, *_: Any) -> None:
        """Log nothing."""


class Files(Silent, SimpleHTTPRequestHandler):
    """The files of a folder."""


@contextmanager
def host(handler: Callable[..., BaseHTTPRequestHandler]) -> Iterator[str]:
    """A host whose requests a handler answers; yields its origin."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def file_host(folder: Path, handler: type[SimpleHTTPRequestHandler] = Files) -> AbstractContextManager[str]:
    """A host of a folder's files, as ``python3 -m http.server`` serves them."""
    return host(partial(handler, directory=str(folder)))
