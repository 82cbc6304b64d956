"""Assistance over a real socket: what a recording says of it, and nothing for who does not ask."""

from __future__ import annotations

import csv
import json
from pathlib import Path

from tests.server.running import PATIENCE_S, running
from tests.server.test_assisted import CPI, asking, reach
from tests.unit.talking import events, hello


def test_a_recording_says_that_the_cursor_was_helped(tmp_path: Path) -> None:
    rows = reach(30)
    greeting = json.dumps(asking(strength=0.25))
    with running(record=tmp_path) as service, service.greeted(greeting) as socket:
        socket.send(json.dumps(events(*rows)))
        cursor = json.loads(socket.recv(PATIENCE_S))
        socket.recv(PATIENCE_S)
        socket.send(json.dumps({"type": "configure", "assist": {"strength": 0.0}}))
        socket.recv(PATIENCE_S)
        last = [rows[-1][0] + 0.001, 0.0, 0.0, 3.0, 0.0, 0]
        socket.send(json.dumps(events(last)))
        socket.recv(PATIENCE_S)
    (predictions,) = tmp_path.rglob("*_predictions.csv")
    (samples,) = tmp_path.rglob("*_samples.csv")
    with predictions.open(newline="", encoding="utf-8") as file:
        said = [json.loads(row["parameters"])["assist"]["strength"] for row in csv.DictReader(file)]
    assert said == [0.25] * 30 + [0.0]
    _, *lines = samples.read_text(encoding="utf-8").splitlines()  # the first says what the file is
    places = [(float(row["x_px"]), float(row["y_px"])) for row in csv.DictReader(lines)]
    assert places[29] == (cursor["x"], cursor["y"])


def test_who_does_not_ask_hears_no_cursor_over_a_real_socket() -> None:
    rows = reach(30)
    with running() as service:
        with service.greeted(json.dumps(asking())) as socket:
            socket.send(json.dumps(events(*rows)))
            assert [json.loads(socket.recv(PATIENCE_S))["type"] for _ in range(2)] == ["cursor", "prediction"]
        plain = json.dumps(hello("switched-direction", device={"cpi": CPI}))
        with service.greeted(plain) as socket:
            socket.send(json.dumps(events(*rows)))
            assert json.loads(socket.recv(PATIENCE_S)).keys() == {
                "type", "t", "x", "y", "region", "phase", "remaining_s", "remaining_spread"
            }  # fmt: skip
