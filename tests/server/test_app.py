"""What the service answers, without a socket."""

from __future__ import annotations

from html.parser import HTMLParser

import pytest
from fastapi.testclient import TestClient

from pointpred import __version__
from pointpred.datasets import sample
from pointpred_server.app import create_app
from pointpred_server.page import REPOSITORY, WEB
from pointpred_server.service import Service
from pointpred_server.settings import Settings


@pytest.fixture(scope="module")
def client() -> TestClient:
    return TestClient(create_app(), base_url="http://127.0.0.1:8765")


def test_health(client: TestClient) -> None:
    assert client.get("/healthz").json() == {"status": "ok", "version": __version__}


class References(HTMLParser):
    """What a page loads."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        named = [value for name, value in attributes if name in ("src", "href") and value]
        self.found += [value for value in named if not value.startswith("#")]  # a part of the page itself


SVG = "http://www.w3.org/2000/svg"
"""The name of a namespace, which no browser fetches."""


def test_page_loads_only_what_lies_beside_it(client: TestClient) -> None:
    page = client.get("/")
    assert page.status_code == 200
    assert page.headers["content-type"].startswith("text/html")
    assert "default-src 'none'" in page.headers["content-security-policy"]
    references = References()
    references.feed(page.text)
    assert references.found
    for reference in references.found:
        if reference.startswith(REPOSITORY):
            continue  # a link to follow: nothing of it is loaded
        assert client.get(reference).status_code == 200, reference
        assert "//" not in reference, "relative to the page, wherever that is"
    shown = (path for path in (WEB / "page").iterdir() if path.suffix in (".html", ".js", ".css", ".svg"))
    for path in shown:  # what lies in vendor/ names its authors' pages
        text = path.read_text(encoding="utf-8").replace(SVG, "")
        assert "//" not in text.replace("// ", ""), f"{path.name} names another host"


def test_samples_are_listed_and_each_can_be_read(client: TestClient) -> None:
    listing = client.get("/v1/samples").json()
    assert listing["simulated"] is True
    assert len(listing["samples"]) == len(sample().trials)
    name = listing["samples"][-1]["name"]
    shown = client.get(f"/v1/samples/{name}").json()
    assert shown["name"] == name
    events = sample().rows(len(sample().trials) - 1)
    for field in ("x", "y", "dx", "dy", "buttons"):
        assert shown[field] == getattr(events, field).tolist()
    assert shown["t"] == (events.t - events.t[0]).tolist()


def test_an_unknown_name_is_404_and_said(client: TestClient) -> None:
    answer = client.get("/v1/samples/nobody")
    assert answer.status_code == 404
    assert "unknown sample 'nobody'" in answer.json()["message"]


@pytest.mark.parametrize(
    ("bound", "header", "admitted"),
    [
        ("127.0.0.1", "127.0.0.1:8765", True),
        ("127.0.0.1", "localhost", True),
        ("127.0.0.1", "LOCALHOST:1", True),
        ("127.0.0.1", "[::1]:8765", True),
        ("127.0.0.1", "evil.example", False),
        ("127.0.0.1", "evil.example:8765", False),
        ("127.0.0.1", "127.0.0.1.evil.example", False),
        ("127.0.0.1", "localhost.evil.example", False),
        ("127.0.0.1", "192.168.0.7", False),
        ("127.0.0.1", "[::1].evil.com", False),
        ("127.0.0.1", "[::1]:80@evil.com", False),
        ("127.0.0.1", "localhost:80@evil", False),
        ("127.0.0.1", "localhost:", True),
        ("127.0.0.1", "", False),
        ("0.0.0.0", "192.168.0.7:8765", True),
        ("0.0.0.0", "evil.example", False),
        ("0.0.0.0", "lab.example", True),
        ("lab.example", "lab.example", True),
    ],
)
def test_foreign_hosts_are_refused(bound: str, header: str, admitted: bool) -> None:
    further = ["lab.example"] if bound != "127.0.0.1" else []
    service = Service(Settings(host=bound, allow_host=further, token="open-sesame-9"))
    shown = {"Authorization": "Bearer open-sesame-9"}
    with TestClient(create_app(service), base_url="http://127.0.0.1", headers=shown) as client:
        for path in ("/", "/healthz", "/v1/samples", "/web/page/page.js"):
            answer = client.get(path, headers={"Host": header})
            assert answer.status_code == (200 if admitted else 403)
            assert admitted or answer.json()["code"] == "unauthorized"
            assert answer.headers["X-Content-Type-Options"] == "nosniff"
            assert "frame-ancestors 'none'" in answer.headers["Content-Security-Policy"]
