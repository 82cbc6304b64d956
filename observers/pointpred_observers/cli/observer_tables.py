"""Designs, audits and simulated errors as tables in the terminal and as JSON."""

from __future__ import annotations

import msgspec
import numpy as np
from rich.table import Table

from pointpred.console import results
from pointpred_observers import Observer
from pointpred_observers.simulations.result import Simulation

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


ABOUT = {
    "error": "proved of the error",
    "x - Pi w": "proved of x - Pi w, the error of the estimate",
    "Pi w": "proved of Pi w, the estimate, which x - Pi w and v drive as d",
}


class ProvedBound(msgspec.Struct, frozen=True):
    """A norm shrinks as exp(-``decay`` t), 1/s (1/step), from ``overshoot`` times the first."""

    decay: float
    overshoot: float
    gains: dict[str, float]


class DesignDocument(msgspec.Struct, frozen=True):
    """What ``design --json`` and ``audit --json`` write; ``gap`` is null where nothing is proved.

    ``bounds`` by what they bound: the "error", or "x - Pi w" and "Pi w" of a regulator, of which x is the
    sum. An audit does not compute ``gap`` again: it is the one that the file holds.
    """

    version: int
    kind: str
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


def summary(design: Observer) -> DesignDocument:
    """The numbers that a certificate proves of the error."""
    bounds = {
        name: ProvedBound(one.decay, one.overshoot, dict(zip(one.disturbances, one.gains, strict=True)))
        for name, one in design.bounds.items()
    }
    gap = float(design.gap) if design.gap <= KNOWN else None
    return DesignDocument(2, design.kind, gap, design.margins, bounds)


def print_design(design: Observer) -> None:
    """What was designed, and what is proved of it."""
    screen = results()
    screen.print(f"{design.kind} observer" if design.kind != "regulator" else "regulator", style="bold")
    for table in _tables(design, "gap to the best"):
        screen.print(table)
    for name, matrix in design.chosen.items():
        screen.print(f"{name} = {np.array2string(matrix, precision=6, separator=', ')}")


def print_audit(design: Observer, margins: dict[str, float]) -> None:
    """How far each inequality holds, and what they prove."""
    table = Table(box=None, pad_edge=False)
    table.add_column("inequality")
    table.add_column("holds by, where the largest eigenvalue of P is 1", justify="right")
    sizes = {name: float(np.linalg.norm(np.atleast_2d(p), 2)) for name, p in design.lyapunov.items()}
    for name, margin in margins.items():
        size = next(one for part, one in sizes.items() if name.startswith(part))
        table.add_row(name, f"{margin / size:.4g}")
    screen = results()
    screen.print(table)
    for bounded in _tables(design, "gap to the best, as stored, not recomputed"):
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


def _tables(design: Observer, label: str) -> list[Table]:
    """A table for each bound, the gap below the first, whose gain is the one that was minimised."""
    tables = []
    unit = "1/step" if getattr(design.plant, "time", "continuous") == "discrete" else "1/s"
    for part, bound in design.bounds.items():
        table = Table(box=None, pad_edge=False)
        table.add_column(ABOUT[part])
        table.add_column("", justify="right")
        table.add_row(f"decays at least at [{unit}]", f"{bound.decay:.6g}")
        table.add_row("overshoot at most", f"{bound.overshoot:.4g}")
        for name, gain in zip(bound.disturbances, bound.gains, strict=True):
            table.add_row(f"gain of {DISTURBANCES.get(name, name)} at most", f"{gain:.4g}")
        tables.append(table)
    tables[0].add_row(label, f"{design.gap:.2%}" if design.gap <= KNOWN else "not known")
    return tables
