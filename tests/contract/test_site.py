"""The site has every page, and works from a folder. What needs the generator is slow: ``make site-check``."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections import Counter
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

from evidence import ROOT
from evidence.site import contents
from tests.hosts import file_host
from tests.server import browser, page_browser
from tests.server.page_browser import Visitor

LOADED_BY_THE_PAGE = {"src", "srcset", "poster"}


def test_every_page_is_listed_once() -> None:
    found = [*(ROOT / "docs").rglob("*.md"), *(ROOT / "observers").glob("docs/*.md"), *ROOT.glob("*.md")]
    listed = Counter(contents.paths())
    assert set(listed) == {page.relative_to(ROOT).as_posix() for page in found} | {contents.OBSERVERS}
    assert listed.most_common(1)[0][1] == 1


def test_the_list_for_language_models_names_pages_that_exist() -> None:
    listed = re.findall(r"^- \[[^\]]+\]\(([^)]+)\)", contents.short_list(""), re.M)
    assert [name for name in listed if not (ROOT / name).is_file()] == []
    assert sorted(listed) == sorted({*contents.paths()} - {"docs/README.md"})
    assert contents.full_text().count("<!-- docs/guide/") == len([*(ROOT / "docs/guide").glob("*.md")])


def test_the_pictures_of_the_front_page_exist_and_are_small() -> None:
    shown = re.findall(r'src(?:set)?="([^"]+)"', (ROOT / contents.FIRST).read_text(encoding="utf-8"))
    assert max((ROOT / name).stat().st_size for name in shown if name.startswith("docs/")) < 600_000


def shown_without_file(folder: Path) -> list[tuple[str, str]]:
    """Pictures that the Markdown of a page in this folder shows and that do not lie there."""
    texts = {path: (folder / path).read_text(encoding="utf-8") for path in contents.paths()}
    shown = {
        path: re.findall(r"!\[.*?\]\((.+?)\)|<(?:img|source).*? src(?:set)?=\"(.+?)\"", text)
        for path, text in texts.items()
    }
    assert sum(map(len, shown.values())) > 30
    links = [(path, link) for path, found in shown.items() for pair in found for link in pair if link]
    return [(path, link) for path, link in links if not ((folder / path).parent / link).is_file()]


def test_the_markdown_for_language_models_has_its_pictures_beside_it(tmp_path: Path) -> None:
    for path in contents.paths():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / path, tmp_path / path)
    assert len(shown_without_file(tmp_path)) > 30
    contents.copy_pictures(tmp_path)
    assert shown_without_file(tmp_path) == []


class Links(HTMLParser):
    """What an HTML file leads to and loads, and the places in it that can be led to."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.leads: list[str] = []
        self.loads: list[str] = []
        self.places = {"", "top"}
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.places.add(value or "")
            elif name in LOADED_BY_THE_PAGE or (tag == "link" and name == "href"):
                self.loads.append(value or "")
            elif name == "href":
                self.leads.append(value or "")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site, as its command builds it: with warnings as errors."""
    folder = tmp_path_factory.mktemp("site")
    subprocess.run(["make", "site", f"FOLDER={folder}"], cwd=ROOT, check=True)
    return folder


@pytest.fixture(scope="module")
def visitor(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    with page_browser.visitor(tmp_path_factory.mktemp("profile")) as one:
        yield one


@pytest.mark.slow
def test_every_link_of_the_site_leads_somewhere(site: Path) -> None:
    pages = {file: Links(file) for file in site.rglob("*.html") if not file.is_relative_to(site / "demo")}
    assert {site / name for name in ("index.html", "docs/guide/in-page.html")} < set(pages)
    wrong = []
    for file, links in pages.items():
        for link in (*links.leads, *links.loads):
            address = urlsplit(link)
            if address.scheme in ("http", "https", "mailto") and link in links.leads:
                continue
            goal = (file.parent / unquote(address.path)).resolve() if address.path else file
            there = goal.is_file() and not address.scheme and not address.path.startswith("/")
            if not there or (goal in pages and unquote(address.fragment) not in pages[goal].places):
                wrong.append((file.relative_to(site).as_posix(), link))
    assert wrong == []
    assert shown_without_file(site / "_sources") == []


@pytest.mark.slow
@browser.needed
def test_from_a_folder_pages_ask_for_nothing_elsewhere_and_can_be_searched(
    site: Path, visitor: Visitor
) -> None:
    for page in contents.paths():
        visitor.open(f"{site.as_uri()}/{page.removesuffix('.md')}.html")
        visitor.wait("document.readyState === 'complete'")
        assert visitor.complaints() == [], page
        assert [one for one in visitor.asked() if not one.startswith(f"{site.as_uri()}/")] == [], page
    visitor.open(f"{site.as_uri()}/index.html")
    visitor.page.fill("input[name=q]", "ellipse")
    with visitor.page.expect_navigation():
        visitor.press("Enter")
    visitor.wait("document.querySelectorAll('#search-results li a').length > 5")
    assert visitor.complaints() == []


@pytest.mark.slow
@browser.needed
def test_on_a_static_host_the_front_page_leads_to_the_live_page(site: Path, visitor: Visitor) -> None:
    with file_host(site) as origin:
        visitor.open(f"{origin}/index.html")
        with visitor.page.expect_navigation():
            visitor.page.click("text=Move your mouse over the live page.")
        visitor.wait("document.querySelector('#live-card-0 .connection')?.dataset.state === 'open'")
        assert visitor.complaints() == []
        assert [one for one in visitor.asked() if not one.startswith(origin)] == []
