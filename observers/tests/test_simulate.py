"""Plants beside their observers, against closed forms and against equations solved by scipy."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import pointpred_observers as o
from observers.tests import kept_designs as kept
from pointpred.errors import DivergenceError, EventError, ParameterError
from pointpred_observers import trajectory
from pointpred_observers.interconnected.persidskii_stage import PersidskiiStage
from pointpred_observers.simulations import signals
from pointpred_observers.simulations.signals import SeededSignal

pytest.importorskip("cvxpy")

TIMES = np.arange(0.0, 3.0, 0.01)


def solved(field: Any, start: Any, times: Any = TIMES) -> Any:
    """The solution by an implicit method that the library does not use."""
    answer = solve_ivp(
        field, (times[0], times[-1]), start, "Radau", times, rtol=1e-9, atol=1e-11, max_step=0.05
    )
    return answer.y.T


def test_a_linear_plant_and_its_error_follow_the_exponential() -> None:
    design = kept.design("reduced order, linear")
    result = o.simulate(kept.CART, design, times=TIMES, start=[1.0, -2.0], estimate=[0.0, 0.5])
    exact = np.array([expm(kept.CART.A0 * t) @ [1.0, -2.0] for t in TIMES])
    assert np.allclose(result.state, exact, atol=1e-7)
    now = design.observer.at(0.0)
    onto = design.observer.recovery(0.0)[0][1, 0]
    error = onto * (now.Z @ np.array([-1.0, 2.5]))[0] * np.exp(now.S0[0, 0] * TIMES)
    # y between the samples is a line for the observer
    assert np.allclose(result.error[:, 1], error, atol=1e-4)
    assert np.abs(result.error[:, 0]).max() < 1e-12  # measured without noise
    assert (np.linalg.norm(result.error, axis=1) <= result.bound * (1.0 + 1e-9) + 1e-4).all()
    unknown, driving, count = result.unknown_input, result.driving, len(result.t)
    assert (unknown.shape, driving.shape) == ((count, 0), (count, 0))


def test_a_pendulum_with_inputs_and_its_full_order_observer() -> None:
    design = kept.design("full order")
    m = design.gain[:, 0]

    def field(t: float, both: Any) -> Any:
        a, s, b, r = both
        u, rho = np.sin(2.0 * t), 0.3
        return [s, -0.3 * s - 9.81 * np.sin(a) + u + 0.5 * rho,
                r + m[0] * (a - b), -0.3 * r - 9.81 * np.sin(b) + u + 0.5 * rho + m[1] * (a - b)]  # fmt: skip

    times = np.arange(0.0, 3.0, 0.002)
    result = o.simulate(
        kept.PENDULUM, design, times=times, start=[0.5, 0.0], estimate=[0.0, 1.0],
        input=lambda t: [np.sin(2.0 * t), 0.3],
    )  # fmt: skip
    exact = solved(field, [0.5, 0.0, 0.0, 1.0], times)
    assert np.allclose(result.state, exact[:, :2], atol=1e-6)
    assert np.allclose(result.estimate, exact[:, 2:], atol=2e-4)
    assert np.array_equal(result.input[:, 1], np.full(len(times), 0.3))
    assert (np.linalg.norm(result.error, axis=1) <= result.bound).all()


def test_discrete_plants_follow_their_recursion() -> None:
    design = kept.design("full order, discrete")
    result = o.simulate(kept.TANKS, design, times=range(40), start=[1.0, 2.0], input=[0.5], noise=0.1, seed=3)
    x, z = np.array([1.0, 2.0]), np.zeros(2)
    noise = 0.1 * np.random.default_rng(3).standard_normal((40, 1))
    for k in range(40):
        assert np.allclose(result.state[k], x, atol=1e-12)
        assert np.allclose(result.estimate[k], z, atol=1e-12)
        y = x[1] + noise[k, 0]
        drive = np.array([0.05, 0.0])
        z = kept.TANKS.A0 @ z + drive + design.gain[:, 0] * (y - z[1])
        x = kept.TANKS.A0 @ x + drive
    assert result.discrete
    assert not result.bound.size


def test_a_discrete_reduced_order_observer_keeps_its_bound() -> None:
    result = o.simulate(kept.TANKS, kept.design("reduced order, discrete"), times=range(60))
    assert (np.linalg.norm(result.error, axis=1) <= result.bound * (1.0 + 1e-9) + 1e-12).all()
    assert result.bound[-1] < 1e-9


def test_a_driven_plant_with_its_generator() -> None:
    design = kept.design("driven")

    def field(t: float, both: Any) -> Any:
        x1, x2, w = both
        return [-x1 + 0.5 * x2 + 0.1, -2.0 * x2 - np.tanh(x1) + 4.0 * w + np.tanh(w), 0.0]

    result = o.simulate(
        kept.DRIVEN, design, times=np.arange(0.0, 8.0, 0.01), start=[1.0, 0.0, 2.0], disturbance=[0.1, 0.0]
    )
    exact = solved(field, [1.0, 0.0, 2.0], np.arange(0.0, 8.0, 0.01))
    assert np.allclose(result.state, exact[:, :2], atol=1e-6)
    assert np.allclose(result.driving[:, 0], 2.0)
    quiet = o.simulate(kept.DRIVEN, design, times=np.arange(0.0, 12.0, 0.01), start=[2.0, 4.0])
    assert np.allclose(quiet.driving[:, 0], 2.0)  # Pi w = x
    assert np.allclose(quiet.driving_estimate[-1], quiet.driving[-1], atol=1e-3)


@pytest.mark.parametrize("name", ["unknown input", "unknown input, discrete"])
def test_an_unknown_input_is_reconstructed(name: str) -> None:
    design = kept.design(name)
    discrete = name.endswith("discrete")
    plant = kept.SAMPLED_WING if discrete else kept.WING
    times = np.arange(100.0) if discrete else np.arange(0.0, 8.0, 0.02)
    k = 0.3 if discrete else 2.0
    result = o.simulate(plant, design, times=times, unknown_input=[-0.7], schedule={"k": k}, input=[0.0, 0.2])
    a, f = plant.a({"k": k}), plant.f({})[:, 0]
    if discrete:
        x = np.ones(2)
        for row in result.state:
            assert np.allclose(row, x)
            x = a @ x + [0.0, 0.2] - 0.7 * f
    else:
        exact = solved(lambda t, x: a @ x + [0.0, 0.2] - 0.7 * f, [1.0, 1.0], times)
        assert np.allclose(result.state, exact, atol=1e-6)
    assert np.allclose(result.estimate[-1], result.state[-1], atol=1e-3)
    assert np.allclose(result.unknown_input_estimate[-1], [-0.7], atol=1e-3)
    moving = o.simulate(
        plant, design, times=times, schedule=lambda t, x: {"k": k + 0.1 * np.tanh(x[0])}, noise=1e-3
    )
    assert np.isfinite(moving.estimate).all()


def test_a_schedule_that_leaves_the_box_is_told() -> None:
    said = r"schedule leaves the box of the design at 401 samples, first k at t = 0\.6: what is proved"
    with pytest.warns(UserWarning, match=said):
        o.simulate(
            kept.WING,
            kept.design("unknown input"),
            times=np.arange(0.0, 1.0001, 0.001),
            schedule={"k": lambda t: 2.0 if t < 0.5995 else 9.0},
        )


def test_an_interlaced_plant() -> None:
    def field(t: float, both: Any) -> Any:
        w1, w2, x1, x2 = both
        return [w2, -w1, -x1 + x2**2, -np.sin(x2) + w2 + np.sin(w1)]

    start, times = [0.5, 0.0, 0.2, 0.0], np.arange(0.0, 20.0, 0.02)
    result = o.simulate(kept.SYMBOLIC, kept.design("interlaced"), times=times, start=start)
    exact = solved(field, start, times)
    assert np.allclose(result.driving, exact[:, :2], atol=1e-6)
    assert np.allclose(result.state, exact[:, 2:], atol=1e-6)
    assert np.allclose(result.estimate[-1], result.state[-1], atol=1e-2)
    assert np.allclose(result.input[:, 0], exact[:, 1] + np.sin(exact[:, 0]), atol=1e-6)


def test_a_plant_that_is_stiff_or_slow() -> None:
    stiff = o.Persidskii([[-1e5, 1e5], [0.0, -1.0]], None, None, "sin", C0=[0.0, 1.0])
    result = o.simulate(stiff, o.design(stiff, "reduced", decay=2.0), times=TIMES)
    assert np.allclose(result.state[-1], np.exp(-TIMES[-1]) * np.array([1e5 / (1e5 - 1.0), 1.0]), atol=1e-6)
    slow = o.Persidskii([[-1e-4, 0.0], [1e-4, -2e-4]], None, None, "sin", [1e-4, 0.0], None, [0.0, 1.0])
    times = 60.0 * np.arange(300.0)
    result = o.simulate(slow, o.design(slow, "reduced", decay=5e-4), times=times, input=[1.0])
    assert np.abs(result.error[-1]).max() < 1e-3  # no interval is a gap, after which it would restart


@pytest.mark.parametrize("unit", [1e-3, 1.0, 60.0])
def test_a_loop_estimates_the_same_in_every_unit_of_time(unit: float) -> None:
    """The unit in s: a plant that is sampled once a second, 1000 units of 1 ms or 1/60 of a minute apart."""
    cart = o.Persidskii([[0.0, unit], [0.0, -0.3 * unit]], None, None, "sin", [0.0, unit], None, [1.0, 0.0])
    design = o.design(cart, "reduced", decay=0.5 * unit)
    result = o.simulate(cart, design, times=np.arange(30) / unit, input=[1.0])
    loop = design.observer.stage()
    answers = [loop.update(t, [y[0], 1.0]) for t, y in zip(result.t, result.output, strict=True)]
    assert np.array_equal(answers, result.estimate)
    assert answers[-1] == pytest.approx(result.state[-1], rel=1e-4)


def test_samples_too_far_apart_for_a_fast_observer_are_refused() -> None:
    stage = PersidskiiStage([[-1e8]], None, None, [[1e8]], "sin")
    stage.update(0.0, 1.0)
    before = stage.remembered()
    with pytest.raises(EventError, match=r"comes 0\.01 s after the last one, .* most 0\.001 s"):
        stage.update(0.01, 1.0)
    assert stage.remembered() == before
    table = np.array([[1e-4, 1.0], [0.01, 1.0]])
    with pytest.raises(EventError, match="sample more often, or give gap_s"):
        stage.walk(np.zeros(2, np.bool_), table)
    assert stage.remembered() == before
    assert np.isfinite(stage.walk(np.array([False, True]), table)).all()  # another run begins
    design = o.design(kept.CART, "reduced", decay=3e4)
    with pytest.raises(ParameterError, match="times: samples lie 10 s apart, more than 1e5 steps"):
        o.simulate(kept.CART, design, times=[0.0, 10.0])


def test_another_plant_than_the_design_shows_what_a_wrong_model_does() -> None:
    heavier = o.Persidskii([[0.0, 1.0], [0.0, -1.5]], None, None, "sin", [0.0, 0.5], None, [1.0, 0.0])
    design = kept.design("reduced order, linear")
    right = o.simulate(kept.CART, design, times=TIMES, input=[1.0])
    wrong = o.simulate(heavier, design, times=TIMES, input=[1.0])
    assert right.rmse(after=2.5)[1] < 1e-2 < wrong.rmse(after=2.5)[1]
    assert (right.bound.size, wrong.bound.size) == (len(TIMES), 0)  # nothing is proved of another plant


@pytest.mark.parametrize("name", ["full order", "reduced order, linear"])
def test_nothing_is_proved_of_a_plant_that_varies(name: str) -> None:
    """Its matrices agree with those of the design at 0 only."""
    design = kept.design(name)
    known = design.plant
    given = known.matrices(0.0)
    constant = o.Persidskii(f=known.f, **given)
    growing = {"A0": lambda t: known.A0 + 3.0 * t * np.diag([0.0, 1.0])}
    varying = o.Persidskii(f=known.f, **{**given, **growing})
    times = np.arange(0.0, 1.0, 0.01)
    assert o.simulate(constant, design, times=times).bound.size == len(times)
    assert not o.simulate(varying, design, times=times).bound.size


def test_noise_is_seeded_and_as_large_as_asked() -> None:
    design = kept.design("reduced order, linear")
    first, second = (
        o.simulate(kept.CART, design, times=np.arange(0.0, 30.0, 0.01), noise=[0.2]) for _ in range(2)
    )
    assert np.array_equal(first.output, second.output)
    assert np.std(first.output - first.state[:, :1]) == pytest.approx(0.2, rel=0.05)
    other = o.simulate(kept.CART, design, times=TIMES, noise=0.2, seed=1)
    assert not np.array_equal(first.output[: len(TIMES)], other.output)


RIGHT = {"plant": kept.CART, "observer": "reduced order, linear", "times": TIMES[:20]}
WRONG = [
    ({"start": [1.0]}, "start must be 2 numbers"),
    ({"times": [1.0, 0.0]}, "times needs two samples"),
    ({"unknown_input": [1.0]}, "has no unknown_input"),
    ({"plant": kept.PENDULUM}, "received one of 2 states, 2 inputs"),
    ({"plant": kept.TANKS}, "discrete time"),
    ({"plant": lambda t, x: -x, "observer": [1.0]}, "trajectory(field, start, times)"),
    ({"plant": kept.CART, "observer": "unknown input"}, "plant must be a ParameterVaryingSystem"),
    ({"plant": kept.WING, "observer": "unknown input", "schedule": {"q": 1.0}}, "schedule lacks k"),
    ({"plant": kept.WING, "observer": "unknown input, discrete"}, "in discrete time"),
    ({"plant": kept.SYMBOLIC, "observer": "interlaced", "input": [1.0]}, "has no input"),
    ({"plant": kept.TANKS, "observer": "full order, discrete", "times": [0.0, 2.0]}, "go up by 1"),
]


@pytest.mark.parametrize(("change", "words"), WRONG, ids=[row[1] for row in WRONG])
def test_a_wrong_argument_is_named(change: dict[str, Any], words: str) -> None:
    asked = {**RIGHT, **change}
    plant, observer = asked.pop("plant"), asked.pop("observer")
    observer = kept.design(observer) if isinstance(observer, str) else observer
    with pytest.raises(ParameterError) as wrong:
        o.simulate(plant, observer, **asked)
    assert words in str(wrong.value)


def test_a_figure_is_written_in_one_call(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    result = o.simulate(kept.CART, kept.design("reduced order, linear"), times=TIMES)
    for ending, begins in ((".svg", b"<svg"), (".png", b"\x89PNG")):
        figure = result.plot(tmp_path / f"cart{ending}")
        assert (tmp_path / f"cart{ending}").read_bytes().startswith(begins)
    assert [ax.get_ylabel() for ax in figure.axes] == ["x1", "x2", "error"]
    drawn = figure.axes[1].lines[1].get_ydata()
    assert np.array_equal(np.asarray(drawn), result.estimate[:, 1])
    with pytest.raises(ParameterError, match=r"\.svg, \.png, \.pdf"):
        result.plot(tmp_path / "cart.bmp")


FAILING: list[tuple[str, Any, str]] = [
    ("schedule", lambda t: {"k": 1.0}, r"function of t and x, it fails at t = 0: TypeError"),
    ("schedule", lambda t, x: 1.0, r"schedule must return a dict of k, received 1\.0 at t = 0"),
    ("schedule", lambda t, x: {"k": 1.0 / t}, "it fails at t = 0: ZeroDivisionError"),
    (
        "schedule",
        lambda t, x: {"k": np.nan if t > 0.05 else 1.5},
        r"finite number .* received nan at t = 0\.0",
    ),
    ("schedule", {"k": "a"}, r"a finite number for k, received 'a' at t = 0"),
    ("input", lambda: 1.0, "it fails at t = 0: TypeError: .* takes 0 positional arguments"),
    ("input", lambda t: np.nan if t > 0.05 else 1.0, r"input must be finite, it is \[nan\] at t = 0\.0"),
]


@pytest.mark.parametrize(("field", "given", "words"), FAILING, ids=[row[2][:30] for row in FAILING])
def test_a_function_that_fails_is_named_with_its_time(field: str, given: Any, words: str) -> None:
    plant = kept.WING if field == "schedule" else kept.CART
    design = kept.design("unknown input" if field == "schedule" else "reduced order, linear")
    with pytest.raises(ParameterError, match=words) as refused:
        o.simulate(plant, design, times=TIMES[:20], **{field: given})
    assert refused.value.field == field


@given(st.integers(0, 100))
@settings(max_examples=10)
def test_no_jump_of_a_disturbance_is_stepped_over(seed: int) -> None:
    noise = SeededSignal(seed, 1, 0.5, period_s=0.1)
    times = np.arange(0.0, 2.05, 0.1)
    expected, x = [1.0], 1.0
    for t in times[:-1]:
        held = noise(t + 0.05)[0]
        x = held + (x - held) * np.exp(-0.1)
        expected.append(x)
    found = trajectory(lambda t, x: -x + noise(t), [1.0], times)
    assert np.allclose(found[:, 0], expected, atol=1e-8)


def test_a_seeded_signal_is_a_function_of_time() -> None:
    noise, twin = SeededSignal(3, 2, 0.2), SeededSignal(3, 2, 0.2)
    forward = [noise(t) for t in np.arange(0.0, 30.0, 0.01)]
    backward = [twin(t) for t in np.arange(0.0, 30.0, 0.01)[::-1]][::-1]
    assert np.array_equal(forward, backward)
    assert np.abs(forward).max() <= 0.2
    assert np.std(forward) == pytest.approx(0.2 / np.sqrt(3.0), rel=0.03)
    assert not np.array_equal(SeededSignal(4, 2, 0.2)(0.0), noise(0.0))


def test_what_blows_up_is_said_with_its_time() -> None:
    with pytest.raises(DivergenceError, match=r"near t = 1\b"):
        trajectory(lambda t, x: x * x, [1.0], np.arange(0.0, 3.0, 0.25))


def test_a_start_beyond_what_can_be_computed_ends_at_once() -> None:
    with pytest.raises(DivergenceError, match=r"leaves every bound (near|after) t = 0"):
        trajectory(lambda t, x: -5e3 * x, [1e308], [0.0, 0.5, 1.0])


def test_a_field_that_turns_too_fast_ends_after_so_many_values(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(signals, "CALLS_MOST", 5000)
    with pytest.raises(
        DivergenceError, match="needs more than 7000 values of the field and has reached t = "
    ):
        trajectory(lambda t, x: 1e9 * np.array([x[1], -x[0]]), [1.0, 0.0], [0.0, 1.0])
