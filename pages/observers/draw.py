"""Draw the figures of docs/guide/observers.

``python -m pages.observers.draw [example-1 example-2 ...]``: all of them unless some are named.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

from pages import DOCS
from pages.arguments import parse

FIGURES = DOCS / "guide" / "observers" / "figures"
PARTS = ("examples_1_4", "examples_5_7", "examples_8_9")
"""Modules with ``FIGURES``, functions by the name of a figure, or with a ``main`` that draws its own."""


def figures() -> dict[str, Callable[[Path], None]]:
    """Every figure's name with the function that draws it into a file."""
    writers: dict[str, Callable[[Path], None]] = {}
    for part in PARTS:
        if find_spec(f"pages.observers.{part}"):
            module = import_module(f"pages.observers.{part}")
            writers |= (
                module.FIGURES
                if hasattr(module, "FIGURES")
                else {part: lambda file, whole=module.main: whole()}
            )
    return writers


def main(names: list[str]) -> None:
    writers = figures()
    for name in names or writers:
        file = FIGURES / f"{name}.svg"
        writers[name](file)
        print(f"drew {name}")


if __name__ == "__main__":
    main(parse(__doc__, metavar="figure"))
