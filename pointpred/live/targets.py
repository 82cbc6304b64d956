"""The targets of a file, for ``pointpred live --targets``, and which of them a movement is for, in words."""

from __future__ import annotations

import csv
import io
from collections.abc import Hashable, Mapping
from pathlib import Path
from typing import Any

import msgspec

from pointpred.errors import ParameterError
from pointpred.protocol.client_messages import Rectangle
from pointpred.registry import RECOMMENDED, build

EXPECTED = (
    "expected a JSON list of objects with id, x, y, width and height (upper left corner and size, px), and "
    "perhaps weight and kind, or a CSV file with these columns"
)


def read_targets(file: Path) -> tuple[Rectangle, ...]:
    """The rectangles in a JSON or CSV file, as messages of the service have them.

    Raises ParameterError that names the file, the place in it, what is wrong there, and what was expected.
    """
    try:
        text = file.read_text(encoding="utf-8-sig")
        targets = _of_json(text) if text.lstrip()[:1] in ("[", "{") else _of_csv(text)
        if not targets:
            raise ParameterError("it holds no targets")
        build(RECOMMENDED, targets=targets)  # an id that comes twice, or too many
    except (OSError, ValueError, csv.Error) as error:
        reason = error.strerror if isinstance(error, OSError) else error
        message = f"--targets {file}: {reason}; {EXPECTED}"
        raise ParameterError(message, field="targets", value=str(file)) from error
    return targets


def _of_json(text: str) -> tuple[Rectangle, ...]:
    objects = msgspec.json.decode(text, type=list[dict[str, Any]])
    named = [one | {"id": str(one["id"])} if isinstance(one.get("id"), int) else one for one in objects]
    return msgspec.convert(named, tuple[Rectangle, ...])


def _of_csv(text: str) -> tuple[Rectangle, ...]:
    """A target a row; an empty cell is none. Cells are parted by what parts the names of the columns."""
    head = text.partition("\n")[0]
    delimiter = max(",;\t", key=head.count)
    rows = csv.DictReader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
    targets = []
    for row in rows:
        if None in row or None in row.values():
            raise ParameterError(f"line {rows.line_num} has not as many cells as the first line")
        cells = {name.strip(): value.strip() for name, value in row.items() if value.strip()}
        try:
            targets.append(msgspec.convert(cells, Rectangle, strict=False))
        except msgspec.ValidationError as error:
            raise ParameterError(f"line {rows.line_num}: {error}") from error
    return tuple(targets)


def likeliest(shares: Mapping[Hashable, float]) -> str:
    """The likeliest target and its share, from ``Pipeline.shares``.

    >>> likeliest({"save": 0.72, "open": 0.2, None: 0.08})
    'save, 72 %'
    """
    id = max(shares, key=lambda one: shares[one])
    return f"{'none of them' if id is None else id}, {100.0 * shares[id]:.0f} %"
