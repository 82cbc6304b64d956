"""What the values of a law are in C: numbers, arrays, tuples; read from the annotations."""

from __future__ import annotations

import ast
from itertools import groupby
from typing import Any, NamedTuple, TypeAlias

from pointpred.layout import Layout
from translation.source import Module, Name, UntranslatableError, member, module, origin, row_of

RESERVED = {
    *("EOF", "FlagTable", "FlagVector", "INFINITY", "INT64_C", "NAN", "NULL", "RELEASED", "Table"),
    *("Vector", "WholeTable", "WholeVector", "abort", "abs", "acos", "alloca", "asin", "atan"),
    *(
        "atan2",
        "auto",
        "bool",
        "calloc",
        "case",
        "ceil",
        "char",
        "const",
        "copied",
        "copy_into",
        "copy_whole_into",
        "copysign",
    ),
    *("cos", "cosh", "default", "do", "double", "enum", "erf", "errno", "exit", "exp", "expm1"),
    *("extern", "fabs", "false", "fill", "fill_whole", "float", "floor", "floor_divided_float"),
    *("floor_divided_whole", "free", "goto", "hypot", "inline", "int", "int64_t", "isfinite"),
    *("lgamma", "log", "log1p", "log2", "long", "malloc", "max_float", "max_whole", "memcpy", "memmove"),
    *("memset", "min_float", "min_whole", "pow", "power_of_whole", "register", "release", "remainder_float"),
    *("remainder_whole", "reserved", "restrict", "short", "signed", "sin", "sinh", "size_t"),
    *("sizeof", "sqrt", "square", "static", "stderr", "stdin", "stdout", "struct", "switch"),
    *("tan", "tanh", "true", "trunc", "typedef", "uint8_t", "union", "unsigned", "void", "volatile"),
    "whole_power",
}
"""Words that mean something in the files that are written; a name that is one gets an underscore."""


def local(name: str) -> str:
    """A local name in C."""
    return f"{name}_" if name in RESERVED else name


def in_c(name: Name) -> str:
    """A name of a module as one of C."""
    return "_".join([*name.module.split(".")[1:], name.name])


class Number(NamedTuple):
    """A single value."""

    c: str
    letter: str


class Array(NamedTuple):
    """Numbers of one kind, one behind the other (``dimensions`` 1) or in rows (2)."""

    of: Number
    dimensions: int

    @property
    def c(self) -> str:
        """The struct that ``laws.h`` has for it."""
        word = {"d": "", "q": "Whole", "b": "Flag"}[self.of.letter]
        return f"{word}{'Vector' if self.dimensions == 1 else 'Table'}"


class Parts(NamedTuple):
    """A tuple; ``of`` names the class, and ``names`` the parts, where it is a row."""

    kinds: tuple[Kind, ...]
    of: Name | None = None
    names: tuple[str, ...] = ()

    @property
    def c(self) -> str:
        """The struct in C: after the class, or by the kinds of the parts."""
        if self.of is not None:
            return in_c(self.of)
        codes = [one.letter if isinstance(one, Number) else f"_{one.c}_" for one in self.kinds]
        runs = [(code, len(list(same))) for code, same in groupby(codes)]
        return "T" + "".join(f"{count}{code}" if count > 1 else code for code, count in runs)

    def field(self, place: int) -> str:
        """The name of a part in C."""
        return local(self.names[place]) if self.names else f"f{place}"


class Memory(NamedTuple):
    """A memory with names: a pointer to the struct of its layout."""

    of: type[Layout]

    @property
    def struct(self) -> str:
        """The name of the struct."""
        return in_c(Name(self.of.__module__, self.of.__name__))

    @property
    def c(self) -> str:
        """The pointer."""
        return f"{self.struct} *"


class Memories(NamedTuple):
    """So many memories with the same names, within another one."""

    of: type[Layout]
    size: int

    @property
    def c(self) -> str:
        """What an error calls it."""
        return f"{Memory(self.of).struct}[{self.size}]"


Kind: TypeAlias = Number | Array | Parts | Memory | Memories
FLOAT, WHOLE, FLAG, NOTHING = (
    Number("double", "d"),
    Number("int64_t", "q"),
    Number("bool", "b"),
    Number("void", "v"),
)
NUMBERS = {"float": FLOAT, "int": WHOLE, "bool": FLAG, "None": NOTHING}
ARRAYS = {
    "FloatArray": Array(FLOAT, 1),
    "FloatTable": Array(FLOAT, 2),
    "IntArray": Array(WHOLE, 1),
    "IntTable": Array(WHOLE, 2),
    "BoolArray": Array(FLAG, 1),
    "BoolTable": Array(FLAG, 2),
}
"""The names of ``pointpred.records`` for arrays."""


def annotated(reader: Module, annotation: ast.expr | None) -> Kind:
    """The kind that an annotation says; raises UntranslatableError where it says none."""
    match annotation:
        case ast.Constant(value=None):
            return NOTHING
        case ast.Name(id=word):
            name = origin(reader, word)
        case ast.Attribute(value=ast.Name(id=owner), attr=word):
            name = origin(module(reader.imports[owner]), word)
        case ast.Subscript(value=ast.Name(id="tuple"), slice=ast.Tuple(elts=parts)):
            return Parts(tuple(annotated(reader, one) for one in parts))
        case ast.Subscript(value=ast.Name(id="tuple"), slice=part):
            return Parts((annotated(reader, part),))
        case _:
            raise UntranslatableError(f"{reader.path}: no kind: {annotation and ast.unparse(annotation)}")
    if not name.module and word in NUMBERS:
        return NUMBERS[word]
    if name.module == "pointpred.records" and word in ARRAYS:
        return ARRAYS[name.name]
    if (layout := layout_of(name)) is not None:
        return Memory(layout)
    if (row := row_of(name)) is not None:
        kinds = tuple(annotated(module(name.module), one) for _, one in row)
        return Parts(kinds, name, tuple(word for word, _ in row))
    if not name.module.startswith("pointpred"):
        raise UntranslatableError(f"{reader.path}: no kind: {word}")
    if (alias := module(name.module).aliases.get(name.name)) is not None:
        return annotated(module(name.module), alias)
    raise UntranslatableError(f"{reader.path}: no kind: {word}")


def layout_of(name: Name) -> type[Layout] | None:
    """The layout that a name stands for; None for any other name."""
    value = module(name.module).values.get(name.name) if name.module.startswith("pointpred") else None
    return value if isinstance(value, type) and issubclass(value, Layout) else None


def layout_at(reader: Module, node: ast.expr | None) -> type[Layout] | None:
    """The layout that an expression or an annotation names; None for any other."""
    match node:
        case ast.Name(id=word):
            return layout_of(origin(reader, word))
        case ast.Attribute(value=ast.Name(id=owner), attr=word) if owner in reader.imports:
            return layout_of(member(reader, owner, word))
    return None


def joined(one: Kind | None, other: Kind) -> Kind:
    """The kind of a name that stands for both; raises UntranslatableError."""
    if one is None or one.c == other.c:
        return other
    if isinstance(one, Parts) and isinstance(other, Parts) and len(one.kinds) == len(other.kinds):
        kinds = tuple(map(joined, one.kinds, other.kinds))
        return Parts(kinds)
    numbers = (FLAG, WHOLE, FLOAT)
    if one in numbers and other in numbers:
        return numbers[max(numbers.index(one), numbers.index(other))]
    raise UntranslatableError(f"{one.c} and {other.c} under one name")


def kind_of_value(value: Any) -> Kind | None:
    """The kind of a constant; None where it is none."""
    if isinstance(value, bool):
        return FLAG
    if isinstance(value, int):
        return WHOLE
    if isinstance(value, float):
        return FLOAT
    if isinstance(value, tuple):
        kinds = [kind_of_value(one) for one in value]
        if None in kinds:
            return None
        if set(kinds) == {FLOAT, WHOLE}:
            kinds = [FLOAT] * len(kinds)
        return Parts(tuple(one for one in kinds if one is not None))
    if type(value).__name__ == "ndarray" and value.dtype == float:
        return Array(FLOAT, value.ndim)
    return None
