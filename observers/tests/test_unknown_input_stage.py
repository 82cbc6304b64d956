"""Unknown input observers of any system that run: every output measured or some missing, costs, refusals."""

from __future__ import annotations

import pickle
from typing import Any

import msgspec
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pointpred.errors import DivergenceError, EventError, EventOrderError, ParameterError
from pointpred_observers import Box, CornerSystem, ParameterVaryingSystem, UnknownInputSample
from pointpred_observers.unknown_input import stage as running
from pointpred_observers.unknown_input.observer import UnknownInputObserver

A = np.array([[-1.0, 2.0, 0.0], [0.5, 0.3, 1.0], [0.0, -1.0, -0.4]])
F = np.array([[1.0], [0.5], [0.0]])
PART = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
NAN = np.nan


def system(c: Any, a: Any = None, f: Any = F, **more: Any) -> ParameterVaryingSystem:
    """A system with a coefficient k that varies, or of constant matrices."""
    first = A if a is None else np.asarray(a)
    return ParameterVaryingSystem(
        lambda p: first + p["k"] * np.eye(len(first)), lambda p: np.asarray(f), np.asarray(c), **more
    )


def k(t: float) -> float:
    return float(-0.25 + 0.25 * np.sin(t))


def at(t: float) -> Any:
    return lambda _: {"k": k(t)}


def observed(c: Any, f: Any = F, decay: float = 0.25) -> UnknownInputObserver:
    return UnknownInputObserver.design(system(c, f=f), Box({"k": (-0.5, 0.0)}), decay)


def sample(t: float, y: Any, k: Any = 0.0, known: Any = (0.0, 0.0, 0.0)) -> UnknownInputSample:
    y = None if y is None else np.array(y, float)
    return UnknownInputSample(t, y, np.array(known, float), k if callable(k) else lambda _: {"k": k})


def gain_at(observer: UnknownInputObserver, point: Any) -> Any:
    return observer.box.mixed(observer.gains, point)


def run(
    observer: UnknownInputObserver, start: Any, times: Any, lost: Any = (), **noise: Any
) -> tuple[Any, Any, Any]:
    """Errors of the state, estimates, and the true d, with outputs ``lost[i]`` missing from sample i."""
    one, lost = observer.system, dict(lost)

    def d(t: float) -> Any:
        return np.array([1.5 * np.sin(2.0 * t) + 0.5, np.cos(t)])[: one.f({"k": 0.0}).shape[1]]

    def rate(t: float, x: Any) -> Any:
        return one.a({"k": k(t)}) @ x + one.f({"k": k(t)}) @ d(t) + np.array([0.0, t, 0.0])

    truth = solve_ivp(
        rate, (0.0, times[-1]), [0.3, -0.2, 0.5], method="DOP853", t_eval=times, rtol=1e-10, atol=1e-12
    ).y.T
    stage = observer.stage(start, **noise)
    estimates = []
    for i, (t, x) in enumerate(zip(times, truth, strict=True)):
        y = one.c @ x
        y[list(lost.get(i, ()))] = NAN
        estimates.append(stage.update(sample(t, y, at(t), [0.0, t, 0.0])))
    errors = np.array([e.x for e in estimates]) - truth
    return errors, estimates, np.array([d(t) for t in times])


@pytest.mark.parametrize("f", [F, np.eye(3, 2), np.eye(3)])
def test_every_state_measured(f: Any) -> None:
    observer = observed(np.eye(3), f)
    one = observer.certificate
    assert one.margin > 0.0
    assert one.zeros.size == 0
    assert one.largest_decay == np.inf
    for k in (-0.5, -0.2, 0.0):
        n = observer.system.gamma({"k": k}) - gain_at(observer, {"k": k})
        assert np.linalg.eigvals(n).real.max() < -0.25
        assert np.abs(n).max() < 30.0  # no gain is larger than it must be
    if f is F:
        errors, _, _ = run(observer, np.zeros(3), np.arange(0.0, 3.0, 0.01))
        assert np.abs(errors[-1]).max() < 1e-4


@pytest.mark.parametrize(
    "more",
    [
        [[2.0, 0.0, -1.0]],
        pytest.param([[1.0, 0.0, 0.0]], marks=pytest.mark.slow),
        pytest.param([[1e4, 0.0, 0.0], [0.0, 0.0, 1e-3], [1.0, 0.0, 1.0]], marks=pytest.mark.slow),
    ],
)
def test_redundant_outputs(more: Any) -> None:
    observer = observed(np.vstack([PART, more]))
    assert observer.certificate.margin > 0.0
    for k in (-0.5, 0.0):
        n = observer.system.gamma({"k": k}) - gain_at(observer, {"k": k}) @ observer.system.c
        assert np.linalg.eigvals(n).real.max() < -0.25
    errors, _, _ = run(observer, [0.0, 1.0, 0.0], np.arange(0.0, 20.0, 0.1))
    assert np.abs(errors[0]).max() > 1.0
    assert np.abs(errors[-1]).max() < 0.01


@pytest.mark.slow
def test_the_unknown_input_is_the_mean_over_each_interval() -> None:
    """Its error falls with the square of the interval, against the true d at the middle."""
    worst = []
    for h in (0.08, 0.04):
        times = np.arange(0.0, 12.0, h)
        _, estimates, _ = run(observed(PART), [0.3, -0.2, 0.5], times)
        middle = times[1:] - 0.5 * h
        found = np.array([e.d[0] for e in estimates[1:]])
        worst.append(np.abs(found - 1.5 * np.sin(2.0 * middle) - 0.5)[len(found) // 2 :].max())
    assert np.isnan(estimates[0].d).all()
    assert worst[0] < 3e-2
    assert 3.0 < worst[0] / worst[1] < 5.0


def test_the_spread_is_that_of_the_riccati_equation() -> None:
    from scipy.linalg import solve_discrete_are

    h, size, density = 0.02, 1e-3, 5.0
    _, estimates, _ = run(observed(PART), np.zeros(3), np.arange(0.0, 4.0, h), noise=size, density=density)
    # The unknown input moves the first output only, by C F = (1, 0)'.
    onward, row = np.array([[1.0, h], [0.0, 1.0]]), np.array([[1.0, 0.0]])
    growth = density * np.array([[h**3 / 3.0, h**2 / 2.0], [h**2 / 2.0, h]])
    before = solve_discrete_are(onward.T, row.T, growth, np.array([[size**2]]))
    after = before - before @ row.T @ row @ before / (before[0, 0] + size**2)
    assert estimates[-1].spread[0] == pytest.approx(np.sqrt(after[1, 1]), rel=1e-6)


def test_an_unknown_input_that_stays_is_bridged_without_error() -> None:
    """With a constant d the model with the last d is the plant: the error of a gap is that of its start."""
    a = np.array([[0.0, 1.0], [-2.0, -0.3]])
    one = ParameterVaryingSystem(lambda p: a + 0.0 * p["k"], lambda p: np.array([[1.0], [0.0]]), np.eye(1, 2))
    observer = UnknownInputObserver.design(one, Box({"k": (0.0, 0.0)}), 0.25)
    times = np.arange(0.0, 3.0, 0.01)
    truth = solve_ivp(
        lambda t, x: a @ x + [0.8, 0.0], (0.0, 3.0), [0.3, -0.2], t_eval=times, rtol=1e-11, atol=1e-12
    ).y.T
    stage = observer.stage([0.3, -0.2])
    for i, (t, x) in enumerate(zip(times, truth, strict=True)):
        y = x[:1] if i < 100 or i > 200 else np.array([NAN])
        estimate = stage.update(sample(t, y, known=[0.0, 0.0]))
        assert estimate.x == pytest.approx(x, abs=2e-4)
        assert estimate.certified == (i < 100 or i > 201)
        if i > 100:
            assert estimate.d[0] == pytest.approx(0.8, abs=1e-3)


def test_what_the_caller_writes_into_afterwards_changes_nothing() -> None:
    """Also: a schedule may be a dict, or a function as that of ``sample``."""
    stage, twin = observed(PART).stage([1.0, 2.0, 3.0]), observed(PART).stage([1.0, 2.0, 3.0])
    y, known, schedule = np.zeros(2), np.zeros(3), {"k": 0.0}
    for i in range(5):
        y[:], known[:], schedule["k"] = np.sin(i), np.cos(i), -0.1 * i
        estimate = stage.update(UnknownInputSample(0.1 * i, y, known, schedule))
        wanted = twin.update(sample(0.1 * i, y, schedule["k"], known))
        assert estimate.x.tobytes() == wanted.x.tobytes()
        assert estimate.d.tobytes() == wanted.d.tobytes()
        estimate.x[:] = estimate.d[:] = 1e6


def test_a_stage_is_pickled_in_the_middle_of_a_run() -> None:
    box, corners = Box({"k": (-0.5, 0.0)}), [A - 0.5 * np.eye(3), A]
    stage = UnknownInputObserver.design(CornerSystem(box, corners, F, PART), box, 0.25).stage()
    samples = [UnknownInputSample(0.1 * i, np.ones(2), np.zeros(3), {"k": -0.1 * i}) for i in range(4)]
    for one in samples[:2]:
        stage.update(one)
    twin = pickle.loads(pickle.dumps(stage))
    for one in samples[2:]:
        assert twin.update(one).x.tobytes() == stage.update(one).x.tobytes()


def test_the_first_output_may_be_missing() -> None:
    stage = observed(PART).stage([0.3, -0.2, 0.5])
    first, second = stage.update(sample(0.0, [NAN, NAN])), stage.update(sample(0.5, None))
    assert first.x.tolist() == [0.3, -0.2, 0.5]
    wanted = solve_ivp(lambda t, x: A @ x, (0.0, 0.5), first.x, rtol=1e-10, atol=1e-12).y[:, -1]
    assert second.x == pytest.approx(wanted, abs=1e-7)
    assert not first.certified
    assert np.isnan(second.d).all()


@pytest.mark.slow
def test_the_outputs_that_are_left_still_correct_along_f() -> None:
    """The second output is lost for a while: the first still shows what the unknown input does to it."""
    times = np.arange(0.0, 20.0, 0.04)
    lost = dict.fromkeys(range(150, 200), (1,))
    both = dict.fromkeys(range(150, 200), (0, 1))
    one, estimates, _ = run(observed(PART), [0.3, -0.2, 0.5], times, lost)
    none, _, _ = run(observed(PART), [0.3, -0.2, 0.5], times, both)
    gap = slice(151, 200)
    assert np.abs(one[gap, 0]).max() < 1e-6  # measured
    assert np.abs(one[gap]).max() < 0.5 * np.abs(none[gap]).max()
    assert not any(e.certified for e in estimates[gap])
    assert np.abs(none[-1]).max() < 5e-3  # after twelve seconds with both again
    assert np.abs(one[-1]).max() < 5e-3


def test_a_fast_unknown_input_observer_takes_short_steps() -> None:
    one = ParameterVaryingSystem(
        lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]), lambda p: np.array([[1.0], [0.0]]), np.eye(1, 2)
    )
    observer = UnknownInputObserver.design(one, Box({"k": (-310.0, -300.0)}), 0.5)
    stage = observer.stage([0.0, 1.0])
    for i in range(40):
        found = stage.update(sample(0.02 * i, [7.0], -300.0, [0.0, 0.0])).x[1]
    assert abs(found) < 1e-9
    quick = UnknownInputObserver.design(system(PART), Box({"k": (-0.5, 0.0)}), 0.25, output_decay=400.0)
    errors, _, _ = run(quick, [0.3, 0.2, 0.5], np.arange(0.0, 3.0, 0.04))
    assert np.abs(errors[-1]).max() < 0.05


def test_a_slow_plant_takes_as_many_steps_as_a_fast_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same plant in other units of time: the same number of rates between two samples."""
    counts, push = [], running.push
    for unit in (1.0, 1e-5):
        slow = system(PART, unit * A)
        design = UnknownInputObserver.design(slow, Box({"k": (-0.5 * unit, 0.0)}), 0.25 * unit)
        stage = design.stage([0.3, -0.2, 0.5])
        called: list[int] = []
        monkeypatch.setattr(running, "push", lambda *given, c=called: (c.append(0), push(*given)))
        for i in range(3):
            stage.update(sample(0.1 * i / unit, [1.0, 1.0]))
        counts.append(len(called))
    assert 0 < counts[0] == counts[1] < 200


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        (sample(0.0, [0.0, 0.0]), "t must increase"),
        (sample(0.1, [0.0, np.inf]), "y needs 2 finite numbers"),
        (sample(0.1, [1e308, -1e308]), "leaves every bound"),
        (UnknownInputSample(0.1, ["a", "b"], np.zeros(3), {"k": 0.0}), "y needs 2 numbers"),
        (UnknownInputSample(0.1, np.zeros(2), [[1.0, 2.0], [3.0]], {"k": 0.0}), "known needs 3 numbers"),
        (msgspec.structs.replace(sample(0.1, [0.0, 0.0]), t="1"), "t must be a finite number"),
        (msgspec.structs.replace(sample(0.1, [0.0, 0.0]), t=10**400), "t must be a finite number"),
        (UnknownInputSample(0.1, np.zeros(2), np.zeros(3), None), "schedule needs a number for each"),
        (UnknownInputSample(0.1, np.zeros(2), np.zeros(3), {"k": "a"}), "schedule needs a number for each"),
        (sample(1e9, None), r"bridges at most .* s, 1e\+05 steps: sample more often"),
        (None, "UnknownInputSample, with y=None where every output is missing"),
        (sample(0.1, [0.0, 0.0], lambda _: {}), "a point needs k"),
    ],
)
def test_refusals_change_nothing(wrong: Any, said: str) -> None:
    observer = observed(PART)
    stage = observer.stage([1.0, 2.0, 3.0])
    first = stage.update(sample(0.0, [0.0, 0.0])).x
    with pytest.raises((EventError, ParameterError, DivergenceError), match=said) as refused:
        stage.update(wrong)
    assert isinstance(refused.value, EventOrderError) == (said == "t must increase")
    after = stage.update(sample(0.1, [0.0, 0.0])).x
    stage.reset()
    for twin in (stage, stage.fresh()):
        assert np.array_equal(twin.update(sample(0.0, [0.0, 0.0])).x, first)
        assert np.array_equal(twin.update(sample(0.1, [0.0, 0.0])).x, after)


def test_outside_the_box_it_goes_on_and_says_so() -> None:
    """There the system's own matrices run, with the gains of the nearest point of the box."""
    observer = observed(PART)
    stage = observer.stage([0.3, -0.2, 0.5])
    for i, k in enumerate((-0.25, 0.5, -0.25)):
        assert stage.update(sample(0.02 * i, [0.0, 0.0], k)).certified == (k == -0.25)
    far = observer.stage([0.3, -0.2, 0.5])
    x, z = far.update(sample(0.0, [0.3, 0.5], 0.5)).x, None
    gain = gain_at(observer, {"k": 0.0})
    point = {"k": 0.5}
    gamma, e = observer.system.gamma(point), observer.system.e(point)
    z = solve_ivp(
        lambda _, z: gamma @ (z - e @ [0.3, 0.5]) + gain @ ([0.3, 0.5] - PART @ (z - e @ [0.3, 0.5])),
        (0.0, 0.1), x + e @ [0.3, 0.5], rtol=1e-11, atol=1e-12,
    ).y[:, -1]  # fmt: skip
    assert far.update(sample(0.1, [0.3, 0.5], 0.5)).x == pytest.approx(z - e @ [0.3, 0.5], abs=1e-5)


def damped(two: bool = False) -> UnknownInputObserver:
    """Three states, an unknown input at the first; errors of the outputs decay at 10 1/s."""
    a = np.array([[0.0, 1.0, 0.0], [-1.0, -2.0, 0.3], [0.0, 0.4, -1.0]])
    moving = np.array([[0.0, 0.0, 0.0], [-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    c = np.eye(3)[[0, 2]] if two else np.eye(1, 3)
    one = ParameterVaryingSystem(lambda p: a + p["k"] * moving, [[1.0], [0.0], [0.0]], c)
    return UnknownInputObserver.design(one, Box({"k": (0.0, 1.0)}), 0.5, output_decay=10.0)


def driven(observer: UnknownInputObserver, count: int, k: Any) -> list[UnknownInputSample]:
    width = len(observer.system.c)
    return [
        sample(0.01 * i, np.full(width, np.sin(0.01 * i)), k(i), [0.0, 0.1 * i, 0.0]) for i in range(count)
    ]


@pytest.mark.parametrize("two", [False, True])
def test_a_schedule_that_rests_gives_the_numbers_of_one_that_moves(two: bool) -> None:
    """Also where it first moves, and where it follows the estimate, whose steps are integrated."""
    observer = damped(two)

    def run(k: Any, width: float) -> list[Any]:
        """Estimates with ``width`` added to the schedule by halves, so that it moves in each interval."""
        stage = observer.stage([0.0, 1.0, -1.0])
        given = driven(observer, 40, lambda i: 0.0)
        return [
            stage.update(msgspec.structs.replace(one, schedule=lambda x, i=i: {"k": k(x) + width * (i % 2)}))
            for i, one in enumerate(given)
        ]

    for k in (lambda x: 0.5, lambda x: 0.5 + 0.1 * np.tanh(x[1])):
        resting, moving = run(k, 0.0), run(k, 1e-13)
        for one, other in zip(resting, moving, strict=True):
            assert one.x == pytest.approx(other.x, rel=1e-9, abs=1e-11)
            assert one.d == pytest.approx(other.d, rel=1e-7, abs=1e-9, nan_ok=True)
            assert one.certified == other.certified
