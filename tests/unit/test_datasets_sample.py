"""The embedded sample: generated, labelled, the same every time."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred.datasets import embedded, sample
from pointpred.recording import Recording


@pytest.fixture(scope="module")
def loaded() -> Recording:
    return sample()


def test_the_committed_sample_is_what_the_command_generates(loaded: Recording) -> None:
    again = embedded.generate()
    np.testing.assert_array_equal(loaded.events.table, again.events.table)
    np.testing.assert_array_equal(loaded.offsets, again.offsets)
    assert loaded.trials == again.trials
    assert loaded.provenance == again.provenance
    assert loaded.name == again.name
    assert not loaded.skipped
    assert not loaded.notes


def test_writing_twice_gives_the_same_bytes(
    tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    contents = []
    for turn in ("first", "second"):
        monkeypatch.setattr(embedded, "FILE", tmp_path_factory.mktemp(turn) / embedded.FILE.name)
        contents.append([path.read_bytes() for path in embedded.write()])
    assert contents[0] == contents[1]


def test_the_sample_says_that_it_is_simulated(loaded: Recording) -> None:
    assert loaded.provenance.simulated
    assert loaded.provenance.format == "simulated"
    assert loaded.name.startswith("simulated")
    assert (loaded.provenance.cpi, loaded.provenance.dpi) == (2000.0, 96.0)


def test_the_sample_is_a_small_full_factorial_of_ten_people(loaded: Recording) -> None:
    keys = ("distance_mm", "width_mm", "transfer")
    cells = [(trial.user, *(trial.condition[key] for key in keys)) for trial in loaded.trials]
    assert len({cell[0] for cell in cells}) == 10
    assert {cells.count(cell) for cell in cells} == {3}
    assert len(set(cells)) == 80
    trials = embedded.FILE.with_name(embedded.FILE.name.replace("_samples", "_trials"))
    assert embedded.FILE.stat().st_size + trials.stat().st_size < 1.2e6


def test_every_trial_can_be_used(loaded: Recording) -> None:
    assert np.isfinite(loaded.events.table).all()
    for i, trial in enumerate(loaded.trials):
        events = loaded.rows(i)
        assert (np.diff(events.t) > 0.0).all()
        assert events.buttons.max() == 1.0
        assert np.hypot(events.x[0] - trial.target_x, events.y[0] - trial.target_y) > 5 * trial.target_w


def test_a_longer_run_keeps_every_direction(loaded: Recording) -> None:
    """Circles start at different targets, so that three movements each do not all run up and down."""
    directions = [
        np.arctan2(trial.target_y - loaded.rows(i).y[0], trial.target_x - loaded.rows(i).x[0])
        for i, trial in enumerate(loaded.trials)
    ]
    halves = np.histogram(np.abs(np.cos(directions)), [0.0, 0.5, 1.0])[0]
    assert halves.min() > len(directions) / 5
