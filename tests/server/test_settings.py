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


HOSTS = [
    '["lab.example"]',
    '"lab.example"',
    "lab.example:8000",
    "http://lab.example",
    "*",
    "*.example",
    "[::1]",
]
ORIGINS = ["lab.example", "https://lab.example/", "https://lab.example/page", "null", "https://Lab.example"]
PROXIES = ["lab.example", "10.0.0.0/40", "127.0.0.1:80", "*"]
REFUSED = [
    ("port", 65536, "port"),
    ("max_sessions", 0, "max_sessions"),
    ("idle_s", float("nan"), "idle_s"),
    ("idle_s", 0.0, "idle_s"),
    ("max_frame_bytes", 2**20, "max_frame_bytes"),
    ("log_format", "xml", "log_format"),
    ("token", "short", "token"),
    *(("allow_host", [host], "a host reads like") for host in HOSTS),
    *(("allow_origin", [origin], "an origin reads like") for origin in ORIGINS),
    ("record", "", "name a folder to record in"),
    *(("trust_proxy", [proxy], "a proxy is an address or a network") for proxy in PROXIES),
]


@pytest.mark.parametrize(("name", "value", "words"), REFUSED)
def test_what_cannot_be_is_refused(name: str, value: object, words: str) -> None:
    with pytest.raises(ValidationError, match=words):
        Settings(**{name: value})


@pytest.mark.parametrize("host", HOSTS)
def test_a_host_of_the_environment_is_refused_alike(monkeypatch: pytest.MonkeyPatch, host: str) -> None:
    monkeypatch.setenv("POINTPRED_ALLOW_HOST", f"good.example,{host}")
    with pytest.raises(ValidationError, match="a host reads like"):
        Settings()


def test_hosts_are_names_or_addresses(monkeypatch: pytest.MonkeyPatch) -> None:
    hosts = ("lab", "Lab.example", "192.168.0.7", "fe80::1", "pc_7.lab")
    monkeypatch.setenv("POINTPRED_ALLOW_HOST", ",".join(hosts))
    assert Settings().allow_host == hosts
    rule = HostRule("127.0.0.1", hosts)
    for header in (*hosts[:3], "lab.example:8000", "[fe80::1]:80", "pc_7.lab"):
        assert rule.admits({"headers": [(b"host", header.encode())]}), header


def test_a_variable_that_nobody_reads_is_refused_with_the_nearest_name(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A misspelt token would leave a service open."""
    for name, near in (("POINTPRED_TOKN", "POINTPRED_TOKEN"), ("pointpred_max_session", "MAX_SESSIONS")):
        with monkeypatch.context() as patch:
            patch.setenv(name, "open-sesame-9")
            with pytest.raises(ValidationError, match=f"unknown variable {name} .*{near}"):
                Settings()
    wrong = serve(POINTPRED_TOKN="open-sesame-9")
    assert wrong.returncode == 2
    assert "unknown variable POINTPRED_TOKN" in wrong.stderr


def test_a_wrong_setting_is_one_line_that_names_flag_and_variable() -> None:
    for variable, named in (
        ("MAX_SESSIONS", "(POINTPRED_MAX_SESSIONS)"),
        ("METRICS_PORT", "--metrics-port or POINTPRED_METRICS_PORT"),
    ):
        wrong = serve(**{f"POINTPRED_{variable}": "many"})
        assert wrong.returncode == 2
        assert named in wrong.stderr
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


def test_a_service_behind_a_proxy_has_a_token() -> None:
    assert Settings().guarded().token is None
    assert Settings(trust_proxy=["127.0.0.1"]).guarded().token
