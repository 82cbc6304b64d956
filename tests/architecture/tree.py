"""The project's own files, and what they import, read without importing them."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGES = {"pointpred": ROOT, "pointpred_server": ROOT / "server", "pointpred_observers": ROOT / "observers"}
"""The package of each distribution, and the folder of the distribution."""


def package_files() -> list[Path]:
    """Every Python file of the installed packages."""
    return sorted(path for name, folder in PACKAGES.items() for path in (folder / name).rglob("*.py"))


def own_files() -> list[Path]:
    """Every Python file of the project."""
    rooms = ("tests", "observers/tests", "evidence")
    others = [path for room in rooms for path in (ROOT / room).rglob("*.py")]
    return sorted([*package_files(), *others])


def module_of(path: Path) -> str:
    """The dotted name a file is imported by."""
    parts = list(path.relative_to(ROOT).with_suffix("").parts)
    if parts[-1] == "__init__":
        parts.pop()
    return ".".join(parts[next((k for k, part in enumerate(parts) if part in PACKAGES), 0) :])


def imports_of(path: Path, *, everywhere: bool = True) -> set[str]:
    """The dotted names a file imports from our packages; ``from a import b`` is both.

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
    return {name for name in found if name.partition(".")[0] in PACKAGES}


@cache
def _modules() -> frozenset[str]:
    return frozenset(module_of(path) for path in package_files())
