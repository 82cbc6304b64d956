"""The scheduling variables of a simulation, and the matrices of a parameter-varying plant there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import isfinite
from typing import Any

import numpy as np

from pointpred.errors import ParameterError, PointpredError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.plants.boxes import Box, Point
from pointpred_observers.plants.varying import ParameterVaryingSystem


def schedule_of(given: Any, box: Box) -> Callable[[float, FloatArray], Point]:
    """The scheduling variables as a function of t and x; the middle of the box where nothing is given."""
    names = box.names
    if given is None:
        given = {name: 0.5 * (low + high) for name, (low, high) in box.bounds.items()}
    if not (callable(given) or isinstance(given, Mapping)):
        raise ParameterError(
            f"schedule must be a dict of {', '.join(names)} or a function of t and x, received {given!r:.60}",
            field="schedule",
            value=given,
        )

    def asked(t: float, x: FloatArray) -> Any:
        if callable(given):
            return given(t, x)
        return {name: one(t) if callable(one) else one for name, one in given.items()}

    def schedule(t: float, x: FloatArray) -> Point:
        try:
            point = asked(t, x)
        except PointpredError:
            raise
        except (TypeError, ValueError, ArithmeticError, LookupError, AttributeError) as failure:
            raise ParameterError(
                f"schedule must be a dict of {', '.join(names)}, each a number or a function of t, or one "
                f"function of t and x that returns such a dict; it fails at t = {t:g}: "
                f"{type(failure).__name__}: {failure}",
                field="schedule",
            ) from failure
        return _point(point, names, t)

    return schedule


def _point(given: Any, names: tuple[str, ...], t: float) -> Point:
    """Scheduling variables as finite numbers; raises ParameterError for others, and for a missing one."""
    if not isinstance(given, Mapping):
        raise ParameterError(
            f"schedule must return a dict of {', '.join(names)}, received {given!r:.60} at t = {t:g}",
            field="schedule",
            value=given,
        )
    if missing := [name for name in names if name not in given]:
        raise ParameterError(
            f"schedule lacks {', '.join(missing)}, received {', '.join(map(str, given))}", field="schedule"
        )
    point = {
        name: one.item() if isinstance(one, np.ndarray) and one.size == 1 else one
        for name, one in given.items()
    }
    for name, value in point.items():
        if not (is_number(value) and isfinite(value)):
            raise ParameterError(
                f"schedule needs a finite number for {name}, or a function of t that returns one, received "
                f"{value!r:.60} at t = {t:g}",
                field="schedule",
                value=value,
            )
    return {name: float(value) for name, value in point.items()}


def matrices_at(system: ParameterVaryingSystem, point: Point) -> tuple[FloatArray, FloatArray]:
    """A and F at a point; raises ParameterError for a variable of the plant that the schedule lacks."""
    try:
        return system.a(point), system.f(point)
    except KeyError as missing:
        raise ParameterError(
            f"schedule lacks the variable {missing} of the plant, received {', '.join(point)}: give it as "
            "well, as a number or a function",
            field="schedule",
        ) from missing
