"""A static host, as people have one, and a browser that opens pages on it."""

from __future__ import annotations

from collections.abc import Iterator
from http.server import SimpleHTTPRequestHandler
from pathlib import Path

import pytest

from tests.hosts import Silent, file_host
from tests.intent import npm
from tests.intent.npm import LIB
from tests.intent.page import IntentPage
from tests.server import page_browser

EMPTY = b'<!doctype html><title>a page</title><body style="margin:0">'


class StaticHost(Silent, SimpleHTTPRequestHandler):
    """Files of the browser client below ``/pointpred/``, and an empty page at any other address."""

    def do_GET(self) -> None:
        if self.path.startswith("/pointpred/"):
            self.path = self.path.removeprefix("/pointpred")
            super().do_GET()
            return
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.send_header("Content-Length", str(len(EMPTY)))
        self.end_headers()
        self.wfile.write(EMPTY)


@pytest.fixture(scope="session")
def host() -> Iterator[str]:
    """The address of a static host."""
    with file_host(LIB, StaticHost) as origin:
        yield origin


@pytest.fixture(scope="module")
def visitor(tmp_path_factory: pytest.TempPathFactory) -> Iterator[page_browser.Visitor]:
    """Somebody with a browser of this module's own."""
    with page_browser.visitor(tmp_path_factory.mktemp("profile"), size=(1000, 700)) as opened:
        yield opened


@pytest.fixture
def page(visitor: page_browser.Visitor, host: str) -> IntentPage:
    """An empty page with the module loaded."""
    return IntentPage(visitor, host)


@pytest.fixture(scope="session")
def packages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the frameworks and drivers of npm, and this package as users install it."""
    folder = tmp_path_factory.mktemp("packages")
    npm.install(folder, *npm.TRIED)
    return folder


@pytest.fixture(scope="session")
def older_packages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same with the oldest versions that the package is made for."""
    folder = tmp_path_factory.mktemp("older")
    npm.install(folder, *npm.OLDER)
    return folder
