"""Names of Python as names of JavaScript."""

from __future__ import annotations

from collections import Counter
from functools import cache
from pathlib import Path

from translation.source import Name

RESERVED = frozenset(
    (
        *(
            "arguments",
            "await",
            "case",
            "catch",
            "const",
            "debugger",
            "default",
            "delete",
            "do",
            "enum",
            "eval",
        ),
        *(
            "export",
            "extends",
            "function",
            "implements",
            "in",
            "instanceof",
            "interface",
            "let",
            "new",
            "null",
        ),
        *("package", "private", "protected", "public", "static", "super", "switch", "this", "throw", "try"),
        *("typeof", "undefined", "var", "void", "with", "yield"),
    )
)
"""Words that are no names in JavaScript; a name of a law that is one gets an underscore behind."""


def renamed(name: str) -> str:
    """A name of Python as one of JavaScript."""
    return f"{name}_" if name in RESERVED else name


def qualified(name: Name) -> str:
    """A name of another module: the module's last word, or the two last, and the name."""
    return f"{alias(name.module)}.{renamed(name.name)}"


def alias(module: str) -> str:
    """What a module is called where it is imported: its last word, or the two last where others share it."""
    words = module.split(".")
    return "$" + "_".join(words[-1:] if words[-1] not in shared_stems() else words[-2:])


@cache
def shared_stems() -> frozenset[str]:
    """The names that several files of the package have."""
    package = Path(__file__).resolve().parent.parent / "pointpred"
    counts = Counter(path.stem for path in package.rglob("*.py"))
    return frozenset(stem for stem, count in counts.items() if count > 1)


def path_of(name: str) -> str:
    """Where the module in JavaScript lies, relative to the folder of laws."""
    return name.removeprefix("pointpred.").replace(".", "/") + ".js"
