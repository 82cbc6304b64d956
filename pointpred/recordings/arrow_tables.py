"""CSV and Parquet files as Arrow tables, and the cells of any table by column.

Errors name the file, the row and the expected content.
"""

from __future__ import annotations

import csv
import io
import os
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, BinaryIO

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv as pacsv
import pyarrow.parquet as pq
from numpy.typing import NDArray

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Skip
from pointpred.recordings.encodings import UTF_8, head_of, open_utf8
from pointpred.recordings.reading import Cut, TimeUnit, row_name
from pointpred.records import FloatArray

AT_ONCE = 1024 * 1024
"""Bytes that are read at a time."""
IntArray = NDArray[np.int64]
PARQUET_MAGIC = b"PAR1"
NUMBER = r"^[ \t]*[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?[ \t]*$"
NOT_A_NUMBER = r"^[ \t]*[+-]?(?i:nan?)?[ \t]*$"
CELL_MOST = 40
LARGEST_BLOCK = 1 << 25
JOINTS = "+|/;"
"""Separators of joined columns: the first that occurs in no cell is used."""
PLAIN = (
    pa.types.is_string,
    pa.types.is_large_string,
    pa.types.is_integer,
    pa.types.is_floating,
    pa.types.is_boolean,
    pa.types.is_null,
)
UNREADABLE = (
    pa.ArrowException,
    OSError,
    UnicodeError,
    csv.Error,
    ValueError,
    KeyError,
    IndexError,
    MemoryError,
)
"""Errors of Arrow on damaged bytes, which may declare sizes that fit into no memory."""


def open_file(path: Path, mode: str = "rb") -> Any:
    """A file opened by Arrow; a name in bytes need not be UTF-8. Raises OSError."""
    return pa.OSFile(os.fsencode(path), mode)


def in_memory(file: BinaryIO) -> Any:
    """The bytes of a file from its beginning in an Arrow buffer; raises OSError."""
    buffer = pa.allocate_buffer(file.seek(0, io.SEEK_END))
    file.seek(0)
    with memoryview(buffer) as signed, signed.cast("B") as free:
        size = _fill(file, free)
    return buffer.slice(0, size)


def _fill(file: BinaryIO, free: memoryview) -> int:
    """Read until the memory is full or the file ends; returns the number of bytes read."""
    size = 0
    while part := file.read(min(AT_ONCE, len(free) - size)):
        free[size : size + len(part)] = part
        size += len(part)
    return size


class ColumnTable(msgspec.Struct, frozen=True):
    """The cells of one table by column, all of one length.

    A cell is a str, a number, a bool, ``None``, a date and time, or a list of numbers (a row a trial);
    a column is a list, a numpy array or an Arrow array. ``format`` for the provenance. ``row_of``: the file's
    row of each row if some were left out, which ``skipped`` names. ``unsure``: columns of ambiguous numbers,
    and why. ``known``: what the format says itself; ``None`` for any table.
    """

    columns: dict[str, Any]
    format: str
    notes: tuple[str, ...] = ()
    skipped: tuple[Skip, ...] = ()
    row_of: Sequence[int] | IntArray | None = None
    unsure: dict[str, str] = {}
    known: Known | None = None


class Known(msgspec.Struct, frozen=True, kw_only=True):
    """What a format says of its columns: which is which field, and their units.

    ``fields``: field -> column; without ``user`` there is one, ``one_user``. ``gain``: px in a unit of x and
    of y, below 0 where an axis is turned. ``cut``: how a stream is cut by default. ``faults``: what is wrong
    with a row.
    """

    fields: dict[str, str]
    time_unit: TimeUnit
    provenance: Provenance
    gain: tuple[float, float] = (1.0, 1.0)
    one_user: str | None = None
    cut: Cut | None = None
    faults: dict[int, str] = {}


def distinct_names(names: Sequence[str]) -> list[str]:
    """The names made unique: a repeated one gets its place from 0 as a suffix.

    >>> distinct_names(["t", "x", "x", "x.1"])
    ['t', 'x.1', 'x.2', 'x.1.3']
    """
    often = Counter(names)
    taken: dict[str, None] = {}
    for place, name in enumerate(names):
        title = name if often[name] == 1 else f"{name}.{place}"
        while title in taken:
            title += f".{place}"
        taken[title] = None
    return list(taken)


def read_table(path: Path, text: Callable[[str], bool], separator: str = ",") -> tuple[Any, str]:
    """The table in a Parquet or CSV file, and a note on its encoding; ``text`` names the text columns.

    In a CSV file every other column is read as numbers if all its cells are numbers, else as text:
    ``numbers`` then lists the wrong cells. Raises RecordingError.
    """
    try:
        if head_of(path).startswith(PARQUET_MAGIC):
            table, note = read_parquet(path)[0], ""
        else:
            with open_utf8(path) as (file, encoding):
                table, note = read_csv(path, file, text, separator), encoding.note
        check_columns(path, table)
    except UNREADABLE as error:
        raise unreadable(path, error) from error
    unbroken(path, table, [name for name in table.column_names if not text(name)])
    return table, note


def unreadable(path: Path, error: BaseException) -> RecordingError:
    """One of ``UNREADABLE`` as an error that names the file; a RecordingError as it is."""
    if isinstance(error, RecordingError):
        return error
    why = " ".join(str(error).split())
    if isinstance(error, MemoryError):
        why = f"needs more memory than there is, or is damaged: {why}"
    return RecordingError(f"{path}: {why}")


def check_names(path: Path, names: Sequence[str]) -> None:
    """Raise RecordingError if two columns have the same name."""
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise RecordingError(
            f"{path}: column {twice[0]!r} occurs twice, expected every column once", field=twice[0]
        )


def check_columns(path: Path, table: Any) -> None:
    """Raise RecordingError if two columns have the same name, or one holds neither words nor numbers.

    Also UnicodeError, where a name is no text.
    """
    check_names(path, table.column_names)
    for name, column in zip(table.column_names, table.columns, strict=True):
        kind = column.type.value_type if pa.types.is_dictionary(column.type) else column.type
        if not any(fits(kind) for fits in PLAIN):
            raise RecordingError(f"{path}: column {name!r} holds {kind}, expected words or numbers")


@contextmanager
def parquet_file(path: Path, **options: Any) -> Iterator[Any]:
    """A Parquet file opened by Arrow; checksums are verified if present. Raises ``UNREADABLE``."""
    with (
        open_file(path) as opened,
        pq.ParquetFile(opened, page_checksum_verification=True, **options) as file,
    ):
        groups = [file.metadata.row_group(i).num_rows for i in range(file.num_row_groups)]
        if sum(groups) != file.metadata.num_rows:  # Arrow makes room for the rows of a group before it reads
            raise ValueError(f"damaged: its parts claim {sum(groups)} rows, it has {file.metadata.num_rows}")
        yield file


def read_parquet(path: Path) -> tuple[Any, dict[bytes, bytes]]:
    """The table in a Parquet file, and what the file says of itself; raises ``UNREADABLE``."""
    with parquet_file(path) as file:
        table = file.read()
        table.validate(full=True)
        return table.replace_schema_metadata(None), file.metadata.metadata or {}


def read_csv(
    path: Path, file: BinaryIO, text: Callable[[str], bool], separator: str = ",", *, skip: int = 0
) -> Any:
    """The table below ``skip`` lines of an open CSV file; raises ``UNREADABLE``."""
    file.seek(0)
    for _ in range(skip + 1):
        columns = file.readline(1 << 26)
    names = next(csv.reader(columns.removeprefix(UTF_8).decode().splitlines()[:1], delimiter=separator), [])
    types = {name: pa.string() if text(name) else pa.float64() for name in names}
    return parse_csv(path, file, types, separator, skip=skip)


def parse_csv(
    path: Path,
    file: BinaryIO,
    types: dict[str, Any],
    separator: str = ",",
    *,
    skip: int = 0,
    odd: dict[int, tuple[int, str]] | None = None,
) -> Any:
    """The rows below ``skip`` lines of the open ``file``, named ``path`` in messages: every CSV is read here.

    Without ``odd`` the first row names the columns. They have the named Arrow ``types``, or are all strings
    if a cell is not of its type; an empty cell is null. A row that is cut or too long is an error with its
    number as ``value``. With ``odd`` the columns are named as ``types`` are, and an empty cell is an empty
    string. Rows that are cut or too long are left out, and the number of their cells and their text are added
    to ``odd`` by their row. Raises RecordingError.
    """
    rows, named = in_memory(file), odd is not None
    wrong: list[Any] = []

    def remember(row: Any) -> str:
        wrong.append(row)
        return "skip" if named else "error"

    def parsed(types: dict[str, Any], handler: Any = None) -> Any:
        return pacsv.read_csv(
            pa.BufferReader(rows),
            read_options=pacsv.ReadOptions(
                skip_rows=skip,
                column_names=list(types) if named else None,
                use_threads=handler is None,
                block_size=min(max(rows.size, 1), LARGEST_BLOCK),  # Arrow needs the longest row in one block
            ),
            parse_options=pacsv.ParseOptions(
                delimiter=separator, newlines_in_values=True, invalid_row_handler=handler
            ),
            convert_options=pacsv.ConvertOptions(
                column_types=types,
                null_values=[""],
                strings_can_be_null=not named,
                quoted_strings_can_be_null=False,
            ),
        )

    try:
        with suppress(pa.ArrowInvalid):
            return parsed(types)
        # In order, so that Arrow numbers the rows, and without threads, which must not call Python.
        table = parsed(dict.fromkeys(types, pa.string()), remember)
    except UNREADABLE as error:
        if not wrong or named:
            raise unreadable(path, error) from error
        number = wrong[0].number - 2 - skip
        raise RecordingError(
            f"{path}: {row_name(number)}: {wrong[0].actual_columns} cells, "
            f"expected {wrong[0].expected_columns}; cut or mixed up?",
            code="bad_row",
            value=number,
        ) from error
    if odd is not None:
        odd |= {row.number - 1 - skip: (row.actual_columns, row.text) for row in wrong}
    return table


def unbroken(path: Path, table: Any, columns: Iterable[str]) -> None:
    """Raise RecordingError for a line break inside a cell: an unclosed quote merges rows."""
    for name in columns:
        if name in table.column_names and pa.types.is_string(table[name].type):
            broken = as_array(pc.indices_nonzero(pc.match_substring_regex(table[name], "[\r\n]")))
            if len(broken):
                row = int(broken[0])
                cell = short(str(table[name][row].as_py()))
                raise RecordingError(
                    f"{path}: {row_name(row)}: {name} is {cell!r}, "
                    "a line break inside a cell: unclosed quote?"
                )


def short(cell: str) -> str:
    """A cell as shown in messages: truncated after 40 characters."""
    return cell if len(cell) <= CELL_MOST else cell[:CELL_MOST] + "..."


def words(column: Any) -> Any:
    """A column as text; numbers as they print."""
    if pa.types.is_dictionary(column.type):
        column = column.cast(column.type.value_type)
    return column if pa.types.is_string(column.type) else pc.cast(column, pa.string())


def join_columns(columns: list[Any]) -> Any:
    """The words of several columns as one column, such as ``2+7``; null if one of them is empty."""
    columns = [pc.utf8_trim_whitespace(words(column)) for column in columns]
    columns = [pc.if_else(pc.equal(column, ""), None, column) for column in columns]
    taken = {
        mark for mark in JOINTS for column in columns if pc.any(pc.match_substring(column, mark)).as_py()
    }
    mark = next((mark for mark in JOINTS if mark not in taken), " ++ ")
    return pc.binary_join_element_wise(*columns, mark, null_handling="emit_null")


def is_words(column: Any) -> bool:
    """Whether the cells of a column are text."""
    return bool(pa.types.is_string(column.type) or pa.types.is_large_string(column.type))


def numbers(column: Any) -> tuple[FloatArray, dict[int, str]]:
    """A column as float64, NaN for empty cells, and the cells that are not numbers by their row."""
    if pa.types.is_dictionary(column.type):
        column = column.cast(column.type.value_type)
    if pa.types.is_temporal(column.type):
        column = pc.cast(column, pa.string())
    faults: dict[int, str] = {}
    if is_words(column):
        try:
            return float64(pc.cast(column, pa.float64())), faults
        except pa.ArrowInvalid:
            pass  # some cell is not a number, or has blanks around it
        good = pc.match_substring_regex(column, NUMBER)
        empty = pc.match_substring_regex(column, NOT_A_NUMBER)
        wrong = as_array(pc.indices_nonzero(pc.invert(pc.or_(good, empty))))
        faults = {int(row): short(str(column[int(row)].as_py())) for row in wrong}
        column = pc.utf8_trim_whitespace(pc.if_else(good, column, pa.nulls(len(column), column.type)))
    if pa.types.is_boolean(column.type):
        column = pc.cast(column, pa.int8())
    values = pc.cast(column, pa.float64(), safe=False)
    return float64(values), faults


def finite_numbers(column: Any) -> tuple[FloatArray, dict[int, str]]:
    """As ``numbers``, but infinite cells also count as not numbers."""
    array, faults = numbers(column)
    for row in np.flatnonzero(np.isinf(array)).tolist():
        faults.setdefault(row, str(array[row]))
        array[row] = np.nan
    return array, faults


def as_arrow(column: Any) -> Any:
    """A column as an Arrow array; cells of several types become text."""
    if isinstance(column, pa.ChunkedArray):
        return column
    try:
        array = pa.array(column)
    except MemoryError:  # one of Arrow's, too: text takes even more
        raise
    except (pa.ArrowException, TypeError, ValueError, OverflowError):
        array = pa.array([None if cell is None else str(cell) for cell in column], pa.string())
    if pa.types.is_null(array.type):
        array = pc.cast(array, pa.string())
    return pa.chunked_array([array])


def float64(column: Any) -> FloatArray:
    """A float64 column as an array, NaN for null; even ``fill_null`` would import pandas for its scalar."""
    parts = [np.empty(0)]
    for chunk in _chunks(column):
        parts.append(np.full(len(chunk), np.nan) if chunk.null_count else as_array(chunk))
        if 0 < chunk.null_count < len(chunk):
            bits, data = (np.frombuffer(buffer, np.uint8) for buffer in chunk.buffers())
            rows = slice(chunk.offset, chunk.offset + len(chunk))
            valid = np.unpackbits(bits, bitorder="little")[rows] == 1
            parts[-1][valid] = data.view(np.float64)[rows][valid]
    return np.concatenate(parts)


def as_array(column: Any) -> Any:
    """A column of numbers without nulls as an array; Arrow's own ``to_numpy`` would import pandas."""
    parts = [np.from_dlpack(chunk) for chunk in _chunks(column) if len(chunk)]
    return np.concatenate(parts) if parts else np.empty(0)


def _chunks(column: Any) -> list[Any]:
    return column.chunks if isinstance(column, pa.ChunkedArray) else [column]


def rows_without(count: int, left: Collection[int]) -> NDArray[np.int64]:
    """The rows from 0 up to ``count`` except some."""
    return np.delete(np.arange(count, dtype=np.int64), sorted(left))


def need_columns(path: Path, names: Iterable[str], required: Iterable[str], valid: Iterable[str]) -> None:
    """Raise RecordingError when a required column is missing or a column is unknown."""
    names, valid = list(names), list(valid)
    missing = [name for name in required if name not in names]
    if missing:
        raise RecordingError(
            f"{path}: column {missing[0]!r} is missing, found {', '.join(names)}",
            code="missing_column",
            field=missing[0],
        )
    unknown = [name for name in names if name not in valid]
    if unknown:
        raise RecordingError(
            f"{path}: unknown column {unknown[0]!r}, expected only {', '.join(valid)}",
            code="unknown_column",
            field=unknown[0],
        )
