"""What a step of an unknown-input observer costs, and that the kept matrices change no number."""

from __future__ import annotations

from time import process_time
from typing import Any

import msgspec
import numpy as np
import pytest
from pointpred_observers.unknown_input.run import UnknownInputSample

from pointpred_observers import Box, ParameterVaryingSystem
from pointpred_observers.unknown_input.observer import UnknownInputObserver


def damped(two: bool = False) -> UnknownInputObserver:
    """Three states, an unknown input at the first; errors of the outputs decay at 10 1/s."""
    a = np.array([[0.0, 1.0, 0.0], [-1.0, -2.0, 0.3], [0.0, 0.4, -1.0]])
    moving = np.array([[0.0, 0.0, 0.0], [-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    c = np.eye(3)[[0, 2]] if two else np.eye(1, 3)
    system = ParameterVaryingSystem(lambda p: a + p["k"] * moving, [[1.0], [0.0], [0.0]], c)
    return UnknownInputObserver.design(system, Box({"k": (0.0, 1.0)}), 0.5, output_decay=10.0)


def samples_of(observer: UnknownInputObserver, count: int, k: Any) -> list[UnknownInputSample]:
    width = len(observer.system.c)
    return [
        UnknownInputSample(0.01 * i, np.full(width, np.sin(0.01 * i)), np.array([0.0, 0.1 * i, 0.0]), k)
        for i in range(count)
    ]


@pytest.mark.parametrize("two", [False, True])
def test_a_step_costs_tens_of_microseconds_while_the_schedule_rests(two: bool) -> None:
    """It cost 600 us of a processor; here at most 150 us, as the processor may be an old one."""
    observer = damped(two)
    given = samples_of(observer, 200, lambda x: {"k": 0.5})
    costs = []
    for _ in range(5):
        stage = observer.stage(np.zeros(3))
        began = process_time()
        for sample in given:
            stage.update(sample)
        costs.append((process_time() - began) / len(given))
    assert min(costs) < 150e-6


@pytest.mark.parametrize("two", [False, True])
def test_a_schedule_that_rests_gives_the_numbers_of_one_that_moves(two: bool) -> None:
    """Also where it first moves, and where it follows the estimate, whose steps are integrated."""
    observer = damped(two)

    def run(k: Any, width: float) -> list[Any]:
        """Estimates with ``width`` added to the schedule by halves, so that it moves in each interval."""
        stage = observer.stage([0.0, 1.0, -1.0])
        given = samples_of(observer, 40, None)
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
