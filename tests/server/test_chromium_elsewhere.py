"""The browser client in a page of another origin, in a real browser."""

from __future__ import annotations

import socket
from pathlib import Path

import pytest
from playwright.sync_api import Page

from pointpred_server.page import WEB
from tests.server import browser
from tests.server.listener import soon
from tests.server.pages_elsewhere import page_elsewhere
from tests.server.running import running

pytestmark = browser.needed


ISOLATED = {
    "Cross_Origin_Opener_Policy": "same-origin",
    "Cross_Origin_Embedder_Policy": "require-corp",
}
USE = """import("{url}/pointpred.js").then(({{ connect }}) => {{
  window.heard = [];
  window.connection = connect(undefined, {{ pointer: false, reply: "event" }});
  connection.on("prediction", ({{ t }}) => heard.push(t));
  connection.send(Array.from({{ length: 5 }}, (_, i) => [i / 100, i, 0, null, null, 0]));
}})"""


@pytest.mark.parametrize("headers", [{}, ISOLATED], ids=["plain", "isolated"])
def test_another_site_that_is_allowed_uses_the_client(tmp_path: Path, headers: dict[str, str]) -> None:
    """Every part of the module comes from the service, and the connection goes there without being told."""

    def settled(page: Page) -> None:
        soon(lambda: page.evaluate("heard.length") == 5, "five predictions")
        assert page.evaluate("connection.state") == "open"

    with (
        page_elsewhere(**headers) as origin,
        running(allow_origin=(origin,)) as service,
        browser.running(tmp_path / "profile") as chromium,
        chromium.tab(origin) as page,
    ):
        page.evaluate(USE.format(url=service.url))
        settled(page)
        loaded = page.evaluate("performance.getEntriesByType('resource').map(({ name }) => name)")
        modules = {name for name in loaded if name.endswith(".js")}
        parts = {
            f"{service.url}/web/lib/client/{part.name}" for part in (WEB / "lib" / "client").glob("*.js")
        }
        assert {f"{service.url}/pointpred.js", f"{service.url}/web/lib/pointpred.js", *parts} <= modules
        assert all(name.startswith(service.url) for name in modules)
        page.evaluate("connection.close()")


REFUSED = """import("{url}/pointpred.js").then(({{ connect }}) => {{
  window.another = connect;
  window.heard = {{ error: [], state: [] }};
  window.warned = [];
  console.warn = (words) => warned.push(words);
  window.connection = connect();
  for (const name in heard) connection.on(name, (message) => heard[name].push(message));
  connection.on("error", ({{ message }}) => console.warn(message));
}})"""


def test_another_site_that_is_not_allowed_hears_which_flag_allows_it(tmp_path: Path) -> None:
    with (
        page_elsewhere() as origin,
        running() as service,
        browser.running(tmp_path / "profile") as chromium,
        chromium.tab(origin) as page,
    ):
        page.evaluate(REFUSED.format(url=service.url))
        soon(lambda: page.evaluate("connection.state") == "refused", "the refusal")
        (error,) = page.evaluate("heard.error")
        assert (error["code"], error["recoverable"], error["path"]) == ("unauthorized", False, None)
        assert f"--allow-origin {origin}" in error["message"]
        assert page.evaluate("warned") == [error["message"]]  # by the page alone
        page.evaluate("window.unheard = another(), 0")
        soon(lambda: page.evaluate("unheard.state") == "refused", "the refusal of one that nobody listens to")
        _, warning = page.evaluate("warned")
        assert service.url.partition("://")[2] in warning
        assert f"--allow-origin {origin}" in warning
        states = page.evaluate("heard.state")
        assert states[-1] == "refused"
        page.evaluate("connection.configure({})")
        soon(lambda: page.evaluate("heard.error.length") == 2, "configure tries once more")
        soon(lambda: page.evaluate("connection.state") == "refused", "and is refused")
        service.service.settings = service.service.settings.model_copy(update={"allow_origin": (origin,)})
        page.evaluate("connection.configure({})")
        soon(lambda: page.evaluate("connection.state") == "open", "once it is allowed")
        assert page.evaluate("heard.error.length") == 2
        assert page.evaluate("warned") == [error["message"], warning, error["message"]]
        page.evaluate("connection.close()")


UNREACHABLE = """import("{url}/pointpred.js").then(({{ connect }}) => {{
  window.warned = [];
  window.waits = 0;
  console.warn = (words) => warned.push(words);
  window.connection = connect("ws://127.0.0.1:{port}", {{ token: "secret" }});
  connection.on("state", (state) => waits += state === "waiting");
}})"""


def test_a_service_that_cannot_be_reached_is_warned_of_once(tmp_path: Path) -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]  # bound and not listening: every connection is refused
        with (
            page_elsewhere() as origin,
            running() as service,
            browser.running(tmp_path / "profile") as chromium,
            chromium.tab(origin) as page,
        ):
            page.evaluate(UNREACHABLE.format(url=service.url, port=port))
            soon(lambda: page.evaluate("waits") >= 3, "three tries")
            (warning,) = page.evaluate("warned")
            assert f"127.0.0.1:{port}" in warning
            assert "secret" not in warning
            page.evaluate("connection.close()")


def test_the_ten_lines_of_the_docs_light_up_a_card(tmp_path: Path) -> None:
    text = (Path(__file__).parents[2] / "docs" / "guide" / "browser.md").read_text(encoding="utf-8")
    lines = text.partition("```html\n")[2].partition("```")[0]
    with (
        page_elsewhere() as origin,
        running(allow_origin=(origin,)) as service,
        browser.running(tmp_path / "profile") as chromium,
        chromium.tab(origin) as page,
    ):
        assert "http://127.0.0.1:8765" in lines
        page.evaluate(
            f"document.write({lines.replace('http://127.0.0.1:8765', service.url)!r}); document.close()"
        )
        lit = "[...document.querySelectorAll('.card.ahead')].map((card) => card.textContent)"
        soon(lambda: len(service.service._open) == 1, "the page has a session")
        box = page.evaluate("document.querySelectorAll('.card')[1].getBoundingClientRect().toJSON()")
        place = {"x": box["x"] + box["width"] / 2, "y": box["y"] + box["height"] / 2}
        page.mouse.move(**place)
        soon(lambda: page.evaluate(lit) == ["Two"], "the card is lit")
        page.mouse.move(place["x"], place["y"] + 300)
        soon(lambda: "Two" not in page.evaluate(lit), "the mouse has left")
