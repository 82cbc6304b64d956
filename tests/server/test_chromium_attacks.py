"""What a hostile page tries in a real browser: it opens, reads, frames and runs nothing of the service."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Page

from tests.server import browser
from tests.server.browser import Chromium
from tests.server.listener import soon
from tests.server.pages_elsewhere import page_elsewhere
from tests.server.running import Running

pytestmark = browser.needed
EVIL, REBOUND = "evil.example", "rebound.example"
RESOLVE = f"--host-resolver-rules=MAP {EVIL} 127.0.0.1, MAP {REBOUND} 127.0.0.1"
SOCKET = """new Promise((resolve) => {{
  const socket = new WebSocket("{url}", "pointpred.v1");
  socket.onopen = () => resolve("open");
  socket.onerror = () => resolve("refused");
}})"""
FETCH = """fetch("{url}", {options}).then(
  (answer) => answer.text().then((text) => [answer.type, answer.status, text]), () => "refused")"""


@pytest.fixture(scope="module")
def chromium(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Chromium]:
    with browser.running(tmp_path_factory.mktemp("profile"), RESOLVE) as running_browser:
        yield running_browser


@pytest.fixture
def evil(chromium: Chromium) -> Iterator[Page]:
    """A tab at a page of another site."""
    with page_elsewhere() as origin, chromium.tab(origin.replace("127.0.0.1", EVIL)) as page:
        yield page


@pytest.fixture
def rebound(chromium: Chromium, service: Running) -> Iterator[Page]:
    """A tab at the service under a foreign name that resolves to this machine, as after DNS rebinding."""
    with chromium.tab() as page:
        protocol = page.context.new_cdp_session(page)  # as if the name had meant a page of its own before
        protocol.send("Page.setBypassCSP", {"enabled": True})
        page.goto(f"http://{REBOUND}:{service.port}/")
        yield page


def refused(service: Running) -> float:
    """How many connections and requests were refused as unauthorized."""
    read = service.service.metrics.registry.get_sample_value
    return read("pointpred_connections_refused_total", {"code": "unauthorized"}) or 0.0


def fetched(page: Page, url: str, options: str = "{}") -> Any:
    return page.evaluate(FETCH.format(url=url, options=options))


@pytest.mark.parametrize("path", ["/v1/stream", "/v1/live"])
def test_another_sites_socket_is_refused_before_the_upgrade(service: Running, evil: Page, path: str) -> None:
    before = refused(service)
    assert evil.evaluate(SOCKET.format(url=f"ws://127.0.0.1:{service.port}{path}")) == "refused"
    assert refused(service) > before or path == "/v1/live"
    assert not service.service._open


@pytest.mark.parametrize("path", ["/", "/v1/predictors", "/v1/samples", "/readyz", "/v1/live"])
def test_another_site_reads_nothing(service: Running, evil: Page, path: str) -> None:
    assert fetched(evil, f"{service.url}{path}") == "refused"


def test_another_site_reads_the_files_of_the_client_only(service: Running, evil: Page) -> None:
    kind, status, text = fetched(evil, f"{service.url}/pointpred.js")
    assert (kind, status) == ("cors", 200)
    assert "export" in text


@pytest.mark.parametrize("mode", ["cors", "no-cors"])
def test_another_sites_post_is_refused(service: Running, evil: Page, mode: str) -> None:
    before = refused(service)
    answer = fetched(evil, f"{service.url}/v1/samples", f'{{method: "POST", mode: "{mode}", body: "t,x,y"}}')
    assert answer in ("refused", ["opaque", 0, ""])
    assert refused(service) == before + 1


def test_another_sites_form_is_refused(service: Running, evil: Page) -> None:
    before = refused(service)
    with evil.expect_navigation():
        evil.evaluate(
            f"""document.body.innerHTML = '<form method=post enctype=text/plain'
              + ' action="{service.url}/v1/samples"><input name=t value=1></form>';
            document.forms[0].submit()"""
        )
    assert refused(service) == before + 1
    assert "unauthorized" in (evil.text_content("body") or "")


def test_a_request_of_another_site_that_asks_first_is_not_allowed(service: Running, evil: Page) -> None:
    """The preflight of a request with a header of its own, as private network access sends one too."""
    options = '{method: "PUT", headers: {"X-Any": "1"}}'
    assert fetched(evil, f"{service.url}/v1/samples", options) == "refused"
    assert fetched(evil, f"{service.url}/pointpred.js", '{headers: {"X-Any": "1"}}') == "refused"


def test_a_rebound_name_gets_nothing(service: Running, rebound: Page) -> None:
    assert "not served here" in rebound.evaluate("document.body.textContent")
    for path in ("/v1/predictors", "/healthz", "/pointpred.js"):
        kind, status, text = fetched(rebound, path)
        assert (kind, status) == ("basic", 403)
        assert "not served here" in text
    assert fetched(rebound, "/v1/samples", '{method: "POST", body: "t,x,y"}')[1] == 403
    assert rebound.evaluate(SOCKET.format(url=f"ws://{REBOUND}:{service.port}/v1/stream")) == "refused"
    assert not service.service._open


@pytest.mark.parametrize("path", ["/", "/healthz", "/web/page/page.js"])
def test_another_site_shows_nothing_in_a_frame(service: Running, evil: Page, path: str) -> None:
    evil.evaluate(
        f"""new Promise((resolve) => {{
          const frame = document.createElement("iframe");
          frame.onload = resolve;
          frame.src = "{service.url}{path}";
          document.body.append(frame);
        }}).then(() => 0)"""
    )
    (frame,) = evil.main_frame.child_frames
    assert frame.evaluate("location.href") == "chrome-error://chromewebdata/"


def test_another_site_that_opens_the_page_has_no_hold_on_it(service: Running, evil: Page) -> None:
    evil.evaluate(f'window.opened = window.open("{service.url}/"); 0')
    soon(lambda: evil.evaluate("opened.closed"), "the page is cut off from the one that opened it")


@pytest.mark.parametrize("path", ["/healthz", "/v1/samples", "/"])
def test_what_is_no_script_is_not_run_as_one(service: Running, evil: Page, path: str) -> None:
    loading = f"""new Promise((resolve) => {{
      const script = document.createElement("script");
      script.onload = () => resolve("run");
      script.onerror = () => resolve("refused");
      script.src = "{service.url}{path}";
      document.body.append(script);
    }})"""
    assert evil.evaluate(loading) == "refused"
