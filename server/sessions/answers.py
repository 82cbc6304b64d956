"""Predictions as frames: one for the newest event, or one for each."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from msgspec import UNSET, UnsetType

from pointpred.columns import FloatArray
from pointpred.events import PHASES
from pointpred.server.protocol.records import pack, pack_one
from pointpred.server.protocol.server_messages import Likely, PredictionMessage, Region, encode
from pointpred.server.sessions.outbox import Frame


def frames(
    predictions: FloatArray, *, binary: bool, each: bool, likely: Sequence[list[Likely]] | None = None
) -> tuple[list[Frame], int]:
    """What to send after a frame of events with these rows of predictions, and how many that are.

    Binary: one frame of packed records. JSON: one text a prediction. ``each``: one prediction an event,
    otherwise the newest one only. ``likely``: the likeliest targets after each event that is told, which a
    packed record has no room for.
    """
    told = predictions if each else predictions[-1:]
    if likely is not None and not binary:
        return [text_of(row, one) for row, one in zip(told.tolist(), likely, strict=True)], len(told)
    if len(told) == 1 or not binary:
        frame = frame_of(binary=binary)
        return [frame(row) for row in told.tolist()], len(told)
    return [pack(told)], len(told)


def frame_of(*, binary: bool) -> Callable[[Sequence[float]], Frame]:
    """What makes a frame of one row of predictions."""
    return pack_one if binary else text_of


def text_of(row: Sequence[float], likely: list[Likely] | UnsetType = UNSET) -> str:
    """One row of predictions as JSON text."""
    return encode(message(row, likely)).decode()


def message(row: Sequence[float], likely: list[Likely] | UnsetType = UNSET) -> PredictionMessage:
    """A row of predictions as a message, with the likeliest targets where there are any."""
    t, x, y, sxx, sxy, syy, remaining_s, phase, tail, _ = row
    if x != x:
        return PredictionMessage(t, targets=likely)
    return PredictionMessage(
        t,
        x,
        y,
        Region(sxx, sxy, syy, tail if tail == tail else None) if sxx == sxx else None,
        PHASES[int(phase)],
        remaining_s if remaining_s == remaining_s else None,
        likely,
    )
