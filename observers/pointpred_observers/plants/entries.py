"""Matrices, infinite bounds and Python functions as JSON holds them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Self

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred_observers.numerics.matrices import matrix, wrong
from pointpred_observers.plants.expressions import names_of, text_of
from pointpred_observers.plants.nonlinearity import NAMED, Nonlinearity


class PythonFunction(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Stands for a Python function, which no file holds; ``function`` is its name there."""

    function: str


Rows = list[list[float] | float]
"""A matrix by its rows; a flat list is one row or one column, as everywhere in this library."""
Entries = Rows | PythonFunction | None
"""A matrix, a function of t or of the index, or nothing for zero."""
Values = dict[str, Rows | float]
"""Matrices of a certificate by their names in the theorem."""
Functions = Mapping[str, Callable[..., Any]]


class Document(msgspec.Struct, frozen=True, tag_field="kind", forbid_unknown_fields=True, omit_defaults=True):
    """What a file holds of one thing: ``of`` a Python object, and ``made`` into one again."""

    @classmethod
    def of(cls, thing: Any) -> Self:
        """The document of a thing; raises ParameterError for what no file can hold."""
        return cls(**fields_of(cls, thing))

    def made(self, functions: Functions) -> Any:
        """The thing, its checks and audits done; ``functions`` by name where Python functions are missing."""
        raise NotImplementedError


def fields_of(document: type[msgspec.Struct], thing: Any) -> dict[str, Any]:
    """The fields of a document that its thing has under the same names, as JSON holds them."""
    names = document.__struct_fields__
    return {name: written(getattr(thing, name)) for name in names if hasattr(thing, name)}


def written(value: Any) -> Any:
    """Anything that a plant or a design holds, as JSON holds it."""
    if isinstance(value, tuple):
        return tuple(map(written, value))
    if isinstance(value, np.ndarray):
        return entries(value)
    if isinstance(value, Nonlinearity):
        return named(value)
    if isinstance(value, float):
        return finite(value)
    if hasattr(value, "free_symbols"):
        return names_of([value])[0] if value.is_Symbol else text_of(value)
    return value


def named(f: Nonlinearity) -> Any:
    """The names of f, one if all components have the same; of a function its own."""
    if f.codes is None:
        return entries(f.function)
    names = tuple(NAMED[code] for code in f.codes)
    return names[0] if len(set(names)) == 1 else names


def entries(value: Any) -> Any:
    """A matrix as lists, ``None`` for an empty one, the name of a function for a function."""
    if callable(value):
        return PythonFunction(getattr(value, "__name__", type(value).__name__))
    table = np.asarray(value, np.float64)
    return table.tolist() if table.size else None


def finite(value: float) -> float | None:
    """A number, ``None`` for an infinite one, which JSON does not have."""
    return float(value) if np.isfinite(value) else None


def unbounded(value: float | None) -> float:
    """The number that ``finite`` was given, infinite for ``None``."""
    return np.inf if value is None else value


def gap_of(value: float | None, name: str = "gap") -> float:
    """The stored gap of a design, infinite for ``None``; raises ParameterError for one below 0."""
    if value is not None and not value >= 0.0:
        raise wrong(name, "must be a number not below 0, or null where nothing is proved", value)
    return unbounded(value)


def restored(name: str, value: Any, functions: Functions) -> Any:
    """A field with its Python function in place; raises ParameterError naming the function to pass."""
    if not isinstance(value, PythonFunction):
        return value
    if name not in functions:
        again = f"functions={{{name!r}: {value.function if value.function.isidentifier() else '...'}}}"
        words = f"{name} was saved as the Python function {value.function!r}: pass it again, as {again}"
        raise ParameterError(words, field=name)
    return functions[name]


def plain(values: dict[str, Any]) -> Values:
    """Matrices as lists, numbers as they are."""
    return {name: float(one) if np.ndim(one) == 0 else entries(one) for name, one in values.items()}


def matrices_of(
    values: Values,
    shapes: dict[str, tuple[int, int]],
    numbers: tuple[str, ...] = (),
    *,
    optional: tuple[str, ...] = (),
) -> dict[str, Any]:
    """The matrices of a certificate in their shapes; raises ParameterError for a missing or unknown one."""
    known = (*shapes, *numbers)
    if unknown := [name for name in values if name not in known]:
        raise ParameterError(f"certificate: {unknown[0]} is not known, it may hold {', '.join(known)}")
    if missing := [name for name in known if name not in values and name not in optional]:
        raise ParameterError(f"certificate: {missing[0]} is missing, it needs {', '.join(known)}")
    found: dict[str, Any] = {}
    for name, one in values.items():
        if name in numbers:
            if not isinstance(one, float):
                raise ParameterError(f"certificate: {name} must be a number, received a matrix")
            found[name] = one
        else:
            found[name] = matrix(f"certificate: {name}", one, *shapes[name])
    return found
