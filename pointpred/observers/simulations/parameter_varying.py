"""Parameter-varying plants with unknown inputs beside their observers."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import ParameterError
from pointpred.observers.matrices import instance
from pointpred.observers.simulations.result import Simulation
from pointpred.observers.simulations.signals import Setting, run, sampled
from pointpred.observers.unknown_input.observer import UnknownInputObserver
from pointpred.observers.unknown_input.run import RunningUnknownInputObserver, UnknownInputSample
from pointpred.observers.unknown_input.system import ParameterVaryingSystem, Point


def unknown_inputs(observer: UnknownInputObserver, plant: Any, setting: Setting) -> Simulation:
    """An unknown-input observer, whose scheduling variables may depend on the state."""
    system = instance("plant", plant, ParameterVaryingSystem)
    known = observer.system
    if system.c.shape != known.c.shape or system.time != known.time:
        raise ParameterError(
            f"the observer was designed for C of shape {known.c.shape} in {known.time} time, received a "
            f"plant of shape {system.c.shape} in {system.time} time",
            field="plant",
        )
    n, discrete = system.c.shape[1], system.time == "discrete"
    times, start = setting.samples(discrete), setting.begin(n)
    schedule = _schedule(setting.schedule, observer)
    width = system.f(schedule(float(times[0]), start)).shape[1]
    b, d = setting.signal("input", n), setting.signal("unknown_input", width)
    shake = setting.signal("disturbance", n)

    def field(t: float, x: FloatArray) -> FloatArray:
        point = schedule(t, x)
        change: FloatArray = system.a(point) @ x + b(t) + system.f(point) @ d(t) + shake(t)
        return change

    state = run(field, start, times, discrete)
    outputs = setting.measured(state @ system.c.T)
    running = RunningUnknownInputObserver(observer, setting.begin(n, "estimate", 0.0))
    inputs, unknown = sampled(b, times), sampled(d, times)
    estimate, found = np.empty_like(state), np.full_like(unknown, np.nan)
    for i, t in enumerate(times.tolist()):
        answer = running.update(UnknownInputSample(t, outputs[i], inputs[i], partial(schedule, t)))
        estimate[i], found[i] = answer.x, answer.d
    none = np.zeros((len(times), 0))
    return Simulation(
        times, state, estimate, outputs, inputs, tuple(f"x{i + 1}" for i in range(n)),
        "unknown-input observer", discrete, unknown, found, none, none, np.zeros(0),
    )  # fmt: skip


def _schedule(given: Any, observer: UnknownInputObserver) -> Any:
    """The scheduling variables as a function of t and x; the middle of the box where nothing is given."""
    if callable(given):
        return given
    if given is None:
        given = {name: 0.5 * (low + high) for name, (low, high) in observer.box.bounds.items()}
    if not isinstance(given, Mapping):
        raise ParameterError(
            f"schedule must be a dict of {', '.join(observer.box.names)} or a function of t and x, "
            f"received {given!r:.60}",
            field="schedule",
            value=given,
        )
    if missing := [name for name in observer.box.names if name not in given]:
        raise ParameterError(
            f"schedule lacks {', '.join(missing)}, received {', '.join(given)}", field="schedule"
        )
    moving = {name: one for name, one in given.items() if callable(one)}
    fixed = {name: float(one) for name, one in given.items() if name not in moving}

    def schedule(t: float, x: FloatArray) -> Point:
        return {**fixed, **{name: float(one(t)) for name, one in moving.items()}}

    return schedule
