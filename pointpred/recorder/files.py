"""The files of one recorded session: rows as CSV, appended, each file made when its first row comes."""

from __future__ import annotations

import csv
import errno
import os
from collections.abc import Callable, Sequence
from io import StringIO
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.csv as pacsv

from pointpred.protocol.client_messages import Conditions
from pointpred.recordings.own import MARK, RECORDED, RECORDED_TRIALS
from pointpred.records import EVENT_FIELDS, PHASES, PREDICTION_FIELDS, FloatArray

COLUMNS = {
    "samples": RECORDED,
    "trials": RECORDED_TRIALS,
    "predictions": (*(field.column for field in PREDICTION_FIELDS), "predictor", "parameters"),
}
FLAGS = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_APPEND
FLAGS |= getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)  # the latter on Windows: LF stays LF

POOL = pa.system_memory_pool()
"""Arrow's own allocator keeps some 20 MB, now more, now less, where these rows take 3 MB at a time."""

Words = Sequence[tuple[str | None, int]]
"""Words, and in how many consecutive rows each is; ``None`` is an empty cell."""
Write = Callable[[int, bytes], int]


class SessionFiles:
    """Appends to up to three files of one name; not safe for threads.

    Assumes that nobody else writes to them. Every method may raise OSError: what was written before it stays,
    at worst with an incomplete last line, which the reader skips.
    """

    def __init__(self, folder: Path, name: str, about: dict[str, Any], write: Write = os.write) -> None:
        self.folder = folder
        self.name = name
        self.about = about
        self.conditions: Conditions | None = None
        """What the first trial was, once it has ended: the names are columns of all."""
        self.rows = 0
        """Complete rows in the files."""
        self._write = write
        self._opened: dict[str, int] = {}
        self._dirty: set[str] = set()

    def append(self, part: str, rows: bytes) -> None:
        """Append rows to one of the files; the file begins with its header."""
        head = b""
        if part not in self._opened:
            self._check_exists()
            head = self._head(part)
            self._opened[part] = os.open(self.path_of(part), FLAGS, 0o600)
            self._sync_folder()
        self._dirty.add(part)
        whole, left = head + rows, memoryview(head + rows)
        try:
            while left:
                left = left[self._write(self._opened[part], bytes(left)) :]
        finally:
            self.rows += whole.count(b"\n", len(head), max(len(head), len(whole) - len(left)))

    def path_of(self, part: str) -> Path:
        """Where a part is written."""
        return self.folder / f"{self.name}_{part}.csv"

    def sync(self) -> None:
        """Sync the files, so that they survive a loss of power."""
        if self._dirty:
            self._check_exists()
        while self._dirty:
            os.fsync(self._opened[self._dirty.pop()])

    def close(self) -> None:
        """Close every file, whatever happened before; raises the error of the first that fails to close."""
        opened, self._opened = self._opened, {}
        self._dirty.clear()
        errors: list[OSError] = []
        for descriptor in opened.values():
            try:
                os.close(descriptor)
            except OSError as error:
                errors.append(error)
        if errors:
            raise errors[0]

    def _check_exists(self) -> None:
        """Raise FileNotFoundError where a file was deleted meanwhile: it is not begun again."""
        if any(os.fstat(descriptor).st_nlink == 0 for descriptor in self._opened.values()):
            raise FileNotFoundError(errno.ENOENT, "its files were deleted")

    def _head(self, part: str) -> bytes:
        conditions = self.conditions or {}
        columns = _line([*COLUMNS[part], *(conditions if part == "trials" else ())])
        if part == "predictions":
            return columns
        text = [name for name, value in conditions.items() if isinstance(value, str)]
        header = {"version": 1, "append": True, "name": self.name} | (
            self.about if part == "samples" else {"text": text}
        )
        return MARK + msgspec.json.encode(header, order="sorted") + b"\n" + columns

    def _sync_folder(self) -> None:
        if not hasattr(os, "O_DIRECTORY"):  # Windows opens no folder, and needs no sync of it
            return
        folder = os.open(self.folder, os.O_RDONLY | os.O_DIRECTORY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)


def sample_rows(user: str, trials: Words, table: FloatArray) -> bytes:
    """Events as rows of the samples file."""
    return _csv(
        [_repeated([(user, len(table))]), _repeated(trials), *(_numbers(column) for column in table.T)]
    )


def prediction_rows(predictors: Words, parameters: Words, table: FloatArray) -> bytes:
    """Predictions as rows of the predictions file; empty cells where nothing was justified."""
    names = [field.name for field in PREDICTION_FIELDS]
    codes = table[:, names.index("phase")]
    phases = pa.DictionaryArray.from_arrays(
        pa.array(np.nan_to_num(codes).astype(np.int8), mask=np.isnan(codes), memory_pool=POOL),
        pa.array(PHASES, memory_pool=POOL),
    )
    phases = phases.cast(pa.string(), memory_pool=POOL)
    columns = [
        phases if name == "phase" else _numbers(column) for name, column in zip(names, table.T, strict=True)
    ]
    return _csv([*columns, _repeated(predictors), _repeated(parameters)])


def warm_rows() -> None:
    """Make rows once: the first call loads a library, and nothing would be written for half a second."""
    sample_rows("", [("", 1)], np.zeros((1, len(EVENT_FIELDS))))
    prediction_rows([("", 1)], [(None, 1)], np.zeros((1, len(PREDICTION_FIELDS))))


def trial_row(
    user: str,
    trial: str,
    target: tuple[float, float, float] | None,
    samples: int,
    conditions: Sequence[str | float | None] = (),
) -> bytes:
    """One row of the trials file; ``conditions`` in the order of their columns."""
    return _line([user, trial, *(target or (None, None, None)), samples, *conditions])


def _line(cells: Sequence[str | float | None]) -> bytes:
    """Cells as a line of CSV; ``None`` is an empty one."""
    out = StringIO()
    csv.writer(out, lineterminator="\n").writerow(cells)
    return out.getvalue().encode()


def _numbers(column: FloatArray) -> Any:
    values = np.ascontiguousarray(column)
    return pa.array(values, mask=np.isnan(values), memory_pool=POOL)


def _repeated(words: Words) -> Any:
    """Each word in as many rows as it is in."""
    distinct = [word for word, _ in words]
    counts = [count for _, count in words]
    index = np.repeat(np.arange(len(distinct), dtype=np.int32), counts)
    words_array = pa.array(distinct, pa.string(), memory_pool=POOL)
    return pa.DictionaryArray.from_arrays(index, words_array).cast(pa.string(), memory_pool=POOL)


def _csv(columns: list[Any]) -> bytes:
    table = pa.table(columns, names=[str(place) for place in range(len(columns))])
    out = pa.BufferOutputStream(POOL)
    pacsv.write_csv(table, out, pacsv.WriteOptions(include_header=False), POOL)
    rows: bytes = out.getvalue().to_pybytes()
    return rows
