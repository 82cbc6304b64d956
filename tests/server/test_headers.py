"""What stands around every answer: types, caching, what a page may do; and the shape of failures."""

from __future__ import annotations

import pytest
from fastapi.testclient import TestClient

from pointpred_server.app import create_app

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
        ("/web/page/page.js", "text/javascript; charset=utf-8"),
        ("/healthz", "application/json"),
        ("/v1/predictors", "application/json"),
        ("/v1/samples/nobody", "application/json"),
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
    first = client.get("/web/lib/pointpred.js")
    again = client.get("/web/lib/pointpred.js", headers={"If-None-Match": first.headers["etag"]})
    assert again.status_code == 304


def test_any_page_may_load_the_client_and_nothing_else(client: TestClient) -> None:
    for path in ("/pointpred.js", "/web/lib/pointpred.js", "/web/lib/client/frames.js"):
        shared = client.get(path, headers=FOREIGN).headers
        assert shared["access-control-allow-origin"] == "*"
        assert shared["cross-origin-resource-policy"] == "cross-origin"
    for path in ("/", "/v1/samples", "/readyz"):
        own = client.get(path, headers=FOREIGN).headers
        assert "access-control-allow-origin" not in own
        assert "cross-origin-resource-policy" not in own


@pytest.mark.parametrize(
    ("path", "mode", "site", "status"),
    [
        ("/v1/predictors", "no-cors", "cross-site", 403),
        ("/", "no-cors", "cross-site", 403),
        ("/", "navigate", "cross-site", 200),
        ("/web/lib/pointpred.js", "cors", "cross-site", 200),
        ("/v1/predictors", "cors", "same-origin", 200),
    ],
)
def test_a_page_of_another_site_has_nothing_done(
    client: TestClient, path: str, mode: str, site: str, status: int
) -> None:
    """A link to the page and the client's modules are for everybody."""
    answer = client.get(path, headers={"Sec-Fetch-Site": site, "Sec-Fetch-Mode": mode})
    assert answer.status_code == status
    assert status == 200 or answer.json()["code"] == "unauthorized"


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
