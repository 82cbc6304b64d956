"""What watches a session: its recording in a file, and the transfer function learned from it."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from pathlib import Path

import msgspec
import numpy as np
from msgspec.structs import replace

from pointpred.devices.cursor_paths import CursorPath, PlaceEvent, PositionPath, SurfacePath
from pointpred.errors import EventError, SourceError
from pointpred.protocol.client_messages import Hello, cpi_of, dpi_of
from pointpred.recorder.files import SessionFiles
from pointpred.recorder.writer import Recorder, about_of
from pointpred.recording import Provenance
from pointpred.recordings.own import LIVE
from pointpred.records import EventColumns, Pair, PredictionColumns, prediction_row
from pointpred.transfer import GainCurve, TransferLearner, save_transfer

TOGETHER_S = 0.05
"""Events of so much time go to the recorder together."""
MOST = 1024

CURVE_S = 2.0
"""How often the curve is computed anew: it takes some 30 ms."""
NEEDS_CURSOR = "a transfer function is learnt from counts and the screen's cursor; here only counts are known"
NEEDS_COUNTS = (
    "a transfer function is learnt from counts and the screen's cursor; here only the cursor is known"
)
NEEDS_CPI = "the transfer function is learnt with counts per inch: give --cpi, or answer its question with m"


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

    ``origin`` and ``clock`` say where the positions come from and which clock stamps them; they are asked
    when the first event is written, because the device may not be known before. The rows of each contact of
    an absolute device are marked as a trial: a reader sees where it ends. Assumes that one thread calls it.
    Raises SourceError where the folder cannot be written.
    """

    def __init__(
        self,
        file: Path,
        hello: Hello,
        origin: Callable[[], str],
        clock: Callable[[], str],
        *,
        simulated: bool = False,
    ) -> None:
        provenance = Provenance(LIVE, dpi=dpi_of(hello), cpi=cpi_of(hello), simulated=simulated)
        self.file = file
        self.events = 0
        self._recorder = Recorder(file.parent)
        self._origin, self._clock, self._provenance = origin, clock, provenance
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
        for pair in pairs:
            if isinstance(pair[0], PlaceEvent) and pair[0].begins:
                self._flush()
                self._session.trial("start")
                waiting = self._waiting
            waiting.append(pair)
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
                about = replace(self._provenance, origin=self._origin(), clock=self._clock())
                self._files.set_provenance(about)
            self.events += len(waiting)
            events = EventColumns.of_events(event for event, _ in waiting)
            rows = [prediction_row(prediction, event.t) for event, prediction in waiting]
            self._session.events(events, PredictionColumns(np.array(rows)))


class CurveLearner:
    """Learns from the events of a session (a ``Watcher``); a thread of its own computes the curve."""

    def __init__(self, cpi: float, dpi: float, size: tuple[int, int] | None) -> None:
        self.cpi, self.dpi = cpi, dpi
        self.learner = TransferLearner(cpi=cpi, dpi=dpi, size=size)
        self.curve: GainCurve = self.learner.curve()
        self.unused = 0
        """Events it refused, such as those that only correct a place."""
        self._events = 0

    def take(self, pairs: Sequence[Pair]) -> None:
        """Learn from a batch."""
        for event, _ in pairs:
            try:
                self.learner.update(event)
            except EventError:
                self.unused += 1
        self._events += len(pairs)

    def start(self, stopping: threading.Event, changed: Callable[[GainCurve], None]) -> None:
        """Compute the curve every two seconds in which something came, until ``stopping`` is set."""
        threading.Thread(target=self._run, args=(stopping, changed), name="transfer", daemon=True).start()

    def save(self, path: Path) -> str:
        """Write the function; returns a sentence about it. Raises SourceError where there is none."""
        function = self.learner.identify().function
        if function is None:
            raise SourceError(f"no transfer function to save in {path}: {self.learner.curve().words}")
        save_transfer(path, function, cpi=self.cpi, dpi=self.dpi)
        return f"saved in {path}; 'pointpred live --transfer {path}' uses it"

    def words(self) -> str:
        """The curve in a line."""
        curve = self.curve
        best = next((one for one in curve.compared if one.kind == curve.closest), None)
        like = f"; closest: {best.kind}, off by {100 * best.largest:.1f} % at most" if best else ""
        return curve.words + like

    def _run(self, stopping: threading.Event, changed: Callable[[GainCurve], None]) -> None:
        events = 0
        while not stopping.wait(CURVE_S):
            if self._events != events:
                events = self._events
                self.curve = self.learner.curve()
                changed(self.curve)


def curve_learner(path: CursorPath, cpi: float | None, dpi: float) -> CurveLearner | str:
    """A learner, or why this path does not allow one."""
    if isinstance(path, SurfacePath):
        if path.counts is None:
            return NEEDS_COUNTS
        path = path.counts
    if path.space != "screen":
        return NEEDS_CURSOR
    if isinstance(path, PositionPath) and not path.counts:
        return NEEDS_COUNTS
    if cpi is None:
        return NEEDS_CPI
    cursor = getattr(path, "cursor", None)
    return CurveLearner(cpi, dpi, getattr(cursor, "size", None))
