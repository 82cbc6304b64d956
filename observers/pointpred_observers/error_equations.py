"""The error system of each kind of observer in this library."""

from __future__ import annotations

from functools import singledispatch
from typing import Any

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.error_systems.system import ErrorSystem, sloped_system
from pointpred_observers.interconnected.design import ObserverDesign
from pointpred_observers.reduced_order.design import ReducedOrderDesign
from pointpred_observers.reduced_order.reversed_connection import InvariantObserver
from pointpred_observers.rounding import without_rounding
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver, output_matrix
from pointpred_observers.unknown_input.observer import UnknownInputObserver


def error_system(observer: Any) -> ErrorSystem:
    """The system that an observer's error obeys, for ``l2_gain``, ``certify_decay`` and simulations.

    - ``ObserverDesign``, (3.6): w - w^, disturbed by ``v`` of Y, ``eps`` (v~ is v + eps) and ``w`` of the
      generator
    - ``ReducedOrderDesign``, ``InvariantObserver``, (3.26): w^ - (Pi x + Upsilon y), disturbed by ``delta``
      of the observer's equation and by ``v`` of y
    - ``InterlacedObserver``, Theorem 4.4.1: w - w^, disturbed by ``v``, noise and the plant's distance from
      its steady state
    - ``UnknownInputObserver``, Theorem 1 of the camera paper: T x - z, disturbed by ``delta`` = (A(p) -
      A(p^)) x

    Raises ParameterError for anything else, and where the observer's matrices vary; CertificateError where
    w = Pi x + Upsilon y is not invariant, so that its error obeys no such equation.

    >>> from pointpred_observers import Persidskii, design_reduced_order, l2_gain
    >>> plant = Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", C0=[1.0, 0.0])
    >>> design = design_reduced_order(plant, [[0.0, 1.0]], decay=2.0)
    >>> noise = error_system(design).disturbed_by("v")
    >>> gain = l2_gain(noise)  # of speed in rad/s for noise in rad
    >>> bool(gain.lower <= gain.upper < 1.001 * gain.lower)
    True
    """
    return _system(observer)


@singledispatch
def _system(observer: Any) -> ErrorSystem:
    raise ParameterError(
        "an error system needs an ObserverDesign, a ReducedOrderDesign, an InvariantObserver, an "
        f"InterlacedObserver or an UnknownInputObserver, received {type(observer).__name__}",
        field="observer",
        value=observer,
    )


@_system.register
def _interconnected(observer: ObserverDesign) -> ErrorSystem:
    g, plant, m = observer.generator, observer.plant, observer.gain
    return sloped_system(
        g.S0 - m @ plant.C0 @ observer.Pi,
        without_rounding(g.S1 - m @ plant.C1, g.S1, m @ plant.C1),
        plant.H @ observer.Pi,
        {"v": -(g.G + m), "eps": -m, "w": np.eye(g.q)},
        slopes=plant.slopes,
        time=plant.time,
        domain=plant.domain,
    )


@_system.register
def _invariant(observer: InvariantObserver) -> ErrorSystem:
    if observer.varying:
        raise ParameterError("an error system needs constant matrices, those of the observer vary")
    now, plant = observer.at(0.0), observer.plant
    now.require_equalities()
    return sloped_system(
        now.S0,
        without_rounding(now.S1, now.onward @ plant.A1),
        now.J,
        {"delta": np.eye(observer.q), "v": now.B},
        slopes=plant.slopes,
        time=plant.time,
        through={"v": now.R},
        domain=plant.domain,
    )


@_system.register
def _reduced(observer: ReducedOrderDesign) -> ErrorSystem:
    return _invariant(observer.observer)


@_system.register
def _interlaced(observer: InterlacedObserver) -> ErrorSystem:
    gain = np.asarray(observer.certificate.L, np.float64)
    a = observer.steady.generator.matrix() - gain @ output_matrix(observer.steady)
    return _linear(a[None], -gain[None], {"v": gain.shape[1]}, ("",))


@_system.register
def _unknown_input(observer: UnknownInputObserver) -> ErrorSystem:
    return observer.error_system()


def _linear(
    a: FloatArray, b: FloatArray, widths: dict[str, int], names: tuple[str, ...], time: str = "continuous"
) -> ErrorSystem:
    return ErrorSystem(a, b, np.eye(a.shape[1]), names, widths, time)
