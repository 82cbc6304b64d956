"""Predictions as a stream of Lab Streaming Layer, for recorders and for programs beside this one."""

from __future__ import annotations

import uuid
from collections.abc import Sequence

import numpy as np

from pointpred.devices.lsl import ahead_s, library
from pointpred.devices.source import DeviceSource
from pointpred.records import PHASES, Pair, Prediction, PredictionRow, prediction_row

NAME, KIND = "pointpred", "Prediction"
CHANNELS = {
    "t": "s",
    "x": "px",
    "y": "px",
    "sxx": "px2",
    "sxy": "px2",
    "syy": "px2",
    "tail": "1",
    "remaining_s": "s",
    "phase": "code",
}
"""The channels of a sample, with units."""


class LslOutlet:
    """A stream that others on the network may read: a ``Watcher`` that sends each prediction with its event.

    A sample has the channels of ``CHANNELS``: the event's time ``t`` on the source's clock, and the rest of
    its prediction, NaN where nothing was justified or is not known. ``phase`` counts the words of ``phases``
    in the description. The stamp is the time of the event where the source counts on this computer's clock,
    else the time of sending. The description says which clock ``t`` is on (``clock/source``), what leads from
    ``t`` to the stamp where that is fixed (``clock/offset_s``), and for an event that came by a stream itself
    what its first stamps were corrected by (``clock/correction_s``). Assumes that one thread calls ``take``.
    Memory: what Lab Streaming Layer keeps for readers.
    Raises MissingExtraError and SourceError.
    """

    def __init__(self, predictor: str, source: DeviceSource) -> None:
        lsl = library()
        self._source, self._now = source, lsl.local_clock
        self._ahead_s = ahead_s(lsl)
        about = lsl.StreamInfo(
            NAME, KIND, len(CHANNELS), lsl.IRREGULAR_RATE, lsl.cf_double64, f"{NAME}-{uuid.uuid4().hex}"
        )
        about.set_channel_labels(list(CHANNELS))
        about.set_channel_units(list(CHANNELS.values()))
        described = about.desc()
        described.append_child_value("predictor", predictor)
        described.append_child_value("phases", " ".join(PHASES))
        clock = described.append_child("clock")
        clock.append_child_value("source", source.clock)
        if self._dated:
            clock.append_child_value("offset_s", repr(-self._ahead_s))
        clock.append_child_value("correction_s", repr(float(getattr(source, "offset_s", 0.0))))
        self._outlet = lsl.StreamOutlet(about)

    @property
    def _dated(self) -> bool:
        """Whether the times of events are those of this computer's clock; a recording's are its own."""
        return "monotonic" in self._source.clock

    def take(self, pairs: Sequence[Pair]) -> None:
        """Send what came."""
        if pairs:
            rows = np.array([_sample(event.t, one) for event, one in pairs])
            stamps = rows[:, 0] - self._ahead_s if self._dated else np.full(len(rows), self._now())
            self._outlet.push_chunk(rows, stamps.tolist())


def _sample(t: float, prediction: Prediction | None) -> list[float]:
    row = PredictionRow(*prediction_row(prediction, t))
    return [getattr(row, name) for name in CHANNELS]
