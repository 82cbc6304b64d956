"""What stands around every answer: types, caching, what a page may do; and the shape of failures."""

from __future__ import annotations

import pytest
from fastapi.testclient import TestClient

from pointpred_server.app import create_app
from pointpred_server.service import Service
from pointpred_server.settings import Settings

SECRET = "7315.25"
HERE = "http://127.0.0.1:8765"
FOREIGN = {"Origin": "http://evil.example"}
SHAPE = {"type", "code", "message", "path", "recoverable"}


@pytest.fixture(scope="module")
def client() -> TestClient:
    return TestClient(create_app(), base_url=HERE)


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("/", "text/html; charset=utf-8"),
        ("/pointpred.js", "text/javascript; charset=utf-8"),
        ("/web/page.js", "text/javascript; charset=utf-8"),
        ("/healthz", "application/json"),
        ("/v1/predictors", "application/json"),
        ("/v1/samples/nobody", "application/json"),
        ("/metrics", "text/plain; version=0.0.4; charset=utf-8"),
    ],
)
def test_every_answer_says_what_it_is_and_what_a_page_may_do(
    client: TestClient, path: str, kind: str
) -> None:
    headers = client.get(path).headers
    assert headers["content-type"] == kind
    assert headers["cache-control"] == "no-cache"
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["referrer-policy"] == "no-referrer"
    assert headers["cross-origin-opener-policy"] == "same-origin"
    policy = dict(part.strip().split(" ", 1) for part in headers["content-security-policy"].split(";"))
    assert policy == {
        "default-src": "'none'",
        "script-src": "'self'",
        "style-src": "'self'",
        "img-src": "'self'",
        "connect-src": "'self'",
        "base-uri": "'none'",
        "form-action": "'none'",
        "frame-ancestors": "'none'",
    }


def test_a_page_that_has_not_changed_is_not_sent_again(client: TestClient) -> None:
    first = client.get("/web/pointpred.js")
    again = client.get("/web/pointpred.js", headers={"If-None-Match": first.headers["etag"]})
    assert again.status_code == 304


def test_any_page_may_load_the_client_and_nothing_else(client: TestClient) -> None:
    for path in ("/pointpred.js", "/web/pointpred.js", "/web/client/frames.js"):
        shared = client.get(path, headers=FOREIGN).headers
        assert shared["access-control-allow-origin"] == "*"
        assert shared["cross-origin-resource-policy"] == "cross-origin"
    for path in ("/", "/v1/samples", "/metrics", "/readyz"):
        own = client.get(path, headers=FOREIGN).headers
        assert "access-control-allow-origin" not in own
        assert "cross-origin-resource-policy" not in own


def test_another_sites_page_may_not_post() -> None:
    client = TestClient(create_app(), base_url=HERE)
    for origin in ("http://evil.example", "null", "http://127.0.0.1:9999"):
        answer = client.post("/v1/samples", content=b"nonsense", headers={"Origin": origin})
        assert answer.status_code == 403, origin
        assert answer.json().keys() == SHAPE
        assert answer.json()["code"] == "unauthorized"
    assert client.post("/v1/samples", content=b"nonsense", headers={"Origin": HERE}).status_code == 405
    allowed = Service(Settings(allow_origin=["http://evil.example"]))
    client = TestClient(create_app(service=allowed), base_url=HERE)
    assert client.post("/v1/samples", content=b"nonsense", headers=FOREIGN).status_code == 405


def test_what_breaks_is_500_in_the_shape_of_errors_without_its_words(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def broken() -> None:
        raise RuntimeError(f"at {SECRET}")

    monkeypatch.setattr("pointpred_server.samples.listing", broken)
    client = TestClient(create_app(), base_url=HERE, raise_server_exceptions=False)
    answer = client.get("/v1/samples")
    assert answer.status_code == 500
    assert answer.headers["content-type"] == "application/json"
    assert answer.json() == {
        "type": "error",
        "code": "internal",
        "message": "the server failed",
        "path": None,
        "recoverable": True,
    }
    assert answer.headers["cache-control"] == "no-cache"
    assert answer.headers["x-content-type-options"] == "nosniff"
    assert "frame-ancestors 'none'" in answer.headers["content-security-policy"]
