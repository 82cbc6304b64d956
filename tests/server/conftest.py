"""What all tests of the service share."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from pointpred.live.devtools import Page
from pointpred.recorder.writer import Recorder
from tests.server import browser, page_browser
from tests.server.listener import Listener
from tests.server.page_browser import Visitor
from tests.server.running import PATIENCE_S


@pytest.fixture(autouse=True)
def patient_recorders(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a recorder holds is written to the end, however long a busy disk takes."""
    close = Recorder.close
    monkeypatch.setattr(Recorder, "close", lambda self, timeout_s=PATIENCE_S: close(self, timeout_s))


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    """The page's address at a service of this module's own, ready to answer."""
    with page_browser.service() as address:
        yield address


@pytest.fixture(scope="module")
def one(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    """Somebody with a browser of this module's own."""
    with page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        yield opened


@pytest.fixture(scope="module")
def devtools(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of the DevTools of a browser of this module's own."""
    with browser.running(tmp_path_factory.mktemp("profile")) as address:
        yield address


@pytest.fixture
def listener() -> Iterator[Listener]:
    """A service of this test's own, on a real socket."""
    with Listener() as service:
        yield service


@pytest.fixture
def page(devtools: str, listener: Listener) -> Iterator[Page]:
    """A tab at that service."""
    with browser.tab(devtools, listener.url) as tab:
        yield tab
        tab.call("Page.close")
