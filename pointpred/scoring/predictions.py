"""Predictions made elsewhere, as a table from R or PyTorch, in the place of a predictor.

A row belongs to one event of a recorded trial. That it was made from no later events cannot be checked.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Self

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv as pacsv
import pyarrow.parquet as pq
from numpy.typing import NDArray

from pointpred.columns import Frame, is_frame
from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.errors import RecordingError
from pointpred.pipeline import Pipeline
from pointpred.predictors import HoldPredictor
from pointpred.recording import Recording
from pointpred.records import PREDICTION_FIELDS, ROUNDING_S, FloatArray, PredictionColumns, PredictionRow
from pointpred.scoring.trials import GOOD, ONSET, STOP, VERDICT, Prepared, cuts_of

Key = tuple[str, str, str]
"""Set ("" where the table does not say it), user, trial."""
WORDS = ("dataset", "user", "trial")
ABSENT = ["", "NA", "NaN", "nan", "NULL", "null"]
BALLISTIC = 1.0
NUMBERS = tuple(field for field in PREDICTION_FIELDS if field.name != "phase")
NEEDED = ("t", "x", "y")


class PredictedElsewhere(Pipeline):
    """A table of predictions in the place of a pipeline: scoring takes its rows, and nothing is computed."""

    def __init__(self, name: str, file: str, rows: Mapping[Key, FloatArray]) -> None:
        super().__init__(name, HomogeneousDifferentiator(), _Stated())
        self.file, self.rows = file, dict(rows)

    def fresh(self) -> Self:
        """Itself: it remembers nothing."""
        return self

    def __copy__(self) -> Self:
        return self

    def _of(self, dataset: str) -> dict[tuple[str, str], FloatArray]:
        """The rows of a set, by user and trial."""
        return {key[1:]: rows for key, rows in self.rows.items() if key[0] in ("", dataset)}

    def check(self, recording: Recording) -> tuple[str, ...]:
        """What to note of a recording; raises RecordingError for rows that belong to no event of it."""
        own, name = self._of(recording.name), f"{self.file}, set {recording.name}"
        there = Counter((one.user, one.trial) for one in recording.trials)
        skipped = {(one.user, one.trial) for one in recording.skipped}
        if unknown := [key for key in own if key not in there and key not in skipped]:
            such = " and ".join(map(repr, list(there)[:2]))
            raise RecordingError(
                f"{name}: {len(unknown)} of {len(own)} trials are not in the recording, the first is user, "
                f"trial {unknown[0]!r}; there are such as {such}. With several sets a column 'dataset' says "
                "which one a row is of"
            )
        if not own:
            raise RecordingError(f"{name}: no row is of this set")
        scored, cuts = 0, cuts_of(recording)
        for k, one in enumerate(recording.trials):
            key = (one.user, one.trial)
            if key not in own:
                continue
            if there[key] > 1:
                raise RecordingError(f"{name}: the recording has user, trial {key!r} more than once")
            places = self._matched(name, key, recording.rows(k).t, own[key][:, 0])
            if cuts[k, VERDICT] == GOOD:
                onset, stop = (int(cuts[k, at] - recording.offsets[k]) for at in (ONSET, STOP))
                scored += int(np.count_nonzero((places >= onset) & (places < stop)))
        notes = []
        if unanswered := sum(count for key, count in there.items() if key not in own):
            notes.append(
                f"{self.name}: {unanswered} of {len(recording.trials)} trials have no row in {self.file}"
            )
        if outside := sum(map(len, own.values())) - scored:
            notes.append(
                f"{self.name}: {outside} of {outside + scored} rows are not scored: they lie before the "
                "onset of their movement or after its end, or their trial cannot be scored. Predictions made "
                "from events before the onset know more than a predictor, which is reset there"
            )
        if others := sum(len(rows) for key, rows in self.rows.items() if key[0] not in ("", recording.name)):
            notes.append(f"{self.name}: {others} rows of {self.file} are of other sets")
        return tuple(notes)

    def _matched(self, name: str, key: tuple[str, str], t: FloatArray, rows: FloatArray) -> NDArray[np.int64]:
        """The event of each row; raises RecordingError where one has none."""
        places = _places(t, rows)
        wrong = np.flatnonzero(places < 0)
        if wrong.size:
            at = float(rows[wrong[0]])
            near = float(t[np.abs(t - at).argmin()]) if len(t) else float("nan")
            taken = abs(near - at) <= ROUNDING_S * 1.001
            where = "which has its row already" if taken else f"where the nearest event is at {near!r} s"
            raise RecordingError(
                f"{name}: {len(wrong)} of {len(rows)} rows of user, trial {key!r} have no event of their "
                "own, "
                f"the first at t = {at!r} s, {where}; times are those of the recording, and an event has one "
                "row at most"
            )
        return places

    def answers(self, prepared: Prepared, first: int, stop: int) -> PredictionColumns:
        """The rows beside the events of trials ``first`` up to ``stop``, empty where an event has none."""
        own = self._of(prepared.name)
        events = prepared.events.rows(int(prepared.offsets[first]), int(prepared.offsets[stop]))
        table = np.full((len(events), len(PredictionRow._fields)), np.nan)
        table[:, 0], table[:, 7] = events.t, BALLISTIC
        base = int(prepared.offsets[first])
        for k in range(first, stop):
            trial = prepared.trials[k].trial
            rows = own.get((trial.user, trial.trial))
            if rows is None:
                continue
            begin = int(prepared.offsets[k]) - base
            places = _places(prepared.rows(k).t, rows[:, 0])
            scored = places >= 0  # the others lie before the onset or after the click
            table[begin + places[scored], 1:] = rows[scored, 1:]
        return PredictionColumns(table)


class _Stated(HoldPredictor):
    """Stands where a pipeline has its predictor."""

    claims_time = True


def predicted(name: str, table: str | Path | Frame) -> PredictedElsewhere:
    """A table of predictions as a predictor of this name, for ``score``.

    ``table``: a CSV or Parquet file or a ``pandas.DataFrame``, with columns ``user, trial, t, x, y``, and
    optionally ``sxx, sxy, syy`` (px squared, all three), ``tail, remaining_s, remaining_spread`` and
    ``dataset``. Names with units do as well, as ``t_s, x_px, y_px``; other columns are left aside. A row
    without x and y says that nothing is predicted, as no row does. Raises RecordingError naming the column or
    the row.
    """
    file = "the DataFrame" if not isinstance(table, str | Path) else str(table)
    columns = _columns(table, file)
    names = {}
    for field in NUMBERS:
        found = [one for one in (field.column, field.name) if one in columns.column_names]
        if found:
            names[field.name] = found[0]
        elif field.name in NEEDED:
            known = ", ".join(columns.column_names)
            raise RecordingError(f"{file}: no column {field.name} or {field.column}; it has {known}")
    for word in WORDS[1:]:
        if word not in columns.column_names:
            raise RecordingError(f"{file}: no column {word}; it has {', '.join(columns.column_names)}")
    rows = np.full((columns.num_rows, len(PredictionRow._fields)), np.nan)
    rows[:, 7] = BALLISTIC
    for word, column in names.items():
        rows[:, PredictionRow._fields.index(word)] = _numbers(columns[column], column, file)
    _check_rows(rows, file)
    keys = [_words(columns[word]) if word in columns.column_names else [""] * len(rows) for word in WORDS]
    parts: dict[Key, list[int]] = {}
    for place, key in enumerate(zip(*keys, strict=True)):
        parts.setdefault(key, []).append(place)
    ordered = {key: rows[places] for key, places in parts.items()}
    return PredictedElsewhere(
        name, file, {key: part[np.argsort(part[:, 0], kind="stable")] for key, part in ordered.items()}
    )


def _columns(table: str | Path | Frame, file: str) -> Any:
    """The table in Arrow; raises RecordingError."""
    try:
        if is_frame(table):
            return pa.Table.from_pandas(table, preserve_index=False)
        assert isinstance(table, str | Path)
        if Path(table).suffix == ".parquet":
            return pq.read_table(table)
        types = dict.fromkeys(WORDS, pa.string())
        options = pacsv.ConvertOptions(column_types=types, null_values=ABSENT, strings_can_be_null=True)
        return pacsv.read_csv(table, convert_options=options)
    except (pa.ArrowException, OSError, ValueError, TypeError) as error:
        raise RecordingError(f"{file}: cannot be read as a table: {error}") from error


def _numbers(column: Any, name: str, file: str) -> FloatArray:
    try:
        values: FloatArray = column.cast(pa.float64()).to_numpy()
    except (pa.ArrowException, ValueError) as error:
        raise RecordingError(f"{file}: the column {name} must hold numbers: {error}") from error
    return values


def _words(column: Any) -> list[str]:
    """Cells as words, whole numbers without a point, as a recording has its users and trials."""
    if pa.types.is_dictionary(column.type):
        column = column.cast(column.type.value_type)
    if pa.types.is_floating(column.type):
        column = pc.cast(column, pa.int64(), safe=True)
    return [str(cell) for cell in column.cast(pa.string()).to_pylist()]


def _check_rows(rows: FloatArray, file: str) -> None:
    """Raise RecordingError for the first row that is no prediction."""
    there = ~np.isnan(rows[:, 1:3])
    region = ~np.isnan(rows[:, 3:6])
    sxx, sxy, syy = np.nan_to_num(rows[:, 3:6]).T
    faults = {
        "needs a time": ~np.isfinite(rows[:, 0]),
        "holds an infinite number": np.isinf(rows).any(axis=1),
        "has only one of x and y": there.any(axis=1) & ~there.all(axis=1),
        "has only some of sxx, sxy and syy": region.any(axis=1) & ~region.all(axis=1),
        "has a covariance that is none": (sxx < 0.0) | (syy < 0.0) | (sxx * syy < sxy * sxy * (1.0 - 1e-9)),
        "has a negative time left": rows[:, 6] < 0.0,
    }
    for words, wrong in faults.items():
        if wrong.any():
            row = int(np.flatnonzero(wrong)[0])
            values = ", ".join(f"{value:g}" for value in rows[row, :7])
            raise RecordingError(f"{file}: data row {row} (counted from 0) {words}: t, x, y, ... = {values}")


def _places(events: FloatArray, t: FloatArray) -> NDArray[np.int64]:
    """The event of each row, both by times that ascend and are equal within a microsecond; -1: none.

    Of equal times the k-th row belongs to the k-th event.
    """
    equal = np.arange(len(t)) - np.searchsorted(t, t, side="left")
    places = np.searchsorted(events, t - ROUNDING_S, side="left") + equal
    inside = places < len(events)
    near = np.abs(events[np.minimum(places, len(events) - 1)] - t) <= ROUNDING_S * 1.001
    return np.where(inside & near, places, -1).astype(np.int64)
