"""``pointpred live --serve``: a process that reads an emulated mouse and shows it to whoever looks."""

from __future__ import annotations

import json
import signal
from contextlib import suppress
from pathlib import Path
from typing import Any

from httpx2 import get
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from tests.devices.live_fakes import reach
from tests.devices.live_process import PATIENCE_S, READING, send, started, until_said
from tests.devices.mice import TWO_WHEELS, plug
from tests.devices.umockdev import Testbed


def heard(socket: ClientConnection, told: dict[str, list[Any]], reports: int) -> None:
    """Add what a viewer is told until it has heard of the device and of so many events."""
    while "device" not in told or sum(len(one["events"]) for one in told.get("events", [])) < reports:
        message = json.loads(socket.recv(PATIENCE_S))
        told.setdefault(message["type"], []).append(message)


def goodbye(socket: ClientConnection) -> dict[str, Any]:
    """The last thing that is said before the connection is closed."""
    last: dict[str, Any] = {}
    with suppress(ConnectionClosed):
        while True:
            last = json.loads(socket.recv(PATIENCE_S))
    return last


def test_a_viewer_sees_the_mouse_and_hears_the_end(testbed: Testbed, tmp_path: Path) -> None:
    mouse, errors = plug(testbed, TWO_WHEELS), tmp_path / "errors"
    words = (
        "--cpi",
        "800",
        "--predictor",
        "switched",
        "--serve",
        "--port",
        "0",
        "--record",
        str(tmp_path / "a.csv"),
    )
    with started(testbed, errors, *words) as process:
        until_said(errors, READING, process)
        assert process.stdout is not None
        address = next(line.strip() for line in process.stdout if line.startswith("http"))
        assert get(f"{address}v1/live", timeout=PATIENCE_S).json()["attached"]["name"] == "two wheels"
        stream = address.replace("http", "ws") + "v1/live"
        with connect(stream, compression=None, open_timeout=PATIENCE_S) as socket:
            told: dict[str, list[Any]] = {}
            heard(socket, told, 0)  # whoever is connected but not greeted is not shown what comes
            sent = send(mouse, reach(0.0, (900.0, -400.0), rate_hz=500.0))
            heard(socket, told, sent)
            assert told["device"][0]["predictor"] == "switched"
            assert told["transfer"][0]["words"].startswith("a transfer function is learnt from")
            rows = [row for one in told["events"] for row in one["events"]]
            assert len(rows) == sent
            assert sum(row[3] for row in rows) == 900.0
            assert any(one["phase"] == "ballistic" for one in told["prediction"])
            process.send_signal(signal.SIGTERM)
            assert goodbye(socket) == {"type": "bye", "reason": "the server stops"}
            assert socket.close_code == 1001
        assert process.wait(PATIENCE_S) == 0
    assert "Traceback" not in errors.read_text()
    assert len((tmp_path / "a.csv").read_text().splitlines()) == 2 + sent


def test_it_ends_by_itself_when_its_time_is_over(testbed: Testbed, tmp_path: Path) -> None:
    plug(testbed, TWO_WHEELS)
    errors = tmp_path / "errors"
    words = ("--cpi", "800", "--predictor", "hold", "--serve", "--port", "0", "--seconds", "1")
    with started(testbed, errors, *words) as process:
        out, _ = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 0, errors.read_text()
    assert "0 reports; " in out
