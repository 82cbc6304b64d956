"""The project's own files, and what they import, read without importing them."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
ROOMS = {"server": "pointpred_server", "datasets": "pointpred.datasets"}
"""Top-level folders that are installed inside the package."""


def package_files() -> list[Path]:
    """Every Python file of the installed package, each once, where it lies."""
    inside = [path for path in (ROOT / "pointpred").rglob("*.py") if not _behind_link(path)]
    return sorted(inside + [path for room in ROOMS for path in (ROOT / room).rglob("*.py")])


def own_files() -> list[Path]:
    """Every Python file of the project."""
    others = [path for room in ("tests", "benchmarks", "pages") for path in (ROOT / room).rglob("*.py")]
    return sorted([*package_files(), *others])


def module_of(path: Path) -> str:
    """The dotted name a file is imported by."""
    parts = list(path.relative_to(ROOT).with_suffix("").parts)
    if parts[-1] == "__init__":
        parts.pop()
    return ".".join([ROOMS.get(parts[0], parts[0]), *parts[1:]])


def imports_of(path: Path, *, everywhere: bool = True) -> set[str]:
    """The dotted names a file imports from pointpred; ``from a import b`` is both.

    Not ``everywhere``: only the imports that run when the file itself is imported.
    """
    known = _modules()
    found: set[str] = set()
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for node in ast.walk(tree) if everywhere else tree.body:
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found |= {node.module or ""}
            found |= {f"{node.module}.{alias.name}" for alias in node.names} & known
    return {name for name in found if name == "pointpred" or name.startswith("pointpred.")}


@cache
def _modules() -> frozenset[str]:
    return frozenset(module_of(path) for path in package_files())


def _behind_link(path: Path) -> bool:
    return any(parent.is_symlink() for parent in path.parents)
