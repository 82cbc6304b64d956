"""What a user may set of a stage: declared once, in the class, and read from there by everybody else.

The declaration gives the default, the check, the order in the memory, ``describe`` and the docs::

    class LinearPredictor(Predictor):
        horizon_s: float = parameter("s", 0.0, 1.0, "how far ahead the velocity goes on", default=0.12)
"""

from __future__ import annotations

import inspect
import warnings
from collections.abc import Mapping
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError

REQUIRED: Any = ...
"""The default of a parameter that has none."""
SLOW_S, SLOWEST_MS, FEW = 2.0, 500.0, 3
"""The longest median interval of a pointer in s, and in ms, judged by at least so many."""


def is_number(value: object) -> bool:
    """Whether a value is a number by its kind: no word that reads like one, no truth value, no duration."""
    numbers = int | float | np.integer | np.floating
    return isinstance(value, numbers) and not isinstance(value, bool | np.timedelta64)


def warn_of_milliseconds(steps: Any) -> None:
    """Warn where the median step forwards of a clock, an array in s, is one of a pointer in ms."""
    forwards = steps[steps > 0]
    middle = float(np.median(forwards)) if len(forwards) >= FEW else 0.0
    if SLOW_S < middle <= SLOWEST_MS:
        words = f"the median interval of t is {middle:g} s: t is in seconds, are these milliseconds?"
        warnings.warn(words, stacklevel=3)


class Parameter(msgspec.Struct, frozen=True):
    """A number that a user may set: its unit, its closed bounds, what it does, and its default."""

    name: str
    unit: str
    low: float
    high: float
    meaning: str
    default: Any = REQUIRED
    whole: bool = False
    """Whether it must be a whole number."""
    absent: float | None = None
    """What stands in the memory for ``None``; ``None`` itself: a number is needed."""
    positional: bool = False

    def check(self, value: Any) -> None:
        """Raise ParameterError for a value that is not a number within the bounds."""
        if value is None and self.absent is not None:
            return
        unit = f" {self.unit}" if self.unit else ""
        if not is_number(value):
            kind = f"a number ({self.unit})" if unit else "a number"
            raise self._error(f"{self.name} must be {kind}, received {value!r}", value)
        if not self.low <= value <= self.high:
            bounds = f"[{self.low:g}, {self.high:g}]{unit}"
            raise self._error(f"{self.name} must lie in {bounds}, received {value!r}", value)
        if self.whole and value != int(value):
            raise self._error(f"{self.name} must be a whole number, received {value!r}", value)

    def number(self, value: Any) -> float:
        """A checked value as it stands in the memory."""
        return float(self.absent if value is None and self.absent is not None else value)

    def _error(self, message: str, value: object) -> ParameterError:
        return ParameterError(message, field=self.name, value=value)


class Option(msgspec.Struct, frozen=True):
    """Something a user may set that is not a number, such as a file or one of several words."""

    name: str
    meaning: str
    default: Any = REQUIRED
    positional: bool = False
    """Whether the constructor also takes it by its place."""


def parameter(
    unit: str,
    low: float,
    high: float,
    meaning: str,
    *,
    default: Any = REQUIRED,
    whole: bool = False,
    absent: float | None = None,
    kw_only: bool = True,
) -> Any:
    """Declare a number as an attribute of a stage's class; the attribute's name is the parameter's."""
    return Parameter("", unit, low, high, meaning, default, whole, absent, not kw_only)


def option(meaning: str, *, default: Any = REQUIRED, kw_only: bool = True) -> Any:
    """Declare something else that may be set as an attribute of a stage's class."""
    return Option("", meaning, default, not kw_only)


def declared(
    own: Mapping[str, Any], inherited: tuple[Parameter | Option, ...]
) -> tuple[Parameter | Option, ...]:
    """The declarations of a class body behind those of its parent; one that replaces another takes its place.

    The place in the memory follows the order, so that the law of the parent finds its own.
    """
    declarations = {one.name: one for one in inherited}
    for name, value in own.items():
        if isinstance(value, Parameter | Option):
            declarations[name] = msgspec.structs.replace(value, name=name)
    return tuple(declarations.values())


def signature(declarations: tuple[Parameter | Option, ...]) -> inspect.Signature:
    """The signature of a constructor that takes these, as ``help`` shows it."""
    kinds = {True: inspect.Parameter.POSITIONAL_OR_KEYWORD, False: inspect.Parameter.KEYWORD_ONLY}
    ordered = [one for one in declarations if one.positional and one.default is REQUIRED]
    ordered += [one for one in declarations if one.positional and one.default is not REQUIRED]
    ordered += [one for one in declarations if not one.positional]
    return inspect.Signature(
        [
            inspect.Parameter(
                one.name,
                kinds[one.positional],
                default=inspect.Parameter.empty if one.default is REQUIRED else one.default,
            )
            for one in ordered
        ]
    )


def by_name(declarations: tuple[Parameter | Option, ...], values: tuple[Any, ...]) -> dict[str, Any]:
    """The names of values that a constructor was given by their place."""
    names = [one.name for one in declarations if one.positional]
    if len(values) > len(names):
        raise TypeError(f"takes {len(names)} values by their place, received {len(values)}")
    return dict(zip(names, values, strict=False))


def complete(
    owner: str, declarations: tuple[Parameter | Option, ...], given: dict[str, Any]
) -> dict[str, Any]:
    """Every declared value by name: what is given, else its default; raises ParameterError."""
    names = [one.name for one in declarations]
    if unknown := [name for name in given if name not in names]:
        message = f"{owner} has no parameter {unknown[0]!r}; it has {', '.join(names) or 'none'}"
        raise ParameterError(message, code="unknown_parameter", field=unknown[0], value=given[unknown[0]])
    values = {}
    for one in declarations:
        value = given.get(one.name, one.default)
        if value is REQUIRED:
            raise ParameterError(f"{owner} needs {one.name}", field=one.name)
        if isinstance(one, Parameter):
            one.check(value)
        values[one.name] = value
    return values


def check(parameters: tuple[Parameter, ...], values: dict[str, Any]) -> None:
    """Raise ParameterError for a value that is not a number within its bounds."""
    for one in parameters:
        one.check(values[one.name])
