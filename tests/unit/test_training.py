"""Training: slopes against differences, the network in training against the law, the same bytes twice."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import msgspec
import numpy as np
import pytest

from pointpred import EventColumns
from pointpred.errors import ParameterError
from pointpred.predictors.kinematic import coefficient_file, features
from pointpred.predictors.kinematic import network as net
from pointpred.recording import Recording, Trial
from pointpred.scoring import prepare
from pointpred.scoring.executors import open_executor
from pointpred.scoring.measures.regions import LEVELS
from pointpred.training import calibration, data, fitting, train
from pointpred.training.data import examples, join, varied
from pointpred.training.fitting import Settings

SMALL = Settings(hidden=(8, 6), passes=2, batch=64)


def reaches(count: int = 24, seed: int = 3) -> Recording:
    """Minimum-jerk reaches of two people, in whole pixels at 100 Hz."""
    random = np.random.default_rng(seed)
    paths, trials = [], []
    for number in range(count):
        t = np.arange(0.0, 1.0, 0.01)
        s = np.clip(t / random.uniform(0.5, 0.8), 0.0, 1.0)
        way = (10 * s**3 - 15 * s**4 + 6 * s**5) * random.uniform(200.0, 600.0)
        angle = random.uniform(0.0, 2.0 * np.pi)
        paths.append(EventColumns.of(t, np.round(way * np.cos(angle)), np.round(way * np.sin(angle))))
        trials.append(Trial("ann" if number % 2 else "bob", str(number)))
    return Recording.of("reaches", paths, trials)


@pytest.fixture(scope="module")
def material() -> data.TrainingData:
    return data.training_data([reaches()], 1, lambda _: None, variants=1)


def test_slopes_agree_with_differences() -> None:
    """Of the whole chain: features to loss, by every weight, in double precision."""
    random = np.random.default_rng(5)
    rows, sizes = 7, (5, 4, 3, net.Outputs.length)
    layers = [
        (0.4 * random.standard_normal((a, b)), 0.1 * random.standard_normal(b)) for a, b in pairwise(sizes)
    ]
    inputs = random.standard_normal((rows, 5))
    shapes = ((rows, net.BASES), (rows, net.BASES), rows, rows, rows)
    truth = fitting.Truth(
        *(random.standard_normal(shape) for shape in shapes),
        *(random.uniform(0.2, 0.9, rows) for _ in range(2)),
        *(random.uniform(0.5, 2.0, rows) for _ in range(3)),
    )

    def loss(frozen: fitting.Floats) -> float:
        """The point's errors enter the law as they were: so its slope is taken."""
        outputs, _ = fitting.forward(layers, inputs)
        whole, _ = fitting.slopes(outputs, truth)
        held = outputs.copy()
        still = [net.ALONG, net.ACROSS, *range(net.BASIS, net.BASIS + net.BASES)]
        held[:, still] = frozen[:, still]
        law_moved = fitting._law(outputs, truth, *_off(outputs, truth), np.zeros_like(outputs))
        law_held = fitting._law(outputs, truth, *_off(held, truth), np.zeros_like(outputs))
        spread_moved = fitting._time(outputs, truth, np.zeros_like(outputs))
        return whole - law_moved + law_held - spread_moved + _time_held(outputs, frozen, truth)

    outputs, kept = fitting.forward(layers, inputs)
    _, slope = fitting.slopes(outputs, truth)
    gradient = fitting.backward(layers, kept, slope)
    for (weights, offset), (by_weights, by_offset) in zip(layers, gradient, strict=True):
        for array, by in ((weights, by_weights), (offset, by_offset)):
            for place in np.ndindex(array.shape):
                was, step = array[place], 1e-5
                array[place] = was + step
                above = loss(outputs)
                array[place] = was - step
                below = loss(outputs)
                array[place] = was
                assert by[place] == pytest.approx((above - below) / (2 * step), rel=1e-3, abs=2e-6)


def _off(outputs: fitting.Floats, truth: fitting.Truth) -> tuple[fitting.Floats, fitting.Floats]:
    along, across = fitting.point(outputs, truth)
    return along - truth.along, across - truth.across


def _time_held(outputs: fitting.Floats, frozen: fitting.Floats, truth: fitting.Truth) -> float:
    """The time's loss with the spread judged at the time left as it was."""
    judged = outputs.copy()
    judged[:, net.LEFT] = frozen[:, net.LEFT]
    no_error = msgspec.structs.replace(truth, time_weight=0.0 * truth.time_weight)
    no_law = msgspec.structs.replace(truth, law_weight=0.0 * truth.law_weight)
    zeros = np.zeros_like(outputs)
    return fitting._time(judged, no_error, zeros) + fitting._time(outputs, no_law, zeros)


def test_the_law_computes_what_training_computes(material: data.TrainingData, tmp_path: Path) -> None:
    fitted = train.fit_without(material, set(), None, SMALL)
    path = tmp_path / "small.npz"
    train.save(path, fitted, np.zeros((net.KNOTS, net.FACTORS)), {})
    flat, stored = coefficient_file.read(path), fitting.load_network(path)
    rows = material.own[0].features[:50]
    np.testing.assert_allclose(stored.outputs(rows), fitted.outputs(rows), atol=0.05)
    for seen, wanted in zip(rows, stored.outputs(rows), strict=True):
        said = np.empty(net.Outputs.length)
        at = net.evaluate(net.Coefficients(flat), seen.astype(np.float64), said)
        np.testing.assert_allclose(said, wanted, rtol=2e-3, atol=2e-4)
        assert len(flat) - net.Coefficients.length - at == net.KNOTS * net.FACTORS


def test_training_is_reproducible_to_the_byte(tmp_path: Path) -> None:
    files = []
    ways: dict[str, dict[str, int]] = {"one.npz": {"threads": 1}, "two.npz": {"processes": 2}}
    for name, way in ways.items():
        with open_executor(**way) as executor:
            made = data.training_data([reaches()], 1, lambda _: None, variants=1, executor=executor)
        train.train(made, SMALL, tmp_path / name, lambda _: None)
        files.append((tmp_path / name).read_bytes())
    assert files[0] == files[1]
    made = data.training_data([reaches()], 2, lambda _: None, variants=1)
    train.train(made, msgspec.structs.replace(SMALL, seed=2), tmp_path / "three.npz", lambda _: None)
    assert (tmp_path / "three.npz").read_bytes() != files[0]


def test_training_learns(material: data.TrainingData) -> None:
    """Reaches of one shape are learnt well from some of them."""
    fitted = train.fit_without(
        material, {0}, None, msgspec.structs.replace(SMALL, passes=60, hidden=(24, 24))
    )
    own = material.own[0].only(material.own[0].user == 0)
    wanted = fitting.truth(own, SMALL)
    along, across = fitting.point(fitted.outputs(own.features), wanted)
    error = np.hypot(along - wanted.along, across - wanted.across) * own.reach
    assert (own.weight @ error) < 0.5 * (own.weight @ own.hold())


def test_examples_are_what_the_scorer_sees() -> None:
    """Weights of a trial add to one; the endpoint and the time left are the scorer's."""
    recording = reaches(4)
    given = examples(recording, 0, {"reaches ann": 0, "reaches bob": 1}, 1)
    prepared = prepare(recording, threads=1)
    np.testing.assert_allclose(np.bincount(given.trial, given.weight), 1.0, atol=0.06)
    for trial in range(4):
        rows = given.trial == trial
        duration = prepared.trials[trial].arrival_s
        np.testing.assert_allclose(given.left_s[rows] + given.share[rows] * duration, duration, rtol=1e-9)
        end = prepared.rows(trial).table[-1, 1:3] - prepared.rows(trial).table[0, 1:3]
        start_to_cursor = given.features[rows][:, features.PLACE["distance"]] * given.reach[rows]
        np.testing.assert_allclose(
            np.hypot(start_to_cursor + given.along[rows], given.across[rows]), np.hypot(*end), rtol=1e-4
        )


def test_variants_keep_the_shape() -> None:
    recording = reaches(6)
    other = varied(recording, 7)
    assert [trial.trial for trial in other.trials] == [trial.trial for trial in recording.trials]
    for number in range(6):
        a, b = recording.rows(number), other.rows(number)
        ratios = []
        for rows in (a, b):
            place = np.hypot(rows.x - rows.x[0], rows.y - rows.y[0])
            middle = np.interp(0.3 * rows.t[-1], rows.t, place)
            ratios.append(middle / place[-1])
        assert ratios[1] == pytest.approx(ratios[0], abs=0.03)
        assert not np.array_equal(a.x, b.x)


def test_calibration_mends_what_is_too_sure() -> None:
    """Half as wide and with too light a tail as it should be: the table widens it everywhere."""
    random = np.random.default_rng(8)
    count = 20_000
    share = random.uniform(0.05, 0.95, count)
    said = np.clip(share + random.normal(0.0, 0.1, count), 0.0, 1.0)
    true_tail = 3.0
    chi = random.chisquare(2, count) / (random.chisquare(true_tail, count) / true_tail)
    known = calibration.Claims(
        said, share, 4.0 * chi, np.full(count, 6.0), 1.7 * random.standard_normal(count), np.ones(count)
    )
    before = calibration.coverage(known)
    after = calibration.coverage(calibration.apply_table(known, calibration.fit_table(known)))
    wanted = np.array([*LEVELS, *LEVELS])
    assert np.abs(before - wanted).max() > 0.15
    assert np.abs(after - wanted).max() < 0.03


def test_a_missing_folder_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv("POINTPRED_RECORDINGS", raising=False)
    with pytest.raises(ParameterError, match="must name a folder of recordings, received None"):
        data.folder()
    with pytest.raises(ParameterError, match="must hold one of freihaut2021"):
        data.read_sets(tmp_path)


def test_users_are_dealt_evenly_into_folds() -> None:
    many = data.TrainingData((), (), (), {f"set {number}": number for number in range(23)})
    sizes = np.bincount(list(many.fold().values()))
    assert sizes.tolist() == [5, 5, 5, 4, 4]


def test_what_a_moment_weighs() -> None:
    """By hand: sets by the fourth root, moments near the end more, variants less for widths and time."""
    given = examples(reaches(4), 0, {"reaches ann": 0, "reaches bob": 1}, 1)
    moments = len(given.set)
    other = msgspec.structs.replace(given, set=np.full(moments, 1), own=np.zeros(moments, bool))
    both = join([given, other.only(other.trial == 0)])
    found = fitting.truth(both, Settings())
    hold, weight, reach = both.hold(), both.weight, both.reach.astype(np.float64)
    trials = [both.trial == k for k in range(5)]
    mean = np.array([(weight * hold)[rows].sum() / weight[rows].sum() for rows in trials])
    of_set = np.where(both.set == 0, mean[:4].mean(), mean[4])
    share = np.where(both.set == 0, 4.0**-0.25, 1.0)
    own = mean[both.trial]
    near = (own / np.maximum(hold, 0.05 * own)) ** 0.75
    point = weight * share * near * reach / of_set
    np.testing.assert_allclose(found.point_weight, point / point.mean(), rtol=1e-5)
    law = weight * share * np.where(both.own, 1.0, 0.5)
    np.testing.assert_allclose(found.law_weight, 0.2 * law / law.mean(), rtol=1e-5)
    ratio = found.time_weight / (weight * share)
    np.testing.assert_allclose(ratio[both.trial == 4] / ratio[both.trial == 0], 0.05, rtol=1e-4)


def test_a_recording_in_which_nobody_moves_is_refused() -> None:
    still = EventColumns.of(np.array([0.0, 0.1, 0.2]), np.zeros(3), np.zeros(3))
    recording = Recording.of("still", [still], [Trial("ann", "1")])
    with pytest.raises(ParameterError, match="still must hold a movement to learn from, holds none"):
        examples(recording, 0, {"still ann": 0}, 1)
