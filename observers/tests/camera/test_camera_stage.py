"""What every stage on camera samples obeys: refusals, chunks, pickles, plain Python of the same source."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

from pointpred.errors import EventError, EventOrderError
from pointpred_observers.camera import (
    SCENARIOS,
    CameraColumns,
    CameraSample,
    DepthObserver,
    Gravity,
    Noise,
    PointEstimate,
    PointFilter,
    simulate,
)
from pointpred_observers.camera.point_filter import PointTrack

FOCAL = 800.0


def observer(chi: float = 4.0, eta: float = -1.6) -> DepthObserver:
    return DepthObserver(focal_px=FOCAL, start_chi=chi, start_eta=eta)


GOOD = CameraSample(0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("change", "kind", "said"),
    [
        ({"t": -1.0}, EventOrderError, r"t must increase: received -1.0 s after 0.0 s"),
        ({"t": 0.0}, EventOrderError, "t must increase"),
        ({"t": 5.0}, EventError, "the inertial sensor was silent from 0.0 s to 5.0 s, at most 1 s"),
        ({"t": 0.1, "y": float("nan")}, EventError, "x and y come together or not at all"),
        ({"t": 0.1, "x": None}, EventError, "x must be a number, received None"),
        ({"t": 0.1, "wx": float("inf")}, EventError, r"wx must lie in \[-1000, 1000\], received inf"),
        ({"t": 0.1, "az": 1j}, EventError, "az must be a number"),
        ({"t": 0.1, "x": 1e9}, EventError, "x must lie in"),
        ({"t": 0.1, "ay": "0"}, EventError, "ay must be a number"),
    ],
)
def test_bad_samples_are_refused_and_change_nothing(change: dict, kind: type[Exception], said: str) -> None:
    stage = observer()
    stage.update(GOOD)
    kept = stage.remembered()
    values = {name: getattr(GOOD, name) for name in CameraColumns.names} | change
    with pytest.raises(kind, match=said):
        stage.update(CameraSample(**values))
    assert stage.remembered() == kept


def test_a_bad_row_is_named_and_nothing_is_consumed() -> None:
    samples, _ = simulate(SCENARIOS["paper"], focal_px=FOCAL, duration_s=1.0)
    table = samples.table.copy()
    table[7, 4] = np.nan
    stage = observer()
    kept = stage.remembered()
    with pytest.raises(EventError, match="row 7: wy must lie in"):
        stage.run(CameraColumns(table))
    assert stage.remembered() == kept
    with pytest.raises(EventError, match="must be a CameraSample"):
        stage.update(3.0)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "made",
    [observer, lambda: PointFilter(focal_px=FOCAL, noise_px=1.7), lambda: Gravity(up=(0.0, -1.0, 0.1))],
    ids=["observer", "filter", "gravity"],
)
def test_rows_chunks_pickles_and_fresh_agree(made: Any) -> None:
    noise = Noise(noise_px=3.0, dropped=0.2)
    samples, _ = simulate(SCENARIOS["paper"], focal_px=FOCAL, readings=2, noise=noise)
    whole = made().run(samples)
    stage = made()
    parts = [stage.run(CameraColumns(samples.table[:200]))]
    stage = pickle.loads(pickle.dumps(stage))
    parts.append(stage.run(CameraColumns(samples.table[200:])))
    assert np.array_equal(np.vstack([numbers(one) for one in parts]), numbers(whole), equal_nan=True)
    stage.reset()
    assert stage.remembered() == stage.fresh().remembered() == made().remembered()
    for row, sample in zip(numbers(whole), samples, strict=True):
        one = stage.update(sample)
        if isinstance(one, PointEstimate):
            one = (*one.state, *one.covariance.ravel())
        assert np.array_equal(np.full(len(row), np.nan) if one is None else one, row, equal_nan=True)


def numbers(found: Any) -> Any:
    """The answers to a table as rows."""
    if isinstance(found, PointTrack):
        return np.hstack([found.state, found.covariance.reshape(-1, 36)])
    return found.table


@pytest.mark.parametrize("seed", range(4))
def test_wild_samples_within_the_bounds_leave_a_memory_of_finite_numbers(seed: int) -> None:
    random = np.random.default_rng(seed)
    rows = 3000
    table = np.zeros((rows, 9))
    table[:, 0] = np.cumsum(random.choice([1e-6, 0.01, 0.9], rows))
    table[:, 1:3] = random.choice([0.0, 1.0, -300.0, 1e6], (rows, 2)) * random.normal(size=(rows, 2)).clip(
        -1, 1
    )
    table[random.uniform(size=rows) < 0.2, 1:3] = np.nan
    table[:, 3:6] = random.choice([0.0, 0.1, 1e3], (rows, 3)) * random.uniform(-1.0, 1.0, (rows, 3))
    table[:, 6:9] = random.choice([0.0, 0.1, 1e4], (rows, 3)) * random.uniform(-1.0, 1.0, (rows, 3))
    for stage in (observer(), PointFilter(focal_px=FOCAL, gyro_noise=1.0, accel_noise=10.0)):
        out = stage.run(CameraColumns(table))
        memory = np.frombuffer(stage.remembered())
        assert np.isfinite(memory).all()
        answers = out.table if hasattr(out, "table") else out.state
        assert not np.isinf(answers).any()
