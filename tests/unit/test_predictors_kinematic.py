"""The learned predictor: what must not matter does not, and what it says is sound."""

from __future__ import annotations

import pickle
from math import cos, log, sin
from pathlib import Path

import numpy as np
import pytest

from pointpred import REGISTRY, EventColumns, Motion, Pipeline, build, run
from pointpred.datasets import sample
from pointpred.predictors import KinematicPredictor
from pointpred.predictors.kinematic import coefficient_file
from pointpred.records import FloatArray
from pointpred.scoring import prepare

X, Y, SXX, SXY, SYY, LEFT, PHASE, TAIL, SPREAD = range(1, 10)


def reach(rate: float = 250.0, size: float = 1.0) -> EventColumns:
    """A bent reach of about 500 px with a correction, unrounded."""
    t = np.arange(0.0, 1.1, 1.0 / rate)
    s, r = np.clip(t / 0.7, 0.0, 1.0), np.clip((t - 0.75) / 0.3, 0.0, 1.0)
    way, back = 10 * s**3 - 15 * s**4 + 6 * s**5, 10 * r**3 - 15 * r**4 + 6 * r**5
    return EventColumns.of(t, size * (480 * way - 30 * back), size * (150 * way**2 + 12 * back))


def table(events: EventColumns, **device: float) -> FloatArray:
    return run(build("kinematic", **device), events).table


def moved(events: EventColumns, matrix: FloatArray) -> EventColumns:
    changed = events.table.copy()
    changed[:, 1:3] = changed[:, 1:3] @ matrix.T
    return EventColumns(changed)


@pytest.mark.parametrize("mirror", [1.0, -1.0])
@pytest.mark.parametrize("angle", [0.3, 1.9, 4.4])
def test_a_turned_or_mirrored_screen_turns_the_answer(angle: float, mirror: float) -> None:
    """Except for the differentiator, which works per axis: its alpha of 0 makes it linear."""
    matrix = np.array([[cos(angle), -sin(angle)], [sin(angle), cos(angle)]]) @ np.diag([1.0, mirror])
    here, there = table(reach()), table(moved(reach(), matrix))
    np.testing.assert_allclose(there[:, [X, Y]], here[:, [X, Y]] @ matrix.T, rtol=1e-6, atol=1e-5)
    np.testing.assert_allclose(there[1:, LEFT:], here[1:, LEFT:], rtol=1e-6)
    spread = here[:, [SXX, SXY, SXY, SYY]].reshape(-1, 2, 2)
    turned = (matrix @ spread @ matrix.T).reshape(-1, 4)[:, [0, 1, 3]]
    largest = np.abs(turned[1:]).max(axis=1, keepdims=True)
    np.testing.assert_allclose(there[1:, SXX:LEFT] / largest, turned[1:] / largest, atol=1e-6)


@pytest.mark.parametrize("scale", [0.25, 3.0])
def test_with_counts_the_screen_scales_the_answer(scale: float) -> None:
    """The hand does the same; the cursor goes ``scale`` times as far."""
    events = reach()
    counts = events.table.copy()
    counts[:, 3:5] = np.round(np.diff(7.0 * counts[:, 1:3], prepend=7.0 * counts[:1, 1:3], axis=0))
    scaled = counts.copy()
    scaled[:, 1:3] *= scale
    here, there = table(EventColumns(counts), cpi=800.0), table(EventColumns(scaled), cpi=800.0)
    np.testing.assert_allclose(there[:, [X, Y]], scale * here[:, [X, Y]], rtol=1e-6, atol=1e-5)
    np.testing.assert_allclose(there[1:, SXX:LEFT], scale**2 * here[1:, SXX:LEFT], rtol=1e-6, atol=1e-5)
    np.testing.assert_allclose(there[1:, LEFT:], here[1:, LEFT:], rtol=1e-6)


def test_another_cpi_with_its_counts_changes_nothing() -> None:
    events = reach()
    coarse, fine = events.table.copy(), events.table.copy()
    coarse[:, 3:5] = np.round(np.diff(9.0 * coarse[:, 1:3], prepend=0.0, axis=0))
    fine[:, 3:5] = 4.0 * coarse[:, 3:5]
    here, there = table(EventColumns(coarse), cpi=400.0), table(EventColumns(fine), cpi=1600.0)
    np.testing.assert_allclose(there, here, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("rate", [60.0, 125.0, 1000.0, 8000.0])
def test_the_rate_matters_little(rate: float) -> None:
    """Time-averaged distance to the endpoint, of a smooth reach as every rate sees it."""
    averages = []
    for events in (reach(250.0), reach(rate)):
        answers = table(events)
        error = np.hypot(answers[:, X] - 450.0, answers[:, Y] - 162.0)
        averages.append(np.trapezoid(error, answers[:, 0]))
    assert averages[1] == pytest.approx(averages[0], rel=0.05)


def test_the_first_answer_is_the_place_without_a_region() -> None:
    predictor = KinematicPredictor()
    first = predictor.update(Motion(0.0, 5.0, 7.0, 0.0, 0.0, 0.0, 0.0, True, start=True))
    assert first is not None
    assert (first.x, first.y, first.scale, first.tail) == (5.0, 7.0, None, None)
    second = predictor.update(Motion(0.01, 6.0, 7.0, 0.02, 0.0, 1.0, 0.0, True))
    assert second is not None
    assert second.scale is not None
    assert second.tail is not None
    assert second.tail > 1.0
    assert second.remaining_s is not None
    assert second.remaining_spread is not None


def test_it_beats_no_prediction_on_people_it_never_saw() -> None:
    """The embedded sample was generated; nothing was trained on it."""
    prepared = prepare(sample(), threads=1)
    last = (prepared.offsets[1:] - 1).repeat(np.diff(prepared.offsets))
    errors = []
    for name in ("kinematic", "hold"):
        answers = run(build(name, cpi=sample().provenance.cpi), prepared.events).table
        away = np.hypot(answers[:, X] - prepared.events.x[last], answers[:, Y] - prepared.events.y[last])
        errors.append(away.mean())
    assert errors[0] < 0.9 * errors[1]


def test_coefficients_are_shared_and_not_pickled() -> None:
    one, two = KinematicPredictor(), KinematicPredictor()
    twin = pickle.loads(pickle.dumps(one))
    for other in (two, twin, one.fresh()):
        assert other.shared[0] is one.shared[0]
    assert not one.shared[0].flags.writeable
    assert len(pickle.dumps(one)) < 8192


def other_file(path: Path, **changed: object) -> Path:
    with np.load(coefficient_file.OWN) as own:
        arrays = {name: own[name] for name in own.files} | changed
    np.savez(path, **{name: value for name, value in arrays.items() if value is not None})  # type: ignore[arg-type]
    return path


def test_other_coefficients_say_other_things(tmp_path: Path) -> None:
    with np.load(coefficient_file.OWN) as own:
        path = other_file(tmp_path / "other.npz", offset2=own["offset2"] + np.float32(0.5))
    given = Pipeline("kinematic", build("hold").differentiator, KinematicPredictor(coefficients=path))
    assert not np.allclose(run(given, reach()).table[5:, X], table(reach())[5:, X])
    assert pickle.loads(pickle.dumps(given)).predictor.__dict__["_source"] == path


def test_the_card_says_what_the_file_is() -> None:
    page = (Path(__file__).parents[2] / "docs/evidence/results.md").read_text(encoding="utf-8")
    notice = (Path(__file__).parents[2] / "NOTICE").read_text(encoding="utf-8")
    assert coefficient_file.digest() in page
    assert coefficient_file.OWN.stat().st_size <= coefficient_file.LARGEST_BYTES
    said = coefficient_file.card()
    for one in said["sets"]:
        row = next(line for line in page.splitlines() if line.startswith(f"| [{one['name']}]("))
        assert f"| {one['users']} | {one['trials']} |" in row
        assert f"{one['name']} ({one['licence']})" in notice
    assert "kinematic" in REGISTRY


def test_a_region_widens_with_its_tail() -> None:
    """The region of level p ends where nu ((1 - p)^(-2 / nu) - 1) is: far beyond -2 ln(1 - p)."""
    answers = table(reach())[2:]
    nu = answers[:, TAIL]
    assert (nu * (0.05 ** (-2.0 / nu) - 1.0) > -2.0 * log(0.05)).all()
