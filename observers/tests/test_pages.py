"""Pages of observers/docs are run and reached; the version is the library's, the names of before load."""

from __future__ import annotations

import doctest
import re
from importlib import import_module
from pathlib import Path

import pytest

from pointpred import extras
from pointpred.errors import MissingExtraError

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


@pytest.mark.parametrize(
    ("old", "new", "name"),
    [
        ("pointpred.observers", "pointpred_observers", "Persidskii"),
        ("pointpred.observers.examples", "pointpred_observers.examples", "two_masses"),
        ("pointpred.camera", "pointpred_observers.camera", "DepthObserver"),
    ],
)
def test_the_names_of_version_0_1_load_with_a_warning(old: str, new: str, name: str) -> None:
    with pytest.warns(DeprecationWarning, match=f"is {new.removesuffix('.examples')} now"):
        exec(f"from {old} import {name}", found := {})
    assert found[name].__qualname__ == getattr(import_module(new), name).__qualname__


@pytest.mark.parametrize("old", ["observers", "camera"])
def test_without_the_distribution_the_old_name_says_what_to_install(
    old: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pointpred.extras.find_spec", lambda name: None)
    with pytest.raises(MissingExtraError) as refused:
        exec(f"from pointpred.{old} import simulate")
    assert str(refused.value).endswith(extras.install_command(of="pointpred-observers"))
