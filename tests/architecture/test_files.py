"""Files hold one idea, names say something, and each law stands beside its own loop."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.architecture.tree import ROOT, module_of, own_files, package_files

LINES_MOST = 400
LOOP_LINES_MOST = 20
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


STAGE_ROOMS = ("pointpred.differentiators", "pointpred.predictors")
LAWS = [
    path
    for path in package_files()
    if module_of(path).startswith(STAGE_ROOMS) and {"step", "loop"} & compiled_functions(path).keys()
]


def test_laws_are_found() -> None:
    assert "pointpred.predictors.hold" in {module_of(path) for path in LAWS}


@pytest.mark.parametrize("path", LAWS, ids=module_of)
def test_law_has_one_step_and_a_short_loop_around_it(path: Path) -> None:
    laws = compiled_functions(path)
    assert {"step", "loop"} <= laws.keys()
    loop = laws["loop"]
    called = {
        node.func.id
        for node in ast.walk(loop)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    }
    assert "step" in called, "the loop must call the same step"
    assert loop.end_lineno is not None
    assert loop.end_lineno - loop.lineno < LOOP_LINES_MOST, "a loop holds no law of its own"
