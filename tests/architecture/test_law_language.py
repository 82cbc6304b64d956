"""Laws are written in a small part of Python, so that they can be translated to another language.

docs/architecture.md, section "The law language", says in words what is held here. Loops that ``loop_of`` and
``loop_into`` make are exempt: they are not translated.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

import pytest

from tests.architecture.tree import module_of, package_files

EXEMPT = {
    "pointpred.protocol.records": "it reads numpy records off the wire; another language has its own way"
}
"""Modules whose laws are not translated, and why."""
MARKS = ("law", "layout")
BUILTINS = {"abs", "bool", "float", "int", "len", "max", "min", "range"}
MATH = {
    *("acos", "asin", "atan", "atan2", "ceil", "copysign", "cos", "cosh", "erf", "exp", "expm1"),
    *("floor", "hypot", "isfinite", "lgamma", "log", "log1p", "sin", "sinh", "sqrt", "tan", "tanh", "trunc"),
}
ARRAYS = {"empty", "zeros"}
"""Functions of numpy that make an array; with ``dtype=np.int64`` one of whole numbers."""
NUMBERS = {"nan", "inf", "pi"}
"""Constants of numpy and of ``math``."""
STATEMENTS = (
    *(ast.Assign, ast.AugAssign, ast.Expr, ast.Return),
    *(ast.If, ast.For, ast.While, ast.Break, ast.Continue),
)
EXPRESSIONS = (
    *(ast.Attribute, ast.BinOp, ast.BoolOp, ast.Call, ast.Compare, ast.Constant, ast.IfExp, ast.Name),
    *(ast.Slice, ast.Starred, ast.Subscript, ast.Tuple, ast.UnaryOp),
)
OPERATORS = (
    *(ast.Add, ast.Sub, ast.Mult, ast.Div, ast.FloorDiv, ast.Mod, ast.Pow, ast.USub),
    *(ast.Eq, ast.NotEq, ast.Lt, ast.LtE, ast.Gt, ast.GtE, ast.And, ast.Or, ast.Not),
    *(ast.BitAnd, ast.Invert),
)


class Module(NamedTuple):
    """A file as the reader of laws needs it."""

    name: str
    functions: dict[str, ast.FunctionDef]
    laws: dict[str, ast.FunctionDef]
    compiled: dict[str, str]
    """Names that stand for compiled functions of other modules, and where these are, dotted."""
    rows: dict[str, set[str]]
    """Classes that name the parts of a tuple, and these names."""
    imports: dict[str, str]
    """What each imported name stands for, dotted."""


@cache
def modules() -> dict[str, Module]:
    """Every module of the package by its dotted name."""
    read = {module_of(path): _parsed(module_of(path), path.read_text("utf-8")) for path in package_files()}
    for module in read.values():
        for dotted in module.compiled.values():
            where, _, name = dotted.rpartition(".")
            read[where].laws[name] = read[where].functions[name]
    return read


def _parsed(name: str, source: str) -> Module:
    tree = ast.parse(source)
    functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    laws = {key: node for key, node in functions.items() if any(map(_is_mark, node.decorator_list))}
    rows = {
        node.name: {part.target.id for part in node.body if _is_field(part)}
        for node in tree.body
        if isinstance(node, ast.ClassDef) and any(_is_name(base, "NamedTuple") for base in node.bases)
    }
    imports: dict[str, str] = {}
    for node in tree.body:
        if isinstance(node, ast.Import):
            imports |= {alias.asname or alias.name: alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            imports |= {alias.asname or alias.name: f"{node.module}.{alias.name}" for alias in node.names}
    compiled = {
        target.id: imports[node.value.args[0].id]
        for node in tree.body
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call) and _is_mark(node.value.func)
        for target in node.targets
        if isinstance(target, ast.Name) and isinstance(node.value.args[0], ast.Name)
    }
    return Module(name, functions, laws, compiled, rows, imports)


def _is_name(node: ast.expr, name: str) -> bool:
    return isinstance(node, ast.Name) and node.id == name


def _is_mark(node: ast.expr) -> bool:
    return any(_is_name(node, mark) for mark in MARKS)


def _is_field(node: ast.stmt) -> bool:
    return isinstance(node, ast.AnnAssign)


def strangers(module: Module) -> Iterator[str]:
    """``line: law: construct`` for each part of a module's laws that the language does not have."""
    for function in module.laws.values():
        arguments = function.args
        if arguments.vararg or arguments.kwarg or arguments.kwonlyargs or arguments.defaults:
            yield f"{function.lineno}: {function.name}: an argument that is not plain"
        body = function.body[1:] if ast.get_docstring(function) else function.body
        for node in (node for statement in body for node in ast.walk(statement)):
            if isinstance(node, ast.stmt | ast.expr) and (what := _stranger(module, node)):
                yield f"{node.lineno}: {function.name}: {what}"


def _stranger(module: Module, node: ast.stmt | ast.expr) -> str:
    """What of a node is not of the language; empty where all is."""
    if not isinstance(node, (*STATEMENTS, *EXPRESSIONS)):
        return type(node).__name__
    operators = [getattr(node, "op", None), *getattr(node, "ops", [])]
    if wrong := [one for one in operators if one is not None and not isinstance(one, OPERATORS)]:
        return f"{type(wrong[0]).__name__} in {ast.unparse(node)}"
    match node:
        case ast.For() | ast.While() if node.orelse:
            return "else of a loop"
        case ast.For() if not (isinstance(node.iter, ast.Call) and _is_name(node.iter.func, "range")):
            return f"for over {ast.unparse(node.iter)}"
        case ast.Expr() if not isinstance(node.value, ast.Call):
            return f"a value that is not used: {ast.unparse(node)}"
        case ast.Constant() if not isinstance(node.value, bool | int | float):
            return f"constant {node.value!r}"
        case ast.Attribute():
            return _strange_attribute(module, node)
        case ast.Call():
            return _strange_call(module, node)
    return ""


def _strange_attribute(module: Module, node: ast.Attribute) -> str:
    """A field of a row, ``shape``, or what a module holds."""
    if isinstance(node.value, ast.Name) and (where := module.imports.get(node.value.id)):
        known = where in modules() or (
            where in ("numpy", "math") and node.attr in NUMBERS | ARRAYS | MATH | {"int64"}
        )
        return "" if known else f"{where}.{node.attr}"
    fields = {field for one in modules().values() for names in one.rows.values() for field in names}
    return "" if node.attr in fields | {"shape"} else f".{node.attr}"


def _strange_call(module: Module, call: ast.Call) -> str:
    """A law, a row with names, a builtin, a function of ``math``, or an array."""
    if isinstance(call.func, ast.Name):
        dotted = module.imports.get(call.func.id, f"{module.name}.{call.func.id}")
    elif isinstance(call.func, ast.Attribute) and isinstance(call.func.value, ast.Name):
        dotted = f"{module.imports.get(call.func.value.id, '')}.{call.func.attr}"
    else:
        return f"call of {ast.unparse(call.func)}"
    where, _, name = dotted.rpartition(".")
    known = module if where == module.name else modules().get(where)
    if known is not None and name in known.rows:
        return "" if not call.keywords else f"keyword in {ast.unparse(call)}"
    if any(isinstance(argument, ast.Starred) for argument in call.args):
        return f"* in {ast.unparse(call)}"
    if where == "numpy" and name in ARRAYS:
        whole = all(word.arg == "dtype" and ast.unparse(word.value) == "np.int64" for word in call.keywords)
        return "" if whole else f"keyword in {ast.unparse(call)}"
    allowed = (
        (known is not None and name in known.laws | known.compiled)
        or (where == module.name and name in BUILTINS)
        or (where == "math" and name in MATH)
    )
    if call.keywords or not allowed:
        return f"call of {ast.unparse(call)}"
    return ""


WITH_LAWS = [name for name, module in modules().items() if module.laws]


@pytest.mark.parametrize("name", WITH_LAWS)
def test_laws_are_written_in_the_law_language(name: str) -> None:
    found = list(strangers(modules()[name]))
    if name in EXEMPT:
        assert found, f"{name} need not be exempt"
    else:
        assert not found, f"{name}: " + "; ".join(found)


@pytest.mark.parametrize(
    ("line", "construct"),
    [
        ("for x in (a, b): a = x", "for over (a, b)"),
        ("while a: a = 0\n    else: a = 1", "else of a loop"),
        ("a = [b]", "List"),
        ("a = {1: b}", "Dict"),
        ("a = 'word'", "constant 'word'"),
        ("a = lambda: b", "Lambda"),
        ("a = [x for x in b]", "ListComp"),
        ("a = b is None", "Is in b is None"),
        ("a = b >> 1", "RShift in b >> 1"),
        ("a = b.copy()", ".copy"),
        ("a = sum(b)", "call of sum(b)"),
        ("a = np.linalg.inv(b)", "numpy.linalg"),
        ("a = np.median(b)", "numpy.median"),
        ("a = np.empty(3, dtype=bool)", "keyword in np.empty(3, dtype=bool)"),
        ("a = max(*b)", "* in max(*b)"),
        ("a: float = b", "AnnAssign"),
        ("try: a = b\n    except ValueError: a = 0", "Try"),
        ("print(a)", "call of print(a)"),
        ("a", "a value that is not used: a"),
        ("assert a", "Assert"),
        ("def inner(): return a", "FunctionDef"),
    ],
)
def test_another_construct_is_named_with_its_line(line: str, construct: str) -> None:
    source = f"import numpy as np\n@law\ndef step(a, b):\n    {line}\n    return a\n"
    found = list(strangers(_parsed("pointpred.step", source)))
    assert any(one.endswith(f"step: {construct}") for one in found), found
    assert found[0].startswith("4: ")


def test_what_the_language_has_is_let_through() -> None:
    source = """
from math import hypot, nan
import numpy as np
from pointpred.rows import MotionRow
TABLE = (1.0, 2.0)
@law
def step(memory, motion):
    m = MotionRow(*motion)
    sums, counts = np.zeros(3), np.empty(2, dtype=np.int64)
    for i in range(len(sums)):
        if memory[i] != memory[i] or not m.x > 0.0:
            continue
        elif i & 1 == 0:
            break
        sums[i] += hypot(m.x, m.y) * TABLE[0] if i else nan
    while counts[0] < 3:
        counts[0] += 1
    memory[1:3] = 0.0
    return sums.shape[0], min(m.t, 1.0), np.pi
"""
    assert list(strangers(_parsed("pointpred.step", source))) == []
