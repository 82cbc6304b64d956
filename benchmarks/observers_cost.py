"""What a design of an observer and one of its steps cost on this machine."""

from __future__ import annotations

from time import process_time

import numpy as np

from pages.arguments import parse
from pointpred.records import FloatArray
from pointpred.stage import CompiledStage
from pointpred_observers import (
    Generator,
    Persidskii,
    PersidskiiObserver,
    design_observer,
    invariant_observer,
    invariant_stage,
    steady_state_map,
)
from pointpred_observers.examples import UNMEASURED, two_masses

STATES = (2, 4, 8, 16)
ROWS = 100_000
"""Samples in the table of which a step is timed."""


def pair(states: int) -> tuple[Persidskii, Generator]:
    """A random plant with two components of f and two outputs, which its generator copies: Pi = I."""
    rng = np.random.default_rng(states)
    a = rng.normal(size=(states, states)) / np.sqrt(states) - 0.8 * np.eye(states)
    h, a1 = rng.normal(size=(2, states)) / np.sqrt(states), 0.1 * rng.normal(size=(states, 2))
    return Persidskii(a, a1, h, "sin", C0=rng.normal(size=(2, states))), Generator(a, a1, h)


def design_s(states: int) -> tuple[float, float]:
    """Processor time of the map and of the design, after a first one that imports the solver."""
    plant, generator = pair(states)
    began = process_time()
    solution = steady_state_map(plant, generator)
    between = process_time()
    design_observer(plant, generator, np.eye(states) if solution.nullity else solution.Pi)
    return between - began, process_time() - between


def step_us(states: int) -> float:
    """``best_us`` of an observer with as many states, one input and one output."""
    rng = np.random.default_rng(0)
    stage = PersidskiiObserver(
        rng.normal(size=(states, states)) - 3.0 * np.eye(states), 0.1 * rng.normal(size=(states, 1)),
        rng.normal(size=(1, states)), np.ones((states, 1)), "sin",
    )  # fmt: skip
    return best_us(stage, rng.normal(size=(ROWS, 1)))


def example_5_us() -> float:
    """``best_us`` of the observer of example 5: 2 states, 2 outputs, 2 inputs."""
    stage = invariant_stage(invariant_observer(two_masses(), UNMEASURED, [[-1, 0], [0, 0]]))
    return best_us(stage, np.zeros((ROWS, 4)))


def best_us(stage: CompiledStage, samples: FloatArray) -> float:
    """Processor time of one step in the loop over a table of samples 10 ms apart, in us, the best of five."""
    table = np.column_stack([np.arange(len(samples)) * 1e-2, samples])
    begin = np.zeros(len(samples), dtype=np.bool_)
    stage.walk(begin[:10], table[:10])
    best = np.inf
    for _ in range(5):
        fresh = stage.fresh()
        began = process_time()
        fresh.walk(begin, table)
        best = min(best, process_time() - began)
    return best / len(samples) * 1e6


def main() -> None:
    design_observer(*pair(2), np.eye(2))
    for states in STATES:
        map_s, designed = design_s(states)
        print(
            f"{states:3d} states: map {map_s:.3f} s, design {designed:.2f} s, step {step_us(states):.2f} us"
        )
    print(f"example 5: step {example_5_us():.2f} us")


if __name__ == "__main__":
    parse(__doc__)
    main()
