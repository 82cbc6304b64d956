"""Every example a reader can see is run: in docstrings, in the README and in docs/."""

from __future__ import annotations

import ast
import doctest
import importlib
import inspect
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pointpred.client import connect
from tests.architecture.tree import ROOT, module_of, package_files
from tests.server.running import PATIENCE_S

WITH_EXAMPLES = [path for path in package_files() if ">>> " in path.read_text(encoding="utf-8")]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]


@pytest.mark.parametrize("path", WITH_EXAMPLES, ids=module_of)
def test_docstring_examples(path: Path) -> None:
    home = importlib.import_module(module_of(path))
    result = doctest.testmod(home)
    runner = doctest.DocTestRunner()
    for test in examples_of_laws(path, vars(home)):
        runner.run(test)
    assert result.attempted + runner.tries > 0
    assert result.failed + runner.failures == 0


def examples_of_laws(path: Path, values: dict[str, Any]) -> Iterator[doctest.DocTest]:
    """The examples of laws, which ``testmod`` does not see where they are functions in C."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if not isinstance(node, ast.FunctionDef) or not inspect.isbuiltin(values.get(node.name)):
            continue
        text = ast.get_docstring(node) or ""
        yield doctest.DocTestParser().get_doctest(text, dict(values), node.name, str(path), node.lineno)


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_page_examples(page: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # A service on a busy machine may answer later than a client waits.
    defaults = connect.__kwdefaults__
    assert defaults is not None
    monkeypatch.setitem(defaults, "timeout_s", 2 * PATIENCE_S)
    assert doctest.testfile(str(page), module_relative=False).failed == 0
