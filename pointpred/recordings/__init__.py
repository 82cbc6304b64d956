"""Recordings of every known format, read from files and written to files."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pointpred.recordings.known_formats import FORMATS, Format, format_of
    from pointpred.recordings.own import read
    from pointpred.recordings.read_files import open_any, read_any
    from pointpred.recordings.reading import Reading
    from pointpred.recordings.segmentation import Piece, cut_at_clicks, cut_at_pauses
    from pointpred.recordings.stored import StoredRecording
    from pointpred.recordings.writing import Summary, convert, write, write_recordings

__all__ = [
    "FORMATS",
    "Format",
    "Piece",
    "Reading",
    "StoredRecording",
    "Summary",
    "convert",
    "cut_at_clicks",
    "cut_at_pauses",
    "format_of",
    "open_any",
    "read",
    "read_any",
    "write",
    "write_recordings",
]

MODULES = (
    *("reading", "own", "writing", "stored", "segmentation"),
    *("known_formats", "read_files"),
)
"""Where the public names are; loaded when one is first used, since commands need the options of ``Reading``
before they read anything."""


if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        if name not in __all__:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        for place in MODULES:
            module = import_module(f"{__name__}.{place}")
            globals().update({one: getattr(module, one) for one in __all__ if hasattr(module, one)})
        return globals()[name]
