"""The live view's own words and settings: how early the end was known, the demo, the parameters."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from pointpred.registry import RECOMMENDED, REGISTRY, describe
from tests.server import browser, page_browser
from tests.server.page_browser import Visitor, until

pytestmark = browser.needed

HEARD = """
window.lines = [];
const Plain = WebSocket;
window.WebSocket = class extends Plain {
  line = { told: [], answered: [] };
  set onmessage(listen) {
    lines.push(this.line);
    super.onmessage = (event) => {
      if (typeof event.data === "string") this.line.answered.push(JSON.parse(event.data));
      listen(event);
    };
  }
  send(data) {
    if (typeof data === "string") this.line.told.push(JSON.parse(data));
    super.send(data);
  }
};
"""
"""Keeps what each connection tells the service and hears, where it is text."""
CONNECTED = "document.querySelector('#live-card-0 .connection').dataset.state === 'open'"
VERDICT = "JSON.parse(document.querySelector('#live-verdict').dataset.verdict ?? 'null')"
SCENE = "document.querySelector('#live-scene')"
MARKS = f"JSON.parse({SCENE}.dataset.regions ?? '[null]')"
PAUSE = "new Promise((done) => setTimeout(done, 700))"
"""Longer than the pause that ends a movement, after which the page judges it."""
TILES = """import("/web/page/live/tiles.js").then(({ row }) => {
  const { clientWidth, clientHeight } = document.querySelector("#live-scene");
  return row(clientWidth, clientHeight);
})"""


@pytest.fixture(scope="module")
def one(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    with page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        opened.page.add_init_script(HEARD)
        yield opened


@pytest.fixture
def visitor(one: Visitor, url: str) -> Iterator[Visitor]:
    """Somebody at a live view that is connected."""
    one.resize(1280, 720)
    one.prefer(reduced_motion="no-preference", color_scheme="light")
    one.open(f"{url}?by=service#live")
    one.wait(CONNECTED)
    yield one
    assert one.complaints() == []
    assert one.shift() < 0.001


def line(visitor: Visitor) -> dict[str, list[dict[str, Any]]]:
    """What the first card's connection told and heard: the one that has sent the pointer's own events."""
    found: list[dict[str, Any]] = visitor.value("lines")
    (own,) = (
        one for one in found if any(m["type"] == "events" and m["events"][0][0] < 900 for m in one["told"])
    )
    return own


def since(rows: np.ndarray, end: np.ndarray, px: float) -> float | None:
    """The first time from which on every row t, x, y lies so near to an end."""
    near = np.hypot(*(rows[:, 1:3] - end).T) <= px  # NaN: nothing predicted, which is not near
    far = np.flatnonzero(~near)
    first = far[-1] + 1 if len(far) else 0
    return float(rows[first, 0]) if first < len(rows) else None


def leads(own: dict[str, list[dict[str, Any]]]) -> list[dict[str, float | None]]:
    """How early the end of each movement was known, from the events sent and the answers heard.

    None where nothing was predicted in the last 0.3 s before the arrival, as by a slow service.
    """
    events = np.array(
        [row[:3] for m in own["told"] if m["type"] == "events" for row in m["events"]], dtype=float
    )
    answers = np.array(
        [[m["t"], m["x"], m["y"]] for m in own["answered"] if m["type"] == "prediction"], dtype=float
    )
    found = []
    parts = np.split(events, np.flatnonzero(np.diff(events[:, 0]) > 0.3) + 1)
    for rows in parts:
        start, end = rows[0, 1:], rows[-1, 1:]
        distance = math.hypot(*(end - start))
        if distance < 100:
            continue
        arrival, reached = since(rows, end, max(8.0, 0.03 * distance)), since(rows, end, 40.0)
        assert arrival is not None
        assert reached is not None
        within = answers[(answers[:, 0] >= rows[0, 0]) & (answers[:, 0] <= arrival)]
        known = since(within, end, 40.0)
        lead: float | None = arrival - known if known is not None and known < reached else 0.0
        if np.isnan(within[:, 1]).all() or arrival - within[-1, 0] > 0.3:
            lead = None
        found.append({"arrival": arrival, "reached": reached, "lead_s": lead})
    return found


def place(visitor: Visitor, right: float, down: float) -> tuple[float, float]:
    left, top, width, height = visitor.corner("#live-scene")
    return left + right * width, top + down * height


def test_the_sentence_tells_how_early_the_end_was_known(visitor: Visitor) -> None:
    """Eleven movements are judged anew from what went over the wire; averages are over the last ten."""
    name = "minimum-jerk"  # the law of these movements, so that it knows their ends early
    visitor.choose("#live-predictor-0", name)
    corners = [place(visitor, *at) for at in ((0.1, 0.15), (0.8, 0.7), (0.2, 0.6), (0.85, 0.2))]
    verdicts = []
    for i in range(11):
        before = visitor.value(VERDICT)
        visitor.reach(corners[i % 4], corners[(i + 1) % 4], 0.35)
        visitor.value(PAUSE)
        verdicts.append(
            visitor.wait(f"JSON.stringify({VERDICT}) !== {json.dumps(json.dumps(before))} && {VERDICT}")
        )
    verdicts.append(visitor.value(VERDICT))
    expected = leads(line(visitor))
    arrivals = [one["arrival"] for one in expected]  # more than eleven where a slow machine parts a movement
    for verdict in verdicts:
        i = int(np.argmin(np.abs(np.subtract(arrivals, verdict["arrival"]))))
        wanted = expected[i]
        (said,) = verdict["each"]
        assert said["name"] == name
        assert verdict["arrival"] == pytest.approx(wanted["arrival"])
        assert verdict["reached"] == pytest.approx(wanted["reached"])
        assert said["lead_s"] == pytest.approx(wanted["lead_s"])
        last = [one["lead_s"] for one in expected[: i + 1] if one["lead_s"] is not None][-10:]
        silent = wanted["lead_s"] is None or len(last) < 2
        assert said["average_s"] == (None if silent else pytest.approx(np.mean(last)))
    assert verdicts[-1]["arrival"] == pytest.approx(arrivals[-1])
    assert any(one["lead_s"] for one in expected), "some end was known early"
    words = visitor.text("#live-verdict")
    assert not expected[-1]["lead_s"] or f"{1000 * expected[-1]['lead_s']:.0f} ms" in words
    average = 1000 * (verdicts[-1]["each"][0]["average_s"] or 0.0)
    assert average == 0 or f"average of the last ten: {average:.0f} ms" in words


def test_a_clicked_tile_is_judged_by_how_early_it_was_proposed(visitor: Visitor) -> None:
    left, top, *_ = visitor.corner("#live-scene")
    tile = visitor.value(TILES)[3]
    end = (left + 1 + tile["x"] + tile["width"] / 2, top + 1 + tile["y"] + tile["height"] / 2)

    def judged() -> Any:
        """The verdict, when the pointer came, and the choice before; a slow machine may make two."""
        began = visitor.value("performance.now() / 1000")
        visitor.reach(place(visitor, 0.15, 0.2), end, 0.6)
        visitor.click(*end)
        visitor.value(PAUSE)
        verdict = visitor.value(VERDICT)
        if not (verdict and verdict["tile"] and verdict["tile"]["lead_s"] > 0):
            return None
        own = line(visitor)
        events = [row for m in own["told"] if m["type"] == "events" for row in m["events"]]
        inside = [
            tile["x"] <= x <= tile["x"] + tile["width"] and tile["y"] <= y <= tile["y"] + tile["height"]
            for _, x, y, *_ in events
        ]
        pairs = zip(pairwise(events), pairwise(inside), strict=True)
        entered = [b[0] for (_, b), (was, now) in pairs if now and not was][-1]
        choices = [m for m in own["answered"] if m["type"] == "choice" and began < m["t"] < entered]
        return (verdict, entered, choices[0]) if len(choices) == 1 else None

    verdict, entered, choice = until(judged, "a tile that was proposed before the pointer was there")
    assert choice["action"] == "propose"
    assert choice["id"] == tile["id"]
    assert verdict["tile"]["lead_s"] == pytest.approx(entered - choice["t"])
    assert f"Tile: proposed {1000 * verdict['tile']['lead_s']:.0f} ms before" in visitor.text("#live-verdict")


KNOWN = """import("/web/page/live/movement.js").then(({ Movement }) => {
  const movement = new Movement();
  movement.move(ROWS);
  for (const [t, x] of SAID) movement.addPrediction(0, { t, x, y: x === null ? null : 0 }, "it");
  return movement.verdict();
})"""


@pytest.fixture(scope="module")
def known(url: str, one: Visitor) -> Visitor:
    """A page on which functions are asked: one of all questions."""
    one.open(f"{url}?by=service#live")
    return one


@pytest.mark.parametrize(
    ("said", "lead_s"),
    [
        ([[0.2, 150], [0.3, 380], [0.8, 410]], 0.67),
        ([[0.2, 390], [0.5, 300], [0.8, 390]], 0.17),  # it was lost on the way
        ([[0.2, 390], [0.8, None]], 0.0),  # nothing said is not known
        ([[0.2, 390], [0.6, 390]], None),  # the service was away from then on
        ([[0.2, 390], [0.6, 100]], None),
        ([[0.92, 400]], 0.0),  # the pointer was as near before
        ([[0.98, 400]], None),  # after the arrival
        ([], None),
    ],
)
def test_known_is_what_stays_known_until_the_arrival(
    known: Visitor, said: list[list[float | None]], lead_s: float | None
) -> None:
    """400 px in a second at a steady pace: within 40 px from 0.9 s on, arrived (3 %) at 0.97 s."""
    rows = [[i / 100, 4.0 * i, 0.0] for i in range(101)]
    found = known.value(KNOWN.replace("ROWS", json.dumps(rows)).replace("SAID", json.dumps(said)))
    assert found["arrival"] == pytest.approx(0.97)
    assert found["reached"] == pytest.approx(0.9)
    lead = found["predictors"][0]["lead_s"] if found["predictors"] else None
    assert lead == (None if lead_s is None else pytest.approx(lead_s))


def test_the_demo_shows_everything_before_anybody_moves(visitor: Visitor, url: str) -> None:
    """Where less motion is asked for it stands in the middle of a movement."""
    visitor.prefer(reduced_motion="reduce", color_scheme="light")
    visitor.open(f"{url}?by=service#live")
    visitor.wait(f"{SCENE}.dataset.shows === 'demo'")
    visitor.wait("document.querySelector('#live-card-0 [data-of=region]').dataset.px !== ''")
    (mark, none) = visitor.value(MARKS)
    assert none is None
    assert 0 < mark["inner"]["major"] < mark["outer"]["major"]
    visitor.wait("document.querySelector('#live-card-0 [data-of=phase]').textContent !== '–'")
    numbers = {of: visitor.text(f"#view-live [data-of={of}]") for of in ("phase", "left", "region")}
    assert numbers["phase"] in ("ballistic", "corrective")
    assert all(any(sign.isdigit() for sign in numbers[of]) for of in ("left", "region"))
    visitor.wait("/[0-9]/.test(document.querySelector('#live-numbers [data-of=delay]').textContent)")
    for of in ("rate", "speed"):
        assert any(sign.isdigit() for sign in visitor.text(f"#live-numbers [data-of={of}]"))
    assert "imulated" in visitor.text("#live-invitation")
    assert visitor.text("#live-verdict").startswith("Simulated movement")
    assert visitor.value(f"{SCENE}.dataset.ahead").startswith("tile-")
    hello = [m for one in visitor.value("lines") for m in one["told"] if m["type"] == "hello"]
    assert {m["predictor"] for m in hello} == {RECOMMENDED}


@pytest.mark.parametrize("motion", ["reduce", "no-preference"])
@pytest.mark.parametrize("size", [(1440, 900), (1024, 768), (390, 844)])
def test_the_demo_lights_and_frames_a_tile_at_every_size(
    visitor: Visitor, size: tuple[int, int], motion: str
) -> None:
    visitor.prefer(reduced_motion=motion)
    visitor.resize(*size)
    tile = visitor.wait(f"{SCENE}.dataset.shows === 'demo' && {MARKS}[0] && {SCENE}.dataset.ahead")
    assert tile in [one["id"] for one in visitor.value(TILES)]


def test_the_demo_leaves_the_persons_own_sentence_and_connection_alone(visitor: Visitor) -> None:
    visitor.wait(f"{SCENE}.dataset.shows === 'demo'")
    visitor.wait("document.querySelector('#live-verdict').textContent.startsWith('Simulated')")
    visitor.mouse("mouseMoved", *place(visitor, 0.3, 0.3))
    visitor.wait(f"{SCENE}.dataset.shows === 'pointer'")
    assert not visitor.text("#live-verdict").startswith("Simulated")
    assert visitor.value(VERDICT) is None
    for one in visitor.value("lines"):
        begun = [m["events"][0][0] for m in one["told"] if m["type"] == "events"]
        assert all(t < 900 for t in begun) or all(t >= 900 for t in begun), "no connection has both"


CONFIGURED = "lines.flatMap(({ told }) => told).filter(({ type }) => type === 'configure')"


def slide(visitor: Visitor, name: str, kind: str, value: object) -> None:
    """Set a parameter's slider or field, as a hand does."""
    visitor.value(
        f"{{ const field = document.querySelector('#live-parameters-0 input[name={name}]');"
        f"const input = {kind!r} === 'range' ? field.previousElementSibling : field;"
        f"input.value = {str(value)!r}; input.dispatchEvent(new Event('input', {{ bubbles: true }}));"
        "input.dispatchEvent(new Event('change', { bubbles: true })); }"
    )


def test_a_slider_changes_the_predictor_that_is_running(visitor: Visitor) -> None:
    visitor.choose("#live-predictor-0", "switched")
    visitor.value("document.querySelector('#live-parameters-0').open = true")
    slide(visitor, "threshold", "range", 1.0)
    told = visitor.wait(f"{CONFIGURED}.findLast(({{ parameters }}) => parameters?.threshold)")
    known = {one["name"]: one for one in describe("switched")["parameters"]}
    assert told["predictor"] == "switched"
    shown = float(visitor.value("document.querySelector('[name=threshold]').value"))
    assert told["parameters"] == {"threshold": shown}
    assert known["threshold"]["default"] < shown <= known["threshold"]["high"]
    welcomed = "lines.flatMap(({ answered }) => answered).filter(({ type }) => type === 'welcome').length"
    before = visitor.value(welcomed)
    visitor.value("document.querySelector('#live-parameters-0 button').click()")
    visitor.wait(
        f"{CONFIGURED}.at(-1).parameters && Object.keys({CONFIGURED}.at(-1).parameters).length === 0"
    )
    visitor.wait(f"{welcomed} > {before}")
    assert (
        float(visitor.value("document.querySelector('[name=threshold]').value"))
        == known["threshold"]["default"]
    )


def test_a_parameter_that_is_refused_says_so_beside_it(visitor: Visitor) -> None:
    said = "document.querySelector('#live-parameters-0 [role=status]').textContent"
    visitor.choose("#live-predictor-0", "switched")
    slide(visitor, "delay_s", "number", 5)
    assert "delay_s" in visitor.value(said)
    assert visitor.value("document.querySelector('[name=delay_s]').getAttribute('aria-invalid')") == "true"
    assert visitor.value(f"{CONFIGURED}.some(({{ parameters }}) => parameters?.delay_s)") is False
    slide(visitor, "delay_s", "number", 0.02)
    visitor.wait(f"{CONFIGURED}.some(({{ parameters }}) => parameters?.delay_s === 0.02)")
    assert visitor.value(said) == ""
    slide(
        visitor, "step_s", "number", 0.00001
    )  # within its bounds, and more work than the service does for one event
    visitor.wait(f"{said} !== ''")
    assert visitor.value(CONNECTED)
    slide(visitor, "delay_s", "number", 0.03)
    visitor.wait(f"{CONFIGURED}.some(({{ parameters }}) => parameters?.delay_s === 0.03)")
    visitor.wait(f"{said} === ''")


@pytest.mark.parametrize("name", REGISTRY)
def test_every_slider_covers_its_default_and_nothing_beyond_the_bounds(known: Visitor, name: str) -> None:
    settable = [one for one in describe(name)["parameters"] if one["default"] is not None]
    code = (
        f"import('/web/page/live/parameters.js').then(({{ rangeOf }}) => {json.dumps(settable)}.map(rangeOf))"
    )
    for parameter, covered in zip(settable, known.value(code), strict=True):
        low, high = covered["from"], covered["to"]
        assert parameter["low"] <= low <= parameter["default"] <= high <= parameter["high"], parameter["name"]
        assert low < high
        assert covered["log"] or low <= 0 or high / low <= 100, "decades are spread"


def test_every_word_of_the_numbers_and_every_predictor_is_explained(visitor: Visitor) -> None:
    explained = {
        word.lower()
        for word in visitor.value(
            "[...document.querySelectorAll('#live-glossary dt')].map((one) => one.textContent)"
        )
    }
    assert set(REGISTRY) <= explained
    assert {"phase", "time left", "region", "skill", "kep", "ktm", "delay"} <= explained


@pytest.mark.parametrize("size", [(1440, 900), (1024, 768), (390, 844)])
def test_no_number_is_cut(visitor: Visitor, size: tuple[int, int]) -> None:
    """The longest that can stand there."""
    visitor.resize(*size)
    visitor.value("document.querySelector('#live-more').open = true")
    longest = {
        "phase": "corrective",
        "left": "1.99 s",
        "region": "1400 × 1400",
        "delay": "123.45",
        "rate": "1000",
        "speed": "12345",
    }
    cut = visitor.value(
        f"""Object.entries({json.dumps(longest)}).flatMap(([of, words]) => {{
          const cells = [...document.querySelectorAll(`#view-live [data-of=${{of}}]`)];
          return cells.filter((cell) => {{
            cell.textContent = words;
            return cell.scrollWidth > cell.clientWidth;
          }}).map((cell) => [of, cell.clientWidth, cell.scrollWidth]);
        }})"""
    )
    assert cut == []


def test_the_legend_is_drawn_like_the_picture(visitor: Visitor) -> None:
    """Every swatch has something on it, in the colours of what it stands for."""
    drawn = visitor.value(
        """Object.fromEntries([...document.querySelectorAll("#view-live > .legend canvas")].map((one) => {
          const { data } = one.getContext("2d").getImageData(0, 0, one.width, one.height);
          const colours = new Set();
          for (let i = 0; i < data.length; i += 4)
            if (data[i + 3] === 255) colours.add([...data.slice(i, i + 3)].join(" "));
          return [one.dataset.swatch, [...colours]];
        }))"""
    )
    wanted = {
        "trail": "37 99 168", "simulated": "107 118 128", "endpoint": "194 65 12", "second": "126 34 206",
        "region": "194 65 12", "proposed": "194 65 12", "ballistic": "14 116 144", "corrective": "161 98 7",
    }  # fmt: skip
    for swatch, colour in wanted.items():
        assert colour in drawn[swatch], swatch
    assert drawn["likely"]
