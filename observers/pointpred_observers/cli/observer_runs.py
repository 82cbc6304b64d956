"""Signals of ``pointpred observers simulate``: options in, a table of every signal out."""

from __future__ import annotations

import csv
from collections.abc import Callable
from io import TextIOWrapper
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.errors import ParameterError
from pointpred.files import whole
from pointpred.records import FloatArray
from pointpred_observers import CornerSystem, Observer, Persidskii, load
from pointpred_observers.plants.expressions import parsed
from pointpred_observers.plants.polynomials import symbolic
from pointpred_observers.simulations.result import Simulation


def design_of(file: Path) -> Observer:
    """The design of a file, audited; raises ParameterError for the file of a plant."""
    made = load(file)
    if not isinstance(made, Observer):
        raise ParameterError(
            f"{file} must be the file of a design, it holds a {type(made).__name__}: design an observer "
            "first, with pointpred observers design",
            field="design",
        )
    return made


MOST = 1_000_000
"""The most samples of a simulation."""
STEP_S = 0.01
"""Between two samples of a continuous plant."""


def sampling(plant: Any, length: float | None) -> FloatArray:
    """The times of the samples over a length in s, or the indices of a discrete plant over one in steps."""
    discrete = isinstance(plant, Persidskii | CornerSystem) and plant.time == "discrete"
    step, usual = (1.0, 1000.0) if discrete else (STEP_S, 10.0)
    length = usual if length is None else length
    if not 0.0 < length < np.inf:
        raise ParameterError(f"--seconds must be finite and above 0, received {length:g}", field="seconds")
    count = round(length / step)
    if not 1 <= count <= MOST or (discrete and count != length):
        bounds = (
            f"be a whole number in [1, {MOST}]" if discrete else f"lie in [{STEP_S:g}, {STEP_S * MOST:g}]"
        )
        raise ParameterError(f"--seconds must {bounds}, received {length:g}", field="seconds")
    return np.asarray(step * np.arange(count + 1), np.float64)


def signals(
    *,
    start: str | None,
    input: list[str] | None,
    unknown_input: list[str] | None,
    parameter: list[str] | None,
    noise: str,
) -> dict[str, Any]:
    """The arguments of ``simulate`` that the options name."""
    asked: dict[str, Any] = {"noise": _numbers("--noise", noise)}
    if start is not None:
        asked["start"] = _numbers("--start", start)
    for name, texts in (("input", input), ("unknown_input", unknown_input)):
        if texts:
            option = f"--{name.replace('_', '-')}"
            asked[name] = _together([_function(option, text) for text in texts])
    if parameter:
        asked["schedule"] = dict(_variable(text) for text in parameter)
    return asked


def write_signals(result: Simulation, target: Path) -> None:
    """A CSV file with a column for each signal; what is not there (NaN) is an empty field."""
    columns = {"k" if result.discrete else "t": result.t}
    for i, name in enumerate(result.names):
        columns |= {name: result.state[:, i], f"{name}_estimate": result.estimate[:, i]}
    many = {
        "y": result.output,
        "u": result.input,
        "d": result.unknown_input,
        "d_estimate": result.unknown_input_estimate,
        "w": result.driving,
        "w_estimate": result.driving_estimate,
    }
    for name, table in many.items():
        head, _, tail = name.partition("_")
        for i in range(table.shape[1]):
            columns[f"{head}{i + 1}{'_' + tail if tail else ''}"] = table[:, i]
    if result.bound.size:
        columns["bound"] = result.bound
    with whole(target) as unfinished, TextIOWrapper(unfinished, encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(columns)
        for row in zip(*(one.tolist() for one in columns.values()), strict=True):
            writer.writerow(["" if value != value else repr(value) for value in row])


def _numbers(option: str, text: str) -> list[float]:
    try:
        return [float(part) for part in text.split(",")]
    except ValueError as unusable:
        raise ParameterError(
            f"{option} needs numbers separated by commas, received {text!r}", field=option
        ) from unusable


def _function(option: str, text: str) -> Callable[[float], float]:
    """A function of t; raises ParameterError naming the option for anything else."""
    expression, t = parsed(text, option), symbolic().Symbol("t")
    if foreign := expression.free_symbols - {t}:
        raise ParameterError(
            f"{option} must be a function of t alone, received {text!r} with "
            f"{', '.join(sorted(map(str, foreign)))}",
            field=option,
        )
    function = symbolic().lambdify(t, expression, modules="math")

    def value(now: float) -> float:
        try:
            return float(function(now))
        except (ArithmeticError, ValueError, TypeError) as none:
            raise ParameterError(f"{option}: {text!r} has no value at t = {now:g}", field=option) from none

    return value


def _together(functions: list[Callable[[float], float]]) -> Callable[[float], FloatArray]:
    return lambda t: np.array([one(t) for one in functions], np.float64)


def _variable(text: str) -> tuple[str, Callable[[float], float]]:
    name, equals, expression = text.partition("=")
    if not equals:
        raise ParameterError(f"--parameter needs NAME=EXPRESSION, received {text!r}", field="--parameter")
    return name.strip(), _function(f"--parameter {name.strip()}", expression)
