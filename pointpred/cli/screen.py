"""Where the command line writes: results to stdout, everything else to stderr."""

from __future__ import annotations

import sys
from pathlib import Path

import msgspec
from rich.console import Console

from pointpred.errors import ParameterError

WIDE = 160
"""Columns of a table that goes to a file or a pipe, where no terminal says how wide it is."""


def results() -> Console:
    """The console for results; plain and wide when it is not a terminal."""
    return Console(width=None if sys.stdout.isatty() else WIDE, highlight=False)


def remarks() -> Console:
    """The console for progress, remarks and complaints."""
    return Console(stderr=True, highlight=False, soft_wrap=True)


def counted(number: int, noun: str) -> str:
    """A number with its noun.

    >>> counted(1, "trial"), counted(2, "trial")
    ('1 trial', '2 trials')
    """
    return f"{number} {noun}" + "s" * (number != 1)


def write_json(value: object, target: Path) -> None:
    """Write JSON to a file, or to stdout for ``-``."""
    text = msgspec.json.format(msgspec.json.encode(value), indent=2).decode()
    if str(target) == "-":
        print(text)
    else:
        target.write_text(text + "\n", encoding="utf-8")


def check_target(target: Path | None) -> None:
    """Raise ParameterError now where a file could not be written later."""
    if target is None or str(target) == "-":
        return
    if target.is_dir() or not target.parent.is_dir():
        raise ParameterError(
            f"cannot write {target}: its folder must exist and it must not be a folder itself"
        )
