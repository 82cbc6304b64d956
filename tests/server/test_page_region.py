"""The region of a prediction as the page draws it, held against the distances of a normal distribution.

No predictor of today claims a region, so the answers are given theirs on their way into the page.
"""

from __future__ import annotations

import base64
import io
import json
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2, f

from tests.server import browser, page_browser
from tests.server.page_browser import Visitor, until

pytestmark = browser.needed

DOCUMENT = Path(__file__).parents[2] / "docs" / "page.md"
WRITTEN = """
window.region = window.lit = null;
const Plain = WebSocket;
window.WebSocket = class extends Plain {
  set onmessage(listen) {
    super.onmessage = (event) => {
      const message = region === null ? {} : JSON.parse(event.data);
      if (message.type !== "prediction") return listen(event);
      const [x, y, sxx, sxy, syy] = region;
      const targets = lit === null ? [] : [{ id: lit, p: 1 }];
      const data = JSON.stringify({ ...message, x, y, region: { sxx, sxy, syy, tail: null }, targets });
      listen(new MessageEvent("message", { data }));
    };
  }
};
"""
"""Writes x, y, sxx, sxy, syy into every prediction once a region is set, and which tile is sure."""
ORANGE = np.array([194, 65, 12])
"""The first predictor's colour, in the light theme."""
CONNECTED = "document.querySelector('#live-card-0 .connection').dataset.state === 'open'"
ROUND, ALONG, ACROSS = (900.0, 0.0, 900.0), (2500.0, 1300.0, 1600.0), (400.0, -300.0, 2500.0)


@pytest.fixture(scope="module")
def one(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    with page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        opened.page.call("Page.addScriptToEvaluateOnNewDocument", source=WRITTEN)
        opened.prefer(prefers_color_scheme="light")
        yield opened


@pytest.fixture
def visitor(one: Visitor, url: str) -> Iterator[Visitor]:
    """Somebody at a live view that is connected."""
    one.open(f"{url}#live")
    one.wait(CONNECTED)
    yield one
    assert one.complaints() == []
    assert one.shift() < 0.001


TILE = """import("/web/live-tiles.js").then(({ row }) => {
  const { clientWidth, clientHeight } = document.querySelector("#live-scene");
  return row(clientWidth, clientHeight)[3];
})"""
KEPT = """{
  const canvas = document.querySelector("#live-scene");
  const region = document.querySelector("#live-card-0 [data-of=region]");
  window.kept = { picture: null, said: [], cut: false };
  new MutationObserver(([{ oldValue }]) => {
    if (canvas.dataset.drawn !== oldValue) kept.picture = canvas.toDataURL();
  }).observe(canvas, { attributeFilter: ["data-drawn"], attributeOldValue: true });
  new MutationObserver(() => {
    kept.said.push(region.textContent);
    kept.cut ||= region.scrollWidth > region.clientWidth;
  }).observe(region, { childList: true });
}"""
"""Keeps the last picture with an endpoint in it, and the words on its region: both soon go."""


FRAMES = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"


def picture(
    visitor: Visitor, start: tuple[float, float], end: tuple[float, float], *also: str
) -> tuple[np.ndarray, np.ndarray]:
    """The pixels of what is drawn with an endpoint once the pointer is at an end.

    A busy machine may draw nothing before the endpoint has gone: then the pointer moves once more.
    """
    there = " && ".join(("kept.picture !== null", *also))

    def drawn() -> str | None:
        visitor.reach(start, end, 0.2)
        visitor.value("kept.picture = null")  # on the way the pointer was elsewhere
        address: str | None = visitor.value(f"{FRAMES}.then(() => {there} ? kept.picture : null)")
        return address

    return pixels(until(drawn, there))


def pixels(address: str) -> tuple[np.ndarray, np.ndarray]:
    """Colours from 0 to 255 and opacities from 0 to 1 in a picture given as an address with its data."""
    from matplotlib.image import imread

    picture = imread(io.BytesIO(base64.b64decode(address.partition(",")[2])))
    return picture[..., :3] * 255, picture[..., 3]


@pytest.mark.parametrize("covariance", [ROUND, ALONG, ACROSS])
def test_the_region_is_tinted_where_95_per_cent_of_endpoints_lie(
    visitor: Visitor, covariance: tuple[float, float, float]
) -> None:
    """Every pixel by its Mahalanobis distance, whose square has a chi-squared distribution of two degrees."""
    left, top, width, height = visitor.corner("#live-scene")
    x, y = round(0.6 * width), round(0.45 * height)
    visitor.value(KEPT)
    visitor.value(f"window.region = {json.dumps([x, y, *covariance])}")
    start, end = (left + 40.0, top + height - 40.0), (left + 140.0, top + height - 40.0)
    colour, opacity = picture(visitor, start, end, "kept.said.some((words) => /[0-9]/.test(words))")

    sxx, sxy, syy = covariance
    matrix = np.array([[sxx, sxy], [sxy, syy]])
    down, right = np.mgrid[: opacity.shape[0], : opacity.shape[1]] + 0.5
    off = np.stack([right - x, down - y], axis=-1)
    radius = np.sqrt(np.einsum("...i,ij,...j", off, np.linalg.inv(matrix), off))
    edge = np.sqrt(chi2.ppf(0.95, 2))
    to_cursor = np.array([end[0] - left - 1 - x, end[1] - top - 1 - y])
    beside = np.abs(off @ [to_cursor[1], -to_cursor[0]]) / np.hypot(*to_cursor)
    clear = (np.hypot(off[..., 0], off[..., 1]) > 16.0) & (beside > 5.0)  # of the mark, and of the line to it
    near = (np.abs(off[..., 0]) < 200) & (np.abs(off[..., 1]) < 160) & clear
    inside, outside = near & (radius < 0.95 * edge), near & (radius > 1.05 * edge)
    assert inside.sum() > 5000
    assert np.abs(opacity[inside] - 0.12).max() < 0.005
    assert np.abs(colour[inside] - ORANGE).max() < 5.0  # eight bits at so low an opacity
    assert (opacity[outside] == 0.0).all()
    around = near & (np.abs(radius / edge - 1.0) < 0.02)
    outline = near & (opacity > 0.7)
    assert (outline & around).sum() > 0.1 * around.sum()
    assert not (outline & ~around).any()
    assert np.abs(colour[outline] - ORANGE).max() < 5.0

    breadth, length = 2.0 * edge * np.sqrt(np.linalg.eigvalsh(matrix))
    assert set(visitor.value("kept.said")) <= {f"{length:.0f} × {breadth:.0f} px", "–"}
    assert not visitor.value("kept.cut")


def test_the_factors_in_the_document_are_those_of_the_distribution() -> None:
    rows = re.findall(r"^\| (\d+) % \| (\d.+\d) \|$", DOCUMENT.read_text(encoding="utf-8"), re.MULTILINE)
    assert [share for share, _ in rows] == ["50", "80", "95"]
    for share, factors in rows:
        level = float(share) / 100
        wanted = [chi2.ppf(level, 2), *(2.0 * f.ppf(level, 2, tail) for tail in (4, 2, 1))]
        assert [float(one) for one in factors.split(" | ")] == pytest.approx(np.sqrt(wanted), abs=5e-5)


def test_the_trail_is_drawn_under_the_pointer_and_not_beside_it(visitor: Visitor) -> None:
    """The picture has a border, within which it is drawn; tiles are left out."""
    left, top, *_ = visitor.corner("#live-scene")
    visitor.value(KEPT)
    visitor.value("window.region = [500, 99, 9, 0, 9]")  # on one line with the trail
    end = (left + 140.0, top + 100.0)
    _, opacity = picture(visitor, (end[0] - 100.0, end[1]), end)
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
    visitor.value(f"[window.region, window.lit] = [[{x}, {y}, 9, 0, 9], {json.dumps(tile['id'])}]")
    colour, opacity = picture(visitor, (left + 140.0, top + 100.0), (left + 240.0, top + 100.0))
    down, right = np.mgrid[: opacity.shape[0], : opacity.shape[1]] + 0.5
    reach = np.hypot(right - x, down - y)
    below = (down > y + 3.0) & (np.abs(right - x) < 20.0)  # the line to the pointer comes from above
    filled, rim, ring = (below & (reach > a) & (reach < b) for a, b in ((13.5, 17), (11, 11.5), (8.2, 9.8)))
    assert np.abs(colour[filled] - ORANGE).max() < 2.0
    assert np.abs(colour[ring] - ORANGE).max() < 2.0
    assert colour[rim].min() > 225.0
