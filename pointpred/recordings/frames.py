"""A DataFrame of pandas as a file, so that it is read in the way of every table."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from pointpred.errors import PointpredError, RecordingError
from pointpred.records import EVENT_FIELDS

NAME = "DataFrame"
"""What messages and the recording call it."""


@contextmanager
def file_of_frame(frame: Any) -> Iterator[Path]:
    """A Parquet file of the columns and named indices, for as long as it is read; errors name no file.

    ``begin`` is left out: it says where trials begin, which their names do. Raises RecordingError for cells
    that no table holds.
    """
    with TemporaryDirectory() as folder:
        file = Path(folder, f"{NAME}.parquet")
        try:
            named = [name for name in frame.index.names if name is not None]
            plain = (frame.reset_index(named) if named else frame).drop(columns="begin", errors="ignore")
            pq.write_table(pa.Table.from_pandas(plain, preserve_index=False), file)
        except (pa.ArrowException, TypeError, ValueError) as error:
            raise RecordingError(f"{NAME}: {error}") from error
        try:
            yield file
        except PointpredError as error:
            error.args = (str(error).replace(str(file), NAME),)
            raise


def our_columns(frame: Any) -> dict[str, str | int] | None:
    """Columns that are called as in pointpred's own samples, beside which conditions may stand here."""
    named = {field.name: field.column for field in EVENT_FIELDS if field.column in frame.columns}
    named.pop("t", None)  # where t, x and y are all named nothing else is guessed
    return dict(named) or None
