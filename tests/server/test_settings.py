"""Settings: where they come from, what is refused, what is shown of a secret."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
from pydantic import ValidationError

from pointpred_server.access import HostRule
from pointpred_server.settings import Settings
from tests.server.running import PATIENCE_S


def serve(*arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """``pointpred serve`` with settings that it refuses."""
    return subprocess.run(
        [sys.executable, "-m", "pointpred", "serve", "--port", "0", *arguments],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        timeout=PATIENCE_S,
        check=False,
    )


def test_the_environment_is_read_and_an_argument_goes_first(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POINTPRED_MAX_SESSIONS", "7")
    monkeypatch.setenv("POINTPRED_ALLOW_HOST", "lab.example, other.example")
    monkeypatch.setenv("POINTPRED_ALLOW_ORIGIN", "https://lab.example,http://lab.example:8000")
    assert Settings().max_sessions == 7
    assert Settings().limits.max_sessions == 7
    assert Settings(max_sessions=3).max_sessions == 3
    assert Settings().allow_host == ("lab.example", "other.example")
    assert Settings().allow_origin == ("https://lab.example", "http://lab.example:8000")


@pytest.mark.parametrize(
    "origin",
    ["lab.example", "https://lab.example/", "https://lab.example/page", "null", "https://Lab.example"],
)
def test_an_origin_no_browser_would_send_is_refused(origin: str) -> None:
    with pytest.raises(ValidationError, match="an origin reads like"):
        Settings(allow_origin=[origin])


@pytest.mark.parametrize(
    "host",
    ['["lab.example"]', '"lab.example"', "lab.example:8000", "http://lab.example", "*", "*.example", "[::1]"],
)
def test_a_host_no_header_would_name_is_refused(monkeypatch: pytest.MonkeyPatch, host: str) -> None:
    with pytest.raises(ValidationError, match="a host reads like"):
        Settings(allow_host=[host])
    monkeypatch.setenv("POINTPRED_ALLOW_HOST", f"good.example,{host}")
    with pytest.raises(ValidationError, match="a host reads like"):
        Settings()


def test_hosts_are_names_or_addresses(monkeypatch: pytest.MonkeyPatch) -> None:
    hosts = ("lab", "Lab.example", "192.168.0.7", "fe80::1", "pc_7.lab")
    monkeypatch.setenv("POINTPRED_ALLOW_HOST", ",".join(hosts))
    assert Settings().allow_host == hosts
    rule = HostRule("127.0.0.1", hosts)
    assert all(rule.admits(header) for header in (*hosts[:3], "lab.example:8000", "[fe80::1]:80", "pc_7.lab"))


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("port", 65536),
        ("max_sessions", 0),
        ("idle_s", float("nan")),
        ("idle_s", 0.0),
        ("max_frame_bytes", 2**20),
        ("log_format", "xml"),
        ("token", "short"),
    ],
)
def test_values_out_of_bounds_are_refused(name: str, value: object) -> None:
    with pytest.raises(ValidationError, match=name):
        Settings(**{name: value})


def test_a_wrong_setting_is_one_line_that_names_flag_and_variable() -> None:
    wrong = serve(POINTPRED_MAX_SESSIONS="many")
    assert wrong.returncode == 2
    assert "--max-sessions or POINTPRED_MAX_SESSIONS" in wrong.stderr
    assert "Traceback" not in wrong.stderr


def test_a_token_is_never_repeated_in_a_refusal() -> None:
    wrong = serve(POINTPRED_TOKEN="hush-99")
    assert wrong.returncode == 2
    assert "hush-99" not in wrong.stdout + wrong.stderr


def test_a_token_of_ones_own_is_not_shown() -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "pointpred", "serve", "--port", "0"],
        env={**os.environ, "POINTPRED_TOKEN": "open-sesame-9"},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    said = process.stdout.readline()
    process.terminate()
    out, err = process.communicate(timeout=PATIENCE_S)
    assert "open-sesame-9" not in said + out + err
    assert said.startswith("http://127.0.0.1:")


def test_a_token_is_made_up_and_shown_where_others_reach_the_port() -> None:
    made = Settings(host="0.0.0.0").guarded()
    assert made.token
    assert made.address_query == f"?token={made.token}"
    assert Settings(host="0.0.0.0").guarded().token != made.token
    assert Settings(host="0.0.0.0", token="open-sesame-9").guarded().address_query == ""


@pytest.mark.parametrize("proxy", ["lab.example", "10.0.0.0/40", "127.0.0.1:80", "*"])
def test_a_proxy_is_an_address_or_a_network(proxy: str) -> None:
    with pytest.raises(ValidationError, match="a proxy is an address or a network"):
        Settings(trust_proxy=[proxy])


def test_a_service_behind_a_proxy_has_a_token() -> None:
    assert Settings().guarded().token is None
    assert Settings(trust_proxy=["127.0.0.1"]).guarded().token
