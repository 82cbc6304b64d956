"""A scored set as numbers to print: errors beside ``hold``, claims, groups, intervals over people."""

from pointpred.scoring.summary.document import (
    Calibration,
    Document,
    GroupSummary,
    Hits,
    Measure,
    Measures,
    PredictorSummary,
    SetSummary,
    TimeLeft,
    Unread,
)
from pointpred.scoring.summary.summarise import FLOOR, SERIES, document, summarise, summarise_parts

__all__ = [
    "FLOOR",
    "SERIES",
    "Calibration",
    "Document",
    "GroupSummary",
    "Hits",
    "Measure",
    "Measures",
    "PredictorSummary",
    "SetSummary",
    "TimeLeft",
    "Unread",
    "document",
    "summarise",
    "summarise_parts",
]
