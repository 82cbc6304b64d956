"""One region everywhere: the package, both kinds of frames, both clients and the live feed."""

from __future__ import annotations

import json
from typing import Any

import msgspec
import numpy as np
import pytest
from websockets.sync.client import connect as dial
from websockets.typing import Subprotocol

from pointpred import EventColumns, Prediction, Region, build, run
from pointpred.client import connect
from pointpred.datasets import sample
from pointpred_server.live_feed import frames_of
from tests.server import browser
from tests.server.page_browser import Visitor
from tests.server.running import PATIENCE_S
from tests.unit import talking

LEVELS = (0.5, 0.8, 0.95)
PREDICTOR = "kinematic"
COUNT = 400
MOVEMENT = sample().rows(0)[:COUNT]
EVENTS = EventColumns.of(MOVEMENT.t, MOVEMENT.x, MOVEMENT.y)
ROWS = [[*row[:3], None, None, 0] for row in EVENTS.table.tolist()]

Regions = list[list[dict[str, float] | None]]
"""For each event and level an ellipse, by its fields."""


def ellipses(one: Any) -> list[dict[str, float] | None]:
    """What something with a ``region`` gives for each level."""
    found: list[Region | None] = [None if one is None else one.region(level) for level in LEVELS]
    return msgspec.to_builtins(found)


def wanted() -> Regions:
    pipeline = build(PREDICTOR)
    return [ellipses(pipeline.update(event)) for event in EVENTS]


def alike(found: Regions) -> None:
    """Each ellipse is that of the package; browsers may round the last digits otherwise."""
    expected = wanted()
    assert len(found) == len(expected)
    for own, other in zip(found, expected, strict=True):
        for mine, theirs in zip(own, other, strict=True):
            assert mine == (None if theirs is None else pytest.approx(theirs, rel=1e-12, abs=1e-12))


def test_the_movement_has_regions_of_a_heavy_tail_that_differ() -> None:
    """Otherwise equality would say little."""
    answers = run(build(PREDICTOR), EVENTS)
    assert np.isfinite(answers.tail).sum() > 300
    assert np.nanmax(answers.tail) < 30.0
    sizes = [one[0]["major"] for one in wanted() if one[0] is not None]
    assert len(set(sizes)) > 300
    assert ellipses(None) == [None, None, None]


def test_the_batch() -> None:
    answers = run(build(PREDICTOR), EVENTS)
    each = [answers.region(level) for level in LEVELS]
    alike([msgspec.to_builtins(list(regions)) for regions in zip(*each, strict=True)])


@pytest.mark.parametrize("encoding", ["json", "binary"])
def test_frames_read_by_nothing_of_ours(url: str, encoding: str) -> None:
    """Each prediction as JSON or struct gives it; ``Prediction`` makes the ellipse of its numbers."""
    hello = talking.hello(PREDICTOR, reply="event", encoding=encoding)
    address = f"{url.replace('http', 'ws')}v1/stream"
    with dial(address, subprotocols=[Subprotocol("pointpred.v1")], open_timeout=PATIENCE_S) as socket:
        socket.send(json.dumps(hello))
        assert json.loads(socket.recv(PATIENCE_S))["type"] == "welcome"
        found = []
        for first in range(0, COUNT, 50):
            part = ROWS[first : first + 50]
            socket.send(json.dumps(talking.events(*part)) if encoding == "json" else talking.packed(*part))
            if encoding == "json":
                found += [ellipses(of_json(json.loads(socket.recv(PATIENCE_S)))) for _ in part]
                continue
            frame = socket.recv(PATIENCE_S)
            assert isinstance(frame, bytes)
            found += [ellipses(of_record(record)) for record in talking.PREDICTION.iter_unpack(frame)]
        alike(found)


def of_json(said: dict[str, Any]) -> Prediction | None:
    region = said["region"]
    if region is None:
        return None
    scale = (region["sxx"], region["sxy"], region["syy"])
    return Prediction(said["t"], said["x"], said["y"], scale, "still", None, region["tail"])


def of_record(record: tuple[Any, ...]) -> Prediction | None:
    t, x, y, sxx, sxy, syy, _, _, tail = record
    if sxx != sxx:
        return None
    return Prediction(t, x, y, (sxx, sxy, syy), "still", None, None if tail != tail else tail)


@pytest.mark.parametrize("encoding", ["json", "binary"])
def test_the_python_client(url: str, encoding: str) -> None:
    options = {"predictor": PREDICTOR, "reply": "event", "encoding": encoding}
    with connect(url, timeout_s=PATIENCE_S, **options) as connection:
        connection.send(EVENTS)
        alike([ellipses(message) for message in connection.predictions()])
        connection.reset()
        connection.send(EVENTS)
        columns = connection.columns()
        alike([ellipses(one) for one in columns])


HEARD = """import("/pointpred.js").then(({ connect, regionOf }) => new Promise((done) => {
  const heard = [], options = { predictor: P, encoding: E, reply: "event", pointer: false };
  const connection = connect(undefined, { ...options, screen: { dpi: 96 } });
  connection.on("prediction", (prediction) => {
    heard.push(LEVELS.map((level) => regionOf(prediction, level)));
    if (heard.length === ROWS.length) {
      connection.close();
      done(heard);
    }
  });
  connection.send(ROWS);
}))"""


@browser.needed
@pytest.mark.parametrize("encoding", ["json", "binary"])
def test_the_browser_client(one: Visitor, url: str, encoding: str) -> None:
    one.open(f"{url}#circle")
    given = {"ROWS": ROWS, "LEVELS": LEVELS, "P": PREDICTOR, "E": encoding}
    names = "".join(f"const {name} = {json.dumps(value)};" for name, value in given.items())
    alike(one.value(f"(() => {{ {names} return {HEARD}; }})()"))


def test_what_viewers_of_a_device_are_told() -> None:
    pipeline, found = build(PREDICTOR), []
    for event in EVENTS:
        _, text = frames_of([(event, pipeline.update(event))])
        found.append(ellipses(of_json(json.loads(text))))
    alike(found)
