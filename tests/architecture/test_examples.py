"""Every example a reader can see is run: in docstrings, in the README and in docs/."""

from __future__ import annotations

import doctest
import importlib
from pathlib import Path

import pytest

from pointpred.client import connect
from tests.architecture.tree import ROOT, module_of, package_files
from tests.server.running import PATIENCE_S

WITH_EXAMPLES = [path for path in package_files() if ">>> " in path.read_text(encoding="utf-8")]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]


@pytest.mark.parametrize("path", WITH_EXAMPLES, ids=module_of)
def test_docstring_examples(path: Path) -> None:
    result = doctest.testmod(importlib.import_module(module_of(path)))
    assert result.attempted > 0
    assert result.failed == 0


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_page_examples(page: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # A service on a busy machine may answer later than a client waits.
    defaults = connect.__kwdefaults__
    assert defaults is not None
    monkeypatch.setitem(defaults, "timeout_s", 2 * PATIENCE_S)
    assert doctest.testfile(str(page), module_relative=False).failed == 0
