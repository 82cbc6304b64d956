"""Symbolic plants, driven by their generator, beside the interlaced observer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.matrices import instance
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting, Signal, run
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver
from pointpred_observers.triangular.polynomials import symbolic
from pointpred_observers.triangular.system import SymbolicSteadyState, SymbolicSystem


def interlaced(observer: InterlacedObserver, plant: Any, setting: Setting) -> Simulation:
    """An interlaced observer: the plant from a start of its own, under the input l(w) of the steady state."""
    setting.refuse("a symbolic plant", "unknown_input", "schedule", "input")
    system, steady = instance("plant", plant, SymbolicSystem), observer.steady
    if system.parameters():
        raise ParameterError(
            f"parameters without value: {sorted(map(str, system.parameters()))}", field="plant"
        )
    sizes = [(len(one.states), len(one.zero), len(one.outputs)) for one in (system, steady.system)]
    if sizes[0] != sizes[1]:
        raise ParameterError(
            f"the observer was designed for {sizes[1][0]} states, {sizes[1][1]} of zero dynamics and "
            f"{sizes[1][2]} outputs, received a plant of {sizes[0][0]}, {sizes[0][1]} and {sizes[0][2]}",
            field="plant",
        )
    times, q = setting.samples(discrete=False), len(steady.generator.states)
    n = sizes[0][0] + sizes[0][1]
    field = driven_field(steady, system, setting.signal("disturbance", n))
    both = run(field, setting.begin(q + n), times, discrete=False)
    driving, state = both[:, :q], both[:, q:]
    outputs = setting.measured(outputs_of(system, state))
    stage = observer.stage(start=setting.begin(q, "estimate", 0.0))
    table = np.column_stack([times, outputs])
    answers = stage.walk(np.zeros(len(table), np.bool_), table)
    none = np.zeros((len(times), 0))
    names = tuple(str(one) for one in (*system.states, *system.zero))
    pushed = steady.function()(driving.T)[-1][:, None]
    return Simulation(
        times, state, answers[:, q:-1], outputs, pushed, names, "interlaced observer", False, none, none,
        driving, answers[:, :q], np.zeros(0),
    )  # fmt: skip


def driven_field(
    steady: SymbolicSteadyState, system: SymbolicSystem, disturbance: Signal
) -> Callable[[float, Any], FloatArray]:
    """Generator and plant together, states (w, x, z), under the input of the steady state."""
    sp, w = symbolic(), steady.generator.states
    drive = sp.lambdify(w, steady.generator.field, modules="math")
    push = sp.lambdify(w, steady.input, modules="math")
    states = (*system.states, *system.zero)
    plant = sp.lambdify((*states, system.input), (*system.field, *system.zero_field), modules="math")

    def field(t: float, both: Any) -> FloatArray:
        numbers = np.asarray(both).tolist()
        driving, x = numbers[: len(w)], numbers[len(w) :]
        moved = np.array(plant(*x, push(*driving))) + disturbance(t)
        return np.concatenate([drive(*driving), moved])

    return field


def outputs_of(system: SymbolicSystem, states: FloatArray) -> FloatArray:
    """The outputs without noise, (N, p), of states (N, n), x before z."""
    names = (*system.states, *system.zero)
    columns = symbolic().lambdify(names, system.outputs, modules="numpy")(*states.T)
    return np.stack([np.broadcast_to(one, len(states)) for one in columns], axis=-1)
