"""The page at every width, in both themes: nothing is wider than its place, and axe-core finds no fault."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator

import pytest

from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

VIEWS = ("live", "circle", "replay", "assist")
SIZES = (
    (320, 640),
    (390, 844),
    (768, 1024),
    (999, 700),
    (1000, 700),
    (1280, 720),
    (1920, 1080),
    (2560, 1440),
)
AXE = "axe-core@4.14.1"
SELECTS = "document.querySelectorAll('[role=tabpanel]:not([hidden]) select')"
READY = f"[...{SELECTS}].every(({{ disabled }}) => !disabled)"
BEYOND = """[...document.querySelectorAll("header, [role=tabpanel]:not([hidden]), [role=tabpanel] *")]
  .filter((one) => one.checkVisibility() && !one.closest(".scroll, pre, select, svg"))
  .flatMap((one) => {
    const { right } = one.getBoundingClientRect();
    const place = one.closest(".side, .picture, .card") ?? document.documentElement;
    const beyond = right - place.getBoundingClientRect().right;
    return beyond > 0.5 ? [[one.id || one.className || one.localName, beyond]] : [];
  })"""
"""What ends further right than the card, the side or the page that it stands in, px."""
EMPTY = """(() => {
  const bottom = (one) => one.getBoundingClientRect().bottom;
  const stage = document.querySelector("[role=tabpanel]:not([hidden]) .stage");
  return [".picture", ".side"].map((of) => bottom(stage.querySelector(of)));
})()"""


@pytest.fixture
def visitor(one: Visitor) -> Iterator[Visitor]:
    one.prefer()
    yield one
    assert one.complaints() == []
    assert one.shift() < 0.001


@pytest.mark.parametrize("view", VIEWS)
def test_nothing_is_wider_than_its_place(visitor: Visitor, url: str, view: str) -> None:
    visitor.open(f"{url}#{view}")
    visitor.wait(READY)
    for size in SIZES:
        visitor.resize(*size)
        visitor.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        assert visitor.value(BEYOND) == [], size
        fits = "document.documentElement.scrollWidth <= document.documentElement.clientWidth"
        assert visitor.value(fits), size
        if size[0] >= 1000:
            picture, side = visitor.value(EMPTY)
            assert abs(picture - side) < 1.0, "both columns of a view end together"
    visitor.value("shifts.length = 0")  # other sizes have other places


@pytest.fixture(scope="module")
def axe(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The program of axe-core."""
    if shutil.which("npm") is None:
        pytest.skip("no npm on this machine")
    folder = tmp_path_factory.mktemp("axe")
    (folder / "package.json").write_text("{}")
    command = ["npm", "install", "--silent", "--no-audit", "--no-fund", AXE]
    fetched = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)
    if fetched.returncode:
        pytest.skip(f"npm cannot fetch axe-core: {fetched.stderr.strip()[-200:]}")
    return (folder / "node_modules" / "axe-core" / "axe.min.js").read_text(encoding="utf-8")


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("size", [(390, 844), (1280, 720)])
@pytest.mark.parametrize("view", VIEWS)
def test_axe_finds_no_fault(
    visitor: Visitor, url: str, axe: str, view: str, size: tuple[int, int], theme: str
) -> None:
    visitor.resize(*size)
    visitor.prefer(color_scheme="dark" if theme == "dark" else "light", reduced_motion="reduce")
    visitor.open(f"{url}#{view}")
    visitor.wait(READY)
    for part in visitor.page.query_selector_all("details:visible > summary"):
        part.click()
    visitor.page.evaluate(axe)
    found = visitor.value(
        "axe.run(document).then(({ violations }) =>"
        "violations.flatMap(({ id, nodes }) => nodes.map(({ html }) => [id, html.slice(0, 120)])))"
    )
    assert found == []
