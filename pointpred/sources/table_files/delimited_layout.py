"""The layout of a delimited text: its separator, the line of names, and the first row."""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Sequence

import msgspec

from pointpred.recordings.arrow_tables import distinct_names

LINES = 60
"""Most lines examined."""
PREAMBLE = 20
"""Most lines above the table."""
MOST_COLUMNS = 4096
"""Most cells of a row; the reader refuses more."""
MOSTLY = 0.8
"""Share of the lines that must have as many cells as the most frequent count."""
SEPARATORS = ("\t", ";", "|", ",", " ")
NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?|[+-]?(nan|inf)", re.IGNORECASE)
STAMP = re.compile(r"\d{4}-\d{2}-\d{2}[T ]\d{2}:\d{2}.*")
LISTED = re.compile(r"[\s\d.,;|+-]*\d[\s\d.,;|+-]*")
"""Several numbers in one cell."""
QUOTED = re.compile(r'"(?:[^"]|"")*"')
DECLARED = re.compile(r"sep=(.)")
"""Excel's first line that declares the separator."""


class Layout(msgspec.Struct, frozen=True):
    """The layout of a text.

    ``separator`` of cells (a blank stands for any run of blanks); ``names`` of columns, ``None`` without a
    header; ``width`` cells in a row; ``first``: the line of the first row, from 0; ``above``: lines above the
    table.
    """

    separator: str
    names: tuple[str, ...] | None
    width: int
    first: int
    above: int = 0

    @property
    def columns(self) -> list[str]:
        """A unique name for each column: its place from 0 if it has none."""
        names = [name.strip() for name in self.names or ()]
        return distinct_names(
            [name or str(place) for place, name in enumerate(names + [""] * (self.width - len(names)))]
        )


def layout_of(text: str) -> Layout | None:
    r"""The layout of a text that begins with ``text``; ``None`` if it is not a table with numbers.

    Lines that begin with # are comments; the last of them may contain the column names.

    >>> layout_of("t;x;y\n0,1;5;6\n0,2;7;8\n")
    Layout(separator=';', names=('t', 'x', 'y'), width=3, first=1, above=0)
    """
    lines = text.lstrip("\ufeff").splitlines()
    comments = [line for line in lines[:LINES] if line.lstrip().startswith("#")]
    numbered = [
        (at, line) for at, line in enumerate(lines) if line.strip() and not line.lstrip().startswith("#")
    ]
    declared = DECLARED.fullmatch(numbered[0][1].strip()) if numbered else None
    candidates = SEPARATORS if declared is None else (declared[1],)
    numbered = numbered[declared is not None :][:LINES]
    if not numbered or numbered[0][1].lstrip()[:1] in ("{", "[", "<"):
        return None
    below = numbered[1:] or numbered
    outside = set(QUOTED.sub("", "\n".join(line for _, line in below)).replace("\t", "\t "))
    for separator in candidates:
        if separator not in outside:
            continue  # separators inside quotes do not count
        layout = _by(separator, numbered, comments)
        if layout is not None:
            return _from_hash(layout, lines)
    return None


def is_row(line: str, separator: str, width: int) -> bool:
    """Whether a line that begins with # is a row (participant #2): of the same length, with numbers.

    >>> is_row("#2,10,20", ",", 3), is_row("# t,x,y", ",", 3), is_row("# block 2, left", ",", 3)
    (True, False, False)
    """
    rows, _ = _split(separator, [(0, line.strip())])
    return bool(rows) and len(rows[0]) == width and any(map(is_number, rows[0][1:]))


def _from_hash(layout: Layout, lines: Sequence[str]) -> Layout:
    """The layout including rows that begin with # directly below the names."""
    first = layout.first
    while first > 1 and lines[first - 1].lstrip().startswith("#"):
        first -= 1
    below = first < layout.first and any(
        is_row(line, layout.separator, layout.width) for line in lines[first : layout.first]
    )
    named = bool(lines[first - 1].strip()) and not lines[first - 1].lstrip().startswith("#")
    return msgspec.structs.replace(layout, first=first) if below and named else layout


def is_number(cell: str) -> bool:
    """Whether a cell is a number with a point or a comma, or a stamp of date and time."""
    cell = cell.strip()
    return bool(NUMBER.fullmatch(cell) or STAMP.fullmatch(cell))


def _is_value(cell: str) -> bool:
    """Whether a cell is a number or a list."""
    return is_number(cell) or "[" in cell or bool(LISTED.fullmatch(cell))


def _split(separator: str, numbered: Sequence[tuple[int, str]]) -> tuple[list[list[str]], list[int]]:
    """The cells of each row, and its first line; none if the quotes are inconsistent."""
    lines = (" ".join(line.split()) if separator == " " else line for _, line in numbered)
    reader = csv.reader(lines, delimiter=separator, skipinitialspace=separator != " ")
    rows: list[list[str]] = []
    places: list[int] = []
    read = 0
    try:
        for row in reader:
            rows.append([cell.strip() for cell in row])
            places.append(numbered[read][0])
            read = reader.line_num
    except csv.Error:
        return [], []
    return rows, places


def _by(separator: str, numbered: Sequence[tuple[int, str]], comments: Sequence[str]) -> Layout | None:
    """The layout by one separator; ``None`` if the lines have no common number of cells."""
    rows, places = _split(separator, numbered)
    if not rows:
        return None
    width, _ = Counter(map(len, rows[min(1, len(rows) - 1) :])).most_common(1)[0]
    if width < (3 if separator in " |" else 2):
        return None
    start = next((at for at, row in enumerate(rows[:PREAMBLE]) if len(row) == width), None)
    if start is None:
        return None
    if width > MOST_COLUMNS:
        return Layout(separator, None, width, places[start], start)  # refused by the reader
    start = _below_padding(rows, start)
    names: tuple[str, ...] | None
    if start and len(rows[start - 1]) == width - 1 and not any(map(is_number, rows[start - 1])):
        names, body = _short_names(rows[start - 1], rows[start]), start
        above = start - 1
    elif _is_header(rows[start], [row for row in rows[start + 1 :] if len(row) == width]):
        names, body, above = tuple(rows[start]), start + 1, start
    else:
        names, body, above = _in_comment(comments, separator, width), start, start
    same = [row for row in rows[body:] if len(row) == width]
    if len(same) < MOSTLY * len(rows[body:]) or not any(_is_value(cell) for row in same for cell in row):
        return None
    first = places[body] if body < len(places) else numbered[-1][0] + 1
    return Layout(separator, names, width, first, above)


def _below_padding(rows: Sequence[Sequence[str]], start: int) -> int:
    """The row of names below lines that a spreadsheet has padded to the width of the rows.

    The rows then end in empty cells, which the row at ``start`` fills.
    """
    for at in range(start + 1, min(PREAMBLE, len(rows))):
        below = [row for row in rows[at + 1 :] if len(row) == len(rows[start])]
        used = max(map(_filled, below), default=0)
        if _filled(rows[start]) <= used:
            return start
        if len(rows[at]) == len(rows[start]) and _filled(rows[at]) == used and all(rows[at][:used]):
            return at if _is_header(rows[at], below) else start
    return start


def _filled(row: Sequence[str]) -> int:
    """Number of cells up to the last nonempty one."""
    return max((place for place, cell in enumerate(row, 1) if cell), default=0)


def _is_header(row: Sequence[str], below: Sequence[Sequence[str]]) -> bool:
    """Whether a row contains names: text above numbers, and no number above a number."""
    if [cell.strip() for cell in row] == [str(place) for place in range(len(row))]:
        return True
    numeric = [sum(is_number(cells[place]) for cells in below) > len(below) / 2 for place in range(len(row))]
    if any(is_number(cell) and digits for cell, digits in zip(row, numeric, strict=True)):
        return False
    if any(cell and not is_number(cell) and digits for cell, digits in zip(row, numeric, strict=True)):
        return True
    return not any(map(_is_value, row))


def _short_names(names: Sequence[str], row: Sequence[str]) -> tuple[str, ...]:
    """Names that are one fewer than the cells: rows end with a separator, or begin with a row name."""
    return (*names, "") if not row[-1] else ("", *names)


def _in_comment(comments: Sequence[str], separator: str, width: int) -> tuple[str, ...] | None:
    """Names in the last comment, as numpy writes them; ``None`` if it has another number of words."""
    if not comments:
        return None
    rows, _ = _split(separator, [(0, comments[-1].strip().lstrip("#").strip())])
    words = rows[0] if rows else []
    return tuple(words) if len(words) == width and not any(map(is_number, words)) else None
