"""JSON and JSON lines: records anywhere in a document, in the usual layouts."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from pointpred.errors import RecordingError
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.encodings import read_text
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.table_choice import table_in

TITLE = "JSON or JSON lines"
BEGINNING = re.compile(rb"""\s*(\{\s*["}]|\[\s*["\[{\]\-0-9tfnN])""")
MOST_CHARACTERS = 1 << 28
"""Longer text would need more than 4 GB as Python objects."""
MOST_DIGITS = 18
"""Whole numbers with more digits stay text, so that long identifiers keep all digits."""
SURROGATE = re.compile(r"\\u[dD][89abAB]\w\w\\u[dD][c-fC-F]\w\w|\\u[dD][89a-fA-F]\w\w")


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` begins as an array or an object in JSON does."""
    return BEGINNING.match(head) is not None


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read the records that are meant (``table_choice``).

    In JSON lines each line is a record; a damaged last line is ignored with a note.
    Raises RecordingError, also above 2^28 characters. Memory: about 11 bytes a character.
    """
    document, notes = document_in(path)
    table = table_in(path, document, TITLE, reading)
    return ColumnTable(table.columns, table.format, (*table.notes, *notes))


def document_in(path: Path) -> tuple[Any, list[str]]:
    """The value of a file, or the list of the values of its lines, and notes; raises RecordingError."""
    text = read_text(path)
    if len(text) > MOST_CHARACTERS:
        raise RecordingError(
            f"{path}: {len(text)} characters, at most {MOST_CHARACTERS} are read as JSON; "
            "split the file, or save its records as CSV"
        )
    text = SURROGATE.sub(_paired, text)
    try:
        return parse(text), []
    except ValueError as error:  # its text only: the error holds the document
        whole = _reason(error)
    lines = [(number, line) for number, line in enumerate(text.split("\n"), 1) if line.strip()]
    values: list[Any] = []
    for number, line in lines:
        try:
            values.append(parse(line))
        except ValueError as error:
            if not values or number == 1:
                break
            if number == lines[-1][0]:
                return values, [f"line {number} is damaged and left aside: {_reason(error)}"]
            raise RecordingError(f"{path}: line {number} is no JSON: {_reason(error)}") from error
    if len(values) < 2 or len(values) < len(lines):
        raise RecordingError(f"{path}: no JSON: {whole}")
    return values, []


def parse(text: str) -> Any:
    """The value of some JSON text; raises ValueError, also where values are nested too deeply."""
    try:
        return json.loads(text, parse_int=_whole)
    except RecursionError as error:
        raise ValueError("nested too deeply") from error


def _whole(digits: str) -> int | str:
    return int(digits) if len(digits) <= MOST_DIGITS else digits


def _paired(match: re.Match[str]) -> str:
    """Replace half surrogate pairs, which are not characters."""
    return match[0] if len(match[0]) > 6 else "\\ufffd"


def _reason(error: ValueError) -> str:
    return str(error)[:120]
