"""What docs/reference/errors.md shows: errors of the library, codes of the service."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from typing import Any

import msgspec

from pages.asyncapi import words
from pointpred import errors
from pointpred.errors import PointpredError


class Kind(msgspec.Struct, frozen=True):
    """An exception class."""

    name: str
    code: str
    builtin: str
    meaning: str


def kinds() -> Iterator[Kind]:
    """Every exception of the library, in the order of its file."""
    for one in vars(errors).values():
        if inspect.isclass(one) and issubclass(one, PointpredError):
            builtin = next(base.__name__ for base in one.__mro__ if base.__module__ == "builtins")
            meaning = inspect.getdoc(one) or ""
            yield Kind(one.__name__, one.code, builtin, meaning.split("\n\n")[0].replace("\n", " "))


def context() -> dict[str, Any]:
    """What the template needs."""
    return {"kinds": list(kinds()), "codes": words.CODES, "closes": words.CLOSES}
