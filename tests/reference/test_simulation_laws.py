"""The closed loop against an independent integrator, closed forms and conservation laws."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pointpred.records import FloatArray
from pointpred.reproduction.model_checks import (
    ballistic_estimate,
    bare_memory,
    corrective_signals,
    minimum_jerk_check,
)
from pointpred.simulation import loop
from pointpred.transfer import Arctan, ConstantGain, SigmoidGain, TransferFunction


def play(memory: loop.Memory, reports: int) -> dict[str, FloatArray]:
    rows = np.zeros((reports, len(loop.INPUTS)))
    rows[:, 3:] = np.nan
    out = np.empty((reports, len(loop.OUTPUTS)))
    assert loop.play(memory.memory, rows, out) == reports
    return dict(zip(loop.OUTPUTS, out.T, strict=True))


def reference(
    function: TransferFunction, b1: float, b2: float, target: Any, scale: float, t: FloatArray
) -> Any:
    """The corrective phase (2.1) in two dimensions by scipy's adaptive Runge-Kutta; (x, y, vx, vy)."""
    aim = np.asarray(target)

    def rates(_: float, state: FloatArray) -> FloatArray:
        x, v = state[:2], state[2:]
        speed = float(np.hypot(*v))
        return np.concatenate([scale * function.gain(speed) * v, -b1 * v - b2 * (x - aim)])

    solution = solve_ivp(rates, (0.0, t[-1]), np.zeros(4), t_eval=t, rtol=1e-10, atol=1e-12, max_step=0.01)
    return solution.y


@pytest.mark.parametrize(("step_s", "x_px"), [(0.01, 1e-3), (0.001, 2e-4)])
def test_corrective_phase_of_section_2_6_2_agrees_with_scipy(step_s: float, x_px: float) -> None:
    """x is off by what arctan does within the first step: it saturates after a quarter of a millisecond."""
    signals = corrective_signals(step_s=step_s, duration_s=10.0)
    expected = reference(Arctan(), 4.0, 7.0, (600.0, 0.0), 1.0, signals.t)
    np.testing.assert_allclose(signals.x, expected[0], atol=x_px)
    np.testing.assert_allclose(signals.v, expected[2], atol=3e-4 * expected[2].max())


@pytest.mark.parametrize("function", [ConstantGain(4.0), SigmoidGain()])
def test_corrective_phase_in_two_dimensions_agrees_with_scipy(function: TransferFunction) -> None:
    scale = 96.0 / 0.0254
    b2 = 64.0 / (4.0 * scale)
    memory = bare_memory(function, period_s=0.001, px_per_metre=scale)
    memory.state.phase, memory.state.feedback, memory.settings.b1 = loop.CORRECTIVE, b2, 17.0
    memory.settings.aim_x, memory.settings.aim_y = 300.0, -180.0
    made = play(memory, 1500)
    expected = reference(function, 17.0, b2, (300.0, -180.0), scale, made["t"])
    for name, values in zip(("x", "y", "vx", "vy"), expected, strict=True):
        np.testing.assert_allclose(made[name], values, atol=2e-4 * np.abs(values).max(), err_msg=name)


def test_integration_is_of_second_order() -> None:
    def error(step_s: float) -> float:
        signals = corrective_signals(transfer=ConstantGain(1.0), target=1.0, step_s=step_s, duration_s=2.0)
        expected = reference(ConstantGain(1.0), 4.0, 7.0, (1.0, 0.0), 1.0, signals.t)
        return float(np.abs(signals.x - expected[0]).max())

    assert error(0.02) / error(0.01) == pytest.approx(4.0, rel=0.1)
    assert error(0.01) / error(0.005) == pytest.approx(4.0, rel=0.1)


def test_cursor_under_arctan_reaches_600_px_only_after_382_s() -> None:
    signals = corrective_signals(duration_s=420.0)
    assert np.diff(signals.x).max() <= 0.01 * np.pi / 2
    arrival = float(signals.t[np.argmax(signals.x >= 599.0)])
    assert arrival == pytest.approx(599.0 / (np.pi / 2), rel=0.01)
    assert signals.x[-1] == pytest.approx(600.0, abs=0.5)


@pytest.mark.parametrize(("b1", "b2"), [(4.0, 7.0), (2.0, 30.0), (16.0, 64.0)])
def test_constant_gain_settles_at_the_target_at_rest(b1: float, b2: float) -> None:
    signals = corrective_signals(b1=b1, b2=b2, target=-250.0, transfer=ConstantGain(1.0), duration_s=30.0)
    assert signals.x[-1] == pytest.approx(-250.0, abs=1e-6)
    assert signals.v[-1] == pytest.approx(0.0, abs=1e-6)
    assert signals.a[-1] == pytest.approx(0.0, abs=1e-5)


def ballistic(
    target_px: float, c: float, eta: float, friction: float
) -> tuple[loop.Memory, dict[str, FloatArray]]:
    """One piece without skew, noise or end: the thesis's ballistic law with PTF(V) = c V."""
    duration = np.pi / eta
    memory = bare_memory(ConstantGain(1.0), period_s=0.001, px_per_metre=c)
    settings, piece = memory.settings, memory.settings.pieces[0]
    piece.share, piece.duration_s, piece.until = 1.0, duration, 2.0
    settings.count, settings.b1, settings.aim_x = 1.0, friction, target_px
    return memory, play(memory, round(duration / 0.001))


@pytest.mark.parametrize("friction", [0.0, 12.0])
def test_ballistic_piece_is_the_cosine_of_section_2_4_2(friction: float) -> None:
    target, c, eta = 500.0, 12000.0, np.pi / 0.5
    _, made = ballistic(target, c, eta, friction)
    amplitude = target / c
    t = made["t"]
    np.testing.assert_allclose(made["u"], amplitude / 2 * (1 - np.cos(eta * t)), atol=2e-5 * amplitude)
    np.testing.assert_allclose(made["vx"], amplitude * eta / 2 * np.sin(eta * t), atol=2e-5 * amplitude * eta)
    np.testing.assert_allclose(made["x"], c * made["u"], rtol=1e-9)
    assert made["x"][-1] == pytest.approx(target, rel=1e-4)
    assert np.abs(made["v"]).max() == 0.0


def test_frictionless_ballistic_piece_keeps_its_energy() -> None:
    """V' = -eta^2 (x_m - A/2): kinetic and elastic energy of the unit mass add up to the same all the way."""
    eta = np.pi / 0.4
    _, made = ballistic(400.0, 9000.0, eta, 0.0)
    half = 0.5 * 400.0 / 9000.0
    energy = 0.5 * made["vx"] ** 2 + 0.5 * eta**2 * (made["u"] - half) ** 2
    np.testing.assert_allclose(energy, 0.5 * (eta * half) ** 2, rtol=1e-4)


def test_friction_takes_the_energy_the_feedback_gives() -> None:
    """d/dt V^2/2 = -b1 V^2 - b2 (x - T) V: the work of the force less friction is the kinetic energy."""
    signals = corrective_signals(transfer=ConstantGain(1.0), target=1.0, step_s=0.001, duration_s=1.0)
    power = -4.0 * signals.v**2 - 7.0 * (signals.x - 1.0) * signals.v
    work = np.concatenate([[0.0], np.cumsum(0.5 * (power[1:] + power[:-1]) * np.diff(signals.t))])
    np.testing.assert_allclose(0.5 * signals.v**2, work, atol=1e-5)


@pytest.mark.parametrize("skew", [-0.5, 0.0, 0.3, 0.9])
def test_profile_covers_the_way_and_matches_its_derivatives(skew: float) -> None:
    u = np.linspace(0.0, 1.0, 2001)
    share, rate, bend = np.array([loop.profile(float(value), skew) for value in u]).T
    assert (share[0], share[-1]) == (0.0, 1.0)
    assert (rate[1:-1] > 0.0).all()
    np.testing.assert_allclose(rate[1:-1], np.gradient(share, u)[1:-1], atol=2e-4)
    np.testing.assert_allclose(bend[2:-2], np.gradient(rate, u)[2:-2], atol=2e-2)
    assert (u[rate.argmax()] < 0.5) == (skew > 0.0)


@pytest.mark.parametrize("function", [ConstantGain(4.0), SigmoidGain()])
def test_a_person_who_feels_the_averaged_gain_lands_on_the_aim(function: TransferFunction) -> None:
    memory = bare_memory(function, period_s=0.001, px_per_metre=96.0 / 0.0254)
    amplitude = loop.hand_distance(memory.settings.memory, 567.0, 0.6)
    t = np.linspace(0.0, 0.6, 20001)
    speed = amplitude * np.pi / 1.2 * np.sin(np.pi * t / 0.6)
    exact = np.trapezoid(function.cursor_speed(speed), t) * 96.0 / 0.0254
    assert exact == pytest.approx(567.0, rel=5e-3)


def test_doubling_is_exact_at_the_peak_of_minimum_jerk() -> None:
    check = minimum_jerk_check(2001)
    peak = int(check.v.argmax())
    assert check.t[peak] == 0.5
    assert check.v[peak] == 1.875
    np.testing.assert_allclose(check.estimate[peak:], 1.0, atol=1e-8)
    np.testing.assert_allclose(check.estimate[:peak], 2.0 * check.x[:peak], atol=1e-12)
    # The formula is the solution of Hogan's boundary problem: rest at both ends, sixth derivative zero.
    power = np.polynomial.Polynomial.fit(check.t, check.x, 7, domain=[0, 1], window=[0, 1])
    np.testing.assert_allclose(power.coef, [0, 0, 0, 10, -15, 6, 0, 0], atol=1e-7)
    np.testing.assert_allclose(check.v, power.deriv()(check.t), atol=1e-7)


def test_doubling_without_samples_on_the_peak_is_off_by_the_way_between_two_samples() -> None:
    check = minimum_jerk_check(100)
    final = float(check.estimate[-1])
    assert 1.0 - 2 * 1.875 / 99 < final < 1.0


def test_a_sub_movement_adds_twice_its_own_half() -> None:
    """From 0 to 1 and on to 1.5: at the second peak, at 1.25, the end of both is known."""
    t = np.linspace(0.0, 2.0, 401)
    x = np.where(t < 1.0, 0.5 - 0.5 * np.cos(np.pi * t), 1.0 + 0.25 - 0.25 * np.cos(np.pi * (t - 1.0)))
    v = np.gradient(x, t)
    estimate = ballistic_estimate(t, x, v, np.gradient(v, t))
    assert estimate[190] == pytest.approx(1.0, abs=0.03)
    assert estimate[-10] == pytest.approx(1.5, abs=0.03)


def test_a_bent_piece_turns_at_the_planned_rate_and_keeps_its_speed() -> None:
    """The velocity points along angle + curve (1 - 2 share); its size is that of the straight piece."""
    curve, turn = 0.4, -0.7
    straight, bent = (play(piece(bend, turn), 500) for bend in (0.0, curve))
    np.testing.assert_allclose(
        np.hypot(bent["vx"], bent["vy"]), np.hypot(straight["vx"], straight["vy"]), rtol=1e-3, atol=1e-6
    )
    share = 0.5 * (1.0 - np.cos(np.pi * bent["t"] / 0.5))
    moving = slice(20, -20)
    heading = np.unwrap(np.arctan2(bent["vy"], bent["vx"]))
    np.testing.assert_allclose(heading[moving], (turn + curve * (1.0 - 2.0 * share))[moving], atol=2e-3)


def piece(curve: float, turn: float) -> loop.Memory:
    """The memory of one ballistic piece of half a second along the x axis, turned and bent."""
    memory = bare_memory(ConstantGain(1.0), period_s=0.001, px_per_metre=9000.0)
    memory.settings.pieces[0].memory[:] = [1.0, 0.5, 0.0, turn, curve, 2.0]
    memory.settings.count, memory.settings.aim_x = 1.0, 450.0
    return memory


def test_sensor_delay_and_whole_pixels_barely_change_the_corrective_phase() -> None:
    """The hand's known motion makes up for the eyes' delay where the gain is constant."""
    scale = 96.0 / 0.0254
    made = []
    for unit, delay_s in ((0.0, 0.0), (0.0254 / 2000.0, 0.12)):
        memory = bare_memory(ConstantGain(4.0), period_s=0.001, px_per_metre=scale)
        settings, state = memory.settings, memory.state
        settings.metres_per_count, settings.delay_s = unit, delay_s
        state.phase, state.feedback = loop.CORRECTIVE, 64.0 / (4.0 * scale)
        settings.b1, settings.aim_x = 17.0, 300.0
        made.append(play(memory, 2000))
    np.testing.assert_allclose(made[1]["x"], made[0]["x"], atol=2.0)
    assert made[1]["x"][-1] == pytest.approx(300.0, abs=1.5)
