"""The HTTP part over a real socket, and the process as a person starts and stops it."""

from __future__ import annotations

import inspect
import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

import pytest
from httpx2 import get
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from pointpred.registry import RECOMMENDED, REGISTRY, describe
from pointpred_server.cli.serve import FLAGS, serve
from pointpred_server.settings import Settings
from tests.server.running import HELLO, PATIENCE_S, Running, running


def test_predictors_are_those_of_the_registry(service: Running) -> None:
    told = get(f"{service.url}/v1/predictors", timeout=PATIENCE_S).json()
    listed = [describe(name) for name in REGISTRY]
    assert told == {"version": 1, "recommended": RECOMMENDED, "coefficients": [], "predictors": listed}


def test_pages_ask_for_the_token_but_health_does_not() -> None:
    with running(token="open sesame") as here:
        assert get(f"{here.url}/", timeout=PATIENCE_S).status_code == 401
        assert get(f"{here.url}/?token=open%20sesame", timeout=PATIENCE_S).status_code == 200
        assert (
            get(
                f"{here.url}/v1/samples", headers={"Authorization": "Bearer open sesame"}, timeout=PATIENCE_S
            ).status_code
            == 200
        )
        assert get(f"{here.url}/healthz", timeout=PATIENCE_S).status_code == 200


def test_a_service_that_others_reach_makes_up_a_token() -> None:
    open_to_all = Settings(host="0.0.0.0").guarded()
    assert open_to_all.token is not None
    assert len(open_to_all.token) >= 20
    assert open_to_all.token not in str(open_to_all.printable())
    assert Settings(host="127.0.0.1").guarded().token is None


def test_every_setting_has_a_flag() -> None:
    assert set(inspect.signature(serve).parameters) == set(FLAGS) <= set(Settings.model_fields)


@contextmanager
def started(*arguments: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """``pointpred serve`` in a process of its own, once it has printed its address."""
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0", *arguments]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            address = process.stdout.readline().strip()
            assert re.fullmatch(r"http://127\.0\.0\.1:\d+/", address), address
            yield process, address
        finally:
            process.kill()


def talk(socket: ClientConnection, heard: list[str], then: Callable[[], None]) -> None:
    """Send events and hear the answers until the connection closes; after 200 something happens."""
    for i in range(100_000):
        with suppress(ConnectionClosed):  # a goodbye may still wait to be heard
            socket.send(f'{{"type":"events","events":[[{i / 1000},{i},7315.25,null,null,0]]}}')
        heard.append(str(socket.recv(PATIENCE_S)))
        if i == 200:
            then()


@pytest.mark.parametrize("stop", [signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
def test_a_stopped_process_says_bye_in_the_middle_of_traffic(stop: signal.Signals) -> None:
    if signal.getsignal(stop) is signal.SIG_IGN:
        pytest.skip(f"{stop.name} is ignored here, as under nohup, and so by the service")
    with started() as (process, address):
        url = address.replace("http", "ws") + "v1/stream"
        with connect(url, compression=None, open_timeout=PATIENCE_S) as socket:
            socket.send(HELLO)
            socket.recv(PATIENCE_S)
            heard: list[str] = []
            with pytest.raises(ConnectionClosed) as closed:
                talk(socket, heard, lambda: process.send_signal(stop))
        out, err = process.communicate(timeout=PATIENCE_S)
    assert process.returncode in (0, -stop, 128 + stop)
    assert any('"type":"bye"' in answer for answer in heard)
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 1001
    assert "Traceback" not in err
    assert "7315.25" not in err, "movement data in the log"  # four digits: no time of day reads like it
    assert os.linesep.join(out.splitlines()) == ""
