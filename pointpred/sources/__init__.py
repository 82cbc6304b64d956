"""The only input and output of pointpred: recordings of every known format, live devices, the cursor."""

from pointpred.sources.formats import FORMATS, Format, Summary, convert, format_of, read_any, write_found
from pointpred.sources.reading import Reading
from pointpred.sources.recordings import read, write
from pointpred.sources.segmentation import Piece, cut_at_clicks, cut_at_pauses

__all__ = [
    "FORMATS",
    "Format",
    "Piece",
    "Reading",
    "Summary",
    "convert",
    "cut_at_clicks",
    "cut_at_pauses",
    "format_of",
    "read",
    "read_any",
    "write",
    "write_found",
]
