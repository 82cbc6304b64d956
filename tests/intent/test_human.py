"""`pointpred/human` with real drivers: the mouse of a real Chromium moves as the simulated hand does."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pointpred.simulation import hand
from tests.hosts import Silent, file_host, host
from tests.intent import npm
from tests.intent.npm import LIB
from tests.server import browser

PAGE = """<!doctype html><title>a page</title><body style="margin: 0">
<style>button { position: absolute }</style>
<button id="middle" style="left: 300px; top: 150px; width: 200px; height: 200px">middle</button>
<button id="cart" style="left: 600px; top: 400px; width: 80px; height: 30px">cart</button>
<script>
  window.seen = [];
  for (const kind of ["pointermove", "pointerdown", "pointerup", "click", "pointerover"])
    addEventListener(kind, ({ type, timeStamp, clientX, clientY, target, isTrusted }) =>
      seen.push([type, timeStamp / 1000, clientX, clientY, target.id, isTrusted]), true);
</script>"""
SCRIPT = Path(__file__).parent / "driving.mjs"


def drive(packages: Path, name: str, address: str, seed: int) -> Any:
    shutil.copy(SCRIPT, packages / SCRIPT.name)
    command = ["node", SCRIPT.name, name, str(browser.BROWSER), address, str(seed)]
    return json.loads(npm.run(command, packages).stdout)


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    folder = tmp_path_factory.mktemp("page")
    (folder / "index.html").write_text(PAGE)
    with file_host(folder) as origin:
        yield f"{origin}/"


installed = pytest.mark.slow
"""Drivers of npm take longest: `make npm` runs it."""


@pytest.fixture(scope="module", params=["playwright", "puppeteer"])
def driven(request: pytest.FixtureRequest, packages: Path, address: str) -> Any:
    return drive(packages, request.param, address, 1)


@installed
@browser.needed
def test_it_hovers_on_the_way_and_clicks_where_it_was_told(driven: Any) -> None:
    over = [one[4] for one in driven["seen"] if one[0] == "pointerover"]
    assert over.index("middle") < over.index("cart"), "the other button lies on the way"
    clicked = [
        (kind, target) for kind, _, _, _, target, _ in driven["seen"] if kind in ("click", "pointerdown")
    ]
    assert clicked == [
        ("pointerdown", "cart"),
        ("click", "cart"),
        ("pointerdown", "middle"),
        ("click", "middle"),
    ]
    assert all(trusted for *_, trusted in driven["seen"])
    x, y = driven["rested"]["x"], driven["rested"]["y"]
    assert 600 <= x <= 680
    assert 400 <= y <= 430


@installed
@browser.needed
def test_the_page_sees_the_path_of_the_seed(driven: Any) -> None:
    """A browser joins moves of one frame: what the page sees are positions of the path, in their order."""
    memory = np.zeros(hand.LENGTH)
    hand.begin(memory, 1.0, 0.5)
    hand.aim(memory, 640.0, 415.0, 30.0)
    reports = [hand.Report(*hand.report(memory))]
    while reports[-1].phase < hand.RESTING:
        reports.append(hand.Report(*hand.report(memory)))
    path = [(one.x, one.y) for one in reports]
    seen = [(x, y) for kind, _, x, y, _, _ in driven["seen"] if kind == "pointermove"]
    count = seen.index(path[-1]) + 1
    at = 0
    for place in seen[:count]:
        at = path.index(place, at)
    assert count > 20
    times = [t for kind, t, *_ in driven["seen"] if kind == "pointermove"]
    moving = reports[-1].t - next(one.t for one in reports if (one.x, one.y) != (0.0, 0.0))
    assert times[count - 1] - times[0] == pytest.approx(moving, abs=0.5)


@installed
@browser.needed
def test_it_says_what_cannot_be_reached_and_that_it_is_a_driver(driven: Any) -> None:
    nothing, outside = driven["told"]
    assert nothing == "#nothing is not on the page, or not shown"
    assert outside == "the middle of the target lies outside of the viewport, at 5000, 20: scroll there first"
    assert driven["automated"], "what a driver marks as automation stays marked"


class Remote(Silent, BaseHTTPRequestHandler):
    """The three commands of WebDriver that are used, and what was asked with them."""

    asked: list[tuple[str, Any]]

    def do_POST(self) -> None:
        body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.asked.append((self.path, body))
        found: Any = None
        if "innerWidth" in body.get("script", ""):
            found = {"width": 800, "height": 600}
        elif body.get("args") == ["#cart"]:
            found = {"x": 600, "y": 400, "width": 80, "height": 30}
        status = 404 if self.path.startswith("/gone") else 200
        answer = {"value": {"message": "no such session"} if status == 404 else found}
        text = json.dumps(answer).encode()
        self.send_response(status)
        self.send_header("Content-Length", str(len(text)))
        self.end_headers()
        self.wfile.write(text)


WEBDRIVER = """import { human } from "./human/index.js";
const [, , address] = process.argv;
const hand = human(`${address}/session/1/`, { seed: 1 });
await hand.click("#cart");
const told = [];
const gone = human(new URL(`${address}/gone`));
for (const one of [() => hand.moveTo("#nothing"), () => gone.moveTo("#cart"), () => human(7),
  () => human(address, { seed: -1 }), () => human(address, { skill: 2 }),
  () => human(address, { speed: 1 }), () => human(address, { at: { x: 1 } })])
  told.push(await Promise.resolve().then(one).catch((error) => `${error.name}: ${error.message}`));
console.log(JSON.stringify(told));
"""


@pytest.mark.skipif(shutil.which("node") is None, reason="no node on this machine")
def test_a_webdriver_is_given_the_whole_movement_as_actions(tmp_path: Path) -> None:
    """What is sent over the protocol. ``test_chromedriver`` has a real browser."""
    for room in ("human", "laws"):
        (tmp_path / room).symlink_to(LIB / room)
    npm.write(tmp_path, {"use.mjs": WEBDRIVER, "package.json": '{ "type": "module" }'})
    remote = type("Recording", (Remote,), {"asked": []})
    with host(remote) as origin:
        command = ["node", "--preserve-symlinks", "use.mjs", origin]
        told = json.loads(npm.run(command, tmp_path).stdout)
    path, body = next(one for one in remote.asked if one[0].endswith("/actions"))
    assert path == "/session/1/actions"
    (mouse,) = body["actions"]
    assert mouse["type"] == "pointer"
    assert mouse["parameters"] == {"pointerType": "mouse"}
    kinds = [one["type"] for one in mouse["actions"]]
    assert kinds.index("pointerDown") < kinds.index("pointerUp")
    moves = [one for one in mouse["actions"] if one["type"] == "pointerMove"]
    assert all(one["origin"] == "viewport" and one["duration"] % 8 == 0 for one in moves)
    assert 0.5 < sum(one["duration"] for one in moves) / 1000.0 < 4.0
    assert all(0 <= one["x"] < 800 and 0 <= one["y"] < 600 for one in moves)
    assert told[0] == "Error: #nothing is not on the page, or not shown"
    assert told[1].startswith("Error: the WebDriver refused execute/sync: no such session")
    assert told[2].startswith("TypeError: a page of Playwright or Puppeteer is needed")
    assert told[3].startswith("RangeError: seed must be a whole number")
    assert told[4].startswith("RangeError: skill must be a number in [0, 1]")
    assert told[5:] == [
        "TypeError: unknown option speed; known: seed, skill, at",
        'TypeError: at must be a point {x, y}, received {"x":1}',
    ]


EDGE = """import { human } from "./human/index.js";
let moves = [];
globalThis.fetch = async (_, { body }) => {
  moves = JSON.parse(body).actions?.[0].actions.filter(({ type }) => type === "pointerMove") ?? moves;
  return { ok: true, json: async () => ({ value: { width: 800, height: 600 } }) };
};
const told = [];
for (let seed = 0; seed < 20; seed += 1) {
  const hand = human("http://driver.example/session/1", { seed, at: { x: 100, y: 300 } });
  await hand.moveTo({ x: 799, y: 0 });
  const { x, y } = moves.at(-1);
  told.push([hand.at, { x, y }]);
}
console.log(JSON.stringify(told));
"""


@pytest.mark.skipif(shutil.which("node") is None, reason="no node on this machine")
def test_the_hand_is_where_the_mouse_has_stopped_at_an_edge(tmp_path: Path) -> None:
    for room in ("human", "laws"):
        (tmp_path / room).symlink_to(LIB / room)
    npm.write(tmp_path, {"use.mjs": EDGE, "package.json": '{ "type": "module" }'})
    told = json.loads(npm.run(["node", "--preserve-symlinks", "use.mjs"], tmp_path).stdout)
    for at, mouse in told:
        assert at == mouse
        assert at["x"] <= 799
        assert at["y"] >= 0


CHROMEDRIVER = """import { spawn } from "node:child_process";
import { human } from "pointpred/human";
const [, , program, binary, address] = process.argv;
const driver = spawn(program, ["--port=0"]);
let said = "";
const port = await new Promise((found) => driver.stdout.on("data", (text) => {
  said += text;
  const started = /started successfully on port (\\d+)/.exec(said);
  if (started) found(started[1]);
}));
const base = `http://127.0.0.1:${port}/session`;
const ask = async (url, body) => {
  const answer = await fetch(url, { method: "POST", body: JSON.stringify(body) });
  return (await answer.json()).value;
};
const options = { binary, args: ["--headless", "--no-sandbox", "--disable-gpu"] };
const { sessionId } = await ask(base, { capabilities: { alwaysMatch: { "goog:chromeOptions": options } } });
await ask(`${base}/${sessionId}/url`, { url: address });
await human(`${base}/${sessionId}`, { seed: 1 }).click("#cart");
const seen = await ask(`${base}/${sessionId}/execute/sync`, { script: "return seen", args: [] });
await fetch(`${base}/${sessionId}`, { method: "DELETE" });
driver.kill();
console.log(JSON.stringify(seen));
"""


@installed
@browser.needed
@pytest.mark.skipif(shutil.which("chromedriver") is None, reason="no chromedriver on this machine")
def test_chromedriver(packages: Path, address: str) -> None:
    (packages / "webdriver.mjs").write_text(CHROMEDRIVER)
    command = ["node", "webdriver.mjs", "chromedriver", str(browser.BROWSER), address]
    seen = json.loads(npm.run(command, packages).stdout)
    assert [target for kind, _, _, _, target, _ in seen if kind == "click"] == ["cart"]
    assert len([one for one in seen if one[0] == "pointermove"]) > 20
