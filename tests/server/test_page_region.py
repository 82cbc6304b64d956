"""The regions of a prediction as the page draws them, held against the distribution that is claimed.

The answers are given a region of the test's own on their way into the page.
"""

from __future__ import annotations

import base64
import io
import json
import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.stats import chi2, f

from tests.server import browser, page_browser
from tests.server.page_browser import Visitor, until

pytestmark = browser.needed

DOCUMENT = Path(__file__).parents[2] / "docs" / "guide" / "page.md"

WRITTEN = """
window.region = window.lit = null; window.sockets = [];
const Plain = WebSocket;
window.WebSocket = class extends Plain {
  set onmessage(listen) {
    sockets.push(this);
    super.onmessage = (event) => {
      const message = region === null ? {} : JSON.parse(event.data);
      if (message.type !== "prediction") return listen(event);
      const [x, y, sxx, sxy, syy, tail] = region;
      const targets = lit === null ? [] : [{ id: lit, p: 1 }];
      const phase = "ballistic";
      const data = JSON.stringify({ ...message, x, y, region: { sxx, sxy, syy, tail }, targets, phase });
      listen(new MessageEvent("message", { data }));
    };
  }
};
"""
"""Writes x, y, sxx, sxy, syy, tail into every prediction once a region is set, and which tile is sure."""
ORANGE = np.array([194, 65, 12])
"""The first predictor's colour, in the light theme."""
FILL = 0.16
CONNECTED = "document.querySelector('#live-card-0 .connection').dataset.state === 'open'"
MARKS = "JSON.parse(document.querySelector('#live-scene').dataset.regions ?? '[]')"
NUMBER = "document.querySelector('#live-card-0 [data-of=region]')"
CLAIMS = [(900.0, 0.0, 900.0, None), (2500.0, 1300.0, 1600.0, 5.0), (400.0, -300.0, 900.0, 0.9)]
"""Scale matrices with their degrees of freedom; none for a normal law."""


@pytest.fixture(scope="module")
def one(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    with page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        opened.page.add_init_script(WRITTEN)
        opened.prefer(color_scheme="light")
        yield opened


@pytest.fixture
def visitor(one: Visitor, url: str) -> Iterator[Visitor]:
    """Somebody at a live view that is connected."""
    one.open(f"{url}?by=service#live")
    one.wait(CONNECTED)
    yield one
    assert one.complaints() == []
    assert one.shift() < 0.001


TILE = """import("/web/page/live/tiles.js").then(({ row }) => {
  const { clientWidth, clientHeight } = document.querySelector("#live-scene");
  return row(clientWidth, clientHeight)[3];
})"""
KEPT = """{
  const canvas = document.querySelector("#live-scene");
  const region = document.querySelector("#live-card-0 [data-of=region]");
  window.kept = { picture: null, marks: null, px: null, said: [], cut: false };
  new MutationObserver(([{ oldValue }]) => {
    if (canvas.dataset.drawn === oldValue || canvas.dataset.shows !== "pointer") return;
    const marks = JSON.parse(canvas.dataset.regions);
    const { px } = region.dataset;
    if (marks[0]?.opacity === 1) Object.assign(kept, { picture: canvas.toDataURL(), marks, px });
  }).observe(canvas, { attributeFilter: ["data-drawn"], attributeOldValue: true });
  new MutationObserver(() => {
    if (canvas.dataset.shows !== "pointer") return;
    kept.said.push(region.textContent);
    kept.cut ||= region.scrollWidth > region.clientWidth;
  }).observe(region, { childList: true });
}"""
"""Keeps the last picture with an endpoint that does not fade, and the words on its region: both soon go.

The demo, which draws endpoints until somebody moves, is left out.
"""
FRAMES = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"


def picture(visitor: Visitor, start: tuple[float, float], end: tuple[float, float]) -> dict[str, Any]:
    """What is kept of the page once the pointer is at an end.

    A busy machine may draw nothing before the endpoint has gone: then the pointer moves once more.
    """

    def drawn() -> dict[str, Any] | None:
        visitor.reach(start, end, 0.2)
        visitor.value("kept.picture = null")  # on the way the pointer was elsewhere
        visitor.mouse("mouseMoved", end[0] + 1.0, end[1])
        visitor.mouse("mouseMoved", *end)
        found: dict[str, Any] | None = visitor.value(f"{FRAMES}.then(() => kept.picture && kept)")
        return found

    found: dict[str, Any] = until(drawn, "a picture with an endpoint")
    return found


def pixels(address: str) -> tuple[np.ndarray, np.ndarray]:
    """Colours from 0 to 255 and opacities from 0 to 1 in a picture given as an address with its data."""
    from matplotlib.image import imread

    picture = imread(io.BytesIO(base64.b64decode(address.partition(",")[2])))
    return picture[..., :3] * 255, picture[..., 3]


def radius(level: float, tail: float | None) -> float:
    """Mahalanobis distance within which a share of a normal or Student law of two dimensions lies."""
    return float(np.sqrt(chi2.ppf(level, 2) if tail is None else 2.0 * f.ppf(level, 2, tail)))


@pytest.mark.parametrize("claim", CLAIMS)
def test_half_of_the_endpoints_lie_in_the_tinted_region_and_four_fifths_in_the_outline(
    visitor: Visitor, claim: tuple[float, float, float, float | None]
) -> None:
    """Every pixel by its Mahalanobis distance, held against the quantiles of the claimed law."""
    left, top, width, height = visitor.corner("#live-scene")
    x, y = round(0.6 * width), round(0.4 * height)
    visitor.value(KEPT)
    visitor.value(f"window.region = {json.dumps([x, y, *claim])}")
    start, end = (left + 40.0, top + height - 90.0), (left + 140.0, top + height - 90.0)
    kept = picture(visitor, start, end)
    colour, opacity = pixels(kept["picture"])

    sxx, sxy, syy, tail = claim
    matrix = np.array([[sxx, sxy], [sxy, syy]])
    half, most = radius(0.5, tail), radius(0.8, tail)
    down, right = np.mgrid[: opacity.shape[0], : opacity.shape[1]] + 0.5
    off = np.stack([right - x, down - y], axis=-1)
    reached = np.sqrt(np.einsum("...i,ij,...j", off, np.linalg.inv(matrix), off))
    to_cursor = np.array([end[0] - left - 1 - x, end[1] - top - 1 - y])
    beside = np.abs(off @ [to_cursor[1], -to_cursor[0]]) / np.hypot(*to_cursor)
    words = (np.abs(off[..., 0] - 44.0) < 34.0) & (np.abs(off[..., 1] + 21.0) < 14.0)  # the time left
    clear = (np.hypot(off[..., 0], off[..., 1]) > 16.0) & (beside > 6.0) & ~words  # of mark and line, too
    near = (np.abs(off[..., 0]) < 260) & (np.abs(off[..., 1]) < 150) & clear
    apart = 3.0 / math.sqrt(np.linalg.eigvalsh(matrix)[0])  # no outline is that broad
    tinted = near & (reached < half - apart)
    between = near & (reached > half + apart) & (reached < most - apart)
    outside = near & (reached > most + apart)
    assert min(tinted.sum(), between.sum()) > 1000
    assert np.abs(opacity[tinted] - FILL).max() < 0.005
    assert np.abs(colour[tinted] - ORANGE).max() < 5.0  # eight bits at so low an opacity
    assert (opacity[between] == 0.0).all()
    assert (opacity[outside] == 0.0).all()
    for edge in (half, most):
        around = near & (np.abs(reached - edge) < apart / 3)
        assert (opacity[around] > 0.3).mean() > 0.3, "an outline"

    lengths = 2.0 * half * np.sqrt(np.linalg.eigvalsh(matrix))[::-1]
    assert [float(px) for px in kept["px"].split()] == pytest.approx(lengths.tolist())
    inner = kept["marks"][0]["inner"]
    assert [2 * inner["major"], 2 * inner["minor"]] == pytest.approx(lengths.tolist())
    rounded = " × ".join(f"{float(f'{length:.2g}'):.0f}" for length in lengths)
    assert set(kept["said"]) <= {rounded, "–"}
    assert not kept["cut"]


def test_a_region_beyond_the_picture_tints_nothing_and_its_number_says_no_more(visitor: Visitor) -> None:
    left, top, width, height = visitor.corner("#live-scene")
    visitor.value(KEPT)
    visitor.value(f"window.region = {json.dumps([width / 2, height / 2, 4e6, 0.0, 4e6, 1.0])}")
    kept = picture(visitor, (left + 40.0, top + 140.0), (left + 140.0, top + 140.0))
    _, opacity = pixels(kept["picture"])
    empty = opacity[200 : visitor.value(TILE)["y"] - 2, 10:90]
    assert (empty == 0.0).all()
    said = [words for words in kept["said"] if words != "–"][-1]  # before, the pointer was elsewhere
    assert said.startswith("over ")
    assert float(said.split()[1]) <= math.hypot(width, height)


SIZES = [3736.0, 6030.0, 876.0, 596.0, 1497.0, 2441.0]
"""Lengths that the page once drew within 0.3 s."""
FOLLOWED = """import("/web/page/drawing/regions.js").then(({ SmoothRegions, regionsOf }) => {
  const smooth = new SmoothRegions();
  const region = (square) => ({ sxx: square, sxy: 0.2 * square, syy: 0.5 * square, tail: 3 });
  const claim = (px) => ({ x: 1, y: 2, region: region(px * px) });
  const at = (px, ms) => smooth.update(claim(px), ms).inner;
  const drawn = SIZES.flatMap((px, i) => [0, 16, 32].map((ms) => at(px, 48 * i + ms)));
  for (let ms = 300; ms <= 1300; ms += 16) smooth.update(claim(100), ms);
  const late = smooth.update(claim(100), 1316);
  return { drawn, late, wanted: regionsOf(claim(100)), none: smooth.update(null, 1320) };
})"""


def test_a_region_glides_and_never_flashes(visitor: Visitor) -> None:
    found = visitor.value(FOLLOWED.replace("SIZES", json.dumps(SIZES)))
    for axis in ("major", "minor"):
        steps = np.diff(np.log([one[axis] for one in found["drawn"]]))
        assert np.abs(steps).max() < 0.1, "a tenth of its size in a frame at most"
        assert np.abs(steps).max() > 0.01, "it follows"
    for level in ("inner", "outer"):
        assert found["late"][level] == pytest.approx(found["wanted"][level], rel=1e-2)
    assert found["none"] is None


def test_a_region_turns_the_short_way(visitor: Visitor) -> None:
    angles = visitor.value(
        """import("/web/page/drawing/regions.js").then(({ SmoothRegions }) => {
          const smooth = new SmoothRegions();
          const claim = (turn) => {
            const [c, s] = [Math.cos(turn), Math.sin(turn)];
            const [sxx, sxy, syy] = [900 * c * c + 100 * s * s, 800 * s * c, 900 * s * s + 100 * c * c];
            return { x: 0, y: 0, region: { sxx, sxy, syy, tail: null } };
          };
          smooth.update(claim(1.5), 0);
          return [16, 32, 48, 64].map((ms) => smooth.update(claim(1.7), ms).inner.angle);
        })"""
    )
    turned = np.mod(angles, math.pi)
    assert ((turned > 1.5) & (turned < 1.7)).all()


GONE = f"{MARKS}[0] === null"


def test_nothing_of_a_prediction_stays_at_rest(visitor: Visitor) -> None:
    left, top, width, _ = visitor.corner("#live-scene")
    visitor.value(KEPT)
    visitor.value(f"window.region = {json.dumps([width / 2, 150, 900, 0, 900, None])}")
    picture(visitor, (left + 40.0, top + 100.0), (left + 140.0, top + 100.0))
    visitor.wait(GONE)
    assert visitor.value("document.querySelector('#live-scene').dataset.shows") == "pointer"
    shown = visitor.value(f"{FRAMES}.then(() => document.querySelector('#live-scene').toDataURL())")
    colour, opacity = pixels(shown)
    marked = (opacity > 0.05) & (np.abs(colour - ORANGE).max(axis=-1) < 20)
    assert not marked.any()
    assert visitor.value(f"{NUMBER}.textContent") == "–"
    assert visitor.value(f"{NUMBER}.dataset.px") == ""


def test_it_fades_within_a_fifth_of_a_second_and_a_resting_pointer_has_none(visitor: Visitor) -> None:
    shown = visitor.value(
        """import("/web/page/live/prediction.js").then(async ({ markOf, opacityAfter }) => {
          const { SmoothRegions } = await import("/web/page/drawing/regions.js");
          const one = (phase) => ({ x: 1, y: 2, phase, region: { sxx: 4, sxy: 0, syy: 4, tail: null } });
          const mark = (phase, ms) => markOf(one(phase), new SmoothRegions(), 0, opacityAfter(ms)) !== null;
          const seen = [["ballistic", 0], ["corrective", 199], ["ballistic", 200], ["still", 0]];
          return [...seen.map(([phase, ms]) => mark(phase, ms)), opacityAfter(100)];
        })"""
    )
    assert shown == [True, True, False, False, 1]


def test_nothing_of_a_prediction_stays_when_the_connection_is_lost(visitor: Visitor) -> None:
    """The socket is closed and the picture looked at while the last answer is still fresh."""
    left, top, width, _ = visitor.corner("#live-scene")
    tile = visitor.value(TILE)["id"]
    visitor.value(
        f"[window.region, window.lit] = [{json.dumps([width / 2, 150, 900, 0, 900, None])}, {tile!r}]"
    )
    visitor.value(
        """{
          const scene = document.querySelector("#live-scene");
          window.lost = null;
          new MutationObserver(() => {
            if (lost !== null || scene.dataset.shows !== "pointer") return; // the demo draws endpoints, too
            if (JSON.parse(scene.dataset.regions)[0]?.opacity !== 1) return;
            sockets.forEach((socket) => { socket.onclose?.(); });
            const look = (done) => done([scene.dataset.regions, scene.toDataURL()]);
            lost = new Promise((done) => requestAnimationFrame(() => setTimeout(() => look(done))));
          }).observe(scene, { attributeFilter: ["data-drawn"] });
        }"""
    )

    def lost() -> bool:
        visitor.reach((left + 40.0, top + 100.0), (left + 140.0, top + 100.0), 0.2)
        return bool(visitor.value("lost !== null"))

    until(lost, "an endpoint to be drawn")
    marks, shown = visitor.value("lost")
    assert json.loads(marks)[0] is None
    colour, opacity = pixels(shown)
    assert not ((opacity > 0.05) & (np.abs(colour - ORANGE).max(axis=-1) < 20)).any(), "no mark, no lit tile"
    visitor.wait(CONNECTED)


def test_the_factors_in_the_document_are_those_of_the_distribution() -> None:
    rows = re.findall(r"^\| (\d+) % \| (\d.+\d) \|$", DOCUMENT.read_text(encoding="utf-8"), re.MULTILINE)
    assert [share for share, _ in rows] == ["50", "80", "95"]
    for share, factors in rows:
        wanted = [radius(float(share) / 100, tail) for tail in (None, 4, 2, 1)]
        assert [float(one) for one in factors.split(" | ")] == pytest.approx(wanted, abs=5e-5)


def test_the_trail_is_drawn_under_the_pointer_and_not_beside_it(visitor: Visitor) -> None:
    """The picture has a border, within which it is drawn; tiles are left out."""
    left, top, *_ = visitor.corner("#live-scene")
    visitor.value(KEPT)
    visitor.value("window.region = [500, 99, 9, 0, 9, null]")  # on one line with the trail
    end = (left + 140.0, top + 100.0)
    _, opacity = pixels(picture(visitor, (end[0] - 100.0, end[1]), end)["picture"])
    drawn = opacity[: visitor.value(TILE)["y"] - 2, 119:159]
    rows, _ = np.nonzero(drawn > 0.95)
    middle = np.average(np.arange(len(drawn)) + 0.5, weights=np.where(drawn > 0.5, drawn, 0.0).sum(axis=1))
    assert middle == pytest.approx(99.0, abs=0.4)
    assert 6 <= rows.max() - rows.min() < 12, "the disc at the end of the trail, and nothing more"


def test_the_mark_of_an_endpoint_is_seen_on_a_tile_of_its_own_colour(visitor: Visitor) -> None:
    left, top, *_ = visitor.corner("#live-scene")
    tile = visitor.value(TILE)
    x, y = round(tile["x"] + tile["width"] / 2), round(tile["y"] + tile["height"] / 2)
    visitor.value(KEPT)
    visitor.value(f"[window.region, window.lit] = [[{x}, {y}, 9, 0, 9, null], {json.dumps(tile['id'])}]")
    kept = picture(visitor, (left + 140.0, top + 100.0), (left + 240.0, top + 100.0))
    colour, opacity = pixels(kept["picture"])
    down, right = np.mgrid[: opacity.shape[0], : opacity.shape[1]] + 0.5
    reach = np.hypot(right - x, down - y)
    below = (down > y + 3.0) & (np.abs(right - x) < 20.0)  # the line to the pointer comes from above
    filled, rim, ring = (below & (reach > a) & (reach < b) for a, b in ((13.5, 17), (11, 11.5), (8.2, 9.8)))
    assert np.abs(colour[filled] - ORANGE).max() < 2.0
    assert np.abs(colour[ring] - ORANGE).max() < 2.0
    assert colour[rim].min() > 225.0
