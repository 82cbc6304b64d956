"""Recordings for which memory runs out, wherever that happens: too large, and not damaged."""

from __future__ import annotations

import io
import os
import subprocess
import sys

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

LITTLE_MEMORY = """
import resource, sys
import pyarrow
from pointpred_server.uploads import process
from pointpred_server.uploads.answers import answer

pyarrow.set_cpu_count(1)
pyarrow.set_io_thread_count(1)
small, large = (sys.stdin.buffer.read(int(size)) for size in sys.argv[1:])
outcome, _ = answer(process.Order("open", len(small), (), {}), small)
assert outcome.status == 200  # what is loaded late is there, and Arrow's two threads
for size in range(1, 26, 6):
    process.MEMORY_BYTES = size * 2**20
    process._bound_memory()
    outcome, response = answer(process.Order("open", len(large), (), {}), large)
    resource.setrlimit(resource.RLIMIT_DATA, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    print(size, outcome.status, outcome.exhausted, response)
"""


@pytest.mark.parametrize(
    "names", [("user", "trial", "t_s", "x_px", "y_px"), ("user", "trial", "t", "x", "y")]
)
def test_wherever_memory_runs_out_the_recording_is_too_large_and_not_damaged(names: tuple[str, ...]) -> None:
    def moving(rows: int) -> bytes:
        t = np.arange(rows) / 1000.0
        file = io.BytesIO()
        values = [["ann"] * rows, ["1"] * rows, t, 50.0 * t, 0.0 * t]
        pq.write_table(pa.table(dict(zip(names, values, strict=True))), file)
        return file.getvalue()

    small, large = moving(100), moving(400_000)
    done = subprocess.run(
        [sys.executable, "-c", LITTLE_MEMORY, str(len(small)), str(len(large))],
        input=small + large,
        capture_output=True,
        env=os.environ | {"ARROW_DEFAULT_MEMORY_POOL": "system"},  # as UploadProcess starts it
        check=False,
    )
    lines = done.stdout.decode().splitlines()
    assert len(lines) == 5, done.stderr
    for line in lines:
        assert "413 True" in line
        assert "too_large" in line
