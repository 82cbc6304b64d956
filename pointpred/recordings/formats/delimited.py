"""Any delimited text as a table: separator, decimal commas, comments and header are detected."""

from __future__ import annotations

import csv
import io
import re
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.errors import RecordingError
from pointpred.recording import Skip
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable, distinct_names
from pointpred.recordings.encodings import UTF_8, open_utf8
from pointpred.recordings.reading import AS_IS, Reading, row_name

TITLE = "a table of samples (delimited text)"
HEAD = 1 << 16
COMMENT = re.compile(rb"^[ \t]*#[^\r\n]*(\r\n|\n|\r|$)", re.MULTILINE)
LINE = re.compile(rb"\r\n|\n|\r")
MOST_ODD = 0.2
"""With a larger share of rows with another number of cells the text is not a table."""
MOST_NAMED = 20
"""Most rows named one by one among the skips; the rest is counted."""
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
BLANK = r"[ \x{A0}\x{202F}\x{2009}]"
SIGN = r"^\s*[+-]?"
COMMA_NUMBER = SIGN + r"(\d+,\d*|,\d+)([eE][+-]?\d+)?\s*$"
POINT_NUMBER = SIGN + r"(\d+\.\d*|\.\d+)([eE][+-]?\d+)?\s*$"
COMMA_GROUPS = SIGN + r"[1-9]\d{0,2}(,\d{3}){1,3}\s*$"
"""A single comma before three digits, which may be either mark."""
POINT_GROUPS = SIGN + r"[1-9]\d{0,2}(\.\d{3}){1,3}\s*$"
COMMA_THOUSANDS = SIGN + r"[1-9]\d{0,2}((,\d{3}){1,3}\.\d*|(,\d{3}){2,3})\s*$"
POINT_THOUSANDS = SIGN + r"[1-9]\d{0,2}((\.\d{3}){1,3},\d*|(\.\d{3}){2,3})\s*$"
BLANK_THOUSANDS = SIGN + r"[1-9]\d{0,2}(" + BLANK + r"\d{3}){1,2}([.,]\d*)?\s*$"
SMALL = SIGN + r"\d{1,3}\s*$"
NUMERIC = r"^[\s\d.,+\-eE\x{A0}\x{202F}\x{2009}]*$"
SEVERAL = r"^[^,]*,[^,]*,"
"""Two commas or more: a list of three items or more, unless the digits are in groups of three."""
SOME = 0.2
"""Largest share of other cells in a column of such numbers."""


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a delimited table with numbers in it."""
    return b"\0" not in head and _layout(head) is not None


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """The cells of a delimited text as text; numbers have a decimal point.

    The text has no header if its first row has numbers above numbers: columns are then named ``0``, ``1`` and
    so on. Empty cells behind the last column are left out. A row with another number of cells is a skip; if
    many rows have the same number of additional cells, the others are padded with empty ones. Memory: the
    text, and its cells once more. Raises RecordingError.
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
    odd: dict[int, tuple[int, str]] = {}
    types = dict.fromkeys(layout.columns, pa.string())
    table = arrow_tables.parse_csv(path, io.BytesIO(body), types, layout.separator, odd=odd)
    rows = {row: _split(layout.separator, [(0, text)])[0] for row, (_, text) in odd.items()}
    mended = {row: _trimmed(cells[0], layout.width) for row, cells in rows.items() if cells}
    mended = {row: cells for row, cells in mended.items() if len(cells) == layout.width}
    if mended:
        places = np.concatenate([arrow_tables.rows_without(table.num_rows + len(odd), odd), list(mended)])
        columns = zip(layout.columns, zip(*mended.values(), strict=True), strict=True)
        whole = pa.table({name: pa.array(cells, pa.string()) for name, cells in columns})
        table = pa.concat_tables([table, whole]).take(np.argsort(places))
    return table, {row: cells for row, (cells, _) in odd.items() if row not in mended}


def _trimmed(row: list[str], width: int) -> list[str]:
    """A row without the empty cells behind its last column."""
    return row[:width] if len(row) > width and all(row[:width]) and not any(row[width:]) else row


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
    rows = [_trimmed(row, width) for row in rows]
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


class Marks(msgspec.Struct):
    """Columns with numbers in Python's notation, notes on changes, and the reasons for unsure columns."""

    columns: dict[str, Any]
    notes: list[str] = []
    unsure: dict[str, str] = {}


def plain_numbers(columns: dict[str, Any], separator: str) -> Marks:
    """The text columns with decimal points and without thousands separators.

    A comma or a point before three digits is ambiguous; the other cells of the table decide. If they do not,
    or contradict each other, the column is unchanged and unsure. Columns of lists are unchanged.
    """
    marks = Marks(dict(columns))
    if separator != " ":
        _blanks(marks)
    commas = [
        name for name, column in marks.columns.items() if _any(column, ",", plain=True) and _numeric(column)
    ]
    if any(_are_lists(marks.columns[name]) for name in commas) and separator == ",":
        return marks
    commas = [name for name in commas if not _are_lists(marks.columns[name])]
    some = {name: marks.columns[name] for name in commas}
    thousands = _first(some, COMMA_THOUSANDS)
    decimal = _first(some, COMMA_NUMBER, COMMA_GROUPS) or _first(some, POINT_THOUSANDS, POINT_GROUPS)
    for name, column in some.items():
        if not thousands and _any(column, POINT_NUMBER) and _any(column, COMMA_NUMBER):
            marks.unsure[name] = f"{_cell(column, COMMA_NUMBER)!r} has a comma where other cells have a point"
        elif thousands and decimal:
            marks.unsure[name] = f"{thousands!r} has a comma between thousands, {decimal!r} a decimal comma"
        elif decimal:
            _point_for_comma(marks, name)
        elif thousands:
            groups = _match(column, f"{COMMA_GROUPS}|{COMMA_THOUSANDS}")
            _change(marks, name, groups, pc.replace_substring(column, ",", ""))
        elif cell := _cell(column, COMMA_GROUPS):
            whole, point = cell.strip().replace(",", ""), cell.strip().replace(",", ".")
            marks.unsure[name] = f"{cell!r} may be {whole} or {point}"
    if separator in ";\t":
        _points(marks, set(commas))
    return marks


def _blanks(marks: Marks) -> None:
    """Remove the blanks from columns in which they can only separate thousands."""
    for name, column in list(marks.columns.items()):
        groups = _match(column, BLANK_THOUSANDS)
        if not pc.any(groups, min_count=0).as_py():
            continue
        others = pc.and_(pc.invert(groups), _match(column, r"\d" + BLANK + r"+[+-]?\d"))
        if pc.any(others, min_count=0).as_py():
            continue
        changed = pc.replace_substring_regex(column, BLANK, "")
        _change(marks, name, groups, changed)


def _points(marks: Marks, known: set[str]) -> None:
    """Mark columns as unsure in which points may separate thousands.

    That is, all cells of the table have three digits after the point, and some column has numbers below 1000
    without a point.
    """
    numbers = {name: column for name, column in marks.columns.items() if name not in known}
    if _first(numbers, POINT_NUMBER, POINT_GROUPS):
        return
    groups = {name: cell for name, column in numbers.items() if (cell := _cell(column, POINT_GROUPS))}
    if any(_any(numbers[name], SMALL) for name in groups):
        for name, cell in groups.items():
            whole = cell.strip().replace(".", "")
            marks.unsure[name] = f"{cell!r} may be {whole} or {cell.strip()}"


def _point_for_comma(marks: Marks, name: str) -> None:
    """Write decimal commas as points, after removing points that separate thousands."""
    column = marks.columns[name]
    grouped = _match(column, POINT_THOUSANDS)
    if pc.any(grouped, min_count=0).as_py():
        _change(marks, name, grouped, pc.replace_substring(column, ".", ""))
    column = marks.columns[name]
    commas = _match(column, COMMA_NUMBER)
    marks.columns[name] = pc.if_else(commas, pc.replace_substring(column, ",", "."), column)


def _change(marks: Marks, name: str, where: Any, changed: Any) -> None:
    """Replace a column by its cells without thousands separators; a note shows the first of them."""
    rows = arrow_tables.as_array(pc.indices_nonzero(where))
    if len(rows):
        first = str(marks.columns[name][int(rows[0])].as_py())
        marks.columns[name] = pc.if_else(where, changed, marks.columns[name])
        marks.notes.append(f"column {name}: thousands separators taken out, as in {first!r}")


def _are_lists(column: Any) -> bool:
    """Whether most cells with a comma hold three items or more."""
    commas = int(pc.sum(pc.match_substring(column, ","), min_count=0).as_py())
    groups = _match(column, COMMA_GROUPS + "|" + COMMA_THOUSANDS)
    several = pc.and_(_match(column, SEVERAL), pc.invert(groups))
    return int(pc.sum(several, min_count=0).as_py()) > SOME * commas


def _numeric(column: Any) -> bool:
    """Whether nearly all cells with a comma consist of digits and marks."""
    commas = pc.match_substring(column, ",")
    odd = pc.and_(commas, pc.invert(_match(column, NUMERIC)))
    return bool(pc.sum(odd, min_count=0).as_py() <= SOME * pc.sum(commas, min_count=0).as_py())


def _first(columns: dict[str, Any], pattern: str, unlike: str | None = None) -> str:
    """The first cell that matches one pattern and not another; empty if there is none."""
    return next((cell for column in columns.values() if (cell := _cell(column, pattern, unlike))), "")


def _cell(column: Any, pattern: str, unlike: str | None = None) -> str:
    fits = _match(column, pattern)
    if unlike is not None:
        fits = pc.and_(fits, pc.invert(_match(column, unlike)))
    rows = arrow_tables.as_array(pc.indices_nonzero(fits))
    return str(column[int(rows[0])].as_py()) if len(rows) else ""


def _any(column: Any, pattern: str, *, plain: bool = False) -> bool:
    matches = pc.match_substring(column, pattern) if plain else _match(column, pattern)
    return bool(pc.any(matches, min_count=0).as_py())


def _match(column: Any, pattern: str) -> Any:
    return pc.match_substring_regex(column, pattern)
