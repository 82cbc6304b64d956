"""Persidskii plants beside a stage: alone, or under a regulator."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.errors import EventError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.interconnected.persidskii_stage import PersidskiiStage, regulator_stage
from pointpred_observers.plants import nonlinearity
from pointpred_observers.plants.generator import Generator, fitted, require_same_nonlinearity
from pointpred_observers.plants.linear_systems import as_plant
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting, run, sampled

UNUSED = ("unknown_input", "schedule")


def alone(
    plant: Persidskii, observer: Any, setting: Setting, title: str, bound: FloatArray | None = None
) -> Simulation:
    """A plant that nothing feeds back, beside its observer."""
    setting.refuse("a Persidskii plant", *UNUSED)
    times = setting.samples(plant.time == "discrete")
    stage = observer.stage(start=setting.begin(plant.n, "estimate", 0.0))
    both, d = setting.signal("input", plant.m + plant.z), setting.signal("disturbance", plant.n)

    def field(t: float, x: FloatArray) -> FloatArray:
        now = both(t)
        return plant.field(t, x, now[: plant.m], now[plant.m :], d(t))

    state = run(field, setting.begin(plant.n), times, plant.time == "discrete")
    inputs, outputs = sampled(both, times), setting.measured(outputs_of(plant, times, state))
    answers = walked(stage, times, outputs, inputs)
    return Simulation.of(plant, times, state, answers, outputs, inputs, title, bound=bound)


def outputs_of(plant: Persidskii, times: FloatArray, state: FloatArray) -> FloatArray:
    """The outputs without noise, (N, p), of the states at the samples."""
    return np.array([plant.output(float(t), x) for t, x in zip(times, state, strict=True)])


def walked(stage: PersidskiiStage, times: FloatArray, outputs: FloatArray, inputs: FloatArray) -> FloatArray:
    """The answers of a stage, which receives the samples one by one."""
    table = np.column_stack([times, outputs, inputs])
    try:
        return stage.walk(np.zeros(len(table), np.bool_), table)
    except EventError as far:
        raise _too_far(times) from far


def _too_far(times: FloatArray) -> ParameterError:
    return ParameterError(
        f"times: samples lie {np.diff(times).max():g} s apart, more than 1e5 steps of the observer, "
        "which is that fast: they must lie closer together, or the design needs less decay",
        field="times",
    )


def closed(plant: Persidskii, regulator: Generator, pi: FloatArray, setting: Setting) -> Simulation:
    """The stage of the regulator gives u at each sample, and the plant moves on with it until the next."""
    setting.refuse("a plant under a regulator", *UNUSED)
    discrete, g = plant.time == "discrete", fitted(regulator, plant, "regulator")
    require_same_nonlinearity(plant, regulator, name="regulator")
    times = setting.samples(discrete)
    j = plant.H @ pi if g.J is None else g.J
    used = Generator(g.S0, g.S1, j, g.G, g.L0, g.L1, g.E, regulator.f)
    stage = regulator_stage(plant, used, pi, start=setting.begin(g.q, "estimate", 0.0))
    rho, d = setting.signal("input", plant.z), setting.signal("disturbance", plant.n)
    outputs, known = setting.measured(np.zeros((len(times), plant.p))), sampled(rho, times)
    state, answers = np.empty((len(times), plant.n)), np.empty((len(times), plant.m + plant.n))
    state[0] = setting.begin(plant.n)
    for i, t in enumerate(times.tolist()):
        outputs[i] += plant.output(t, state[i])
        try:
            answers[i] = stage.update(t, np.concatenate([outputs[i], known[i]]))
        except EventError as far:
            raise _too_far(times) from far
        if i + 1 < len(times):
            u = answers[i, : plant.m]

            def field(t: float, x: FloatArray, u: FloatArray = u) -> FloatArray:
                return plant.field(t, x, u, rho(t), d(t))

            state[i + 1] = run(field, state[i], times[i : i + 2], discrete)[-1]
    u, estimate = np.split(answers, [plant.m], axis=1)
    inputs = np.hstack([u, known])
    return Simulation.of(plant, times, state, estimate, outputs, inputs, "plant under its regulator")


def like(plant: Any, known: Persidskii) -> Persidskii:
    """The plant to simulate; raises ParameterError unless its sizes are those of the design's."""
    one = as_plant(plant)
    if (one.n, one.m, one.z, one.p, one.time) != (known.n, known.m, known.z, known.p, known.time):
        raise unlike(one, known)
    return one


def same(plant: Persidskii, known: Persidskii) -> bool:
    """Whether a plant is the one that a certificate speaks of, whose inputs may stand in B or in Q.

    Certificates are of constant matrices: one that varies is another plant, also where both agree at 0.
    """
    if plant.varying or known.varying:
        return False
    left, right = plant.matrices(0.0), known.matrices(0.0)
    for one in (left, right):
        one["inputs"] = np.hstack([one.pop("B"), one.pop("Q")])
    return nonlinearity.same(plant.f, known.f) and all(
        np.array_equal(left[name], right[name]) for name in left
    )


def unlike(plant: Persidskii, known: Persidskii) -> ParameterError:
    """What is said of a plant whose sizes are not those of the design's."""

    def shown(one: Persidskii) -> str:
        return f"{one.n} states, {one.m + one.z} inputs and {one.p} outputs in {one.time} time"

    return ParameterError(
        f"the observer was designed for a plant of {shown(known)}, received one of {shown(plant)}",
        field="plant",
    )
