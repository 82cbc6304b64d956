"""A law as a C function: its arguments, its statements."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Iterator

from translation.c_expressions import BINARY, Expressions
from translation.c_names import Law, Made, c_name
from translation.c_values import CALL, Value
from translation.kinds import FLOAT, NOTHING, WHOLE, Array, Kind, Memory, Parts, annotated, joined, local
from translation.source import Module, UntranslatableError, is_law

SHORT = 30
"""Statements of a law that other rooms may have in place."""
ROUNDS = 8
"""How often a law is read until the kinds of its names no longer change."""


class Function:
    """A law in C: ``comment``, ``body``; its ``arguments`` and ``kinds``, what it ``returns`` and ``uses``.

    ``written``: the arguments whose arrays it changes; ``columns``: how many a table must have.
    """

    def __init__(
        self, law: Law, reader: Module, node: ast.FunctionDef, known: Callable[[Law], Function]
    ) -> None:
        self.law, self.reader, self.node = law, reader, node
        bound = dict(law.bound) if isinstance(law, Made) else {}
        self._known = known
        self._at = Expressions(self.reader, self.node, bound, known)
        if self.node.args.kwarg or self.node.args.kwonlyargs or self.node.args.defaults:
            raise self._at.error(self.node, "an argument that is not plain")
        self.arguments, self.kinds = self._arguments(bound)
        self.returns = self._returns(bound)
        self._at.struct(self.returns)
        for kind in self.kinds:
            self._at.struct(kind)
        body = self.node.body[1:] if ast.get_docstring(self.node) else self.node.body
        lines = self._read(body)
        at = self._at
        self.uses, self.structs, self.casts, self.layouts = at.uses, at.structs, at.casts, at.layouts
        self.columns = self._at.columns
        self.written = self._at.written & set(self.arguments)
        self.body = "\n".join([f"{self.head} {{", *_indent(self._declared() + lines), "}"])

    @property
    def head(self) -> str:
        """The function's type, name and arguments."""
        pairs = zip(self.arguments, self.kinds, strict=True)
        arguments = ", ".join(f"{kind.c} {self._argument(name, kind)}" for name, kind in pairs)
        return f"{self.returns.c} {c_name(self.law)}({arguments or 'void'})"

    def _argument(self, name: str, kind: Kind) -> str:
        return local(name) if self._at.locals.get(name, kind).c == kind.c else f"given_{name}"

    @property
    def comment(self) -> str:
        """A line of comment: what the law does."""
        words = (ast.get_docstring(self.node) or "").partition("\n")[0]
        return f"/* {words.replace('*/', '* /')} */\n" if words else ""

    @property
    def is_short(self) -> bool:
        """Whether it is a few statements without a loop."""
        statements = [one for one in ast.walk(self.node) if isinstance(one, ast.stmt)]
        return len(statements) <= SHORT and not any(
            isinstance(one, ast.For | ast.While) for one in statements
        )

    @property
    def is_wide(self) -> bool:
        """Whether it is loops in loops and calls no law: worth compiling for wide registers, too."""
        loops = [one for one in ast.walk(self.node) if isinstance(one, ast.For)]
        nested = any(
            isinstance(one, ast.For) for loop in loops for inner in loop.body for one in ast.walk(inner)
        )
        return nested and not any(isinstance(use, Made) or is_law(use) for use in self.uses)

    def _arguments(self, bound: dict[str, Law]) -> tuple[list[str], list[Kind]]:
        """The names and kinds; of a closure, as the laws take what it hands them."""
        names, kinds = [], []
        for one in self.node.args.args:
            handed = self._handed(one.arg, bound) if bound else None
            names.append(one.arg)
            kinds.append(handed if handed is not None else self._annotated(one))
        if (star := self.node.args.vararg) is not None:
            shared = [f"{star.arg}_{i}" for i in range(self._shared(star.arg, bound))]
            self._at.stars[star.arg] = shared
            names += shared
            kinds += [self._annotated(star)] * len(shared)
        return names, kinds

    def _annotated(self, argument: ast.arg) -> Kind:
        try:
            return annotated(self.reader, argument.annotation)
        except UntranslatableError as error:
            raise self._at.error(argument, f"{argument.arg}: {error}") from error

    def _handed(self, name: str, bound: dict[str, Law]) -> Kind | None:
        """What a law that is bound takes in place of an argument that is handed on to it."""
        for call in ast.walk(self.node):
            if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id in bound:
                for place, one in enumerate(call.args):
                    if isinstance(one, ast.Name) and one.id == name:
                        kind = self._known(bound[call.func.id]).kinds[place]
                        return None if isinstance(kind, Memory) else kind
        return None

    def _shared(self, star: str, bound: dict[str, Law]) -> int:
        """How many arrays stand behind the star: what a bound law takes more than it is handed by name."""
        for call in ast.walk(self.node):
            if not (isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id in bound):
                continue
            if any(isinstance(one, ast.Starred) for one in call.args):
                return len(self._known(bound[call.func.id]).kinds) - len(call.args) + 1
        raise self._at.error(self.node, f"*{star} is handed to no law")

    def _returns(self, bound: dict[str, Law]) -> Kind:
        try:
            return annotated(self.reader, self.node.returns)
        except UntranslatableError as error:
            raise self._at.error(self.node, f"returns {error}") from error

    def _read(self, body: list[ast.stmt]) -> list[str]:
        """The lines of the body, read until the kinds of all names are known."""
        at = self._at
        self._loops: set[str] = set()
        at.locals = dict(zip(self.arguments, self.kinds, strict=True))
        for _ in range(ROUNDS):
            before = {name: kind.c for name, kind in at.locals.items()}
            at.before, at.buffers, at._temporary, at.casts = [], [], 0, set()
            lines = self._block(body)
            if before == {name: kind.c for name, kind in at.locals.items()}:
                return lines
        raise at.error(self.node, "the kinds of its names cannot be found out")

    def _declared(self) -> list[str]:
        """The declarations of the names that the law assigns, and its arrays of fixed sizes."""
        names: dict[str, list[str]] = {}
        lines = []
        for name, kind in self._at.locals.items():
            if name not in self.arguments:
                if name not in self._loops:
                    names.setdefault(kind.c, []).append(local(name))
            elif kind.c != self.kinds[self.arguments.index(name)].c:
                lines.append(f"{kind.c} {local(name)} = given_{name};")
        return (
            [
                f"{kind} {', *'.join(some) if kind.endswith('*') else ', '.join(some)};"
                for kind, some in names.items()
            ]
            + lines
            + self._at.buffers
        )

    # Statements

    def _block(self, statements: Iterable[ast.stmt]) -> list[str]:
        lines = []
        for statement in statements:
            outer, self._at.before = self._at.before, []
            own = list(self._statement(statement))
            lines += self._at.before + own
            self._at.before = outer
        return lines

    def _statement(self, node: ast.stmt) -> Iterator[str]:
        at = self._at
        match node:
            case ast.Return(value=None):
                yield "return;"
            case ast.Return(value=value):
                assert value is not None
                yield f"return {at.cast(at.value(value), self.returns, node).text};"
            case ast.Expr(value=ast.Call() as call):
                yield f"{at.value(call).text};"
            case ast.Assign(targets=[target], value=value):
                yield from self._assign(node, target, value)
            case ast.Assign(targets=targets, value=value):
                yield from self._store(targets[-1], at.value(value))
                for one in reversed(targets[:-1]):
                    yield from self._store(one, at.value(targets[-1]))
            case ast.AnnAssign(target=target, value=value) if value is not None:
                yield from self._assign(node, target, value)
            case ast.AugAssign():
                yield from self._augment(node)
            case ast.If():
                at.conditional += 1
                yield from self._if(node)
                at.conditional -= 1
            case ast.For() | ast.While() if node.orelse:
                raise at.error(node, "else of a loop")
            case ast.For():
                yield from self._for(node)
            case ast.While():
                count = len(at.before)
                condition = at.condition(node.test)
                if len(at.before) > count:
                    raise at.error(node, "a new array within a condition")
                yield f"while ({condition.text}) {{"
                at.conditional += 1
                at.loops += 1
                yield from _indent(self._block(node.body))
                at.conditional -= 1
                at.loops -= 1
                yield "}"
            case ast.Break():
                yield "break;"
            case ast.Continue():
                yield "continue;"
            case _:
                raise at.error(node, type(node).__name__)

    def _if(self, node: ast.If) -> Iterator[str]:
        yield f"if ({self._at.condition(node.test).text}) {{"
        yield from _indent(self._block(node.body))
        if node.orelse:
            other = self._block(node.orelse)
            if isinstance(node.orelse[0], ast.If) and len(node.orelse) == 1 and other[0].startswith("if "):
                yield f"}} else {other[0]}"
                yield from other[1:]
                return
            yield "} else {"
            yield from _indent(other)
        yield "}"

    def _for(self, node: ast.For) -> Iterator[str]:
        at = self._at
        match node:
            case ast.For(target=ast.Name(id=name), iter=ast.Call(func=ast.Name(id="range"), args=arguments)):
                pass
            case _:
                raise at.error(node, f"for {ast.unparse(node.target)} in {ast.unparse(node.iter)}")
        step = at.constant(arguments[2]) if len(arguments) == 3 else 1
        if not step:
            raise at.error(node, "a range whose step is not known")
        if name in self.arguments:
            raise at.error(node, f"the argument {name} as the variable of a loop")
        if any(_stores(one, name) for statement in node.body for one in ast.walk(statement)):
            raise at.error(node, f"{name} is changed within its loop")
        first = at.whole(arguments[0]).text if len(arguments) > 1 else "0"
        last = arguments[0] if len(arguments) == 1 else arguments[1]
        end = at.whole(last)
        if name != "_":
            at.locals[name] = WHOLE
            self._loops.add(name)
        i = local(name) if name != "_" else at.fresh("i")
        declared = f"int64_t {i} = {first}"
        if not self._is_stable(last, node):
            limit = at.fresh("end")
            declared, end = f"{declared}, {limit} = {end.text}", Value(limit, WHOLE)
        after = {1: f"{i}++", -1: f"{i}--"}.get(step, f"{i} += {step}")
        yield f"for ({declared}; {i} {'<' if step > 0 else '>'} {end.within(CALL)}; {after}) {{"
        at.loops += 1
        yield from _indent(self._block(node.body))
        at.loops -= 1
        yield "}"

    def _is_stable(self, last: ast.expr, loop: ast.For) -> bool:
        """Whether the end of a loop costs nothing and keeps its value while the loop runs."""
        if self._at.constant(last) is not None:
            return True
        match last:
            case ast.Name(id=name) | ast.Call(func=ast.Name(id="len"), args=[ast.Name(id=name)]):
                return not any(_stores(one, name) for one in ast.walk(loop))
        return False

    def _augment(self, node: ast.AugAssign) -> Iterator[str]:
        target = ast.copy_location(ast.parse(ast.unparse(node.target), mode="eval").body, node)
        for one in ast.walk(target):
            ast.copy_location(one, node)
        value = ast.copy_location(ast.BinOp(target, node.op, node.value), node)
        at, sign = self._at, BINARY.get(type(node.op), (None,))[0]
        if at.has_law(target):
            raise at.error(node, f"a law called in the place of {ast.unparse(node.target)}")
        if sign is None or at.has_law(node.value):
            yield from self._store(node.target, at.value(value))
            return
        found = at.value(node.value)
        kind = joined(found.kind, at.value(target).kind)
        place = self._place(node.target, kind)
        if place.kind.c == kind.c:
            yield f"{place.text} {sign}= {found.text};"
        else:
            yield from self._store(node.target, at.value(value))

    def _assign(self, node: ast.stmt, target: ast.expr, value: ast.expr) -> Iterator[str]:
        at = self._at
        if (
            isinstance(target, ast.Tuple)
            and isinstance(value, ast.Tuple)
            and len(target.elts) == len(value.elts)
        ):
            pairs = [pair for pair in zip(target.elts, value.elts, strict=True) if not _is_unused(pair[0])]
            written = {name for one, _ in pairs[:-1] for name in _changed(one)}
            if any(name in written for _, one in pairs[1:] for name in _names(one)):
                kept = []
                for one, part in pairs:
                    found, name = at.value(part), at.fresh("value")
                    yield f"{found.kind.c} {name} = {found.text};"
                    kept.append((one, part, Value(name, found.kind)))
                for one, part, found in kept:
                    yield from self._store(one, found, part)
            else:
                for one, part in pairs:
                    yield from self._store(one, at.value(part), part)
            return
        match target, value:
            case ast.Name(id=name), ast.Subscript(value=ast.Name(id=table), slice=index):
                if not isinstance(index, ast.Slice | ast.Tuple):
                    at.row_of[name] = table
        found = at.value(value)
        if isinstance(target, ast.Tuple) and not isinstance(value, ast.Name):
            name = at.fresh("values")
            at.struct(found.kind)
            yield f"{found.kind.c} {name} = {found.text};"
            found = Value(name, found.kind)
        yield from self._store(target, found, value)

    def _store(self, target: ast.expr, value: Value, source: ast.expr | None = None) -> Iterator[str]:
        at = self._at
        match target:
            case ast.Name(id="_"):
                yield f"(void){value.within(CALL)};"
            case ast.Name(id=name):
                place = self._place(target, value.kind)
                if source is not None and holds_arrays(value.kind):
                    at.sources[name] = at.sources.get(name, set()) | at.base(source)
                yield f"{place.text} = {at.cast(value, place.kind, target).text};"
            case ast.Tuple(elts=targets):
                if not isinstance(value.kind, Parts) or len(value.kind.kinds) != len(targets):
                    raise at.error(target, f"{ast.unparse(target)} from {value.kind.c}")
                for i, one in enumerate(targets):
                    if not _is_unused(one):
                        part = Value(f"{value.within(CALL)}.{value.kind.field(i)}", value.kind.kinds[i], CALL)
                        yield from self._store(one, part, source)
            case ast.Subscript() | ast.Attribute():
                if at.has_law(target):
                    raise at.error(target, f"a law called in the place of {ast.unparse(target)}")
                at.write(target.value)
                place = at.value(target)
                if isinstance(place.kind, Array):
                    yield from self._fill(target, place, value)
                else:
                    yield f"{place.text} = {at.cast(value, place.kind, target).text};"
            case _:
                raise at.error(target, f"assignment to {ast.unparse(target)}")

    def _fill(self, target: ast.expr, place: Value, value: Value) -> Iterator[str]:
        """Every number of a part of an array: from one number, or from an array of as many."""
        kind = place.kind
        assert isinstance(kind, Array)
        if kind.dimensions == 2:
            whole = place.within(CALL)
            place = Value(f"(Vector){{{whole}.p, {whole}.n * {whole}.m}}", Array(kind.of, 1), CALL)
            if isinstance(value.kind, Array) or kind.of != FLOAT:
                raise self._at.error(target, f"assignment to {ast.unparse(target)}")
        if isinstance(value.kind, Array):
            word = {"d": "copy_into", "q": "copy_whole_into"}[kind.of.letter]
            yield f"{word}({place.text}, {value.text});"
        else:
            word = {"d": "fill", "q": "fill_whole"}[kind.of.letter]
            yield f"{word}({place.text}, {value.text});"

    def _place(self, target: ast.expr, kind: Kind) -> Value:
        """Where a value goes; a name takes on its kind."""
        at = self._at
        if isinstance(target, ast.Name):
            if kind == NOTHING:
                raise at.error(target, f"{target.id} is given nothing")
            try:
                at.locals[target.id] = at.struct(joined(at.locals.get(target.id), kind))
            except UntranslatableError as error:
                raise at.error(target, f"{target.id}: {error}") from error
            return Value(local(target.id), at.locals[target.id])
        if isinstance(target, ast.Subscript | ast.Attribute):
            at.write(target.value)
        return at.value(target)


def holds_arrays(kind: Kind) -> bool:
    """Whether a value shares memory: an array, a memory with names, or a tuple with one in it."""
    return isinstance(kind, Array | Memory) or (
        isinstance(kind, Parts) and any(map(holds_arrays, kind.kinds))
    )


def _stores(node: ast.AST, name: str) -> bool:
    return isinstance(node, ast.Name) and node.id == name and isinstance(node.ctx, ast.Store)


def _is_unused(target: ast.expr) -> bool:
    return isinstance(target, ast.Name) and target.id == "_"


def _changed(target: ast.expr) -> Iterator[str]:
    """The name that an assignment to a target changes: the name itself, or that of the array."""
    if isinstance(target, ast.Tuple):
        for one in target.elts:
            yield from _changed(one)
        return
    for node in ast.walk(target):
        if isinstance(node, ast.Name):
            yield node.id
            return


def _names(node: ast.expr) -> Iterator[str]:
    return (one.id for one in ast.walk(node) if isinstance(one, ast.Name))


def _indent(lines: Iterable[str]) -> list[str]:
    return [f"  {line}" for line in lines]
