"""Names of Python as names of C, and which laws a closure is made around."""

from __future__ import annotations

import ast
from functools import cache
from typing import NamedTuple, TypeAlias

from translation.kinds import in_c
from translation.source import Module, Name, UntranslatableError, module

RESERVED = {
    *("INFINITY", "NAN", "abs", "acos", "alloca", "asin", "atan", "atan2", "auto", "bool", "calloc"),
    *("case", "ceil", "char", "const", "copysign", "cos", "cosh", "default", "do", "double", "enum"),
    *("erf", "exp", "expm1", "extern", "fabs", "false", "float", "floor", "free", "goto", "hypot"),
    *("inline", "int", "isfinite", "lgamma", "log", "log1p", "long", "malloc", "pow", "register"),
    *("restrict", "short", "signed", "sin", "sinh", "sizeof", "sqrt", "square", "static", "struct"),
    *("switch", "tan", "tanh", "true", "trunc", "typedef", "union", "unsigned", "void", "volatile"),
    *(),
}
"""Words that mean something in the files that are written; a local name that is one gets an underscore."""


class Made(NamedTuple):
    """A law that a function makes around other laws, such as the loop around a step."""

    module: str
    outer: str
    name: str
    bound: tuple[tuple[str, Law], ...]
    """What the names of the outer function's arguments and locals stand for."""


Law: TypeAlias = Name | Made


def local(name: str) -> str:
    """A local name in C."""
    return f"{name}_" if name in RESERVED else name


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
