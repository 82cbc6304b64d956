"""How a law runs: as the C function of its name in ``_laws``, else as plain Python.

Every law is a function on numbers, tuples, memories and contiguous arrays, in the part of Python that
``translation`` turns into C. ``POINTPRED_COMPILED=0`` runs plain Python, the reference that the laws in C are
tested against; so does an installation for which no C compiler could be had.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable
from functools import cache, wraps
from importlib import import_module
from inspect import unwrap
from typing import Any, TypeVar

from pointpred.layout import Layout

NOT_COMPILED = (
    "the laws of {0} are not compiled and run as plain Python, about 100 times slower: install a C "
    "compiler (gcc or clang) or 'python -m pip install ziglang', and install {0} again; "
    "POINTPRED_COMPILED=0 says that plain Python is wanted"
)
Answer = TypeVar("Answer")

OURS = ("pointpred", "pointpred_observers")
_functions: dict[str, Any] = {}
"""The laws in C of the packages met so far, by their keys."""


@cache
def has_c(package: str) -> bool:
    """Whether a package has laws in C, and they are wanted."""
    if os.environ.get("POINTPRED_COMPILED", "1") == "0":
        return False
    try:
        _functions.update(vars(import_module(f"{package}._laws")))
    except ImportError:
        if package in OURS:
            warnings.warn(NOT_COMPILED.format(package), RuntimeWarning, stacklevel=3)
        return False
    return True


COMPILED = has_c("pointpred")
"""False when laws run as plain Python."""


def law(function: Callable[..., Answer]) -> Callable[..., Answer]:
    """The law in C, or in Python where there is none, as in a package of somebody else.

    Where an argument is a ``Layout``, Python may hand it the flat array.
    """
    has_c(function.__module__.partition(".")[0])
    return _functions.get(key_of(function)) or with_names(function)


def with_names(function: Callable[..., Answer]) -> Callable[..., Answer]:
    """A law in Python that takes flat memories where its arguments are layouts."""
    layouts = {i: one for i, word in enumerate(_annotations(function)) if (one := _layout(function, word))}
    if not layouts:
        return function

    @wraps(function)
    def named(*arguments: Any) -> Answer:
        given = list(arguments)
        for i, layout in layouts.items():
            if not isinstance(given[i], Layout):
                given[i] = layout(given[i])
        return function(*given)

    return named


def _annotations(function: Callable[..., Any]) -> list[Any]:
    names = function.__code__.co_varnames[: function.__code__.co_argcount]
    return [function.__annotations__.get(name, "") for name in names]


def _layout(function: Callable[..., Any], annotation: Any) -> type[Layout] | None:
    """The layout that an annotation is or names, such as ``Memory`` or ``sampling.State``."""
    if not isinstance(annotation, str):
        return annotation if isinstance(annotation, type) and issubclass(annotation, Layout) else None
    owner, _, word = annotation.rpartition(".")
    values = function.__globals__
    value = getattr(values.get(owner), word, None) if owner else values.get(word)
    return value if isinstance(value, type) and issubclass(value, Layout) else None


def key_of(function: Any) -> str:
    """What a law is called: its module and name; of one that is made around laws, its maker's, and theirs."""
    function = unwrap(function)
    closed = getattr(function, "__closure__", None)
    if closed is None:
        return (
            function.__name__
            if ":" in function.__name__
            else f"{function.__module__}:{function.__qualname__}"
        )
    maker = function.__qualname__.partition(".<locals>")[0]
    return " ".join([f"{function.__module__}:{maker}", *(f"({key_of(one.cell_contents)})" for one in closed)])
