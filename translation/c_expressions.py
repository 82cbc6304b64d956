"""The expressions of a law in C.

A tuple, and a row, becomes a struct; an array a struct of its place and size. What C means differently is a
call of a function of ``laws.h``: the remainder, ``max``, ``min``, whole powers.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable
from typing import Any

from pointpred.layout import Layout
from translation.c_names import Law, Made, c_name
from translation.c_values import (
    AND,
    BITS,
    CALL,
    CHOICE,
    EQUAL,
    OR,
    ORDER,
    PRODUCT,
    SUM,
    UNARY,
    Value,
    function_of_c,
    literal,
)
from translation.kinds import (
    FLAG,
    FLOAT,
    NOTHING,
    WHOLE,
    Array,
    Kind,
    Memories,
    Memory,
    Number,
    Parts,
    annotated,
    joined,
    kind_of_value,
    layout_at,
    layout_of,
    local,
)
from translation.source import Module, Name, UntranslatableError, is_law, member, module, origin, row_of

BINARY = {ast.Add: ("+", 12), ast.Sub: ("-", 12), ast.Mult: ("*", 13)}
COMPARE = {ast.Eq: "==", ast.NotEq: "!=", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">="}
CLEAR = Name("pointpred.layout", "clear")
LONGEST_LOCAL = 4096
"""Floats of an array of a fixed size that stands on the stack."""


class Expressions:
    """The expressions of one law.

    ``uses``: the laws and constants that they need; ``structs``, ``layouts``: kinds of tuples and memories;
    ``casts``: from which to which tuples are turned; ``written``: the arguments whose arrays are changed;
    ``columns``: how many an argument has at least; ``before``: lines that go before the present statement.
    """

    def __init__(self, reader: Module, function: ast.FunctionDef, bound: dict[str, Law], known: Any) -> None:
        self.reader, self.function, self.bound, self.known = reader, function, bound, known
        self.uses: set[Law] = set()
        self.structs: dict[str, Parts] = {}
        self.casts: set[tuple[Parts, Parts]] = set()
        self.locals: dict[str, Kind] = {}
        self.names = {one.id for one in ast.walk(function) if isinstance(one, ast.Name)}
        self.names |= {one.arg for one in ast.walk(function) if isinstance(one, ast.arg)}
        self.layouts: set[type[Layout]] = set()
        self.stars: dict[str, list[str]] = {}
        self.before: list[str] = []
        self.buffers: list[str] = []
        self.written: set[str] = set()
        self.sources: dict[str, set[str]] = {}
        self.columns: dict[str, int] = {}
        self.row_of: dict[str, str] = {}
        self.conditional = self.loops = 0
        self._guarded = False
        self._temporary = 0

    def error(self, node: ast.AST, what: str) -> UntranslatableError:
        """The error for a construct, with its file, line and law."""
        line = getattr(node, "lineno", self.function.lineno)
        return UntranslatableError(f"{self.reader.path}:{line}: {self.function.name}: {what}")

    def fresh(self, word: str) -> str:
        """A name that the law does not have."""
        self._temporary += 1
        name = f"{word}_{self._temporary}"
        return self.fresh(word) if name in self.names else name

    def struct(self, kind: Kind) -> Kind:
        """The same kind, whose struct is then declared."""
        if isinstance(kind, Memory | Memories):
            self.layouts.add(kind.of)
        if isinstance(kind, Parts):
            for one in kind.kinds:
                self.struct(one)
            self.structs.setdefault(kind.c, kind)
        return kind

    def cast(self, value: Value, to: Kind, node: ast.AST) -> Value:
        """A value as another kind takes it."""
        if value.kind.c == to.c:
            return value
        if isinstance(value.kind, Parts) and isinstance(to, Parts) and len(value.kind.kinds) == len(to.kinds):
            self.struct(value.kind), self.struct(to)
            self.casts.add((value.kind, to))
            for one, other in zip(value.kind.kinds, to.kinds, strict=True):
                self.cast(Value("", one), other, node)
            return Value(f"{to.c}_of_{value.kind.c}({value.text})", to, CALL)
        if isinstance(to, Memory) and value.kind == Array(FLOAT, 1):
            self.struct(to)
            return Value(f"({to.c}){value.within(CALL)}.p", to, UNARY)
        if to == FLOAT and value.kind in (WHOLE, FLAG):
            return Value(value.text, FLOAT, value.binds)
        if to == WHOLE and value.kind == FLAG:
            return Value(value.text, WHOLE, value.binds)
        raise self.error(node, f"{value.kind.c} where {to.c} is expected: {ast.unparse(node)}")

    def condition(self, node: ast.expr) -> Value:
        """An expression as a condition."""
        value = self.value(node)
        if value.kind == FLOAT:
            raise self.error(node, f"the float {ast.unparse(node)} as a condition")
        return value

    def value(self, node: ast.expr) -> Value:
        """An expression; raises UntranslatableError."""
        match node:
            case ast.Constant(value=bool() | int() | float() as constant):
                return literal(constant)
            case ast.Name(id=name) if name in self.locals:
                return Value(local(name), self.locals[name])
            case ast.Name(id=name):
                return self._named(node, origin(self.reader, name))
            case ast.Attribute(attr="length") if (size := self.constant(node)) is not None:
                return literal(size)
            case ast.Attribute(value=ast.Name(id=owner), attr=name) if self._is_module(owner):
                return self._named(node, member(self.reader, owner, name))
            case ast.Attribute(value=whole, attr=name):
                value = self.value(whole)
                if isinstance(value.kind, Memory):
                    return self._inside(node, value, value.kind.of, name)
                if not isinstance(value.kind, Parts) or name not in value.kind.names:
                    raise self.error(node, f".{name} of {ast.unparse(whole)}, which is {value.kind.c}")
                place = value.kind.names.index(name)
                part, kind = value.kind.field(place), value.kind.kinds[place]
                return Value(f"{value.within(CALL)}.{part}", kind, CALL)
            case ast.Tuple(elts=parts):
                values = self._arguments(parts)
                return self._made(Parts(tuple(one.kind for one in values)), values)
            case ast.UnaryOp(op=ast.Not(), operand=operand):
                return Value(f"!{self.condition(operand).within(UNARY)}", FLAG, UNARY)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                value = self.value(operand)
                return Value(
                    f"-{value.within(UNARY + 1)}", WHOLE if value.kind == FLAG else value.kind, UNARY
                )
            case ast.UnaryOp(op=ast.Invert(), operand=operand):
                return Value(f"~{self.value(operand).within(UNARY)}", WHOLE, UNARY)
            case ast.BinOp():
                return self._binary(node)
            case ast.BoolOp(op=op, values=operands):
                binds, sign = (AND, " && ") if isinstance(op, ast.And) else (OR, " || ")
                return Value(sign.join(self._each(operands, binds + (binds == OR) * 2)), FLAG, binds)
            case ast.Compare():
                return self._compare(node)
            case ast.IfExp(test=test, body=body, orelse=orelse):
                return self._choice(node, test, body, orelse)
            case ast.Subscript():
                return self._subscript(node)
            case ast.Call():
                return self._call(node)
        raise self.error(node, type(node).__name__)

    def _in_order(self, nodes: list[ast.expr]) -> list[Value]:
        """Operands or arguments from left to right, as Python computes them; C does so in any order.

        Each is computed before the next one where a law among them writes what another one may read.
        """
        writing = [one for one in nodes if self._has(one, lambda called: bool(called.written))]
        if not writing or not any(one is not writing[0] and self._reads(one) for one in nodes):
            return [self.value(one) for one in nodes]
        if self._guarded:
            raise self.error(nodes[0], f"a law that writes within a condition: {ast.unparse(writing[0])}")
        values = []
        for node in nodes:
            value, name = self.value(node), self.fresh("value")
            if isinstance(node, ast.Constant | ast.Name) and isinstance(value.kind, Number):
                values.append(value)  # nothing changes it
                continue
            self.before.append(f"{value.kind.c} {name} = {value.text};")
            values.append(Value(name, value.kind))
        return values

    def _has(self, node: ast.expr, fits: Callable[[Any], bool]) -> bool:
        """Whether a law is called in an expression that fits."""
        laws = [self._called(one.func) for one in ast.walk(node) if isinstance(one, ast.Call)]
        return any(fits(self.known(law)) for law in laws if isinstance(law, Made) or (law and is_law(law)))

    def has_law(self, node: ast.expr) -> bool:
        """Whether a law is called in an expression."""
        return self._has(node, lambda called: True)

    def _reads(self, node: ast.expr) -> bool:
        """Whether an expression reads numbers of a memory or an array, or calls a law that may."""
        parts = any(isinstance(one, ast.Subscript | ast.Attribute) for one in ast.walk(node))
        return parts or self.has_law(node)

    def _called(self, function: ast.expr) -> Law | None:
        """What a function of a call is; None where it is none that is imported, defined or bound."""
        match function:
            case ast.Name(id=word) if word in self.bound:
                return self.bound[word]
            case ast.Name(id=word) if word not in self.locals:
                return origin(self.reader, word)
            case ast.Attribute(value=ast.Name(id=owner), attr=word) if self._is_module(owner):
                return member(self.reader, owner, word)
        return None

    def _inside(self, node: ast.Attribute, value: Value, layout: type[Layout], name: str) -> Value:
        """A part of a memory."""
        self.struct(value.kind)
        if name == "memory":
            return Value(
                f"(Vector){{(double *){value.within(UNARY)}, {layout.length}}}", Array(FLOAT, 1), CALL
            )
        part = next((one for one in layout.parts if one.name == name), None)
        if part is None:
            raise self.error(node, f".{name} of {ast.unparse(node.value)}, which is {value.kind.c}")
        whole = value.text[1:] + "." if value.text.startswith("&") else value.within(CALL) + "->"
        text = f"{whole}{local(name)}"
        if part.of is not None:
            inner = self.struct(Memories(part.of, part.shape[0]) if part.shape else Memory(part.of))
            return Value(text, inner, CALL) if part.shape else Value(f"&{text}", inner, UNARY)
        if not part.shape:
            return Value(text, FLOAT, CALL)
        kind = Array(FLOAT, len(part.shape))
        first = f"{text}[0]" if len(part.shape) == 2 else text
        sizes = ", ".join(map(str, part.shape))
        return Value(f"({kind.c}){{{first}, {sizes}}}", kind, CALL, text)

    def _is_module(self, owner: str) -> bool:
        return owner in self.reader.imports and owner not in self.locals

    def _each(self, operands: list[ast.expr], binds: int) -> list[str]:
        """Truth values one after the other; only the first may need lines before the statement."""
        texts, outer = [], self._guarded
        for one in operands:
            value = self.condition(one)
            if value.kind != FLAG:
                raise self.error(one, f"the number {ast.unparse(one)} beside and, or")
            texts.append(value.within(binds + 1))
            self._guarded = True
        self._guarded = outer
        return texts

    def _choice(self, node: ast.expr, test: ast.expr, body: ast.expr, orelse: ast.expr) -> Value:
        condition = self.condition(test)
        outer, self._guarded = self._guarded, True
        one, other = self.value(body), self.value(orelse)
        self._guarded = outer
        try:
            kind = self.struct(joined(one.kind, other.kind))
        except UntranslatableError as error:
            raise self.error(node, str(error)) from error
        one, other = self.cast(one, kind, node), self.cast(other, kind, node)
        text = f"{condition.within(CHOICE + 1)} ? {one.within(CHOICE + 1)} : {other.within(CHOICE)}"
        return Value(text, kind, CHOICE)

    def _made(self, kind: Parts, values: list[Value]) -> Value:
        self.struct(kind)
        return Value(f"({kind.c}){{{', '.join(one.text for one in values)}}}", kind, CALL)

    def _named(self, node: ast.expr, name: Name) -> Value:
        """A constant."""
        if name.module in ("math", "numpy") and name.name in ("nan", "inf", "pi"):
            return literal(getattr(math, name.name))
        if name.module.startswith("pointpred") and not is_law(name):
            value = module(name.module).values[name.name]
            kind = kind_of_value(value)
            if kind is not None:
                row = row_of(Name(type(value).__module__, type(value).__name__))
                if row is not None:
                    kind = annotated(module(type(value).__module__), ast.Name(type(value).__name__))
                self.uses.add(name)
                self.struct(kind)
                if isinstance(kind, Array):
                    sizes = ", ".join(map(str, value.shape))
                    return Value(f"({kind.c}){{(double *){c_name(name)}, {sizes}}}", kind, CALL)
                return Value(c_name(name), kind)
        raise self.error(node, f"the name {ast.unparse(node)}")

    def _compare(self, node: ast.Compare) -> Value:
        operands = [node.left, *node.comparators]
        if any(self.has_law(one) for one in operands[1:-1]):
            raise self.error(node, f"a call in the middle of {ast.unparse(node)}")
        if wrong := [one for one in node.ops if type(one) not in COMPARE]:
            raise self.error(node, f"{type(wrong[0]).__name__} in {ast.unparse(node)}")
        texts = [one.within(ORDER + 1) for one in self._in_order(operands)]
        parts = [f"{texts[i]} {COMPARE[type(op)]} {texts[i + 1]}" for i, op in enumerate(node.ops)]
        return Value(" && ".join(parts), FLAG, AND if len(parts) > 1 else EQUAL)

    def _binary(self, node: ast.BinOp) -> Value:
        if isinstance(node.op, ast.Pow):
            return self._power(node)
        left, right = self._in_order([node.left, node.right])
        numbers = (FLAG, WHOLE, FLOAT)
        if left.kind not in numbers or right.kind not in numbers:
            raise self.error(node, f"{left.kind.c} and {right.kind.c} in {ast.unparse(node)}")
        whole = FLOAT not in (left.kind, right.kind)
        match node.op:
            case ast.Div():
                first = f"(double){left.within(UNARY)}" if whole else left.within(PRODUCT)
                return Value(f"{first} / {right.within(PRODUCT + 1)}", FLOAT, PRODUCT)
            case ast.FloorDiv() | ast.Mod():
                word = "floor_divided" if isinstance(node.op, ast.FloorDiv) else "remainder"
                suffix = "_whole" if whole else "_float"
                return Value(f"{word}{suffix}({left.text}, {right.text})", WHOLE if whole else FLOAT, CALL)
            case ast.BitAnd():
                return Value(f"{left.within(BITS)} & {right.within(BITS + 1)}", WHOLE, BITS)
        if type(node.op) not in BINARY:
            raise self.error(node, f"{type(node.op).__name__} in {ast.unparse(node)}")
        sign, binds = BINARY[type(node.op)]
        text = f"{left.within(binds)} {sign} {right.within(binds + 1)}"
        return Value(text, WHOLE if whole else FLOAT, binds)

    def _power(self, node: ast.BinOp) -> Value:
        """Products for whole exponents, a root for 0.5, else ``pow``."""
        base, exponent = self.value(node.left), node.right
        number = ast.literal_eval(exponent) if isinstance(exponent, ast.Constant) else None
        if number == 0.5:
            return Value(f"sqrt({base.text})", FLOAT, CALL)
        if number == 2 and base.kind == FLOAT:
            return Value(f"square({base.text})", FLOAT, CALL)
        power = self.value(exponent)
        if power.kind == WHOLE and base.kind == WHOLE and (number is None or number < 0):
            raise self.error(node, f"a power of a whole number: {ast.unparse(node)}")
        if power.kind == WHOLE:
            word, kind = ("whole_power", FLOAT) if base.kind == FLOAT else ("power_of_whole", WHOLE)
            return Value(f"{word}({base.text}, {power.text})", kind, CALL)
        return Value(f"pow({base.text}, {power.text})", FLOAT, CALL)

    def constant(self, node: ast.expr) -> int | None:
        """The value of a whole number that is known, else None."""
        match node:
            case ast.Constant(value=int() as value):
                return value
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                positive = self.constant(operand)
                return None if positive is None else -positive
            case ast.Attribute(value=whole, attr="length"):
                layout = layout_at(self.reader, whole)
                return None if layout is None else layout.length
            case ast.Name(id=name) if name not in self.locals:
                found = origin(self.reader, name)
            case ast.Attribute(value=ast.Name(id=owner), attr=name) if self._is_module(owner):
                found = member(self.reader, owner, name)
            case ast.BinOp(left=left, op=op, right=right):
                first, second = self.constant(left), self.constant(right)
                if first is None or second is None or type(op) not in BINARY:
                    return None
                return {"+": first + second, "-": first - second, "*": first * second}[BINARY[type(op)][0]]
            case ast.Call(func=ast.Name(id="len"), args=[one]):
                return self._length(self.value(one))
            case _:
                return None
        known = module(found.module).values.get(found.name) if found.module.startswith("pointpred") else None
        return known if isinstance(known, int) else None

    def _length(self, value: Value) -> int | None:
        """How many a tuple or a part of a memory holds."""
        if isinstance(value.kind, Memories):
            return value.kind.size
        if value.place:  # its text is a struct: the first number, then the sizes
            return int(value.text.rpartition("{")[2].rstrip("}").split(", ")[1])
        return len(value.kind.kinds) if isinstance(value.kind, Parts) else None

    def whole(self, node: ast.expr) -> Value:
        """An index."""
        value = self.value(node)
        if value.kind not in (WHOLE, FLAG):
            raise self.error(node, f"an index that is no whole number: {ast.unparse(node)}")
        return value

    def _subscript(self, node: ast.Subscript) -> Value:
        whole = node.value
        if isinstance(whole, ast.Attribute) and whole.attr == "shape":
            array = self.value(whole.value)
            return Value(f"{array.within(CALL)}.{'nm'[self.constant(node.slice) or 0]}", WHOLE, CALL)
        value = self.value(whole)
        if isinstance(value.kind, Memories):
            return Value(f"&{value.text}[{self.whole(node.slice).text}]", Memory(value.kind.of), UNARY)
        if isinstance(value.kind, Parts):
            return self._part(node, value, value.kind)
        if not isinstance(value.kind, Array):
            raise self.error(node, f"an index into {ast.unparse(whole)}, which is {value.kind.c}")
        indices = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        if any(isinstance(one, ast.UnaryOp) for one in indices):
            raise self.error(node, f"an index from the end in {ast.unparse(node)}")
        return self._element(node, value, value.kind, indices)

    def _part(self, node: ast.Subscript, value: Value, kind: Parts) -> Value:
        place = self.constant(node.slice)
        if place is not None:
            place %= len(kind.kinds)
            return Value(f"{value.within(CALL)}.{kind.field(place)}", kind.kinds[place], CALL)
        if len({one.c for one in kind.kinds}) != 1 or not isinstance(
            node.value, ast.Name | ast.Attribute | ast.Subscript
        ):
            raise self.error(node, f"an index that is not known into {ast.unparse(node.value)}")
        inside = kind.kinds[0]
        return Value(
            f"((const {inside.c} *)&{value.within(UNARY)})[{self.whole(node.slice).text}]", inside, CALL
        )

    def _element(self, node: ast.Subscript, value: Value, kind: Array, indices: list[ast.expr]) -> Value:
        """A number of an array, or a part of it, which shares its memory."""
        self._note_column(node, indices[-1], kind)
        array, flat = value.within(CALL), Array(kind.of, 1)
        last = indices[-1]
        if len(indices) > kind.dimensions:
            raise self.error(node, f"{len(indices)} indices into {value.kind.c}")
        if value.place and not any(isinstance(one, ast.Slice) for one in indices):
            text = value.place + "".join(f"[{self.whole(one).text}]" for one in indices)
            if len(indices) == kind.dimensions:
                return Value(text, kind.of, CALL)
            return Value(f"(Vector){{{text}, {value.text.rpartition(' ')[2]}", flat, CALL)
        if kind.dimensions == 1 or (len(indices) == 1 and isinstance(last, ast.Slice)):
            if not isinstance(last, ast.Slice):
                return Value(f"{array}.p[{self.whole(last).text}]", kind.of, CALL)
            start = self.whole(last.lower).within(SUM + 1) if last.lower else ""
            end = self.whole(last.upper).within(SUM) if last.upper else f"{array}.n"
            count = f"{end} - {start}" if start else end
            if kind.dimensions == 2:
                first = f"{array}.p + {start} * {array}.m" if start else f"{array}.p"
                return Value(f"(Table){{{first}, {count}, {array}.m}}", kind, CALL)
            return Value(f"({kind.c}){{{array}.p{f' + {start}' if start else ''}, {count}}}", kind, CALL)
        if isinstance(indices[0], ast.Slice):
            raise self.error(node, f"a column of a table: {ast.unparse(node)}")
        row = f"{array}.p + {self.whole(indices[0]).within(PRODUCT)} * {array}.m"
        if len(indices) == 1:
            return Value(f"({flat.c}){{{row}, {array}.m}}", flat, CALL)
        if isinstance(last, ast.Slice):
            start = self.whole(last.lower).within(SUM + 1) if last.lower else "0"
            end = self.whole(last.upper).within(SUM) if last.upper else f"{array}.m"
            return Value(f"({flat.c}){{{row} + {start}, {end} - {start}}}", flat, CALL)
        place = f"{self.whole(indices[0]).within(PRODUCT)} * {array}.m + {self.whole(last).within(SUM)}"
        return Value(f"{array}.p[{place}]", kind.of, CALL)

    def _note_column(self, node: ast.Subscript, last: ast.expr, kind: Array) -> None:
        """Note which column of an argument is read, where that is known."""
        match node:
            case ast.Subscript(value=ast.Name(id=table), slice=ast.Tuple()) if kind.dimensions == 2:
                pass
            case ast.Subscript(value=ast.Name(id=row)) if row in self.row_of:
                table = self.row_of[row]
            case _:
                return
        place = self.constant(last)
        if place is not None and not self.conditional and not self._guarded:
            self.columns[table] = max(self.columns.get(table, 0), place + 1)

    def _arguments(self, nodes: list[ast.expr]) -> list[Value]:
        """Values in turn; a star gives the parts of a tuple, or the shared arrays of a closure."""
        if not any(isinstance(one, ast.Starred) for one in nodes):
            return self._in_order(nodes)
        values = []
        for node in nodes:
            if not isinstance(node, ast.Starred):
                values.append(self.value(node))
            elif isinstance(node.value, ast.Name) and node.value.id in self.stars:
                values += [Value(local(one), self.locals[one]) for one in self.stars[node.value.id]]
            else:
                whole = self.value(node.value)
                if not isinstance(whole.kind, Parts) or not isinstance(node.value, ast.Name | ast.Attribute):
                    raise self.error(node, f"the parts of {ast.unparse(node.value)}")
                kind = whole.kind
                values += [
                    Value(f"{whole.within(CALL)}.{kind.field(i)}", one, CALL)
                    for i, one in enumerate(kind.kinds)
                ]
        return values

    def _call(self, node: ast.Call) -> Value:
        if node.keywords and not (
            isinstance(node.func, ast.Attribute) and node.func.attr in ("empty", "zeros")
        ):
            raise self.error(node, f"a named argument in {ast.unparse(node)}")
        name = self._called(node.func)
        match node.func:
            case ast.Attribute(value=array, attr="copy") if name is None and not node.args:
                return self._copy(node, self.value(array))
            case ast.Attribute(value=array, attr="reshape") if name is None:
                return self._table(node, self.value(array))
        if name is None:
            raise self.error(node, f"call of {ast.unparse(node.func)}")
        if isinstance(name, Made):
            return self._law(node, name)
        if (layout := layout_of(name)) is not None:
            return self._memory(node, layout)
        if name == CLEAR:
            return self._clear(node)
        if (row := row_of(name)) is not None:
            kind = annotated(module(name.module), ast.Name(name.name))
            assert isinstance(kind, Parts)
            self.struct(kind)
            if len(node.args) == 1 and isinstance(node.args[0], ast.Starred):
                return self.cast(self.value(node.args[0].value), kind, node)
            values = self._arguments(node.args)
            if len(values) != len(row):
                raise self.error(node, f"{len(values)} parts of {len(row)} in {ast.unparse(node)}")
            return self._made(kind, [self.cast(*pair, node) for pair in zip(values, kind.kinds, strict=True)])
        if name.module == "numpy" and name.name in ("empty", "zeros"):
            return self._array(node, name.name)
        if name == Name("", "len") and (known := self.constant(node)) is not None:
            return literal(known)
        if name.module in ("", "math"):
            found = function_of_c(name, self._arguments(node.args))
            if found is None:
                raise self.error(node, f"call of {ast.unparse(node.func)}")
            return found
        if not is_law(name):
            raise self.error(node, f"call of {ast.unparse(node.func)}")
        return self._law(node, name)

    def _memory(self, node: ast.Call, layout: type[Layout]) -> Value:
        """A memory with names, from a place of a flat one on."""
        kind = self.struct(Memory(layout))
        array, *at = [self.value(one) for one in node.args]
        if array.kind != Array(FLOAT, 1):
            raise self.error(node, f"{layout.__name__} of {array.kind.c}")
        start = f" + {at[0].within(SUM)}" if at else ""
        return Value(f"({kind.c})({array.within(CALL)}.p{start})", kind, UNARY)

    def _clear(self, node: ast.Call) -> Value:
        value = self.value(node.args[0])
        if not isinstance(value.kind, Memory):
            raise self.error(node, f"clear of {value.kind.c}")
        self.write(node.args[0])
        return Value(f"memset({value.text}, 0, sizeof({value.kind.struct}))", NOTHING, CALL)

    def _law(self, node: ast.Call, law: Law) -> Value:
        self.uses.add(law)
        called = self.known(law)
        values = self._arguments(node.args)
        if len(values) != len(called.kinds):
            raise self.error(node, f"{len(values)} arguments of {len(called.kinds)} in {ast.unparse(node)}")
        for argument, name in zip(node.args, called.arguments, strict=False):
            if name in called.written:
                self.write(argument)
            if isinstance(argument, ast.Name) and name in called.columns and not self.conditional:
                self.columns[argument.id] = max(self.columns.get(argument.id, 0), called.columns[name])
        texts = [self.cast(one, kind, node).text for one, kind in zip(values, called.kinds, strict=True)]
        return Value(f"{c_name(law)}({', '.join(texts)})", self.struct(called.returns), CALL)

    def write(self, node: ast.expr) -> None:
        """Note that what an expression stands for is changed."""
        for name in self.base(node):
            self.written.add(name)

    def base(self, node: ast.expr) -> set[str]:
        """The arguments whose memory an expression shares."""
        match node:
            case ast.Name(id=name):
                return self.sources.get(name, {name})
            case ast.Subscript(value=value) | ast.Attribute(value=value) | ast.Starred(value=value):
                return self.base(value)
            case ast.Tuple(elts=parts):
                return set().union(*map(self.base, parts))
            case ast.Call(func=ast.Attribute(attr="empty" | "zeros" | "copy")):
                return set()
            case ast.Call(func=ast.Attribute(value=value, attr="reshape")):
                return self.base(value)
            case ast.Call(args=parts):
                return set().union(*map(self.base, parts))
        return set()

    def _copy(self, node: ast.Call, value: Value) -> Value:
        if not isinstance(value.kind, Array) or value.kind.dimensions != 1:
            raise self.error(node, f"a copy of {value.kind.c}")
        self._check_once(node)
        name, of, array = self._buffer(node), value.kind.of.c, value.within(CALL)
        self.before.append(f"RELEASED {of} *{name} = copied({array}.p, sizeof({of}) * {array}.n);")
        return Value(f"({value.kind.c}){{{name}, {array}.n}}", value.kind, CALL)

    def _table(self, node: ast.Call, value: Value) -> Value:
        """The numbers of an array as rows."""
        if not isinstance(value.kind, Array) or value.kind.dimensions != 1 or len(node.args) != 2:
            raise self.error(node, f"{ast.unparse(node)} of {value.kind.c}")
        kind = Array(value.kind.of, 2)
        rows, columns = (self.whole(one).text for one in node.args)
        return Value(f"({kind.c}){{{value.within(CALL)}.p, {rows}, {columns}}}", kind, CALL)

    def _check_once(self, node: ast.AST) -> None:
        if self.loops:  # it ends with the block that it stands in
            raise self.error(node, "an array whose size is not known within a loop")

    def _buffer(self, node: ast.AST) -> str:
        if self._guarded:
            raise self.error(node, "a new array within a condition")
        return self.fresh("buffer")

    def _array(self, node: ast.Call, word: str) -> Value:
        """A new array: on the stack where its size is known."""
        shape = node.args[0].elts if isinstance(node.args[0], ast.Tuple) else [node.args[0]]
        of = WHOLE if node.keywords else FLOAT
        known = [self.constant(one) for one in shape]
        sizes = [self.whole(one) for one in shape]
        kind, name = Array(of, len(shape)), self._buffer(node)
        counts = [one for one in known if one is not None]
        if len(counts) == len(known) and math.prod(counts) <= LONGEST_LOCAL:
            self.buffers.append(f"{of.c} {name}[{math.prod(counts)}];")
            if word == "zeros":
                self.before.append(f"memset({name}, 0, sizeof {name});")
        else:
            self._check_once(node)
            size = " * ".join(one.within(PRODUCT + 1) for one in sizes)
            self.before.append(f"RELEASED {of.c} *{name} = reserved({size});")
        return Value(f"({kind.c}){{{name}, {', '.join(one.text for one in sizes)}}}", kind, CALL)
