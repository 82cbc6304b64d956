"""A device at rest must seem to rest: what explicit Euler makes of a gain that grows without bound."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

from pointpred import REGISTRY, EventColumns, build
from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.errors import ParameterError

CHATTERS: list[dict[str, Any]] = [
    {"gain_lambda": 48.0, "gain_xi": 1.6, "alpha": -0.2},
    {"gain_lambda": 48.0, "gain_xi": 1.6, "alpha": -0.25},
    {"gain_lambda": 100.0, "gain_xi": 2.0, "alpha": -0.25, "step_s": 0.002},
    {"order": 2, "alpha": -0.5, "gains": [40.0, 400.0]},
    {"alpha": -0.1, "step_s": 0.0499},
]


def at_rest(differentiator: HomogeneousDifferentiator, interval: float, place_m: float) -> float:
    """Largest speed from 3 s on after the position stepped by ``place_m``; ``interval`` s between events."""
    t = np.arange(0.0, 4.0, interval)
    x = np.full(len(t), place_m * 96.0 / 0.0254)
    x[0] = 0.0
    motions = differentiator.run(EventColumns.of(t, x, -0.5 * x))
    return float(np.hypot(motions.vx, motions.vy)[t > 3.0].max())


@pytest.mark.parametrize("settings", CHATTERS)
def test_settings_that_chatter_are_refused_with_a_way_out(settings: dict[str, Any]) -> None:
    with pytest.raises(ParameterError, match=r"chatters by .* m/s, at most 0\.05 m/s: choose") as refused:
        HomogeneousDifferentiator(**settings)
    for way_out in ("smaller step_s", "gain_lambda", "alpha nearer to 0"):
        assert way_out in str(refused.value)


def test_the_speed_it_names_is_that_of_the_law_written_a_second_time() -> None:
    with pytest.raises(ParameterError) as refused:
        HomogeneousDifferentiator(**CHATTERS[0])
    found = re.search(r"chatters by (\S+) m/s", str(refused.value))
    assert found
    gains = np.poly(-48.0 * 1.6 ** np.arange(4))[1:]
    z, speeds = np.zeros(4), []
    for _ in range(4000):
        error = z[0] - 1e-3
        z = z + 0.0015 * (
            np.append(z[1:], 0.0) - gains * np.sign(error) * np.abs(error) ** (1.0 - 0.2 * np.arange(1, 5))
        )
        speeds.append(abs(z[1]))
    assert float(found[1]) == pytest.approx(max(speeds[3000:]), rel=0.1)


@pytest.mark.parametrize("way_out", [{"step_s": 0.0005}, {"gain_lambda": 20.0}, {"alpha": -0.15}])
def test_each_way_out_is_one(way_out: dict[str, Any]) -> None:
    differentiator = HomogeneousDifferentiator(**(CHATTERS[0] | way_out))
    assert at_rest(differentiator, 0.0015, 1e-3) <= 0.05 * np.hypot(1.0, 1.0)


@pytest.mark.parametrize("name", list(REGISTRY))
@pytest.mark.parametrize("interval", [0.001, 0.0015, 0.008])
def test_presets_rest(name: str, interval: float) -> None:
    differentiator = build(name).differentiator
    for place_m in (1.27e-5, 1e-3):
        assert at_rest(differentiator.fresh(), interval, place_m) < 1e-4


@pytest.mark.parametrize("order", [3, 4])
def test_the_sliding_mode_end_is_within_reach(order: int) -> None:
    differentiator = HomogeneousDifferentiator(order=order, alpha=-1.0 / order)
    assert at_rest(differentiator, 0.001, 1e-3) < 0.01
