"""Measured numbers as JSON, beside the page that shows them: written by what measures, read by what shows."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from evidence import EVIDENCE

Record = TypeVar("Record")
DIGITS = 5
"""Significant digits that are kept of a measured number."""
WIDTH = 110
"""What fits into a line stands in one."""


class Table(msgspec.Struct, frozen=True):
    """A table: numbers where a column holds nothing else, with the decimals that are shown of each column."""

    columns: list[str]
    decimals: list[int | None]
    """``None``: the column holds text."""
    rows: list[list[str | float]]

    @classmethod
    def of(cls, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> Table:
        """A table of formatted cells."""
        decimals = [_decimals([row[i] for row in rows]) for i in range(len(columns))]
        return cls(
            list(columns),
            decimals,
            [[_value(cell, places) for cell, places in zip(row, decimals, strict=True)] for row in rows],
        )

    def texts(self) -> list[list[str]]:
        """The cells as they are shown."""
        return [
            [
                str(cell) if places is None else f"{cell:.{places}f}"
                for cell, places in zip(row, self.decimals, strict=True)
            ]
            for row in self.rows
        ]


class Tables(msgspec.Struct, frozen=True):
    """What most pages are made from: tables by name, and where they were measured."""

    tables: dict[str, Table]
    machine: str = ""
    numbers: dict[str, Any] = {}
    """Single numbers that the text quotes."""


def _value(cell: str, places: int | None) -> str | float:
    return cell if places is None else float(cell) if places else int(cell)


def _decimals(cells: Sequence[str]) -> int | None:
    """How many decimals all cells of a column have; ``None`` where one is no such number."""
    places = {
        len(cell.partition(".")[2]) if re.fullmatch(r"-?(0|[1-9]\d*)(\.\d+)?", cell) else -1 for cell in cells
    }
    return places.pop() if len(places) == 1 and -1 not in places else None


def write(document: object, file: Path) -> None:
    """Write a record, numbers rounded, small objects in one line."""
    plain = _rounded(msgspec.to_builtins(document, str_keys=True, enc_hook=_number))
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(_lines(plain) + "\n", encoding="utf-8")


def _lines(value: Any, indent: str = "") -> str:
    """JSON with a line for each part that fits into one."""
    whole = json.dumps(value, ensure_ascii=False)
    if len(indent) + len(whole) <= WIDTH or not isinstance(value, dict | list):
        return whole
    inner = indent + " "
    if isinstance(value, list):
        parts, ends = [_lines(one, inner) for one in value], "[]"
    else:
        parts, ends = [f"{json.dumps(key)}: {_lines(one, inner)}" for key, one in value.items()], "{}"
    return f"{ends[0]}\n{inner}" + f",\n{inner}".join(parts) + f"\n{indent}{ends[1]}"


def read(file: Path, kind: type[Record]) -> Record:
    """Read a record."""
    return msgspec.json.decode(file.read_bytes(), type=kind, strict=False)


def file_of(page: str, part: str = "") -> Path:
    """Where the numbers of a question stand: ``PAGE/data.json``, or ``PAGE/data/PART.json``."""
    folder = EVIDENCE / page
    return folder / "data" / f"{part}.json" if part else folder / "data.json"


def stored(page: str, part: str = "") -> Tables:
    """The tables of a question, or of one part of it."""
    return read(file_of(page, part), Tables)


def keep(
    page: str,
    tables: Mapping[str, Table],
    *,
    part: str = "",
    file: Path | None = None,
    machine: str = "",
    numbers: Mapping[str, Any] | None = None,
) -> Path:
    """Put tables and numbers into the JSON of a question, or into ``file``; those of other names stay."""
    file = file or file_of(page, part)
    old = read(file, Tables) if file.exists() else Tables({})
    whole = Tables({**old.tables, **tables}, machine or old.machine, {**old.numbers, **(numbers or {})})
    write(whole, file)
    print(f"wrote {file}: {', '.join([*tables, *(numbers or {})])}")
    return file


def _number(value: Any) -> Any:
    """A number of numpy as Python's own."""
    return value.item()


def _rounded(value: Any) -> Any:
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}") if abs(value) < 10**DIGITS else round(value, 1)
    if isinstance(value, Mapping):
        return {key: _rounded(one) for key, one in value.items()}
    return [_rounded(one) for one in value] if isinstance(value, list | tuple) else value
