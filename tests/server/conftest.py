"""What all tests of the service share."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page

from pointpred.live.devtools import Page as DevTools
from pointpred.recorder.writer import Recorder
from tests.server import browser, page_browser
from tests.server.browser import Chromium
from tests.server.listener import Listener
from tests.server.page_browser import Visitor
from tests.server.recorded import BEGUN, Opened
from tests.server.running import PATIENCE_S, Running, running


@pytest.fixture(autouse=True)
def patient_recorders(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a recorder holds is written to the end, however long a busy disk takes."""
    close = Recorder.close
    monkeypatch.setattr(Recorder, "close", lambda self, timeout_s=PATIENCE_S: close(self, timeout_s))


@pytest.fixture(scope="module")
def service() -> Iterator[Running]:
    """A service of this module's own, in a thread."""
    with running() as here:
        yield here


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
def chromium(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Chromium]:
    """A browser of this module's own."""
    with browser.running(tmp_path_factory.mktemp("profile")) as started:
        yield started


@pytest.fixture
def devtools(chromium: Chromium) -> str:
    """The address of its DevTools."""
    return chromium.devtools


@pytest.fixture
def listener() -> Iterator[Listener]:
    """A service of this test's own, on a real socket."""
    with Listener() as service:
        yield service


@pytest.fixture
def page(chromium: Chromium, listener: Listener) -> Iterator[Page]:
    """A tab at that service."""
    with chromium.tab(listener.url) as tab:
        yield tab


@pytest.fixture
def hand(chromium: Chromium, page: Page) -> Iterator[DevTools]:
    """A hand for the mouse of that tab."""
    with chromium.hand(page) as connection:
        yield connection


@pytest.fixture
def opened(tmp_path: Path) -> Iterator[Opened]:
    """Recorders into one folder, closed in the end."""
    made: list[Recorder] = []

    def make(**options: object) -> Recorder:
        made.append(Recorder(tmp_path / "kept", today=lambda: BEGUN, **options))  # type: ignore[arg-type]
        return made[-1]

    yield make
    for recorder in made:
        assert recorder.close()
