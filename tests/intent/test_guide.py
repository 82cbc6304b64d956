"""The guide for people who build pages: its first page works as printed, its examples name what exists."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.architecture.test_web import exports
from tests.hosts import file_host
from tests.intent.conftest import LIB
from tests.intent.npm import pack
from tests.server import browser
from tests.server.page_browser import Visitor

ROOT = Path(__file__).parents[2]
GUIDE = (ROOT / "docs" / "guide" / "in-page.md").read_text("utf-8")
README = (ROOT / "README.md").read_text("utf-8")
PACKAGE = json.loads((LIB / "package.json").read_text("utf-8"))
LIT = "document.querySelector('.card.next')?.textContent ?? ''"


def blocks(language: str, text: str = GUIDE) -> list[str]:
    """The examples of a language, without the indentation of a list."""
    found = re.findall(rf"^( *)```{language}\n(.*?)^ *```$", text, re.MULTILINE | re.DOTALL)
    return ["".join(line.removeprefix(indent) for line in block.splitlines(True)) for indent, block in found]


@pytest.fixture
def address(tmp_path: Path) -> Iterator[str]:
    """The folder that the first steps of the guide make, on a static host."""
    folder = tmp_path / "my-page"
    folder.mkdir()
    (tmp_path / "dist").mkdir()
    shutil.copy(pack(tmp_path), tmp_path / "dist")
    packing, _, taking = blocks("sh")[0].splitlines()
    assert packing == "make package"
    subprocess.run(["sh", "-c", taking], cwd=tmp_path, check=True)
    (folder / "cards.html").write_text(blocks("html")[0], "utf-8")
    with file_host(folder) as origin:
        yield f"{origin}/cards.html"


@browser.needed
def test_cards_light_up_before_the_pointer_is_there(visitor: Visitor, address: str) -> None:
    visitor.open(address)
    visitor.wait("document.querySelectorAll('.card').length === 4")
    visitor.value("""window.lit = []; new MutationObserver((changes) => {
      for (const { target } of changes) if (target.classList.contains("next"))
        lit.push([target.textContent, target.matches(":hover")]);
    }).observe(document.body, { subtree: true, attributeFilter: ["class"] })""")
    box = visitor.value(
        "(({ x, y, width, height }) => [x + width / 2, y + height / 2])"
        "(document.querySelectorAll('.card')[2].getBoundingClientRect())"
    )
    for _ in range(3):
        visitor.reach((60.0, 600.0), (box[0], box[1]), 0.6)
        visitor.wait(f"{LIT} === 'Three'")
        visitor.reach((box[0], box[1]), (60.0, 600.0), 0.6)
    lit = visitor.value("lit")
    assert ["Three", False] in lit, lit


def test_what_the_examples_import_exists() -> None:
    for text in [*blocks("js"), *blocks("jsx"), *blocks("html")]:
        for names, address in re.findall(r'import \{([^}]*)\} from "([^"]+)"', text):
            entry = address.replace("pointpred", ".", 1)
            module = (LIB / PACKAGE["exports"][entry]["default"]).read_text("utf-8")
            for name in (one.strip() for one in names.split(",")):
                assert name in exports(module), f"{address} has no {name}"


def test_the_readme_shows_the_same_page_and_commands() -> None:
    assert blocks("html", README)[0] == blocks("html")[0]
    for command in blocks("sh"):
        assert command in README
