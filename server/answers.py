"""Predictions as frames: one for the newest event, or one for each."""

from __future__ import annotations

from pointpred.columns import PredictionColumns
from pointpred.events import PHASES
from pointpred.server.decoding import pack
from pointpred.server.messages import PredictionMessage, Region, encode
from pointpred.server.outbox import Frame


def frames(predictions: PredictionColumns, *, binary: bool, each: bool) -> tuple[list[Frame], int]:
    """What to send after a frame of events, and how many predictions that are.

    Binary: one frame of packed records. JSON: one text a prediction. ``each``: one prediction an event,
    otherwise the newest one only.
    """
    told = predictions if each else PredictionColumns(predictions.table[-1:])
    if binary:
        return [pack(told)], len(told)
    return [encode(message(row)).decode() for row in told.table.tolist()], len(told)


def message(row: list[float]) -> PredictionMessage:
    """A row of predictions as a message."""
    t, x, y, sxx, sxy, syy, remaining_s, phase = row
    if x != x:
        return PredictionMessage(t)
    return PredictionMessage(
        t,
        x,
        y,
        Region(sxx, sxy, syy) if sxx == sxx else None,
        PHASES[int(phase)],
        remaining_s if remaining_s == remaining_s else None,
    )
