"""Every differentiator keeps its stated error bounds, and the bounds say something."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from pointpred.differentiators import DIFFERENTIATORS
from tests.differentiator_bounds import BOUNDS, measure, named
from tests.signals import SIGNALS

PAIRS = list(itertools.product(DIFFERENTIATORS, SIGNALS))
FIELDS = ("velocity_rms", "velocity_largest", "acceleration_rms", "acceleration_largest", "settling_s")
LOOSEST = 1.6
"""A bound may exceed what was measured by this factor; rounding to two digits is included."""


@pytest.mark.parametrize(("name", "signal"), PAIRS)
def test_errors_stay_within_tight_bounds(name: str, signal: str) -> None:
    sampled = SIGNALS[signal]()
    errors, bound = measure(named(name, sampled), sampled), BOUNDS[name][signal]
    for field, rounding in zip(FIELDS, (1e-12, 1e-12, 1e-9, 1e-9, 0.0), strict=True):
        measured, most = getattr(errors, field), getattr(bound, field)
        assert measured <= most, field
        assert most <= max(LOOSEST * measured, rounding), f"the bound of {field} says too little"
    if bound.delay_s is None:
        assert errors.delay_s is None
    else:
        assert errors.delay_s is not None
        assert abs(errors.delay_s) <= bound.delay_s <= max(LOOSEST * abs(errors.delay_s), 2e-4)


def test_table_is_complete() -> None:
    assert {(name, signal) for name, row in BOUNDS.items() for signal in row} == set(PAIRS)


@pytest.mark.parametrize("signal", [name for name in SIGNALS if "CPI" not in name])
def test_the_signals_derivatives_are_those_of_their_positions(signal: str) -> None:
    sampled = SIGNALS[signal]()
    t, position = sampled.events.t, sampled.events.x * 0.0254 / 96.0
    velocity = np.gradient(position, t, edge_order=2)
    acceleration = np.gradient(sampled.velocity, t, edge_order=2)
    np.testing.assert_allclose(velocity, sampled.velocity, atol=2e-4)
    np.testing.assert_allclose(acceleration, sampled.acceleration, atol=5e-2)


@pytest.mark.parametrize("signal", [name for name in SIGNALS if "CPI" in name])
def test_quantised_signals_are_whole_counts_off_by_half_a_count(signal: str) -> None:
    sampled = SIGNALS[signal]()
    counts = sampled.events.dx
    assert np.array_equal(counts, np.round(counts))
    period = 0.008 if "125" in signal else 0.001
    nominal = np.arange(len(counts)) * period
    off = sampled.events.t - nominal
    assert 0.9e-4 < np.abs(off).max() <= 1e-4
    travelled = np.cumsum(counts) * 0.0254 / 2000.0
    s = np.clip((nominal - 0.2) / 0.7, 0.0, 1.0)
    wanted = 0.1 * (10 * s**3 - 15 * s**4 + 6 * s**5)
    assert np.abs(travelled - wanted).max() <= 0.5 * 0.0254 / 2000.0 + 1e-12
