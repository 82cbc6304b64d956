"""Recordings of every known format, read from files and written to files."""

from pointpred.sources.conversion import Summary, convert, write_recordings
from pointpred.sources.known_formats import FORMATS, Format, format_of
from pointpred.sources.own.recordings import read, write
from pointpred.sources.own.stored import StoredRecording
from pointpred.sources.read_files import open_any, read_any
from pointpred.sources.reading import Reading
from pointpred.sources.trials.segmentation import Piece, cut_at_clicks, cut_at_pauses

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
