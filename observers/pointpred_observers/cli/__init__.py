"""``pointpred observers`` and ``pointpred camera``."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable
from io import TextIOWrapper
from pathlib import Path
from typing import Any

import typer

from pointpred.cli.output_files import write_json
from pointpred.cli.reading_options import check_exists
from pointpred.files import whole
from pointpred.records import FloatArray


def option(metavar: str, help: str) -> Any:
    """An option, what stands for its value, and what it does."""
    return typer.Option(metavar=metavar, help=help)


def existing(help: str) -> Any:
    """An argument that names a file, which must exist."""
    return typer.Argument(callback=check_exists, dir_okay=False, help=help)


def answer(json: Path | None, document: Callable[[], Any], show: Callable[[], None]) -> None:
    """Write the document of ``--json`` where it is wanted, and print unless that goes to standard output."""
    if json is not None:
        write_json(document(), json)
    if json is None or str(json) != "-":
        show()


def write_table(target: Path, names: Iterable[str], rows: FloatArray) -> None:
    """A CSV file with a header; what is not there (NaN) is an empty field."""
    with whole(target) as unfinished, TextIOWrapper(unfinished, encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(names)
        writer.writerows([["" if v != v else repr(v) for v in row] for row in rows.tolist()])
