"""Persidskii plants beside the observers and regulators of sections 3.2 and 3.3."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.errors import EventError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.interconnected.design import ObserverDesign
from pointpred_observers.interconnected.generator import (
    Fitted,
    Generator,
    fitted,
    require_same_nonlinearity,
)
from pointpred_observers.interconnected.persidskii_observer import (
    PersidskiiObserver,
    observer_stage,
    regulator_with_estimate,
)
from pointpred_observers.interconnected.regulator import RegulatorDesign
from pointpred_observers.interconnected.steady_state import steady_state_map
from pointpred_observers.interconnected.tracking import closed_loop
from pointpred_observers.linear_systems import as_plant
from pointpred_observers.matrices import dimensions
from pointpred_observers.persidskii import Persidskii
from pointpred_observers.reduced_order.design import ReducedOrderDesign
from pointpred_observers.reduced_order.invariant_stage import invariant_stage
from pointpred_observers.reduced_order.reversed_connection import InvariantObserver
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting, run, sampled

UNUSED = ("unknown_input", "schedule")


def reduced_order(design: ReducedOrderDesign, plant: Any, setting: Setting) -> Simulation:
    """A reduced-order observer, with the bound that its certificate proves."""
    observer, one = design.observer, _like(plant, design.observer.plant)
    bound = np.zeros(0)
    proving = setting.silent and np.isinf(design.certificate.domain) and not observer.varying
    if proving and _same(one, observer.plant):
        observer.at(0.0).require_equalities()
        onto = observer.recovery(0.0)[0]
        x, x_hat = setting.begin(one.n), setting.begin(one.n, "estimate", 0.0)
        first = float(np.linalg.norm(observer.at(0.0).Z @ (x_hat - x)))
        times = setting.samples(one.time == "discrete")
        proved = design.certificate.bound
        bound = np.linalg.norm(onto, 2) * np.array([proved(float(t - times[0]), first) for t in times])
    return _without_feedback(observer, one, setting, "reduced-order observer", bound)


def invariant(observer: InvariantObserver, plant: Any, setting: Setting) -> Simulation:
    """An observer of given matrices."""
    return _without_feedback(observer, _like(plant, observer.plant), setting, "observer", np.zeros(0))


def _without_feedback(
    observer: InvariantObserver, plant: Persidskii, setting: Setting, title: str, bound: FloatArray
) -> Simulation:
    discrete = plant.time == "discrete"
    times = setting.samples(discrete)
    stage = invariant_stage(observer, start=setting.begin(plant.n, "estimate", 0.0))
    state, inputs, outputs = _open_loop(plant, setting, times)
    answers = _walked(stage, times, outputs, inputs)
    return _simulation(plant, times, state, answers, outputs, inputs, title, bound=bound)


def observed(design: ObserverDesign, plant: Any, setting: Setting) -> Simulation:
    """An observer of the plant's own state, or of that of the generator which drives the plant."""
    if not design.full_order:
        return _driven(design, plant, setting)
    known = design.plant
    one = as_plant(plant)
    if (one.n, one.m + one.z, one.p, one.time) != (known.n, known.z, known.p, known.time):
        raise _unlike(one, known)
    discrete = one.time == "discrete"
    times = setting.samples(discrete)
    state, inputs, outputs = _open_loop(one, setting, times)
    first = setting.begin(one.n, "estimate", 0.0)
    stage = observer_stage(design, start=first)
    answers = _walked(stage, times, outputs, inputs)
    bound = np.zeros(0)
    if setting.silent and np.isinf(known.domain) and _same(one, known):
        error = float(np.linalg.norm(first - state[0]))
        bound = np.array([design.bound(float(t - times[0]), error) for t in times])
    return _simulation(one, times, state, answers, outputs, inputs, "full-order observer", bound=bound)


def _driven(design: ObserverDesign, plant: Any, setting: Setting) -> Simulation:
    setting.refuse("a plant with a generator", *UNUSED)
    one, q = _like(plant, design.plant), design.generator.q
    discrete = one.time == "discrete"
    times = setting.samples(discrete)
    generator = _generator(design.generator, one.H @ design.Pi)
    alone = dimensions(setting.start) == 1 and len(setting.start) == one.n
    start = setting.begin(one.n) if alone else setting.begin(one.n + q)
    if len(start) == one.n:  # the generator that fits the plant's state best
        start = np.concatenate([start, np.linalg.lstsq(design.Pi, start, rcond=None)[0]])
    rho, d = setting.signal("input", one.z), setting.signal("disturbance", one.n)

    def field(t: float, both: FloatArray) -> FloatArray:
        return closed_loop(one, generator, t, both, rho=rho(t), d=d(t))

    both = run(field, start, times, discrete)
    state, driving = both[:, : one.n], both[:, one.n :]
    outputs = setting.measured(_outputs(one, times, state))
    inputs = sampled(rho, times)
    stage = observer_stage(design, start=setting.begin(q, "estimate", 0.0))
    answers = _walked(stage, times, outputs, inputs)
    return _simulation(
        one, times, state, answers[:, q:], outputs, inputs, "observer of a driven plant",
        driving=driving, driving_estimate=answers[:, :q],
    )  # fmt: skip


def regulated(design: RegulatorDesign, plant: Any, setting: Setting) -> Simulation:
    """A plant under its regulator."""
    return _closed(_like(plant, design.plant), design.regulator, design.Pi, setting)


def driven_by(regulator: Generator, plant: Any, setting: Setting) -> Simulation:
    """A plant under a regulator of given matrices; the estimate is Pi w of the steady-state map."""
    one = as_plant(plant)
    return _closed(one, regulator, steady_state_map(one, regulator).Pi, setting)


def _closed(plant: Persidskii, regulator: Generator, pi: FloatArray, setting: Setting) -> Simulation:
    """The stage of the regulator gives u at each sample, and the plant moves on with it until the next."""
    setting.refuse("a plant under a regulator", *UNUSED)
    discrete, g = plant.time == "discrete", fitted(regulator, plant, "regulator")
    require_same_nonlinearity(plant, regulator, name="regulator")
    times = setting.samples(discrete)
    j = plant.H @ pi if g.J is None else g.J
    used = Generator(g.S0, g.S1, j, g.G, g.L0, g.L1, g.E, regulator.f)
    stage = regulator_with_estimate(plant, used, pi, start=setting.begin(g.q, "estimate", 0.0))
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
    return _simulation(plant, times, state, estimate, outputs, inputs, "plant under its regulator")


def _open_loop(
    plant: Persidskii, setting: Setting, times: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The states, the inputs and the measured outputs of a plant that nothing feeds back."""
    setting.refuse("a Persidskii plant", *UNUSED)
    both, d = setting.signal("input", plant.m + plant.z), setting.signal("disturbance", plant.n)

    def field(t: float, x: FloatArray) -> FloatArray:
        now = both(t)
        return plant.field(t, x, now[: plant.m], now[plant.m :], d(t))

    state = run(field, setting.begin(plant.n), times, plant.time == "discrete")
    return state, sampled(both, times), setting.measured(_outputs(plant, times, state))


def _outputs(plant: Persidskii, times: FloatArray, state: FloatArray) -> FloatArray:
    return np.array([plant.output(float(t), x) for t, x in zip(times, state, strict=True)])


def _walked(
    stage: PersidskiiObserver, times: FloatArray, outputs: FloatArray, inputs: FloatArray
) -> FloatArray:
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


def _generator(g: Fitted, j: FloatArray) -> Generator:
    return Generator(g.S0, g.S1, j, g.G, g.L0, g.L1, g.E)


def _like(plant: Any, known: Persidskii) -> Persidskii:
    """The plant to simulate; raises ParameterError unless its sizes are those of the design's."""
    one = as_plant(plant)
    if (one.n, one.m, one.z, one.p, one.time) != (known.n, known.m, known.z, known.p, known.time):
        raise _unlike(one, known)
    return one


def _same(plant: Persidskii, known: Persidskii) -> bool:
    """Whether a plant is the one that a certificate speaks of, whose inputs may stand in B or in Q.

    Certificates are of constant matrices: one that varies is another plant, also where both agree at 0.
    """
    if plant.varying or known.varying:
        return False
    left, right = plant.matrices(0.0), known.matrices(0.0)
    for one in (left, right):
        one["inputs"] = np.hstack([one.pop("B"), one.pop("Q")])
    same_f = plant.f.codes == known.f.codes and (
        plant.f.codes is not None or plant.f.function is known.f.function
    )
    return same_f and all(np.array_equal(left[name], right[name]) for name in left)


def _unlike(plant: Persidskii, known: Persidskii) -> ParameterError:
    def shown(one: Persidskii) -> str:
        return f"{one.n} states, {one.m + one.z} inputs and {one.p} outputs in {one.time} time"

    return ParameterError(
        f"the observer was designed for a plant of {shown(known)}, received one of {shown(plant)}",
        field="plant",
    )


def _simulation(
    plant: Persidskii,
    times: FloatArray,
    state: FloatArray,
    estimate: FloatArray,
    outputs: FloatArray,
    inputs: FloatArray,
    title: str,
    **more: FloatArray,
) -> Simulation:
    none = np.zeros((len(times), 0))
    names = tuple(f"x{i + 1}" for i in range(plant.n))
    signals = {name: more.get(name, none) for name in ("driving", "driving_estimate")}
    return Simulation(
        times, state, estimate, outputs, inputs, names, title, plant.time == "discrete", none, none,
        bound=more.get("bound", np.zeros(0)), **signals,
    )  # fmt: skip
