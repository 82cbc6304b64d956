"""One call that designs an observer of any kind, and the calls that run and simulate it."""

from __future__ import annotations

from inspect import Parameter, signature
from typing import Any

import numpy as np

from pointpred.errors import ParameterError
from pointpred_observers.interconnected.design import DrivenObserver, FullOrderObserver
from pointpred_observers.interconnected.persidskii_stage import closed
from pointpred_observers.interconnected.regulator import Regulator
from pointpred_observers.interconnected.steady_state import steady_state_map
from pointpred_observers.numerics.matrices import instance, wrong
from pointpred_observers.observer import Observer
from pointpred_observers.plants.generator import Generator
from pointpred_observers.plants.linear_systems import as_plant
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.plants.symbolic import SymbolicSteadyState, SymbolicSystem
from pointpred_observers.plants.varying import ParameterVaryingSystem
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver
from pointpred_observers.unknown_input.observer import UnknownInputObserver

KINDS: dict[str, tuple[type[Observer], Any]] = {
    "full": (FullOrderObserver, Persidskii),
    "reduced": (ReducedOrderObserver, Persidskii),
    "driven": (DrivenObserver, Persidskii),
    "regulator": (Regulator, Persidskii),
    "interlaced": (InterlacedObserver, SymbolicSystem | SymbolicSteadyState),
    "unknown-input": (UnknownInputObserver, ParameterVaryingSystem),
}
"""The class of each kind of observer, and its plant."""


def design(plant: Any, kind: str | None = None, *, decay: float = 1.0, **options: Any) -> Observer:
    """The observer of a plant whose error shrinks as exp(-decay t), with its certificate.

    ============= ======================= ========================================= =======================
    kind          plant                   what it estimates                         options
    ============= ======================= ========================================= =======================
    full          Persidskii or linear    every state, from y and the inputs        gain
    reduced       Persidskii or linear    the unmeasured part of the state          Pi
    driven        Persidskii or linear    the state w of the ``generator`` that     generator, Pi, gain
                                          drives the plant, and x = Pi w
    regulator     Persidskii or linear    the state, and feeds it back: its stage   observer_decay, L1,
                                          answers with the input u                  reference, following
    interlaced    SymbolicSystem          the generator's state and the plant's     generator, first,
                                          steady state                              upper, degree, gain
    unknown-input ParameterVaryingSystem, the state beside inputs that nobody       box, output_decay
                  CornerSystem            measures
    ============= ======================= ========================================= =======================

    Not given, ``kind`` is what the plant allows: of a Persidskii plant "driven" with a generator, "reduced"
    where the outputs are independent, free of f and fewer than the states, else "full".

    Parameters: ``decay`` in 1/s (1/step in discrete time), above 0. The class of the kind says what the
    options are: ``FullOrderObserver``, ``ReducedOrderObserver``, ``DrivenObserver``, ``Regulator``,
    ``InterlacedObserver``, ``UnknownInputObserver``, each with its method ``design``.
    Raises InfeasibleError naming what cannot be observed, or that no gain satisfies the inequalities of the
    kind, proved; UndecidedError where the solver could not decide; CertificateError where an answer does not
    pass the audit; ParameterError for a plant, a kind or an option that does not fit. For "reduced" of a
    discrete plant with an f the inequality is that of Theorem 3.3.2, which knows only the Lipschitz constant
    of f: where it is excluded, the true slopes may still allow an observer, and "full" may find one.

    >>> from pointpred_observers import Persidskii, stage
    >>> cart = Persidskii([[0.0, 1.0], [0.0, -1.0]], B=[0.0, 1.0], C0=[1.0, 0.0])
    >>> observer = design(cart, "full", decay=2.0)
    >>> observer.bound.decay >= 2.0, min(observer.margins.values()) > 0.0
    (True, True)
    >>> running = stage(observer)
    >>> running.update(0.0, [0.1, 0.0]).tolist()  # t, then the output and the input
    [0.0, 0.0]
    """
    if not isinstance(plant, SymbolicSystem | SymbolicSteadyState | ParameterVaryingSystem):
        plant = as_plant(plant)
    if kind is None:
        kind = _fitting(plant, options)
    if not isinstance(kind, str) or kind not in KINDS:
        raise wrong("kind", f"must be one of {', '.join(KINDS)}", kind)
    observer, wanted = KINDS[kind]
    if not isinstance(plant, wanted):
        needs = f"needs a {getattr(wanted, '__name__', wanted)}, received a {type(plant).__name__}"
        raise ParameterError(f"kind {kind!r} {needs}", field="kind")
    known = _known(observer.design, options, kind, ("plant", "decay"))
    for name, one in known.items():
        if one.default is one.empty and name not in options:
            raise ParameterError(f"kind {kind!r} needs {name}", field=name)
    return observer.design(plant, decay=decay, **options)


def _known(call: Any, given: dict[str, Any], kind: str, hidden: tuple[str, ...] = ()) -> dict[str, Parameter]:
    """The options of a kind; raises ParameterError for one that it does not have."""
    known = {name: one for name, one in signature(call).parameters.items() if name not in hidden}
    for name in given:
        if name not in known:
            words = f"{name} is no option of kind {kind!r}, which has {', '.join(known)}"
            raise ParameterError(words, field=name)
    return known


def _fitting(plant: Any, options: dict[str, Any]) -> str:
    """The kind of observer for a plant where none is named."""
    if isinstance(plant, ParameterVaryingSystem):
        return "unknown-input"
    if isinstance(plant, SymbolicSystem | SymbolicSteadyState):
        return "interlaced"
    if options.get("generator") is not None:
        return "driven"
    if not (plant.C0.any() or plant.C1.any()):
        raise ParameterError("an observer needs an output: give the plant C0 or C1", field="C0")
    independent = plant.p == np.linalg.matrix_rank(plant.C0)
    return "reduced" if independent and plant.p < plant.n and not plant.C1.any() else "full"


def stage(observer: Observer, **settings: Any) -> Any:
    """An observer in a loop: ``update(t, inputs)`` of each sample gives the estimate; see its kind's class.

    ``settings``: ``start`` of the estimate, ``gap_s``, ``step_s`` and others of the kind.
    """
    one = instance("observer", observer, Observer)
    _known(one.stage, settings, one.kind)
    return one.stage(**settings)


def simulate(
    plant: Any,
    observer: Any,
    *,
    times: Any = None,
    start: Any = None,
    estimate: Any = None,
    input: Any = None,
    disturbance: Any = None,
    unknown_input: Any = None,
    schedule: Any = None,
    noise: Any = 0.0,
    seed: int = 0,
) -> Simulation:
    """A plant and its observer from their starts on, with arrays of every signal and ``plot``.

    The plant is integrated by an adaptive method, the observer is the stage that a program runs, sample by
    sample; the u of a regulator at a sample acts until the next. The plant need not be the one of the design:
    give another to see what a wrong model does. A ``Generator`` is a regulator of given matrices.

    Parameters: ``times`` of the samples in s, by default 10 s in steps of 10 ms; of a discrete plant its
    indices, by default 0 to 1000. ``start`` of the plant, by default ones: x; for a driven observer x or x
    and the generator's w; for an interlaced one w, x and z. ``estimate``: what the observer starts with, by
    default zeros: x; w for a generator, a regulator and an interlaced observer. Signals are constants,
    functions of t, or left out for zero: ``input`` the known inputs, those of B, then of Q (of Q alone where
    a generator or a regulator gives u; b of a parameter-varying plant); ``disturbance`` added to x' (the next
    x); ``unknown_input`` d and ``schedule`` the scheduling variables of a parameter-varying plant, a dict, or
    a function of t and x. ``noise`` standard deviation of the outputs, one or p; ``seed`` of the noise.

    Warns where a schedule leaves the box of the design. Raises ParameterError naming the argument, also where
    plant and observer do not fit; DivergenceError with
    the time at which the plant leaves every bound; CertificateError for a reduced-order design whose
    observer does not keep the equalities of its certificate.

    >>> import numpy as np
    >>> from pointpred_observers import Persidskii
    >>> cart = Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", [0.0, 1.0], None, [1.0, 0.0])
    >>> observer = design(cart, "reduced", decay=3.0)
    >>> result = simulate(cart, observer, times=np.arange(0.0, 4.0, 0.01), input=np.sin)
    >>> result.state.shape, bool(abs(result.error[-1]).max() < 1e-4)
    ((400, 2), True)
    """
    if not isinstance(seed, int) or isinstance(seed, bool) or seed < 0:
        raise wrong("seed", "must be a whole number not below 0", seed)
    setting = Setting(times, start, estimate, input, disturbance, unknown_input, schedule, noise, seed)
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows leaves every bound, and is refused
        if isinstance(observer, Observer):
            return observer.simulated(plant, setting)
        if isinstance(observer, Generator):
            one = as_plant(plant)
            return closed(one, observer, steady_state_map(one, observer).Pi, setting)
    advice = ": the state of a field over time is trajectory(field, start, times)" if callable(plant) else ""
    words = f"can simulate an Observer or a Generator, received {type(observer).__name__}{advice}"
    raise ParameterError(words, field="observer", value=observer)
