"""The header of pointpred's own files: one JSON object before the rows."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec

from pointpred.errors import RecordingError
from pointpred.recording import Provenance
from pointpred.records import CPI, DPI


class Header(msgspec.Struct, frozen=True):
    """The header of a file; a foreign file has these defaults.

    ``rows``: the number of rows in the file; ``text`` names conditions that are text; ``skipped`` trials that
    were left out before the file was written, each (trial, reason, row, user); ``append``: the recorder's.
    """

    version: Any = None
    name: str = ""
    rows: int | None = None
    text: tuple[str, ...] = ()
    provenance: Provenance | None = None
    skipped: tuple[tuple[str, str, int | None, str | None], ...] = ()
    notes: tuple[str, ...] = ()
    append: bool = False


NO_HEADER = Header(version=1)


class _Appended(msgspec.Struct, frozen=True):
    append: bool = False


def parse_header(path: Path, encoded: bytes) -> Header:
    """The header in ``encoded``; raises RecordingError if it is not JSON or not in our format."""
    try:
        header = msgspec.json.decode(encoded, type=Header)
    except msgspec.ValidationError as error:
        raise RecordingError(f"{path}: the pointpred header is not as expected: {error}") from error
    except (msgspec.DecodeError, UnicodeError, RecursionError) as error:
        raise RecordingError(f"{path}: the pointpred header is not JSON: {error}") from error
    if header.version != 1:
        raise RecordingError(f"{path}: pointpred header version {header.version!r:.40}, expected 1")
    provenance = header.provenance
    if provenance is not None:
        for name, value, (low, high) in (("cpi", provenance.cpi, CPI), ("dpi", provenance.dpi, DPI)):
            if value is not None and not low <= value <= high:
                raise RecordingError(
                    f"{path}: {name} of the pointpred header must lie in [{low:g}, {high:g}], "
                    f"received {value!r}"
                )
    return header


def says_appended(encoded: bytes) -> bool:
    """Whether the header marks a file to which rows were appended one by one."""
    try:
        return msgspec.json.decode(encoded, type=_Appended).append
    except (msgspec.DecodeError, UnicodeError, RecursionError):
        return False
