"""Pages with a Content Security Policy: links are prefetched, and no violation is reported."""

from __future__ import annotations

from collections.abc import Iterator
from http.server import SimpleHTTPRequestHandler
from typing import ClassVar

import pytest

from tests.hosts import Silent, file_host
from tests.intent.conftest import LIB
from tests.server import browser
from tests.server.page_browser import Visitor, until

pytestmark = browser.needed

TYPES = "require-trusted-types-for 'script'"
POLICIES = {
    "strict": "script-src 'self'",
    "nonce": "script-src 'self' 'nonce-abc'",
    "types": f"script-src 'self'; {TYPES}",
    "named": f"script-src 'self' 'nonce-abc'; {TYPES}; trusted-types pointpred",
    "closed": "default-src 'none'; script-src 'nonce-abc'; style-src 'unsafe-inline'; img-src data:",
    "pictures": "default-src 'none'; script-src 'nonce-abc'; style-src 'unsafe-inline'; img-src 'self'",
    "unnamed": "script-src 'self' 'nonce-abc'; trusted-types 'none'",
}
PAGE = """<!doctype html><title>a site</title>META<body style="margin:0">
<a id="goal" href="/next.html" style="position:absolute;left:600px;top:500px;width:100px;height:60px">goal</a>
<a id="far" href="/far.html" style="position:absolute;left:800px;top:40px;width:100px;height:60px">far</a>
<script type="module" nonce="abc" src="/site.js" data-nonce="NONCE"></script>"""
SITE = """import { prefetchLink, ledger } from "/pointpred/intent/index.js";
window.violations = [];
window.counted = ledger;
document.addEventListener("securitypolicyviolation", (one) => violations.push(one.effectiveDirective));
const { nonce } = document.querySelector("script").dataset;
prefetchLink("a", { predictor: "minimum-jerk", nonce: nonce || undefined });"""


class Site(Silent, SimpleHTTPRequestHandler):
    """A page for each policy, by its headers or, with ``meta``, in itself; notes what was asked for."""

    asked: ClassVar[list[str]] = []

    def do_GET(self) -> None:
        path, _, query = self.path.partition("?")
        if path.startswith("/pointpred/"):
            self.path = path.removeprefix("/pointpred")
            super().do_GET()
        elif path == "/site.js":
            self.answer(SITE, "text/javascript")
        elif path in ("/next.html", "/far.html"):
            self.asked.append(path)
            self.answer("<!doctype html>", "text/html")
        else:
            kind, _, way = path.strip("/").partition("/")
            policy = POLICIES.get(kind, "")
            meta = f'<meta http-equiv="Content-Security-Policy" content="{policy}">' if way == "meta" else ""
            sent = {} if way == "meta" or not policy else {"Content-Security-Policy" + way: policy}
            self.answer(PAGE.replace("NONCE", query).replace("META", meta), "text/html", sent)

    def answer(self, text: str, kind: str, headers: dict[str, str] | None = None) -> None:
        body = text.encode()
        self.send_response(200)
        for name, value in {
            "Content-Type": kind,
            "Content-Length": str(len(body)),
            **(headers or {}),
        }.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(body)


@pytest.fixture(scope="module")
def site() -> Iterator[str]:
    with file_host(LIB, Site) as origin:
        yield origin


@pytest.mark.parametrize(
    ("address", "nonce", "by_rules"),
    [
        ("open", "", True),
        ("strict", "", False),
        ("strict/meta", "", False),
        ("strict/-Report-Only", "", False),
        ("nonce", "", False),
        ("nonce", "abc", True),
        ("types", "", False),
        ("pictures", "", False),
        ("named", "abc", True),
    ],
)
def test_a_link_is_prefetched_without_a_violation(
    visitor: Visitor, site: str, address: str, nonce: str, by_rules: bool
) -> None:
    Site.asked.clear()
    said: list[str] = []
    visitor.page.on("console", lambda one: said.append(one.text))
    visitor.open(f"{site}/{address}?{nonce}")
    value = visitor.page.evaluate  # not eval, which a policy refuses
    until(lambda: value("window.counted !== undefined"), "the module")
    value("new Promise((done) => setTimeout(done, 500))")
    visitor.reach((40, 40), (650, 530), 0.5)
    until(lambda: value("counted().fired") == 1, "the link to fire")
    until(lambda: Site.asked, "the page to be asked for")
    rules = value("document.querySelectorAll('script[type=speculationrules]').length")
    assert (rules, value("document.querySelectorAll('link[rel=prefetch]').length")) == (
        (1, 0) if by_rules else (0, 1)
    )
    assert value("violations") == []
    assert said == [], "nothing in the console"


@pytest.mark.parametrize(
    ("address", "nonce", "asked", "violation"),
    [("closed", "", [], "default-src"), ("unnamed", "abc", ["/next.html", "/far.html"], "trusted-types")],
)
def test_what_a_policy_refuses_is_tried_once(
    visitor: Visitor, site: str, address: str, nonce: str, asked: list[str], violation: str
) -> None:
    Site.asked.clear()
    visitor.open(f"{site}/{address}?{nonce}")
    value = visitor.page.evaluate  # not eval, which a policy refuses
    until(lambda: value("window.counted !== undefined"), "the module")
    value("addEventListener('click', (event) => event.preventDefault())")
    value("new Promise((done) => setTimeout(done, 500))")
    visitor.reach((400, 400), (650, 530), 0.5)
    until(lambda: value("counted().fired") == 1, "the link to fire")
    until(lambda: value("violations.length") == 1, "the report")
    visitor.reach((650, 530), (850, 70), 0.5)
    value("new Promise((done) => setTimeout(done, 500))")
    visitor.click(650, 530)
    value("new Promise((done) => setTimeout(done, 200))")
    assert value("violations") == [violation]
    assert Site.asked == asked
    assert value("counted().fired") == (2 if asked else 1)
    assert value("counted().hit") == (1 if asked else 0), "what was refused is never used"
