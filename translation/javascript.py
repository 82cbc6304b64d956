"""A law as a JavaScript function: its statements."""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterable, Iterator

from translation.expressions import BINARY, CALL, COMPARE, Expressions, Text, number
from translation.flat import flattened
from translation.names import renamed
from translation.source import Module


class Law:
    """A law in JavaScript: ``text``; what it needs of the package, ``uses``, and of ``arithmetic.js``."""

    def __init__(self, reader: Module, function: ast.FunctionDef) -> None:
        function, places = flattened(reader, copy.deepcopy(function))
        self.function = function
        self._expressions = Expressions(reader, function)
        self.uses, self.arithmetic = self._expressions.uses, self._expressions.arithmetic
        self._locals = self._expressions.locals
        self._temporary = 0
        self._check_arguments()
        names = ", ".join(
            renamed(one.arg) + (" = 0" if one.arg in places else "") for one in function.args.args
        )
        body = function.body[1:] if ast.get_docstring(function) else function.body
        first = [renamed(name) for name in self._locals.declared_first()]
        lines = [*([f"let {', '.join(first)};"] if first else []), *self._block(body)]
        head = f"export function {renamed(function.name)}({names}) {{"
        self.text = "\n".join([*_types(function), head, *_indent(lines), "}"])

    def _check_arguments(self) -> None:
        arguments = self.function.args
        if arguments.vararg or arguments.kwarg or arguments.kwonlyargs or arguments.defaults:
            raise self._expressions.error(self.function, "an argument that is not plain")

    def _block(self, statements: Iterable[ast.stmt]) -> list[str]:
        return [line for statement in statements for line in self._statement(statement)]

    def _statement(self, node: ast.stmt) -> Iterator[str]:
        match node:
            case ast.Return(value=None):
                yield "return;"
            case ast.Return(value=value):
                assert value is not None
                yield f"return {self._expressions.text(value).text};"
            case ast.Expr(value=ast.Call() as call):
                yield f"{self._expressions.text(call).text};"
            case ast.Expr():
                raise self._expressions.error(node, f"a value that is not used: {ast.unparse(node)}")
            case ast.Assign():
                yield from self._assign(node)
            case ast.AugAssign():
                yield self._augment(node)
            case ast.If():
                yield from self._if(node)
            case ast.For() | ast.While() if node.orelse:
                raise self._expressions.error(node, "else of a loop")
            case ast.For():
                yield f"for ({self._range(node)}) {{"
                yield from _indent(self._block(node.body))
                yield "}"
            case ast.While():
                yield f"while ({self._expressions.condition(node.test).text}) {{"
                yield from _indent(self._block(node.body))
                yield "}"
            case ast.Break():
                yield "break;"
            case ast.Continue():
                yield "continue;"
            case _:
                raise self._expressions.error(node, type(node).__name__)

    def _if(self, node: ast.If, word: str = "if") -> Iterator[str]:
        yield f"{word} ({self._expressions.condition(node.test).text}) {{"
        yield from _indent(self._block(node.body))
        match node.orelse:
            case []:
                yield "}"
            case [ast.If() as other]:
                yield from self._if(other, "} else if")
            case _:
                yield "} else {"
                yield from _indent(self._block(node.orelse))
                yield "}"

    def _range(self, node: ast.For) -> str:
        call = node.iter
        if not (isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id == "range"):
            raise self._expressions.error(node, f"for over {ast.unparse(call)}")
        if not isinstance(node.target, ast.Name):
            raise self._expressions.error(node, f"for {ast.unparse(node.target)}")
        step = call.args[2] if len(call.args) == 3 else ast.Constant(1)
        value = ast.literal_eval(step) if _is_whole(step) else 0
        if value not in (1, -1):
            raise self._expressions.error(node, f"range in steps of {ast.unparse(step)}")
        name = node.target.id
        if self._locals.outlives_loop(node, name):
            raise self._expressions.error(node, f"{name} is used outside of its loop")
        first, last = (
            ("0", call.args[0])
            if len(call.args) == 1
            else (self._expressions.text(call.args[0]).text, call.args[1])
        )
        i, declared, limit = renamed(name), f"let {renamed(name)} = {first}", self._expressions.text(last)
        if not self._is_stable(last):
            end = self._name_for("end")
            declared, limit = f"{declared}, {end} = {limit.text}", Text(end)
        before, next_one = ("<", "++") if value == 1 else (">", "--")
        return f"{declared}; {i} {before} {limit.within(COMPARE + 1)}; {i}{next_one}"

    def _is_stable(self, node: ast.expr) -> bool:
        """Whether an expression costs nothing and keeps its value while a loop runs."""
        if isinstance(node, ast.Name) and node.id in self._locals.names:
            return self._locals.is_constant(node.id)
        return isinstance(node, ast.Constant | ast.Name | ast.Attribute)

    def _name_for(self, word: str) -> str:
        """A name that the law does not have."""
        self._temporary += 1
        return f"{word}_{self._temporary}"

    def _augment(self, node: ast.AugAssign) -> str:
        operator = BINARY.get(type(node.op))
        if operator is None:
            raise self._expressions.error(node, f"{type(node.op).__name__} in {ast.unparse(node)}")
        return f"{self._target(node.target)} {operator[0]}= {self._expressions.text(node.value).text};"

    def _assign(self, node: ast.Assign) -> Iterator[str]:
        self._expressions.types.learn(node)
        if len(node.targets) > 1:
            if any(isinstance(target, ast.Tuple) for target in node.targets):
                raise self._expressions.error(node, f"a tuple in {ast.unparse(node)}")
            chain = " = ".join(self._target(target) for target in node.targets)
            yield f"{chain} = {self._expressions.text(node.value).text};"
            return
        target, value = node.targets[0], node.value
        match target:
            case ast.Tuple(elts=targets) if isinstance(value, ast.Tuple) and len(value.elts) == len(targets):
                yield from self._assign_each(node, targets, value.elts)
            case ast.Tuple(elts=targets):
                yield from self._unpack(node, targets, value)
            case ast.Subscript(slice=ast.Slice() as part):
                array, bounds = (
                    self._expressions.text(target.value).within(CALL),
                    self._expressions.bounds(part),
                )
                yield f"{array}.fill({self._expressions.text(value).text}{bounds});"
            case _:
                yield f"{self._left(node, target)} = {self._value(target, value).text};"

    def _value(self, target: ast.expr, value: ast.expr) -> Text:
        """A value as its target takes it: the offset of a slice, where only single numbers of it are used."""
        if isinstance(target, ast.Name) and target.id in self._locals.views:
            assert isinstance(value, ast.Subscript)
            assert isinstance(value.slice, ast.Slice)
            return number(0) if value.slice.lower is None else self._expressions.text(value.slice.lower)
        return self._expressions.text(value)

    def _assign_each(
        self, node: ast.Assign, targets: list[ast.expr], values: list[ast.expr]
    ) -> Iterator[str]:
        """``a, b = x, y``: one by one, through names of their own where a later value reads a target."""
        pairs = [
            (target, value) for target, value in zip(targets, values, strict=True) if not _is_unused(target)
        ]
        written = {name for target, _ in pairs[:-1] for name in _written(target)}
        apart = any(name in written for _, value in pairs[1:] for name in _names(value))
        texts = []
        for target, value in pairs:
            text = self._value(target, value).text
            if apart:
                name = self._name_for("value")
                yield f"const {name} = {text};"
                text = name
            texts.append(text)
        for (target, _), text in zip(pairs, texts, strict=True):
            if isinstance(target, ast.Tuple):
                raise self._expressions.error(node, f"a tuple within a tuple in {ast.unparse(node)}")
            yield f"{self._left(node, target)} = {text};"

    def _unpack(self, node: ast.Assign, targets: list[ast.expr], value: ast.expr) -> Iterator[str]:
        """``a, b = tuple``: by index, which costs less than a pattern."""
        if isinstance(value, ast.Name):
            source = self._expressions.text(value).text
        else:
            source = self._name_for("values")
            yield f"const {source} = {self._expressions.text(value).text};"
        for i, target in enumerate(targets):
            if not _is_unused(target):
                yield f"{self._left(node, target)} = {source}[{i}];"

    def _left(self, statement: ast.stmt, target: ast.expr) -> str:
        """The target of an assignment, with its declaration where the name begins."""
        if isinstance(target, ast.Name) and self._locals.begins_here(statement, target.id):
            return f"{'const' if self._locals.is_constant(target.id) else 'let'} {renamed(target.id)}"
        return self._target(target)

    def _target(self, target: ast.expr) -> str:
        match target:
            case ast.Name():
                return renamed(target.id)
            case ast.Subscript() if not isinstance(target.slice, ast.Slice):
                return self._expressions.text(target).text
        raise self._expressions.error(target, f"assignment to {ast.unparse(target)}")


def _is_whole(node: ast.expr) -> bool:
    try:
        return isinstance(ast.literal_eval(node), int)
    except ValueError:
        return False


def _is_unused(target: ast.expr) -> bool:
    return isinstance(target, ast.Name) and target.id == "_"


def _written(target: ast.expr) -> Iterator[str]:
    """The name that an assignment to a target changes: the name itself, or that of the array."""
    for node in ast.walk(target):
        if isinstance(node, ast.Name):
            yield node.id
            return


def _names(node: ast.expr) -> Iterator[str]:
    return (one.id for one in ast.walk(node) if isinstance(one, ast.Name))


def _types(function: ast.FunctionDef) -> list[str]:
    """What a checker of types cannot infer: a tuple whose elements are of several types."""
    match function.returns:
        case ast.Subscript(value=ast.Name("tuple"), slice=ast.Tuple(elts=elements)):
            words = ["boolean" if ast.unparse(one) == "bool" else "number" for one in elements]
            return [f"/** @returns {{[{', '.join(words)}]}} */"] if len({*words}) > 1 else []
        case _:
            return []


def _indent(lines: Iterable[str]) -> list[str]:
    return [f"  {line}" for line in lines]
