"""The pages of observers/docs are run, their links lead somewhere, and each can be reached."""

from __future__ import annotations

import doctest
import re
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[1] / "docs"
PAGES = [FOLDER.parent / "README.md", *sorted(FOLDER.glob("*.md"))]
FIGURES = {
    "example-1.md": ["3.3"],
    "example-2.md": ["3.4", "3.5"],
    "example-3.md": ["3.6"],
    "example-4.md": ["3.7"],
    "example-5.md": ["3.8"],
    "example-6.md": ["3.9"],
    "example-7.md": ["3.10", "3.11"],
    "example-8.md": ["4.2"],
    "example-9.md": ["4.4"],
}
"""The figures of the thesis that each page draws again."""


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_page_examples(page: Path) -> None:
    assert doctest.testfile(str(page), module_relative=False).failed == 0


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_links_lead_somewhere(page: Path) -> None:
    for link in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
        assert (page.parent / link).exists(), f"{page.name} links to {link}"


@pytest.mark.parametrize("name", FIGURES)
def test_a_page_shows_its_figures_and_their_command(name: str) -> None:
    page = (FOLDER / name).read_text(encoding="utf-8")
    for number in FIGURES[name]:
        assert f"figures/reproduced/thesis-{number}.svg" in page
    assert f"`pointpred reproduce {FIGURES[name][0]}" in page


def test_every_page_can_be_reached_from_the_index() -> None:
    index = (FOLDER.parent / "README.md").read_text(encoding="utf-8")
    assert {page.name for page in PAGES if f"](docs/{page.name})" not in index} == {"README.md"}
