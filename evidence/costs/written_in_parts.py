"""A recording written some trials at a time, so that it need not fit into memory."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import msgspec
import pyarrow as pa
import pyarrow.parquet as pq

from pointpred.errors import RecordingError
from pointpred.recording import Recording
from pointpred.recordings.arrow_tables import KEY, open_file
from pointpred.recordings.writing import files_of, samples_table, trial_table, write_together


def write_in_parts(parts: Iterable[Recording], path: str | Path) -> tuple[Path, Path]:
    """Write a recording that comes in parts as a samples and a trials file, a row group of each a part.

    ``path`` as for ``write``, but Parquet only. Every part has other trials, the same name and provenance,
    and the same conditions; skips and notes of all are kept. Parts of about 65,536 events are best: they
    are what ``pointpred score`` reads at once. On a failure no file is left. Raises RecordingError.
    """
    samples, beside = files_of(path)
    if samples.suffix != ".parquet":
        raise RecordingError(f"{samples}: in parts only Parquet is written, expected .parquet")
    with write_together() as part:
        _write(parts, samples, part(samples), part(beside))
    return samples, beside


def _write(parts: Iterable[Recording], path: Path, samples: Path, trials: Path) -> None:
    writers: list[pq.ParquetWriter] = []
    about: dict[str, Any] = {}
    counts = [0, 0]
    skipped: list[list[Any]] = []
    notes: list[str] = []
    try:
        for recording in parts:
            rows, text = trial_table(recording)
            described = text | {"provenance": msgspec.to_builtins(recording.provenance)}
            tables = [samples_table(recording, rows, every=True), rows]
            if not writers:
                about = described
                writers = [
                    pq.ParquetWriter(
                        open_file(file, "wb"), table.schema, compression="zstd", write_page_checksum=True
                    )
                    for file, table in zip((samples, trials), tables, strict=True)
                ]
            if described != about or any(w.schema != t.schema for w, t in zip(writers, tables, strict=True)):
                message = (
                    f"{path}: a part has another name, provenance or other conditions than the first one"
                )
                raise RecordingError(message)
            for i, (writer, table) in enumerate(zip(writers, tables, strict=True)):
                writer.write_table(table, row_group_size=max(table.num_rows, 1))
                counts[i] += table.num_rows
            skipped += [[skip.trial, skip.reason, skip.row, skip.user] for skip in recording.skipped]
            notes += recording.notes
        if not writers:
            raise RecordingError(f"{path}: no part to write, expected at least one")
        more = {"provenance": about["provenance"], "skipped": skipped, "notes": notes}
        for writer, count, header in zip(writers, counts, (more, {}), strict=True):
            header = {"name": about["name"], "text": about["text"], **header, "version": 1, "rows": count}
            encoded = msgspec.json.encode(header, order="sorted")
            writer.add_key_value_metadata({KEY: encoded})
    except (OSError, pa.ArrowException) as error:
        raise RecordingError(f"{path}: cannot be written: {error}") from error
    finally:
        for writer in writers:
            writer.close()
