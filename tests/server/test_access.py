"""Pages of other sites: each is told which flag admits it, and the log says so once."""

from __future__ import annotations

import json
import logging
import urllib.request

import pytest
from websockets.exceptions import InvalidStatus

from pointpred_server.access import MOST_ORIGINS, RefusedOrigins, is_origin, origin_advice
from pointpred_server.settings import Settings
from tests.server.running import Running, running

PAGE, OTHER = "https://page.example", "http://127.0.0.1:5173"


def asked(here: Running, **headers: str) -> tuple[dict[str, object], dict[str, str]]:
    request = urllib.request.Request(f"{here.url}/v1/origin", headers=headers)
    with urllib.request.urlopen(request) as answer:
        return json.loads(answer.read()), dict(answer.headers)


def test_any_page_may_ask_whether_it_may_connect() -> None:
    """It shows no token, and reads the answer whatever its origin."""
    with running(allow_origin=(PAGE,), token="a long word") as here:
        told, headers = asked(here, Origin=PAGE)
        assert told == {"origin": PAGE, "allowed": True, "message": None}
        assert headers["access-control-allow-origin"] == "*"
        assert headers["cross-origin-resource-policy"] == "cross-origin"
        assert asked(here)[0] == {"origin": None, "allowed": True, "message": None}
        assert asked(here, Origin=here.url)[0]["allowed"]
        refused = asked(here, Origin=OTHER)[0]
        assert (refused["origin"], refused["allowed"]) == (OTHER, False)
        assert f"--allow-origin {OTHER}" in str(refused["message"])


def test_a_refused_page_is_logged_once_with_the_flag(caplog: pytest.LogCaptureFixture) -> None:
    def warned() -> list[str]:
        return [one.getMessage() for one in caplog.records if one.levelno == logging.WARNING]

    with caplog.at_level(logging.INFO, "pointpred.service"), running() as here:
        for _ in range(3):
            with pytest.raises(InvalidStatus) as refused, here.connect(origin=PAGE):
                pass
            assert refused.value.response.status_code == 403
        assert [f"--allow-origin {PAGE}" in one for one in warned()] == [True]
        with pytest.raises(InvalidStatus), here.connect(origin=OTHER):
            pass
        assert len(warned()) == 2
        with pytest.raises(InvalidStatus), here.connect(origin="null"):
            pass
        assert len(warned()) == 3
        assert "--allow-origin" not in warned()[-1]  # no flag admits a file
        registry = here.service.metrics.registry
        counted = registry.get_sample_value("pointpred_connections_refused_total", {"code": "unauthorized"})
        assert counted == 5.0


def test_origins_without_end_do_not_fill_the_log(caplog: pytest.LogCaptureFixture) -> None:
    refused = RefusedOrigins()
    for i in range(3 * MOST_ORIGINS):
        refused.add(f"https://{i}.example")
    assert len(caplog.records) == MOST_ORIGINS


@pytest.mark.parametrize(
    "origin", ["https://a.example; rm -rf ~", "https://a.example\r\nx", "ftp://a", "https://A", "", None]
)
def test_what_is_no_origin_is_not_quoted(origin: str | None) -> None:
    assert not is_origin(origin)
    assert not origin or origin not in origin_advice(origin)
    with pytest.raises(ValueError, match="origin"):
        Settings(allow_origin=(origin or " x",))


@pytest.mark.parametrize("origin", [PAGE, OTHER, "http://[::1]:8765", "https://xn--bcher-kva.example"])
def test_what_is_advised_is_taken(origin: str) -> None:
    assert origin_advice(origin).split("--allow-origin ")[1].split()[0] == origin
    assert Settings(allow_origin=(origin,)).allow_origin == (origin,)
