"""Any delimited text as a table: separator, decimal commas, comments and header are detected."""

from __future__ import annotations

import io
import re
from pathlib import Path
from typing import Any

import msgspec
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.errors import RecordingError
from pointpred.recording import Skip
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.encodings import UTF_8, open_utf8
from pointpred.recordings.formats.delimited import MOST_COLUMNS, Layout, is_row, layout_of, plain_numbers
from pointpred.recordings.reading import AS_IS, Reading, row_name

TITLE = "a table of samples (delimited text)"
HEAD = 1 << 16
COMMENT = re.compile(rb"^[ \t]*#[^\r\n]*(\r\n|\n|\r|$)", re.MULTILINE)
LINE = re.compile(rb"\r\n|\n|\r")
MOST_ODD = 0.2
"""With a larger share of rows with another number of cells the text is not a table."""
MOST_NAMED = 20
"""Most rows named one by one among the skips; the rest is counted."""


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a delimited table with numbers in it."""
    return b"\0" not in head and _layout(head) is not None


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """The cells of a delimited text as text; numbers have a decimal point.

    The text has no header if its first row has numbers above numbers: columns are then named ``0``, ``1`` and
    so on. A row with another number of cells is a skip; if many rows have the same number of additional
    cells, the others are padded with empty ones. Memory: the text, and its cells once more. Raises
    RecordingError.
    """
    with open_utf8(path) as (file, _):
        text = file.read().removeprefix(UTF_8)
    layout = _layout(text[:HEAD])
    if layout is None:
        raise RecordingError(f"{path}: no table: no separator gives rows of one length with numbers")
    if layout.width > MOST_COLUMNS:
        raise RecordingError(f"{path}: more than {MOST_COLUMNS} columns, which is the most that are read")
    body, comments = _body(text, layout)
    if not body.strip():
        raise RecordingError(f"{path}: no rows below the header {', '.join(layout.columns)}")
    table, odd = _rows(path, body, layout)
    total = table.num_rows + len(odd)
    filled = []
    if len(odd) > MOST_ODD * total and (wider := _wider(body, layout, odd)) is not None:
        filled = [
            f"rows of {layout.width} cells filled up to {wider.width} with empty ones: {table.num_rows}"
        ]
        layout, body = wider, _pad(body, wider)
        table, odd = _rows(path, body, layout)
    if len(odd) > MOST_ODD * total:
        row, cells = next(iter(odd.items()))
        raise RecordingError(
            f"{path}: {len(odd)} of {total} rows have another number of cells: {row_name(row)} has {cells}, "
            f"expected {layout.width}"
        )
    for column in table.columns:
        _check_quotes(path, column, layout)
    marks = plain_numbers(dict(zip(layout.columns, table.columns, strict=True)), layout.separator)
    notes = [] if layout.names is not None else ["no header: columns are named by their place from 0"]
    notes += [f"lines above the table left aside: {layout.above}"] if layout.above else []
    notes += [f"comment lines between the rows left out: {comments}"] if comments else []
    notes += filled + marks.notes
    row_of = arrow_tables.rows_without(total, odd) if odd else None
    return ColumnTable(
        marks.columns, "delimited text", tuple(notes), _skips(odd, layout.width), row_of, marks.unsure
    )


def _layout(head: bytes) -> Layout | None:
    """The layout by the first lines; an incomplete line at the end of ``head`` does not count."""
    text = head.removeprefix(UTF_8).decode("utf-8", "replace")
    if len(head) >= HEAD - 4 and "\n" in text.rstrip("\n"):
        text = text[: text.rindex("\n")]
    return layout_of(text)


def _body(text: bytes, layout: Layout) -> tuple[bytes, int]:
    """The rows alone, with one blank between cells if blanks separate them; the number of comments."""
    place = 0
    for _ in range(layout.first):
        match = LINE.search(text, place)
        place = len(text) if match is None else match.end()
    body = text[place:]
    comments = 0

    def keep_rows(match: re.Match[bytes]) -> bytes:
        nonlocal comments
        if is_row(match[0].decode("utf-8", "replace"), layout.separator, layout.width):
            return match[0]
        comments += 1
        return b""

    if b"#" in body:
        body = COMMENT.sub(keep_rows, body)
    if layout.separator == " ":
        body = re.sub(rb"^[ \t]+|[ \t]+$", b"", re.sub(rb"[ \t]+", b" ", body), flags=re.MULTILINE)
        body = re.sub(rb"[ ]+\r", b"\r", body)
    return body, comments


def _rows(path: Path, body: bytes, layout: Layout) -> tuple[Any, dict[int, int]]:
    """The rows as an Arrow table of words, and the number of cells of each deviating row."""
    odd: dict[int, int] = {}
    types = dict.fromkeys(layout.columns, pa.string())
    return arrow_tables.parse_csv(path, io.BytesIO(body), types, layout.separator, odd=odd), odd


def _wider(body: bytes, layout: Layout, odd: dict[int, int]) -> Layout | None:
    """The layout of rows of two lengths: many have additional cells. ``None`` otherwise."""
    [*widths] = set(odd.values())
    if len(widths) != 1 or widths[0] < layout.width or b'"' in body or layout.separator == " ":
        return None
    return msgspec.structs.replace(layout, width=widths[0])


def _pad(body: bytes, layout: Layout) -> bytes:
    """The rows padded with empty cells to the width of the layout."""
    mark, marks = layout.separator.encode(), layout.width - 1
    lines = (line and line + mark * (marks - line.count(mark)) for line in body.splitlines())
    return b"\n".join(lines) + b"\n"


def _check_quotes(path: Path, column: Any, layout: Layout) -> None:
    """Raise RecordingError for a cell that contains rows."""
    broken = pc.match_substring(column, "\n")
    if pc.any(broken, min_count=0).as_py():
        for row in arrow_tables.as_array(pc.indices_nonzero(broken)).tolist():
            cell = column[row].as_py()
            if cell.count(layout.separator) >= layout.width - 1:
                raise RecordingError(
                    f"{path}: {row_name(row)}: {arrow_tables.short(cell)!r} holds rows: "
                    "a quote that is not closed?"
                )


def _skips(odd: dict[int, int], width: int) -> tuple[Skip, ...]:
    """The rows with another number of cells, one by one up to a bound."""
    named = [
        Skip(f"row {row}", f"{cells} cells, expected {width}", row)
        for row, cells in list(odd.items())[:MOST_NAMED]
    ]
    more = list(odd)[MOST_NAMED:]
    if more:
        named.append(Skip(f"{len(more)} more rows", f"another number of cells than {width}", more[0]))
    return tuple(named)
