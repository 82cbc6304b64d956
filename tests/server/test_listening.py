"""The service as a process: it says where it is only once it answers, and it stops when asked."""

from __future__ import annotations

import signal
import socket
import subprocess
import sys
import urllib.request
from collections.abc import Iterator

import pytest

from pointpred.errors import SourceError
from pointpred_server.listening import address, listen
from tests.server.running import PATIENCE_S


@pytest.fixture
def service() -> Iterator[subprocess.Popen[str]]:
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    yield process
    process.kill()
    process.communicate()


def test_prints_its_address_once_it_answers_and_stops_on_interrupt(service: subprocess.Popen[str]) -> None:
    assert service.stdout is not None
    url = service.stdout.readline().strip()
    assert url.startswith("http://127.0.0.1:")
    assert url.endswith("/")
    with urllib.request.urlopen(url) as answer:  # at once: no second try
        assert b"pointpred" in answer.read()
    with urllib.request.urlopen(f"{url}healthz") as answer:
        assert answer.status == 200
    service.send_signal(signal.SIGINT)
    rest, complaints = service.communicate(timeout=PATIENCE_S)
    assert (service.returncode, rest) == (0, "")
    assert "Traceback" not in complaints


def test_a_busy_port_is_refused_or_passed_over() -> None:
    with listen("127.0.0.1", 0) as taken:
        port = taken.getsockname()[1]
        with pytest.raises(SourceError, match=f"port {port} is in use on 127.0.0.1; choose another"):
            listen("127.0.0.1", port)
        with listen("127.0.0.1", port, 20) as other:
            assert port < other.getsockname()[1] < port + 20


def test_a_port_that_pointpred_holds_is_told_from_others(service: subprocess.Popen[str]) -> None:
    assert service.stdout is not None
    port = int(service.stdout.readline().strip().rstrip("/").rpartition(":")[2])
    with pytest.raises(SourceError, match=f"pointpred already runs on 127.0.0.1 port {port}"):
        listen("127.0.0.1", port)


def test_an_address_of_another_machine_is_refused_in_words() -> None:
    with pytest.raises(SourceError, match=r"cannot listen on 192\.0\.2\.1 port 0"):
        listen("192.0.2.1", 0)


def test_a_name_that_does_not_exist_is_refused_in_words() -> None:
    with pytest.raises(SourceError, match=r"cannot listen on no\.such\.name\.invalid port 0"):
        listen("no.such.name.invalid", 0)


@pytest.mark.parametrize("host", ["127.0.0.1", "0.0.0.0"])
def test_the_address_can_be_opened_on_this_machine(host: str) -> None:
    with listen(host, 0) as opened:
        assert address(host, opened) == f"http://127.0.0.1:{opened.getsockname()[1]}/"


def test_an_ipv6_address_stands_in_brackets() -> None:
    if not socket.has_ipv6:
        pytest.skip("this machine has no IPv6")
    try:
        opened = listen("::1", 0)
    except SourceError as error:
        pytest.skip(f"IPv6 is off here: {error}")
    with opened:
        assert address("::1", opened).startswith("http://[::1]:")
