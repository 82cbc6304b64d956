"""Files hold one idea, names say something, and nobody writes the loop around a law."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.architecture.tree import ROOT, module_of, own_files, package_files

LINES_MOST = 600
EMPTY_WORDS = {"utils", "util", "common", "base", "core", "helpers", "helper", "manager", "misc"}


@pytest.mark.parametrize("path", own_files(), ids=lambda path: str(path.relative_to(ROOT)))
def test_file_is_short_and_named_for_what_it_holds(path: Path) -> None:
    assert len(path.read_text(encoding="utf-8").splitlines()) <= LINES_MOST
    words = {word for part in path.relative_to(ROOT).with_suffix("").parts for word in part.split("_")}
    assert not words & EMPTY_WORDS


@pytest.mark.parametrize("path", package_files(), ids=module_of)
def test_module_says_what_it_is(path: Path) -> None:
    assert ast.get_docstring(ast.parse(path.read_text(encoding="utf-8")))


def compiled_functions(path: Path) -> dict[str, ast.FunctionDef]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return {
        node.name: node
        for node in tree.body
        if isinstance(node, ast.FunctionDef)
        and any(isinstance(mark, ast.Name) and mark.id == "law" for mark in node.decorator_list)
    }


@pytest.mark.parametrize("path", package_files(), ids=module_of)
def test_loops_are_made_of_steps_and_not_written(path: Path) -> None:
    assert "loop" not in compiled_functions(path)
