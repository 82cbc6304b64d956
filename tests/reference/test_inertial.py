"""The differentiator that fuses counts and acceleration, against known sensors and a second filter."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm, solve_continuous_are

from pointpred import EventColumns, Pipeline, build, run
from pointpred.accelerations import Accelerations
from pointpred.differentiators import KalmanDifferentiator, fused_path, inertial
from pointpred.differentiators.inertial import InertialDifferentiator
from pointpred.errors import EventError
from pointpred.predictors import SwitchedPredictor
from pointpred.records import METRES_PER_INCH, FloatArray
from tests.reference.inertial_bench import Bench, path


def test_without_samples_it_is_the_kalman_filter() -> None:
    random = np.random.default_rng(4)
    t = np.cumsum(random.choice([0.0, 0.001, 0.008, 0.05, 0.15, 0.4], 300))
    x = np.cumsum(random.integers(-9, 20, 300)).astype(np.float64)
    events = EventColumns.of(t, x, -x)
    fused, plain = InertialDifferentiator().run(events).table, KalmanDifferentiator().run(events).table
    assert fused.tobytes() == plain.tobytes()


@pytest.mark.parametrize(("turn", "delay_s"), [(0.15, 0.0), (-0.4, 0.006), (1.2, 0.012), (0.1, -0.004)])
def test_known_gravity_bias_angle_scale_and_delay_are_recovered(turn: float, delay_s: float) -> None:
    bench = Bench(8.0, turn, delay_s, 0.05)
    differentiator = InertialDifferentiator(smoothing_s=0.003)
    motions = differentiator.run(bench.beside)
    sensor = differentiator.sensor
    assert sensor is not None
    assert sensor.known
    # weights @ matrix is the identity, whichever of the weights across make it so
    np.testing.assert_allclose(sensor.weights @ bench.matrix, np.eye(2), atol=0.02)
    np.testing.assert_allclose(sensor.weights @ bench.zero + sensor.offset, 0.0, atol=0.05)
    assert sensor.delay_s == pytest.approx(delay_s, abs=0.0007)
    push = path(bench.t)[2]
    speed = path(bench.t + max(-delay_s, 0.0))[1]  # where the counts are ahead, at their time
    last = bench.t > 5.0
    velocity = np.column_stack([motions.vx, motions.vy])[last] - speed[last]
    acceleration = np.column_stack([motions.ax, motions.ay])[last] - push[last]
    assert np.sqrt(np.mean(velocity**2)) < 0.002
    assert np.sqrt(np.mean(acceleration**2)) < 0.14  # 3 ms of averaging at a jerk of 40 m/s^3


JERK = 30.0


def fused_velocity(differentiator: InertialDifferentiator) -> tuple[float, float]:
    """Of the filter with samples, whether it answers yet or not."""
    memory, x = differentiator._memory, inertial.FILTER + fused_path.STATE + fused_path.VELOCITY
    return float(memory[x]), float(memory[x + fused_path.SECOND])


class DenseFilter:
    """The same model by matrix exponentials: the past is reached by carrying the state back."""

    def __init__(self, force_density: float, drift: float, noise: float) -> None:
        self.densities, self.noise = (force_density, drift), noise
        self.state = np.zeros(13)
        self.state[[3, 10]] = 1.0
        axis = [noise, 0.3**2, 25.0, 0.49, 0.49, 0.09]
        self.spread = np.diag([*axis, *axis, 1e-4])
        self.past: list[tuple[float, FloatArray]] = []

    @staticmethod
    def rates(force: FloatArray) -> FloatArray:
        a = np.zeros((13, 13))
        for at in (0, 6):
            a[at, at + 1] = a[at + 1, at + 2] = 1.0
            a[at + 1, at + 3 : at + 6] = force
        return a

    def carry(self, dt: float, force: FloatArray, age: float) -> None:
        """Van Loan's method; ``age`` s of the sample at the end."""
        a, q = self.rates(force), np.zeros((13, 13))
        for at in (0, 6):
            q[at + 1, at + 1], q[at + 2, at + 2] = self.densities
            q[at + 1, at + 1] += JERK * age**2
        q[12, 12] = 1e-6
        both = expm(np.block([[-a, q], [np.zeros((13, 13)), a.T]]) * dt)
        f = both[13:, 13:].T
        self.state, self.spread = f @ self.state, f @ self.spread @ f.T + f @ both[:13, 13:]
        self.past.append((dt, force))

    def row(self, at: int, delay_s: float, force: FloatArray) -> FloatArray:
        """The position of an axis ``delay_s`` ago as a row on the present state."""
        back = np.eye(13)
        if delay_s <= 0.0:
            back = expm(-delay_s * self.rates(force))
        for dt, push in reversed(self.past):
            back = expm(-min(dt, max(delay_s, 0.0)) * self.rates(push)) @ back
            delay_s -= dt
            if delay_s <= 0.0:
                break
        return np.asarray(back[at])

    def measure(self, at: int, place: float, force: FloatArray) -> None:
        d = float(self.state[12])
        h = self.row(at, d, force)
        ends = [self.row(at, d + step, force) @ self.state for step in (-1e-6, 1e-6)]
        error = float(place - h @ self.state)
        h[12] = (ends[1] - ends[0]) / 2e-6
        self.correct(h, error, self.noise)

    def correct(self, h: FloatArray, error: float, noise: float) -> None:
        gain = self.spread @ h / (h @ self.spread @ h + noise)
        self.state, self.spread = self.state + gain * error, self.spread - np.outer(gain, h @ self.spread)
        self.state[12] = np.clip(self.state[12], -0.02, 0.02)


def test_it_equals_a_filter_of_dense_matrices() -> None:
    bench = Bench(0.25, 0.3, 0.003, 0.05, counts=False)
    fused, dense = InertialDifferentiator(), DenseFilter(1e-4, 1e-3, 1e-8)
    start, reference = bench.events.table[0, 1:3], bench.samples[0, 1:]
    fused.run(bench.beside[:1])
    now, force, k, both = 0.0, np.zeros(3), 1, []
    for i in range(1, len(bench.t)):
        for sample_t, *values in bench.samples[k : bench.beside.accelerations.before[i]].tolist():
            newer = np.array(values) - reference
            dense.carry(sample_t - now, 0.5 * (force + newer), sample_t - bench.samples[k - 1, 0])
            now, force, k = sample_t, newer, k + 1
        if bench.t[i] > now:
            dense.carry(bench.t[i] - now, force, bench.t[i] - bench.samples[k - 1, 0])
            now = bench.t[i]
        place = (bench.events.table[i, 1:3] - start) * METRES_PER_INCH / 96.0
        dense.measure(0, float(place[0]), force)
        dense.measure(6, float(place[1]), force)
        fused.run(bench.beside[i : i + 1])
        both.append([fused_velocity(fused), (dense.state[1], dense.state[7])])
    own, wanted = np.array(both).transpose(1, 0, 2)
    # The law keeps the past at intervals of 0.3 ms and draws lines between: 1e-3 of 2.5 m/s.
    np.testing.assert_allclose(own, wanted, rtol=1e-3, atol=1e-3)


def test_the_velocity_has_the_spread_of_the_riccati_equation() -> None:
    q, r = 1e-4, 1e-8 * 1e-3
    steady = solve_continuous_are(
        np.array([[0.0, 0.0], [1.0, 0.0]]), np.array([[1.0], [0.0]]), np.diag([0.0, q]), np.array([[r]])
    )
    assert np.sqrt(steady[1, 1]) == pytest.approx(2**0.25 * q**0.375 * r**0.125, rel=1e-6)


def test_live_chunks_and_a_table_are_one_path() -> None:
    bench = Bench(0.5, 0.3, 0.004, 0.05)
    whole = InertialDifferentiator().run(bench.beside).table
    chunked, live = InertialDifferentiator(), InertialDifferentiator()
    parts = [chunked.run(bench.beside[a:b]).table for a, b in ((0, 1), (1, 177), (177, 500))]
    assert np.concatenate(parts).tobytes() == whole.tobytes()
    k, streamed = 0, []
    for i, event in enumerate(bench.events.events()):
        for sample in bench.samples[k : bench.beside.accelerations.before[i]].tolist():
            live.sense(*sample)
        k = int(bench.beside.accelerations.before[i])
        streamed.append(live.update(event))
    assert [(m.vx, m.ay) for m in streamed] == [(row[3], row[6]) for row in whole.tolist()]


def test_a_pipeline_takes_samples_one_by_one_and_beside_events() -> None:
    bench = Bench(0.5, 0.3, 0.004, 0.05)

    def pipeline() -> Pipeline:
        return Pipeline("switched", InertialDifferentiator(), SwitchedPredictor())

    whole = run(pipeline(), bench.beside)
    live, k, streamed = pipeline(), 0, []
    assert live.learns
    for i, event in enumerate(bench.events.events()):
        for sample in bench.samples[k : bench.beside.accelerations.before[i]].tolist():
            live.sense(*sample)
        k = int(bench.beside.accelerations.before[i])
        streamed.append(live.update(event))
    assert streamed == list(whole.predictions())
    assert whole.x[300:].tolist() != run(pipeline(), bench.events).x[300:].tolist()
    other = build("hold")
    other.sense(0.0, 0.0, 0.0, 9.81)  # HOMD uses no samples
    assert list(run(other, bench.beside).predictions()) == list(
        run(build("hold"), bench.events).predictions()
    )


def test_a_table_names_the_row_of_a_sample_that_is_refused() -> None:
    bench = Bench(0.1, 0.3, 0.004, 0.05)
    differentiator = InertialDifferentiator()
    kept = differentiator.remembered()
    before = bench.beside.accelerations.before
    for place, words in (
        (np.nan, "row 40: ax of a sample must lie in"),
        (0.0, "row 40: t of a sample must not"),
    ):
        samples = bench.samples.copy()
        samples[before[39], 1 if np.isnan(place) else 0] = place
        events = EventColumns(bench.events.table, None, Accelerations(samples, before))
        with pytest.raises(EventError, match=words):
            differentiator.run(events)
        assert differentiator.remembered() == kept
        with pytest.raises(EventError, match=words):
            run(Pipeline("switched", differentiator, SwitchedPredictor()), events)


def test_reset_and_a_begin_mark_keep_the_sensor_and_fresh_forgets_it() -> None:
    bench = Bench(6.0, 0.8, 0.006, 0.05)
    used = InertialDifferentiator()
    first = used.run(bench.beside).table
    assert used.fresh().run(bench.beside).table.tobytes() == first.tobytes()
    used.reset()
    assert used.sensor is None
    again = used.run(bench.beside[:300])
    begin = np.zeros(len(bench.t), np.bool_)
    speed = path(bench.t)[1][100:300, 0]
    off = np.sqrt(np.mean((again.vx[100:300] - speed) ** 2))
    at_first = np.sqrt(np.mean((first[100:300, 3] - speed) ** 2))
    assert off < 0.5 * at_first
    begin[0] = True
    marked = InertialDifferentiator()
    marked.run(bench.beside)
    events = EventColumns(bench.beside.table, begin, bench.beside.accelerations)
    assert marked.run(events).table[:300].tobytes() == again.table.tobytes()


@pytest.mark.parametrize(
    ("sample", "words"),
    [
        ((float("nan"), 0.0, 0.0, 0.0), "t of a sample must lie in"),
        ((1.0, 0.0, float("inf"), 0.0), r"ay of a sample must lie in \[-10000, 10000\] m/s\^2"),
        ((1.0, 0.0, 0.0, -1e5), "az of a sample"),
        ((None, 0.0, 0.0, 0.0), "t of a sample must be a number, received None"),
        (("1", 0, 0, 0), "t of a sample must be a number, received '1'"),
        ((1, 10**400, 0, 0), "ax of a sample must lie in"),
    ],
)
def test_a_sample_that_is_no_measurement_is_refused(sample: Any, words: str) -> None:
    differentiator = InertialDifferentiator()
    differentiator.sense(0.5, 0.0, 0.0, 9.81)
    kept = differentiator.remembered()
    with pytest.raises(EventError, match=words):
        differentiator.sense(*sample)
    assert differentiator.remembered() == kept
