"""Recording a session into a file."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from pathlib import Path

import msgspec
import numpy as np
from msgspec.structs import replace

from pointpred.protocol.client_messages import Hello, cpi_of, dpi_of
from pointpred.recorder.files import SessionFiles
from pointpred.recorder.writer import Recorder, about_of
from pointpred.recording import Provenance
from pointpred.recordings.appended import LIVE
from pointpred.records import EventColumns, Pair, PredictionColumns, prediction_row

TOGETHER_S = 0.05
"""Events of so much time go to the recorder together."""
MOST = 1024


class RecordingFiles(SessionFiles):
    """The files of one recording whose samples are where the user said."""

    def __init__(self, file: Path, origin: Provenance) -> None:
        name = file.stem.removesuffix("_samples") or file.stem
        super().__init__(file.parent, name, about_of(origin, datetime.now(UTC)))
        self._file = file

    def set_provenance(self, origin: Provenance) -> None:
        """Say where the events come from; before the first is written."""
        self.about["provenance"] = msgspec.to_builtins(origin)

    def path_of(self, part: str) -> Path:
        """The file itself for the samples, one beside it for every other part."""
        return self._file if part == "samples" else self._file.with_name(f"{self.name}_{part}.csv")


class LiveRecording:
    """Has the pairs of a session written by the recorder's thread; a ``Watcher``.

    ``clock`` says which clock stamps the events; it is asked when the first of them is written, because the
    device may not be known before. Assumes that one thread calls it. Raises SourceError where the folder
    cannot be written.
    """

    def __init__(
        self, file: Path, hello: Hello, origin: str, clock: Callable[[], str], *, simulated: bool = False
    ) -> None:
        provenance = Provenance(
            LIVE, origin=origin, dpi=dpi_of(hello), cpi=cpi_of(hello), simulated=simulated
        )
        self.file = file
        self.events = 0
        self._recorder = Recorder(file.parent)
        self._clock, self._provenance = clock, provenance
        self._files = RecordingFiles(file, provenance)
        self._session = self._recorder.record(self._files, hello)
        self._waiting: list[Pair] = []

    @property
    def lost(self) -> int:
        """Events that are not in the file."""
        return self._session.lost

    @property
    def failed(self) -> bool:
        """Whether writing has ended with an error, which is logged."""
        return self._session.failed

    def take(self, pairs: Sequence[Pair]) -> None:
        """Record; an empty sequence flushes pending events."""
        waiting = self._waiting
        waiting.extend(pairs)
        if waiting and (
            not pairs or len(waiting) >= MOST or waiting[-1][0].t - waiting[0][0].t >= TOGETHER_S
        ):
            self._flush()

    def close(self) -> bool:
        """Write pending events; False if that took too long or failed."""
        self._flush()
        self._session.close()
        return self._recorder.close() and not self.failed

    def _flush(self) -> None:
        waiting, self._waiting = self._waiting, []
        if waiting:
            if not self.events:
                self._files.set_provenance(replace(self._provenance, clock=self._clock()))
            self.events += len(waiting)
            events = EventColumns.of_events(event for event, _ in waiting)
            rows = [prediction_row(prediction, event.t) for event, prediction in waiting]
            self._session.events(events, PredictionColumns(np.array(rows)))
