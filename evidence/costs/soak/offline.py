"""What a session answered and what was recorded of it, compared with the same events offline, bit for bit."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv as pacsv

from pointpred import EventColumns, build, run
from pointpred.protocol.frames import pack_predictions, row_of_prediction, unpack_predictions
from pointpred.protocol.server_messages import PredictionMessage
from pointpred.recorder.files import PREDICTED
from pointpred.recordings.arrow_tables import EVENT_COLUMNS
from pointpred.records import PHASES, FloatArray

CPI, DPI = 800.0, 96.0
"""The device and the screen that every client of the soak names."""
ROWS_AT_ONCE = 100_000
PREDICTION_NUMBERS, EVENT_NUMBERS = 9, 6
"""How many numbers of a prediction and of an event are stored."""


class OfflineRun:
    """The events of one session, in order, and every answer to them.

    ``file`` names two files of raw floats, the events and the predictions that an offline run makes of them:
    a session of an hour does not fit in memory.
    """

    def __init__(self, predictor: str, file: Path) -> None:
        self.answers = 0
        self.wrong: list[str] = []
        self.file = file
        self.events = 0
        self._pipeline = build(predictor, cpi=CPI, dpi=DPI)
        self._waiting: list[FloatArray] = []
        self._answers: list[FloatArray] = []
        self._times = np.empty(0)
        self._expected = np.empty((0, PREDICTION_NUMBERS))
        self._last_answer = -np.inf
        self._files = [path.open("wb") for path in paths(file)]

    def sent(self, table: FloatArray) -> None:
        """Take in events that were sent."""
        self.events += len(table)
        self._waiting.append(table)

    def answered(self, frame: str | bytes) -> float:
        """Take in a frame of predictions; returns the time of the newest."""
        if isinstance(frame, bytes):
            rows = np.array(unpack_predictions(frame))[:, :PREDICTION_NUMBERS]
        else:
            message = msgspec.json.decode(frame, type=PredictionMessage)
            rows = np.array([row_of_prediction(message)[:PREDICTION_NUMBERS]])
        self._answers.append(rows)
        return float(rows[-1, 0])

    def compare(self) -> None:
        """Predict what was sent since the last call, and compare what was answered."""
        if self._waiting:
            table = np.concatenate(self._waiting)
            self._waiting.clear()
            predictions = run(self._pipeline, EventColumns(table)).table
            for file, rows in zip(self._files, (table, predictions[:, :PREDICTION_NUMBERS]), strict=True):
                file.write(np.ascontiguousarray(rows).tobytes())
            as_sent = np.array(unpack_predictions(pack_predictions(predictions)))[:, :PREDICTION_NUMBERS]
            self._times = np.concatenate([self._times, table[:, 0]])
            self._expected = np.concatenate([self._expected, as_sent])
        if not self._answers:
            return
        answers = np.concatenate(self._answers)
        self._answers.clear()
        self.answers += len(answers)
        times = np.concatenate([[self._last_answer], answers[:, 0]])
        if not (np.diff(times) > 0).all():
            self.wrong.append("answers out of order")
        at = np.searchsorted(self._times, answers[:, 0])
        if at[-1] >= len(self._times) or not same(answers, self._expected[at]):
            self.wrong.append(f"answers between {answers[0, 0]} and {answers[-1, 0]} s differ")
        self._last_answer = float(answers[-1, 0])
        self._times, self._expected = self._times[at[-1] :], self._expected[at[-1] :]

    @property
    def complete(self) -> bool:
        """Whether the newest event is answered."""
        return not self._waiting and (not self.events or len(self._times) == 1)

    def close(self) -> None:
        """Compare the rest, and close the files."""
        self.compare()
        for file in self._files:
            file.close()


def paths(file: Path) -> tuple[Path, Path]:
    """The files of events and predictions of an offline run."""
    return file.with_suffix(".events"), file.with_suffix(".predictions")


def same(one: FloatArray, other: FloatArray) -> bool:
    """Whether two tables hold the same numbers, bit for bit, but for the sign of a NaN."""
    return one.shape == other.shape and np.array_equal(one, other, equal_nan=True)


def difference(folder: Path, session: str, file: Path, *, whole: bool) -> str | None:
    """How a recorded session differs from what was sent and predicted offline; ``None`` where it does not.

    ``whole``: every event must be there; otherwise those up to some event, because the connection was cut.
    """
    events, predictions = paths(file)
    count = events.stat().st_size // (8 * EVENT_NUMBERS)
    parts = (("samples", events, EVENT_NUMBERS), ("predictions", predictions, PREDICTION_NUMBERS))
    for part, path, width in parts:
        recordings = list(folder.glob(f"*-{session}_{part}.csv"))
        if not recordings:
            if whole and count:
                return f"{part} of {session} are missing"
            continue
        rows = 0
        try:
            with path.open("rb") as expected_rows:
                for table in _tables(recordings[0], part):
                    expected = np.frombuffer(expected_rows.read(table.nbytes)).reshape(-1, width)
                    if not same(table, expected):
                        return f"{part} of {session} differ after row {rows}"
                    rows += len(table)
        except pa.ArrowInvalid as error:
            return f"{part} of {session} after row {rows}: {error}"
        if whole and rows != count:
            return f"{part} of {session}: {rows} of {count} rows are recorded"
    return None


def _tables(file: Path, part: str) -> Iterator[FloatArray]:
    """The numbers of a recorded file, a block at a time."""
    columns = EVENT_COLUMNS if part == "samples" else PREDICTED
    options = pacsv.ReadOptions(skip_rows=1 if part == "samples" else 0, block_size=1 << 22)
    kinds = {name: pa.string() if name == "phase" else pa.float64() for name in columns}
    conversion = pacsv.ConvertOptions(include_columns=list(columns), column_types=kinds)
    with pacsv.open_csv(file, options, convert_options=conversion) as reader:
        for batch in reader:
            yield np.column_stack([_numbers(column) for column in batch.columns])


def _numbers(column: pa.Array) -> FloatArray:
    """A column as floats, NaN where a cell is empty; a phase as its code."""
    if pa.types.is_string(column.type):
        column = pc.index_in(column, pa.array(PHASES))
    values: FloatArray = column.cast("double").to_numpy(zero_copy_only=False)
    return values
