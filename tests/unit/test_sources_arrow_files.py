"""Arrow is handed nothing of Python's: its threads would ask an interpreter for it that may have ended."""

from __future__ import annotations

import gc
import os
import weakref
from io import BytesIO
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.csv as pacsv
import pyarrow.parquet as pq
import pytest
from msgspec.structs import replace

from pointpred.recordings import read, write
from pointpred.recordings.arrow_tables import in_memory, open_file
from pointpred.recordings.own import RECORDED

ROWS = "user,trial,t_s,x_px,y_px\na,1,0,1,2\na,1,0.01,3,4\n"


def test_bytes_in_memory_outlive_the_file_that_they_were_read_from() -> None:
    file = BytesIO(b"some bytes")
    file.read(4)
    buffer, gone = in_memory(file), weakref.ref(file)
    del file
    gc.collect()
    assert gone() is None
    assert buffer.to_pybytes() == b"some bytes"
    assert in_memory(BytesIO()).size == 0


def test_a_file_that_grows_shorter_while_it_is_read_gives_what_it_had() -> None:
    class Shrunk(BytesIO):
        def seek(self, offset: int, whence: int = 0) -> int:
            return super().seek(offset, whence) + (whence == os.SEEK_END)

    assert in_memory(Shrunk(b"ab")).to_pybytes() == b"ab"


@pytest.mark.parametrize("end", ["csv", "parquet"])
def test_no_reader_and_no_writer_gets_a_python_file(
    end: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    handed: list[Any] = []

    def watched(module: Any, name: str, place: int = 0) -> None:
        kept = getattr(module, name)

        def call(*given: Any, **options: Any) -> Any:
            handed.append(given[place])
            return kept(*given, **options)

        monkeypatch.setattr(module, name, call)

    for name in ("ParquetFile", "read_metadata"):
        watched(pq, name)
    watched(pq, "write_table", 1)
    watched(pacsv, "read_csv")
    watched(pacsv, "write_csv", 1)
    table = tmp_path / os.fsdecode(b"n\xe9 one_samples.csv")
    table.write_text(ROWS)
    recording = replace(read(table), name="one")
    path, _ = write(recording, tmp_path / os.fsdecode(b"n\xe9 two." + end.encode()))
    assert read(path).events.x.tolist() == recording.events.x.tolist() == [1.0, 3.0]
    live = tmp_path / "live_samples.csv"
    live.write_text(f'# pointpred:{{"append":true,"version":1}}\n{",".join(RECORDED)}\na,1,0,1,2,,,0\n')
    read(live)
    assert len(handed) >= 6
    assert {type(file) for file in handed} <= {pa.OSFile, pa.BufferReader}


def test_an_error_of_the_system_keeps_its_number(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        open_file(tmp_path / "none")
