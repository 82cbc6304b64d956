"""``pointpred observers`` and ``pointpred camera``."""

from __future__ import annotations

from typing import Any

import typer

from pointpred.cli.reading_options import check_exists


def option(metavar: str, help: str) -> Any:
    """An option, what stands for its value, and what it does."""
    return typer.Option(metavar=metavar, help=help)


def existing(help: str) -> Any:
    """An argument that names a file, which must exist."""
    return typer.Argument(callback=check_exists, dir_okay=False, help=help)
