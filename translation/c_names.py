"""Names of Python as names of C, and which laws a closure is made around."""

from __future__ import annotations

import ast
from functools import cache
from typing import NamedTuple, TypeAlias

from translation.kinds import in_c
from translation.source import Module, Name, UntranslatableError, module

RESERVED = frozenset(
    [
        "auto",
        "case",
        "char",
        "const",
        "default",
        "do",
        "double",
        "enum",
        "extern",
        "float",
        "goto",
        "int",
        "long",
        "register",
        "restrict",
        "short",
        "signed",
        "sizeof",
        "static",
        "struct",
        "switch",
        "typedef",
        "union",
        "unsigned",
        "void",
        "volatile",
        "inline",
        "alloca",
        "calloc",
        "malloc",
        "free",
        "abs",
        "fabs",
        "floor",
        "ceil",
        "trunc",
        "sqrt",
        "exp",
        "log",
        "log1p",
        "expm1",
        "sin",
        "cos",
        "tan",
        "asin",
        "acos",
        "atan",
        "atan2",
        "sinh",
        "cosh",
        "tanh",
        "erf",
        "lgamma",
        "hypot",
        "pow",
        "copysign",
        "isfinite",
        "square",
        "bool",
        "true",
        "false",
        "NAN",
        "INFINITY",
    ]
)
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
