"""Names of Python as names of C, and which laws a closure is made around."""

from __future__ import annotations

import ast
from functools import cache
from typing import NamedTuple, TypeAlias

from translation.kinds import in_c
from translation.source import Module, Name, UntranslatableError, module


class Made(NamedTuple):
    """A law that a function makes around other laws, such as the loop around a step."""

    module: str
    outer: str
    name: str
    bound: tuple[tuple[str, Law], ...]
    """What the names of the outer function's arguments and locals stand for."""


Law: TypeAlias = Name | Made


@cache
def c_name(law: Law) -> str:
    """The name of a law, a constant or a row in C."""
    if isinstance(law, Made):
        return "_".join([law.name, *(f"_{c_name(one)}" for _, one in law.bound)])
    return in_c(law)


def key_of(law: Law) -> str:
    """What Python knows a law by; see ``pointpred.compiled``."""
    own = f"{law.module}:{law.name}"
    if isinstance(law, Made):
        return " ".join([f"{law.module}:{law.outer}", *(f"({key_of(one)})" for _, one in law.bound)])
    return own


def source_of(law: Law) -> tuple[Module, ast.FunctionDef]:
    """The module and the definition of a law."""
    reader = module(law.module)
    if isinstance(law, Name):
        return reader, reader.functions[law.name]
    for node in ast.walk(reader.functions[law.outer]):
        if isinstance(node, ast.FunctionDef) and node.name == law.name:
            return reader, node
    raise UntranslatableError(f"{reader.path}: {law.outer} makes no {law.name}")
