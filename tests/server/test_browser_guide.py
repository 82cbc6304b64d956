"""The guide's page that asks a service, in a real browser: served as the guide says, its cards light up."""

from __future__ import annotations

import re
import time
from pathlib import Path

import numpy as np
import pytest

from tests.architecture.tree import ROOT
from tests.hosts import file_host
from tests.server import browser
from tests.server.browser import move_at
from tests.server.listener import soon
from tests.server.running import running

pytestmark = browser.needed

USUAL = "http://127.0.0.1:8765"
WATCH = """() => {
  window.lit = [];
  const told = ({ target }) => target.classList.contains("ahead") && lit.push(target.textContent);
  const watch = new MutationObserver((all) => all.forEach(told));
  watch.observe(document.body, { attributes: true, subtree: true });
  return [...document.querySelectorAll(".card")].map((card) => card.getBoundingClientRect().toJSON());
}"""


def blocks(language: str, of: str = "docs/guide/browser.md") -> list[str]:
    """A page's blocks of code in a language."""
    page = (ROOT / of).read_text(encoding="utf-8")
    return re.findall(rf"```{language}\n(.*?)```", page, flags=re.DOTALL)


@pytest.mark.parametrize("goal", [1, 3])
def test_a_card_lights_up_when_the_mouse_is_heading_for_it(tmp_path: Path, goal: int) -> None:
    (page_text,) = blocks("html")
    assert USUAL in page_text
    (tmp_path / "site").mkdir()
    with (
        file_host(tmp_path / "site") as origin,
        running(allow_origin=(origin,)) as service,
        browser.running(tmp_path / "profile") as chromium,
    ):
        (tmp_path / "site/cards.html").write_text(page_text.replace(USUAL, service.url))
        with chromium.tab(f"{origin}/cards.html") as page:
            places = page.evaluate(f"({WATCH})()")
            assert len(places) == 4
            soon(lambda: len(service.service._open) == 1, "the page's session")
            x, y = (places[goal][a] + places[goal][b] / 2 for a, b in (("x", "width"), ("y", "height")))
            s = np.linspace(0.0, 1.0, 60)
            way = 10 * s**3 - 15 * s**4 + 6 * s**5
            began, protocol = time.time(), page.context.new_cdp_session(page)
            for share, step in zip(way.tolist(), s.tolist(), strict=True):
                move_at(protocol, x - 150 * (1 - share), y + 400 * (1 - share), began + step)
            soon(lambda: page.evaluate("lit.length") > 0, "a card lights up")
            names = ("One", "Two", "Three", "Four")
            soon(lambda: names[goal] in page.evaluate("lit"), f"{names[goal]} lights up")


def test_the_command_allows_the_usual_origins() -> None:
    page = (ROOT / "docs/guide/browser.md").read_text(encoding="utf-8")
    command = re.search(r"`(pointpred serve [^`]*--allow-origin[^`]*)`", page)
    assert command is not None
    origins = [f"http://{host}:8000" for host in ("127.0.0.1", "localhost")]
    assert re.findall(r"--allow-origin (\S+)", command[1]) == origins
    assert f"--port {USUAL.rpartition(':')[2]} " in command[1]
