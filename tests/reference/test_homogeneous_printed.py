"""The thesis's equation (2.2) and its discrete form, written out plainly here, against the compiled law."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns
from pointpred.differentiators import HomogeneousDifferentiator

K1, K2, K3, K4 = 75.0, 1750.0, 15000.0, 40000.0
H = 0.001


def reach(length_s: float = 0.7) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Time, position and velocity of a minimum-jerk reach of 0.1 m in 0.7 s at 1 kHz."""
    t = np.arange(round(length_s / H)) * H
    s = np.clip(t / 0.7, 0.0, 1.0)
    return t, 0.1 * (10 * s**3 - 15 * s**4 + 6 * s**5), 0.1 / 0.7 * 30 * s**2 * (1 - s) ** 2


def signed_power(error: float, power: float) -> float:
    """|error|^power with the sign of error."""
    return float(np.sign(error) * np.abs(error) ** power)


def printed(y: np.ndarray, alpha: float, last_sign: float, start: float = 0.0) -> np.ndarray:
    """Rows z^(k+1) of the discrete equations, the last line's k4 with either sign."""
    z1, z2, z3, z4 = start, 0.0, 0.0, 0.0
    rows = []
    for yk in y:
        error = z1 - yk
        z1, z2, z3, z4 = (
            z1 + H * (z2 - K1 * signed_power(error, 1 + alpha)),
            z2 + H * (z3 - K2 * signed_power(error, 1 + 2 * alpha)),
            z3 + H * (z4 - K3 * signed_power(error, 1 + 3 * alpha)),
            z4 + H * last_sign * K4 * signed_power(error, 1 + 4 * alpha),
        )
        rows.append((z1, z2, z3, z4))
    return np.array(rows)


def test_the_printed_plus_sign_diverges() -> None:
    _, y, _ = reach(1.4)
    velocity = np.abs(printed(y, -0.2, +1.0)[:, 1])
    assert velocity[:700].max() > 10.0  # the hand never moves faster than 0.27 m/s
    assert velocity[1300:].max() > 3.0 * velocity[:700].max()


def test_the_minus_sign_follows_to_a_millimetre_per_second_or_two() -> None:
    t, y, v = reach()
    velocity = printed(y, -0.2, -1.0)[:, 1]
    # z^(k+1) belongs to the next sample's time; read there it is one sample less early.
    assert np.sqrt(np.mean((velocity - v) ** 2)) == pytest.approx(0.00127, abs=3e-5)
    assert t[velocity.argmax()] - 0.35 == pytest.approx(-0.002, abs=1e-9)
    assert np.sqrt(np.mean((velocity[:-1] - v[1:]) ** 2)) < 0.0010


@pytest.mark.parametrize("alpha", [-0.2, -0.1, -0.25, 0.0])
@pytest.mark.parametrize("between", ["hold", "line"])
def test_compiled_law_is_the_printed_one(alpha: float, between: str) -> None:
    t, y, _ = reach()
    metres = HomogeneousDifferentiator(alpha=alpha, between=between, dpi=2.54)  # 1 px is 1 cm
    motions = metres.run(EventColumns.of(t, 100.0 * y, -200.0 * y))
    # One Euler step lies between two samples: it sees the new position (hold) or the old one (line).
    first = {"hold": 1, "line": 0}[between]
    wanted = printed(y[first:], alpha, -1.0)[: len(y) - 1]
    rounding = 1e-12 if alpha == 0.0 else 1e-4 if alpha == -0.25 else 1e-6
    np.testing.assert_allclose(motions.vx[1:], wanted[:, 1], atol=rounding)
    np.testing.assert_allclose(motions.ax[1:], wanted[:, 2], atol=1e3 * rounding)


def test_gains_from_lambda_and_xi_are_the_printed_ones() -> None:
    lam, xi = 7.0, 1.7
    expected = (
        (1 + xi + xi**2 + xi**3) * lam,
        (1 + xi + 2 * xi**2 + xi**3 + xi**4) * xi * lam**2,
        (1 + xi + xi**2 + xi**3) * xi**3 * lam**3,
        xi**6 * lam**4,
    )
    assert HomogeneousDifferentiator().gains == (K1, K2, K3, K4)
    np.testing.assert_allclose(HomogeneousDifferentiator(gain_lambda=lam, gain_xi=xi).gains, expected)


def test_given_gains_are_the_same_law_as_lambda_and_xi() -> None:
    t, y, _ = reach()
    events = EventColumns.of(t, 4000.0 * y, y)
    given = HomogeneousDifferentiator(gains=[K1, K2, K3, K4]).run(events)
    assert np.array_equal(given.table, HomogeneousDifferentiator().run(events).table)


@pytest.mark.parametrize("between", ["hold", "line"])
@pytest.mark.parametrize("interval", [0.008, 1.0 / 60.0])
def test_sub_steps_are_the_printed_law_on_a_finer_clock(between: str, interval: float) -> None:
    """Feeding the positions in between by hand gives what the sub-steps give."""
    t = np.arange(60) * interval
    y = 0.05 * np.sin(6.0 * t)
    coarse = HomogeneousDifferentiator(alpha=-0.1, between=between, step_s=0.0021).run(
        EventColumns.of(t, 4000.0 * y, np.zeros_like(y))
    )
    steps = int(np.ceil(interval / 0.0021))
    z = np.zeros(4)
    gains = np.array([K1, K2, K3, K4])
    powers = 1.0 - 0.1 * np.arange(1, 5)
    u = 4000.0 * (y - y[0]) * 0.0254 / 96.0
    for before, now, velocity in zip(u[:-1], u[1:], coarse.vx[1:], strict=True):
        for i in range(steps):
            measured = now if between == "hold" else before + (now - before) * i / steps
            error = z[0] - measured
            slopes = np.append(z[1:], 0.0) - gains * np.sign(error) * np.abs(error) ** powers
            z = z + interval / steps * slopes
        assert velocity == pytest.approx(z[1], abs=1e-7)
