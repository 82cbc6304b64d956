"""The ring of past samples: right at any rate, bounded at every rate."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.regression import delay

SAMPLES = delay.capacity(2)


def ring() -> delay.Ring:
    return delay.Ring(np.zeros(delay.states(1, SAMPLES)))


def push(memory: delay.Ring, t: float, values: tuple[float, float], delay_s: float) -> None:
    w, y = values
    delay.push(memory, SAMPLES, delay_s / delay.PER_DELAY, t, np.array([w]), y)


def look(memory: delay.Ring, t: float) -> np.ndarray | None:
    w = np.zeros(1)
    known, y = delay.delayed(memory, SAMPLES, t, w)
    return np.array([w[0], y]) if known else None


@pytest.mark.parametrize("rate_hz", [20.0, 60.0, 125.0, 1000.0, 8000.0])
def test_lines_are_recalled_exactly_at_every_rate(rate_hz: float) -> None:
    memory, delay_s = ring(), 0.1
    rng = np.random.default_rng(int(rate_hz))
    times = np.cumsum(rng.uniform(0.5, 1.5, int(rate_hz)) / rate_hz)
    for t in times:
        push(memory, t, (3.0 * t - 1.0, -t), delay_s)
        for back in (0.0, delay_s, 2.0 * delay_s):
            recalled = look(memory, t - back)
            if t - back < times[0]:
                assert recalled is None
            else:
                assert recalled == pytest.approx([3.0 * (t - back) - 1.0, back - t], abs=1e-9)


def test_a_sine_is_recalled_as_well_as_lines_between_samples_allow() -> None:
    memory, delay_s = ring(), 0.1
    worst = 0.0
    for t in np.arange(0.0, 1.0, 1e-4):
        push(memory, t, (np.sin(20.0 * t), 0.0), delay_s)
        recalled = look(memory, t - 0.2)
        if recalled is not None:
            worst = max(worst, abs(recalled[0] - np.sin(20.0 * (t - 0.2))))
    spacing = delay_s / delay.PER_DELAY + 1e-4
    assert 0.0 < worst <= 20.0**2 * spacing**2 / 8.0 * 1.01  # curvature times spacing^2 / 8


def test_the_newest_sample_is_always_there_and_an_early_one_is_not() -> None:
    memory = ring()
    assert look(memory, 0.0) is None
    for t in (0.0, 1e-5, 2e-5):
        push(memory, t, (t, 1.0), 1.0)
    assert look(memory, 2e-5) == pytest.approx([2e-5, 1.0])
    assert look(memory, 5.0) == pytest.approx([2e-5, 1.0])
    assert look(memory, -1e-9) is None


def test_a_sample_at_the_same_time_replaces() -> None:
    memory = ring()
    push(memory, 0.0, (0.0, 0.0), 0.1)
    push(memory, 0.05, (1.0, 0.0), 0.1)
    push(memory, 0.05, (2.0, 0.0), 0.1)
    assert look(memory, 0.05) == pytest.approx([2.0, 0.0])
    assert memory.count == 2.0


@given(st.lists(st.floats(0.0, 0.05), min_size=1, max_size=400))
def test_two_delays_of_history_survive_any_pauses(gaps: list[float]) -> None:
    memory, delay_s = ring(), 0.1
    t = first = 0.0
    push(memory, t, (t, 0.0), delay_s)
    for gap in gaps:
        t += gap
        push(memory, t, (t, 0.0), delay_s)
        assert memory.count <= SAMPLES
        recalled = look(memory, t - 2.0 * delay_s)
        assert (recalled is None) == (t - 2.0 * delay_s < first)
