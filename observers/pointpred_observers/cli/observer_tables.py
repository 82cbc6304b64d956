"""Designs, audits and simulated errors as tables in the terminal and as JSON."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
from rich.table import Table

from pointpred.console import results
from pointpred_observers import (
    InterlacedObserver,
    ObserverDesign,
    ReducedOrderDesign,
    RegulatorDesign,
    Simulation,
    UnknownInputObserver,
)
from pointpred_observers.bounds import ErrorBound
from pointpred_observers.documents.designs import margins_of

DISTURBANCES = {
    "v": "v, noise of the outputs,",
    "eps": "eps, a wrong model of the outputs,",
    "w": "w, a disturbance of the state's rate,",
    "d": "d, a disturbance of the state's rate,",
    "delta": "delta, a disturbance of the observer's equation,",
    "noise": "noise of the outputs",
}
"""What the disturbances of a bound are, by their names in the theorems."""


KNOWN = 10.0
"""A larger gap says nothing: the least objective is then not bounded from below by anything of its size."""


ERROR, ESTIMATE = "x - Pi w", "Pi w"
"""The two parts of a plant under its regulator that are bounded: x is their sum."""
ABOUT = {
    ERROR: f"proved of {ERROR}, the error of the estimate",
    ESTIMATE: f"proved of {ESTIMATE}, the estimate, which {ERROR} and v drive as d",
}


class ProvedBound(msgspec.Struct, frozen=True):
    """A norm decays at ``rate``, 1/s (1/step), from ``overshoot`` times the first; ``gains`` by name."""

    rate: float
    overshoot: float
    gains: dict[str, float]


class DesignDocument(msgspec.Struct, frozen=True):
    """What ``design --json`` and ``audit --json`` write; ``gap`` is null where nothing is proved.

    ``bounds`` by what they bound: the "error", or "x - Pi w" and "Pi w" of a regulator, of which x is the
    sum. ``rate``, ``overshoot`` and ``gains`` are those of the error; a regulator has no one bound, and null
    there. An audit does not compute ``gap`` again: it is the one that the file holds.
    """

    version: int
    observer: str
    rate: float | None
    overshoot: float | None
    gains: dict[str, float] | None
    gap: float | None
    margins: dict[str, float]
    bounds: dict[str, ProvedBound]


class StateErrors(msgspec.Struct, frozen=True):
    """The error of one state: at the first and at the last sample, and its RMSE over the second half."""

    name: str
    first: float
    last: float
    rmse: float


class SimulationDocument(msgspec.Struct, frozen=True):
    """What ``simulate --json`` writes."""

    version: int
    title: str
    samples: int
    states: tuple[StateErrors, ...]


def summary(design: Any) -> DesignDocument:
    """The numbers that a certificate proves of the error."""
    bounds, gap = _proved(design)
    one = bounds.get("error")
    return DesignDocument(
        1,
        type(design).__name__,
        None if one is None else one.rate,
        None if one is None else one.overshoot,
        None if one is None else one.gains,
        float(gap) if gap <= KNOWN else None,
        margins_of(design),
        bounds,
    )


def print_design(kind: str, design: Any) -> None:
    """What was designed, and what is proved of it."""
    screen, one = results(), summary(design)
    screen.print(f"{kind} observer" if kind != "regulator" else "regulator", style="bold")
    for table in _tables(design, one):
        screen.print(table)
    for name, matrix in _gains(design).items():
        screen.print(f"{name} = {np.array2string(matrix, precision=6, separator=', ')}")


def print_audit(design: Any, margins: dict[str, float]) -> None:
    """How far each inequality holds, and what they prove."""
    table = Table(box=None, pad_edge=False)
    table.add_column("inequality")
    table.add_column("holds by, where the largest eigenvalue of P is 1", justify="right")
    sizes = _sizes(design)
    for name, margin in margins.items():
        size = next(one for part, one in sizes.items() if name.startswith(part))
        table.add_row(name, f"{margin / size:.4g}")
    screen = results()
    screen.print(table)
    for bounded in _tables(design, summary(design), stored=True):
        screen.print(bounded)


def errors_document(result: Simulation) -> SimulationDocument:
    """The errors of a simulation."""
    error = np.abs(result.error)
    rmse = result.rmse(after=float(0.5 * (result.t[0] + result.t[-1])))
    states = tuple(
        StateErrors(name, float(error[0, i]), float(error[-1, i]), float(rmse[i]))
        for i, name in enumerate(result.names)
    )
    return SimulationDocument(1, result.title, len(result.t), states)


def print_errors(result: Simulation) -> None:
    """The errors of a simulation, a row a state."""
    table = Table(box=None, pad_edge=False)
    table.add_column("state")
    for heading in ("error at first", "error at last", "RMSE, second half"):
        table.add_column(heading, justify="right")
    for one in errors_document(result).states:
        table.add_row(one.name, f"{one.first:.4g}", f"{one.last:.4g}", f"{one.rmse:.4g}")
    screen = results()
    screen.print(f"{result.title}, {len(result.t)} samples", style="bold")
    screen.print(table)


def _tables(design: Any, one: DesignDocument, *, stored: bool = False) -> list[Table]:
    """A table for each bound, the gap below the first, whose gain is the one that was minimised."""
    tables = []
    unit = "1/step" if _discrete(design) else "1/s"
    for part, bound in one.bounds.items():
        table = Table(box=None, pad_edge=False)
        table.add_column(ABOUT.get(part, "proved of the error"))
        table.add_column("", justify="right")
        table.add_row(f"decays at least at [{unit}]", f"{bound.rate:.6g}")
        table.add_row("overshoot at most", f"{bound.overshoot:.4g}")
        for name, gain in bound.gains.items():
            table.add_row(f"gain of {DISTURBANCES.get(name, name)} at most", f"{gain:.4g}")
        tables.append(table)
    label = "gap to the best, as stored, not recomputed" if stored else "gap to the best"
    tables[0].add_row(label, "not known" if one.gap is None else f"{one.gap:.2%}")
    return tables


def _proved(design: Any) -> tuple[dict[str, ProvedBound], float]:
    """What is bounded, and the gap."""
    if isinstance(design, RegulatorDesign):
        # The generator of this observer is the plant itself, and what disturbs it, w, is the plant's d.
        error = _bound(design.observer.bound, w="d")
        return {ERROR: error, ESTIMATE: _bound(design.feedback.certificate.bound)}, design.observer.gap
    if isinstance(design, UnknownInputObserver):
        proof = design.certificate
        return {"error": ProvedBound(0.5 * proof.sigma, proof.phi1, {"delta": proof.phi2})}, proof.gap
    if isinstance(design, InterlacedObserver):
        shown = design.certificate
        found = ProvedBound(shown.rate, shown.overshoot, {"noise": shown.noise_gain})
        return {"error": found}, shown.gap
    if isinstance(design, ReducedOrderDesign):
        return {"error": _bound(design.certificate.bound)}, design.gap
    assert isinstance(design, ObserverDesign)
    return {"error": _bound(design.bound)}, design.gap


def _sizes(design: Any) -> dict[str, float]:
    """The largest eigenvalue of the P that each inequality has, by how its name begins."""
    if isinstance(design, RegulatorDesign):
        found = {"observer: ": design.observer.values["P"], "feedback: ": design.feedback.certificate.P}
    elif isinstance(design, UnknownInputObserver):
        found = {"": design.certificate.p}
    elif isinstance(design, InterlacedObserver):
        found = {"": design.certificate.P}
    else:
        proof = design.certificate if isinstance(design, ReducedOrderDesign) else design
        found = {"": proof.values["P"]}
    return {name: float(np.linalg.norm(np.atleast_2d(p), 2)) for name, p in found.items()}


def _bound(bound: ErrorBound, **others: str) -> ProvedBound:
    """A bound with its gains by disturbance; ``others`` are other names of some."""
    names = [others.get(name, name) for name in bound.disturbances]
    return ProvedBound(bound.decay, bound.overshoot, dict(zip(names, bound.gains, strict=True)))


def _gains(design: Any) -> dict[str, Any]:
    """The matrices that a program needs to run the observer by itself."""
    if isinstance(design, ReducedOrderDesign):
        return {"Upsilon": design.Upsilon}
    if isinstance(design, RegulatorDesign):
        return {"G": design.observer.gain, "L0": design.feedback.L0}
    if isinstance(design, InterlacedObserver):
        return {"L": np.asarray(design.certificate.L)}
    return {"M": design.gain} if isinstance(design, ObserverDesign) else {}


def _discrete(design: Any) -> bool:
    observer = getattr(design, "observer", design)
    plant = getattr(observer, "plant", getattr(observer, "system", None))
    return getattr(plant, "time", "continuous") == "discrete"
