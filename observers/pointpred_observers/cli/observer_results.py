"""What ``pointpred observers`` reads and says: example plants, options in, tables, JSON and signals out."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.console import results, table
from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers import (
    Box,
    CornerSystem,
    Generator,
    Observer,
    Persidskii,
    SymbolicSystem,
    load,
)
from pointpred_observers import examples as thesis
from pointpred_observers.cli import write_table
from pointpred_observers.plants.entries import parsed
from pointpred_observers.plants.symbolic import symbolic
from pointpred_observers.simulations.result import Simulation

SAMPLES_MOST = 1_000_000
"""The most samples of a simulation."""
STEP_S = 0.01
"""Between two samples of a continuous plant."""
KNOWN = 10.0
"""A larger gap says nothing: the least objective is then not bounded from below by anything of its size."""
DISTURBANCES = {
    "v": "v, noise of the outputs,",
    "eps": "eps, a wrong model of the outputs,",
    "w": "w, a disturbance of the state's rate,",
    "d": "d, a disturbance of the state's rate,",
    "delta": "delta, a disturbance of the observer's equation,",
    "noise": "noise of the outputs",
}
"""What the disturbances of a bound are, by their names in the theorems."""
ABOUT = {
    "error": "proved of the error",
    "x - Pi w": "proved of x - Pi w, the error of the estimate",
    "Pi w": "proved of Pi w, the estimate, which x - Pi w and v drive as d",
}


def motor() -> Any:
    """Angle, speed and current of a motor with friction under a voltage; the angle is measured."""
    a0 = [[0.0, 1.0, 0.0], [0.0, -1.0, 5.0], [0.0, -5.0, -100.0]]
    friction, argument, volt = [0.0, -2.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 100.0]
    return Persidskii(a0, friction, argument, "tanh", B=volt, C0=[1.0, 0.0, 0.0])


def pendulum() -> Any:
    """Angle and speed of a damped pendulum under a torque; the angle is measured."""
    a0 = [[0.0, 1.0], [0.0, -0.3]]
    return Persidskii(a0, [0.0, -9.81], [1.0, 0.0], "sin", B=[0.0, 1.0], C0=[1.0, 0.0])


def tank() -> Any:
    """Levels of two tanks in a row, sampled once a minute; the second is measured."""
    return Persidskii([[0.95, 0.0], [0.05, 0.93]], B=[0.1, 0.0], C0=[0.0, 1.0], time="discrete")


def wing() -> Any:
    """Speed and force of a wing in a wind that nobody measures; its stiffness k varies and is known."""
    corners = [[[-0.5, 1.0], [-stiffness, -2.0]] for stiffness in (1.0, 3.0)]
    return CornerSystem(Box({"k": (1.0, 3.0)}), corners, [[1.0], [0.0]], [[1.0, 0.0]])


def spring() -> Any:
    """Two states with a product between them, written as equations; the second is measured."""
    x1, x2, u = symbolic().symbols("x1 x2 u")
    return SymbolicSystem((x1, x2), (-x1 + x2**2, -x2 + u), u, outputs=(x2,))


def oscillator() -> Any:
    """The generator of a sine and a cosine, which drives the spring."""
    return thesis.oscillator()


def oven() -> Any:
    """Temperatures of an oven and of what stands in it, above the room's, 1/min; the first is measured."""
    return Persidskii([[-0.2, 0.1], [0.1, -0.15]], B=[0.1, 0.0], C0=[1.0, 0.0])


def heating() -> Any:
    """The generator of a constant, which heats the oven by a power that nobody measures."""
    return Generator([[0.0]], L0=[1.0])


EXAMPLES: dict[str, Callable[[], Any]] = {
    one.__name__: one for one in (motor, pendulum, tank, wing, spring, oscillator, oven, heating)
}
"""What ``example`` prints."""


def design_of(file: Path) -> Observer:
    """The design of a file, audited; raises ParameterError for the file of a plant."""
    made = load(file)
    if not isinstance(made, Observer):
        words = f"{file} must be the file of a design, it holds a {type(made).__name__}"
        raise ParameterError(
            f"{words}: design an observer first, with pointpred observers design", field="design"
        )
    return made


def sampling(plant: Any, length: float | None) -> FloatArray:
    """The times of the samples over a length in s, or the indices of a discrete plant over one in steps."""
    discrete = isinstance(plant, Persidskii | CornerSystem) and plant.time == "discrete"
    step, usual = (1.0, 1000.0) if discrete else (STEP_S, 10.0)
    length = usual if length is None else length
    if not 0.0 < length < np.inf:
        raise ParameterError(f"--seconds must be finite and above 0, received {length:g}", field="seconds")
    count = round(length / step)
    if not 1 <= count <= SAMPLES_MOST or (discrete and count != length):
        must = "be a whole number" if discrete else "lie"
        bounds = f"[{step:g}, {step * SAMPLES_MOST:g}]"
        raise ParameterError(f"--seconds must {must} in {bounds}, received {length:g}", field="seconds")
    return np.asarray(step * np.arange(count + 1), np.float64)


def signals(
    start: str | None,
    noise: str,
    parameter: list[str] | None,
    **functions: list[str] | None,
) -> dict[str, Any]:
    """The arguments of ``simulate`` that the options name; ``functions``: a text for each component."""
    asked: dict[str, Any] = {"noise": _numbers("--noise", noise)}
    if start is not None:
        asked["start"] = _numbers("--start", start)
    for name, texts in functions.items():
        if texts:
            asked[name] = _together([_function(f"--{name.replace('_', '-')}", text) for text in texts])
    if parameter:
        asked["schedule"] = dict(_variable(text) for text in parameter)
    return asked


def _numbers(option: str, text: str) -> list[float]:
    try:
        return [float(part) for part in text.split(",")]
    except ValueError as unusable:
        words = f"{option} needs numbers separated by commas, received {text!r}"
        raise ParameterError(words, field=option) from unusable


def _function(option: str, text: str) -> Callable[[float], float]:
    """A function of t; raises ParameterError naming the option for anything else."""
    expression, t = parsed(text, option), symbolic().Symbol("t")
    if foreign := expression.free_symbols - {t}:
        names = ", ".join(sorted(map(str, foreign)))
        words = f"{option} must be a function of t alone, received {text!r} with {names}"
        raise ParameterError(words, field=option)
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


def write_signals(result: Simulation, target: Path) -> None:
    """A CSV file with a column for each signal; what is not there (NaN) is an empty field."""
    columns = {"k" if result.discrete else "t": result.t}
    for i, name in enumerate(result.names):
        columns |= {name: result.state[:, i], f"{name}_estimate": result.estimate[:, i]}
    many = {"y": result.output, "u": result.input, "d": result.unknown_input, "w": result.driving}
    estimates = {"d": result.unknown_input_estimate, "w": result.driving_estimate}
    for name, true in many.items():
        columns |= {f"{name}{i + 1}": one for i, one in enumerate(true.T)}
        if name in estimates:
            columns |= {f"{name}{i + 1}_estimate": one for i, one in enumerate(estimates[name].T)}
    if result.bound.size:
        columns["bound"] = result.bound
    write_table(target, columns, np.column_stack(list(columns.values())))


def summary(design: Observer) -> dict[str, Any]:
    """What ``design --json`` and ``audit --json`` write: what a certificate proves.

    ``bounds`` by what they bound, the "error", or "x - Pi w" and "Pi w" of a regulator, of which x is the
    sum: the norm shrinks as exp(-``decay`` t), 1/s (1/step), from ``overshoot`` times the first. ``gap`` is
    null where nothing is proved; an audit does not compute it again: it is the one that the file holds.
    """
    bounds = {
        name: {
            "decay": one.decay,
            "overshoot": one.overshoot,
            "gains": dict(zip(one.disturbances, one.gains, strict=True)),
        }
        for name, one in design.bounds.items()
    }
    gap = float(design.gap) if design.gap <= KNOWN else None
    return {"version": 2, "kind": design.kind, "gap": gap, "margins": design.margins, "bounds": bounds}


def print_design(design: Observer) -> None:
    """What was designed, and what is proved of it."""
    screen = results()
    screen.print(f"{design.kind} observer" if design.kind != "regulator" else "regulator", style="bold")
    _print_bounds(design, "gap to the best")
    for name, matrix in design.chosen.items():
        screen.print(f"{name} = {np.array2string(matrix, precision=6, separator=', ')}")


def print_audit(design: Observer, margins: dict[str, float]) -> None:
    """How far each inequality holds, and what they prove."""
    sizes = {name: float(np.linalg.norm(np.atleast_2d(p), 2)) for name, p in design.lyapunov.items()}
    rows = []
    for name, margin in margins.items():
        size = next(one for part, one in sizes.items() if name.startswith(part))
        rows.append((name, f"{margin / size:.4g}"))
    relative = "holds by, where the largest eigenvalue of P is 1"
    results().print(table(("inequality", relative), rows, right=(relative,)))
    _print_bounds(design, "gap to the best, as stored, not recomputed")


def _print_bounds(design: Observer, label: str) -> None:
    """A table for each bound, the gap below the first, whose gain is the one that was minimised."""
    unit = "1/step" if getattr(design.plant, "time", "continuous") == "discrete" else "1/s"
    gap = [(label, f"{design.gap:.2%}" if design.gap <= KNOWN else "not known")]
    for part, bound in design.bounds.items():
        rows = [
            (f"decays at least at [{unit}]", f"{bound.decay:.6g}"),
            ("overshoot at most", f"{bound.overshoot:.4g}"),
        ]
        for name, gain in zip(bound.disturbances, bound.gains, strict=True):
            rows.append((f"gain of {DISTURBANCES.get(name, name)} at most", f"{gain:.4g}"))
        results().print(table((ABOUT[part], ""), rows + gap, right=("",)))
        gap = []


def errors_document(result: Simulation) -> dict[str, Any]:
    """What ``simulate --json`` writes: errors at the first and the last sample, RMSE of the second half."""
    error = np.abs(result.error)
    rmse = result.rmse(after=float(0.5 * (result.t[0] + result.t[-1])))
    errors = zip(result.names, error[0].tolist(), error[-1].tolist(), rmse.tolist(), strict=True)
    states = [dict(zip(("name", "first", "last", "rmse"), one, strict=True)) for one in errors]
    return {"version": 1, "title": result.title, "samples": len(result.t), "states": states}


def print_errors(result: Simulation) -> None:
    """The errors of a simulation, a row a state."""
    rows = [
        (one["name"], f"{one['first']:.4g}", f"{one['last']:.4g}", f"{one['rmse']:.4g}")
        for one in errors_document(result)["states"]
    ]
    numbers = ("error at first", "error at last", "RMSE, second half")
    results().print(f"{result.title}, {len(result.t)} samples", style="bold")
    results().print(table(("state", *numbers), rows, right=numbers))
