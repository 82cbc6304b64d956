"""Damaged files of every format: they parse or raise RecordingError, never anything else."""

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred.errors import RecordingError
from pointpred.recordings import read, read_any, write
from tests.property.damage import Edits, damaged, edits

Found = TypeVar("Found")
DATA = Path(__file__).parents[1] / "data" / "sources"
EXAMPLES = sorted(file for file in DATA.rglob("*") if file.is_file())


def attempt(reader: Callable[[], Found]) -> tuple[Found | None, str]:
    """What a reader gives, or why it refuses; any other exception fails the test."""
    try:
        return reader(), ""
    except RecordingError as error:
        return None, str(error)


def parses_or_refuses(path: Path) -> None:
    found, refusal = attempt(lambda: read_any(path))
    if found is None:
        assert path.name in refusal
        return
    for recording in found:
        table = recording.events.table
        assert len(recording.trials) + 1 == len(recording.offsets)
        assert recording.offsets[-1] == len(table)
        assert np.isfinite(table[:, [0, 1, 2, 5]]).all()
        assert all(size >= 2 for size in np.diff(recording.offsets))
        for index in range(len(recording.trials)):
            assert (np.diff(recording.rows(index).t) >= 0).all()


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda file: file.name)
@settings(deadline=None, max_examples=60)
@given(changes=edits(1))
def test_damaged_examples(example: Path, changes: Edits) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / example.name
        path.write_bytes(damaged(example.read_bytes(), changes))
        parses_or_refuses(path)


@pytest.mark.parametrize("extension", ["parquet", "csv"])
@settings(deadline=None, max_examples=80)
@given(changes=edits(1), trials=st.booleans())
def test_damaged_own_files(extension: str, changes: Edits, trials: bool) -> None:
    with tempfile.TemporaryDirectory() as folder:
        files = write(read(DATA / "pair_samples.csv"), Path(folder) / f"pair.{extension}")
        victim = files[1] if trials else files[0]
        victim.write_bytes(damaged(victim.read_bytes(), changes))
        recording, refusal = attempt(lambda: read(files[0]))
        if recording is None:
            assert victim.name in refusal
        else:
            assert len(recording.trials) + len(recording.skipped) >= 1
