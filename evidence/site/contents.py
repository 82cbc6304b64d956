"""The pages of the site, in their order, as docs/README.md lists them: also what llms.txt is made from."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import NamedTuple

from evidence import DOCS, ROOT

FIRST = "README.md"
"""The front page."""
OBSERVERS = "observers/README.md"
"""Followed by every page of observers/docs, which it lists by itself."""
NOT_FOR_READING = "Evidence", "The project"
"""Sections that llms-full.txt leaves out."""


PICTURE = re.compile(r'!\[[^\]]*\]\(([^)#]+)\)|<(?:img|source)\b[^>]*? src(?:set)?="([^"]+)"')
"""What a page shows, in Markdown or HTML."""


class Page(NamedTuple):
    """A page, by its path from the root of the project."""

    path: str
    about: str
    """What it is for."""

    def text(self) -> str:
        """Its Markdown."""
        return (ROOT / self.path).read_text(encoding="utf-8")

    def title(self) -> str:
        """Its first heading."""
        return self.text().partition("\n")[0].removeprefix("# ")

    def pictures(self) -> list[Path]:
        """The files that it shows, by their paths from the root of the project."""
        links = [link for found in PICTURE.findall(self.text()) for link in found if link and ":" not in link]
        beside = (ROOT / self.path).parent
        return [(beside / link).resolve().relative_to(ROOT) for link in links]


def sections() -> dict[str, list[Page]]:
    """The pages of each section of docs/README.md, without files that are no Markdown."""
    found: dict[str, list[Page]] = {}
    for section in re.split(r"^## ", (DOCS / "README.md").read_text(encoding="utf-8"), flags=re.M)[1:]:
        title, _, body = section.partition("\n")
        pages = found[title] = []
        for about, cell in re.findall(r"^\| ([^|]+) \| ([^|]+) \|$", body, re.M):
            links = re.findall(r"\]\(([^)#:]+\.md)\)", cell)
            paths = [(DOCS / link).resolve().relative_to(ROOT).as_posix() for link in links]
            pages += [Page(path, about) for path in paths]
            if OBSERVERS in paths:
                pages += [Page(path, "") for path in others_of(OBSERVERS)]
    return found


def others_of(readme: str) -> list[str]:
    """The pages in the folder ``docs`` beside a README, its own list first, examples by their numbers."""
    folder = (ROOT / readme).parent / "docs"
    names = sorted(folder.glob("*.md"), key=lambda page: (page.stem != "README", numbered(page)))
    return [page.relative_to(ROOT).as_posix() for page in names]


def numbered(page: Path) -> tuple[str, int]:
    """A key by which ``example-10`` comes after ``example-9``."""
    name, number = re.fullmatch(r"(.*?)-?(\d*)", page.stem).groups()
    return name, int(number or 0)


def paths() -> list[str]:
    """Every page of the site."""
    return [FIRST, "docs/README.md", *(page.path for pages in sections().values() for page in pages)]


def copy_pictures(folder: Path) -> None:
    """Copy what the pages show to where their Markdown, copied into ``folder``, looks for it."""
    for picture in {picture for path in paths() for picture in Page(path, "").pictures()}:
        (folder / picture).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / picture, folder / picture)


def short_list(sources: str) -> str:
    """llms.txt: what the project is, and every page; their Markdown lies below ``sources``."""
    first = Page(FIRST, "what it is, three ways in, and how good it is")
    sentence = first.text().split("\n")[2]
    lines = [f"# {first.title()}", "", f"> {sentence}", "", line(first, sources)]
    for title, pages in sections().items():
        lines += ["", f"## {title}", "", *(line(page, sources) for page in pages)]
    return "\n".join(lines) + "\n"


def line(page: Page, sources: str) -> str:
    """A page in llms.txt."""
    return f"- [{page.title()}]({sources}{page.path})" + (f": {page.about}" if page.about else "")


def full_text() -> str:
    """llms-full.txt: the README, guides and reference as one text."""
    read = [page for title, pages in sections().items() if title not in NOT_FOR_READING for page in pages]
    return "\n\n".join(f"<!-- {one.path} -->\n\n{one.text()}" for one in [Page(FIRST, ""), *read])
