"""A law calls only laws that stand above it or are imported: it is read from top to bottom."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.architecture.test_files import compiled_functions
from tests.architecture.tree import module_of, package_files

WITH_LAWS = [path for path in package_files() if compiled_functions(path)]


@pytest.mark.parametrize("path", WITH_LAWS, ids=module_of)
def test_laws_stand_below_those_they_call(path: Path) -> None:
    laws = compiled_functions(path)
    for name, function in laws.items():
        called = {
            node.func.id
            for node in ast.walk(function)
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
        }
        later = {other for other in called & laws.keys() - {name} if laws[other].lineno > function.lineno}
        assert not later, f"{name} calls {', '.join(sorted(later))} before it is defined"
