"""Memory -> file -> memory is exact, in Parquet and CSV, for any recording that can be scored."""

import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings import read, write
from pointpred.records import EventColumns

finite = st.floats(allow_nan=False, allow_infinity=False, width=64)
words = st.text(st.characters(blacklist_categories=["Cs"], blacklist_characters="\x00\r"), max_size=8)
places = st.floats(-1e9, 1e9)
counts = st.one_of(st.just((None, None)), st.tuples(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6)))
samples = st.builds(
    lambda t, x, y, pair, buttons: (t, x, y, *pair, buttons),
    *(st.floats(0, 10), places, places, counts, st.integers(0, 65535)),
)
unknown = st.one_of(st.just(float("nan")), finite)


@st.composite
def recordings(draw: st.DrawFn) -> Recording:
    keys = draw(st.lists(st.tuples(words, words), max_size=4, unique=True))
    kinds = draw(
        st.dictionaries(st.sampled_from(["device", "block", "A", "x y", "ü"]), st.booleans(), max_size=3)
    )
    parts, trials = [], []
    for user, name in keys:
        cells = draw(st.lists(samples, min_size=2, max_size=6))
        none = float("nan")
        table = np.array([[none if cell is None else cell for cell in row] for row in cells], dtype=float)
        table[:, 0] = np.cumsum(table[:, 0])
        table[-1, 3:5] = 1.0, -1.0  # something moves
        parts.append(EventColumns(table))
        condition = {
            key: draw(words if text else finite) for key, text in kinds.items() if draw(st.booleans())
        }
        width = draw(st.one_of(st.just(float("nan")), st.floats(1e-300, 1e300)))
        clean = draw(st.sampled_from([True, False, None]))
        trials.append(Trial(user, name, draw(unknown), draw(unknown), width, clean, condition))
    provenance = Provenance(
        draw(words), draw(words), dpi=draw(st.floats(1, 500)), simulated=draw(st.booleans())
    )
    skipped = [
        Skip(trial, reason, row)
        for trial, reason, row in draw(st.lists(st.tuples(words, words, st.integers(0, 9))))
    ]
    return Recording.of(draw(words.filter(bool)), parts, trials, skipped, provenance, draw(st.lists(words)))


@pytest.mark.parametrize("extension", ["parquet", "csv"])
@settings(deadline=None, suppress_health_check=[HealthCheck.too_slow], max_examples=60)
@given(recording=recordings())
def test_a_written_recording_is_read_exactly(extension: str, recording: Recording) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path, _ = write(recording, Path(folder) / f"set.{extension}")
        back = read(path)
        again = [file.read_bytes() for file in write(back, Path(folder) / f"again.{extension}")]
        assert again == [file.read_bytes() for file in write(recording, Path(folder) / f"set.{extension}")]
    assert back.events.table.tobytes() == recording.events.table.tobytes()
    assert back.offsets.tolist() == recording.offsets.tolist()
    assert [repr(ordered(trial)) for trial in back.trials] == [
        repr(ordered(trial)) for trial in recording.trials
    ]
    assert (back.name, back.provenance) == (recording.name, recording.provenance)
    assert (back.skipped, back.notes) == (recording.skipped, recording.notes)


def ordered(trial: Trial) -> Trial:
    condition = dict(sorted(trial.condition.items()))
    return Trial(
        trial.user, trial.trial, trial.target_x, trial.target_y, trial.target_w, trial.clean, condition
    )


@pytest.mark.parametrize("extension", ["parquet", "csv"])
def test_a_hundred_thousand_rows(extension: str, tmp_path: Path) -> None:
    rng = np.random.default_rng(8)
    rows, each = 100_000, 50
    table = np.full((rows, 6), np.nan)
    table[:, 0] = np.tile(np.sort(rng.random(each)), rows // each)
    table[:, 1:3] = rng.normal(0, 1e3, (rows, 2))
    table[:, 5] = rng.integers(0, 4, rows)
    parts = [EventColumns(part) for part in np.split(table, rows // each)]
    trials = [Trial(f"u{index % 7}", str(index // 7)) for index in range(rows // each)]
    back = read(write(Recording.of("big", parts, trials), tmp_path / f"big.{extension}")[0])
    assert back.events.table.tobytes() == table.tobytes()
    assert [(trial.user, trial.trial) for trial in back.trials] == [
        (trial.user, trial.trial) for trial in trials
    ]
