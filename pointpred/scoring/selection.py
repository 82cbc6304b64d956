"""Which trials count, and by what they are told apart: what is known of a trial, by name, and rules of that.

A rule is an expression such as ``phase != practice and width >= 20``, in the part of Python's grammar that
compares. It is parsed and never run as Python.
"""

from __future__ import annotations

import ast
import difflib
import operator
import re
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.recording import Trial
from pointpred.records import BoolArray
from pointpred.scoring.results import PredictorErrors, ScoredTrial, SetScore

Value = str | float | bool
Known = dict[str, Value]
"""What is known of a trial, by name; what is not known is not there."""

OWN = ("user", "trial", "target_x", "target_y", "target_w", "clean")
"""Of a recorded trial, as in pointpred's table of trials."""
SCORED = (
    *("distance_px", "onset_s", "arrival_s", "events", "submovements"),
    *("end_repeats", "distance_repeats"),
)
"""What scoring finds of a trial."""
UNKNOWN = "unknown"
"""The level of a trial without the value."""
MOST_LEVELS = 50
LONGEST = 1000
"""Characters of a rule: the parser of Python needs memory for each level of brackets."""
QUOTED_NAME = re.compile(r"`([^`]*)`")


def condition_column(name: str) -> str:
    """What a condition is called beside our own names."""
    return f"{name}_condition" if name in (*OWN, *SCORED) else name


def known_of(one: ScoredTrial) -> Known:
    """Everything known of a trial: who and what it was, its conditions, what scoring found."""
    values: dict[str, Value] = {name: getattr(one.trial, name) for name in OWN}
    values |= {name: getattr(one, name) for name in SCORED} | {"clean": one.clean}
    values |= {condition_column(name): value for name, value in one.trial.condition.items()}
    return {name: value for name, value in values.items() if value == value}


def names_of(trials: Iterable[ScoredTrial]) -> list[str]:
    """The names that are known of any of these trials, our own first."""
    conditions = {condition_column(name) for one in trials for name in one.trial.condition}
    return [*OWN, *SCORED, *sorted(conditions)]


def check_names(wanted: Iterable[str], names: Sequence[str], option: str) -> None:
    """Raise ParameterError for a name that no trial of a set knows, saying which there are."""
    for name in wanted:
        if name not in names:
            near = difflib.get_close_matches(name, names, 1)
            hint = f"; did you mean {near[0]}?" if near else "."
            message = f"{option}: trials know no {name!r}{hint} They know {', '.join(names)}"
            raise ParameterError(message, field=option, value=name)


def label(value: Value | None) -> str:
    """A value as a level, and as the word that equals it in a rule.

    >>> label(20.0), label(True), label(None)
    ('20', 'true', 'unknown')
    """
    if value is None:
        return UNKNOWN
    if isinstance(value, bool):
        return str(value).lower()
    return value if isinstance(value, str) else f"{value:g}"


def levels_of(name: str, labels: Iterable[str]) -> list[str]:
    """The levels of a column in their order, numbers by size; raises ParameterError for too many."""
    levels = sorted(set(labels), key=_place)
    if len(levels) > MOST_LEVELS:
        message = f"by: {name} has {len(levels)} values, at most {MOST_LEVELS} can be shown apart"
        if name in (*OWN, *SCORED):
            message += f" (a condition that the recording calls so is {name}_condition)"
        raise ParameterError(f"{message}; 'where' picks some trials", field="by", value=name)
    return levels


def _place(level: str) -> tuple[bool, float, str]:
    try:
        return False, float(level), level
    except ValueError:
        return True, 0.0, level


Rule = Callable[[Known], bool]
Side = Callable[[Known], Value | None]
COMPARISONS: dict[type[ast.cmpop], Callable[[Any, Any], bool]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}


class Where(msgspec.Struct, frozen=True):
    """A rule that picks trials, as it was written; ``where_of`` checks its grammar.

    A name is a column where trials know one of that name; beside a column any other bare word is itself.
    Numbers equal the words that they are written as. What a trial does not know equals nothing and is neither
    smaller nor larger than anything.
    """

    text: str

    def mask(self, trials: Sequence[ScoredTrial], names: Sequence[str]) -> BoolArray:
        """Which trials count; ``names``: what is known in the whole set. Raises ParameterError."""
        rule = _Parser(self.text, names).rule
        return np.array([rule(known_of(one)) for one in trials], dtype=np.bool_)

    def picked(self, trials: Sequence[Trial]) -> BoolArray:
        """Which recorded trials count, by what the recording alone says of them. Raises ParameterError."""
        said = [
            {name: getattr(one, name) for name in OWN if getattr(one, name) not in (None, "")}
            | {f"{name}_condition" if name in OWN else name: value for name, value in one.condition.items()}
            for one in trials
        ]
        known = [{name: value for name, value in one.items() if value == value} for one in said]
        rule = _Parser(self.text, list(dict.fromkeys((*OWN, *(name for one in said for name in one))))).rule
        return np.array([rule(one) for one in known], dtype=np.bool_)

    def about(self, kept: int, every: int) -> str:
        """What it picked, in words."""
        if kept == every:
            return f"all {every} trials count, the rule leaves none out: where {self.text}"
        return f"{kept} of {every} trials count: where {self.text}"


def where_of(text: str) -> Where:
    """A rule, its grammar checked; raises ParameterError.

    >>> conditions = [{"phase": "practice"}, {"phase": "main", "width": 20.0}, {"phase": "main"}]
    >>> made = [Trial("ann", str(k), condition=one) for k, one in enumerate(conditions)]
    >>> trials = [ScoredTrial(one, 9.0, 0.0, 1.0, False, 2) for one in made]
    >>> where_of("phase != practice and width in (20, 40)").mask(trials, names_of(trials)).tolist()
    [False, True, False]
    """
    _Parser(text, None)
    return Where(text)


class _Parser:
    """A rule made of an expression; without ``names`` only the grammar is checked."""

    def __init__(self, text: str, names: Sequence[str] | None) -> None:
        self.text, self.names = text, names
        self.quoted: dict[str, str] = {}
        try:
            if len(text) > LONGEST:
                raise ValueError(f"at most {LONGEST} characters, received {len(text)}")
            tree = ast.parse(QUOTED_NAME.sub(self._placeholder, text.strip()), mode="eval")
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            what = error.msg if isinstance(error, SyntaxError) else str(error)
            raise self._error(f"cannot be read ({what})") from error
        self.rule = self._rule(tree.body)

    def _placeholder(self, found: re.Match[str]) -> str:
        """A name that Python's grammar takes, for one in backquotes."""
        name = f"_quoted_{len(self.quoted)}"
        self.quoted[name] = found[1]
        return name

    def _error(self, why: str) -> ParameterError:
        message = (
            f"where: {self.text[:LONGEST]!r} {why}. Expected comparisons joined by and, or, not, as in: "
            "phase != practice and width >= 20. With other characters: `my column` == 'no practice'"
        )
        return ParameterError(message, field="where", value=self.text)

    def _rule(self, node: ast.expr) -> Rule:
        if isinstance(node, ast.BoolOp):
            rules = [self._rule(one) for one in node.values]
            join = all if isinstance(node.op, ast.And) else any
            return lambda known: join(rule(known) for rule in rules)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            inner = self._rule(node.operand)
            return lambda known: not inner(known)
        if isinstance(node, ast.Compare):
            return self._compared(node)
        if isinstance(node, ast.Name):  # as in: clean and not submovements
            self._need_column([node])
            return lambda known: label(known.get(self._name(node))) in ("true", "1")
        raise self._error(f"has {ast.unparse(node)!r} where a comparison should stand")

    def _compared(self, node: ast.Compare) -> Rule:
        """A comparison, or a chain of them: 20 <= width < 40."""
        sides: list[list[ast.expr]] = []
        for place, one in enumerate((node.left, *node.comparators)):
            listed = place > 0 and isinstance(node.ops[place - 1], ast.In | ast.NotIn)
            if listed != isinstance(one, ast.Tuple | ast.List | ast.Set):
                raise self._error("needs a list, as (20, 40), after in and nowhere else")
            sides.append(list(one.elts) if isinstance(one, ast.Tuple | ast.List | ast.Set) else [one])
        self._need_column([one for side in sides for one in side])
        values = [[self._side(one) for one in side] for side in sides]
        rules = [
            self._comparison(left[0], kind, right)
            for left, kind, right in zip(values, node.ops, values[1:], strict=False)
        ]
        return lambda known: all(rule(known) for rule in rules)

    def _comparison(self, left: Side, kind: ast.cmpop, right: Sequence[Side]) -> Rule:
        if isinstance(kind, ast.Eq | ast.NotEq | ast.In | ast.NotIn):
            wanted = isinstance(kind, ast.Eq | ast.In)
            return lambda known: any(_equal(left(known), one(known)) for one in right) == wanted
        if type(kind) not in COMPARISONS:
            raise self._error("compares by 'is'")
        compare, other = COMPARISONS[type(kind)], right[0]
        return lambda known: self._ordered(left(known), other(known), compare)

    def _ordered(
        self, first: Value | None, second: Value | None, compare: Callable[[Any, Any], bool]
    ) -> bool:
        if first is None or second is None:
            return False
        numbers = _number(first), _number(second)
        if None in numbers:
            raise self._error(f"compares the size of the word {first if numbers[0] is None else second!r}")
        return compare(*numbers)

    def _name(self, node: ast.Name) -> str:
        return self.quoted.get(node.id, node.id)

    def _is_column(self, node: ast.expr) -> bool:
        return isinstance(node, ast.Name) and (self.names is None or self._name(node) in self.names)

    def _need_column(self, nodes: Sequence[ast.expr]) -> None:
        """Raise ParameterError where none of these is a column."""
        if any(self._is_column(one) for one in nodes):
            return
        check_names(
            [self._name(one) for one in nodes if isinstance(one, ast.Name)], self.names or (), "where"
        )
        raise self._error("compares without a column")

    def _side(self, node: ast.expr) -> Side:
        """A column, a number, or a word, bare or in quotes."""
        if isinstance(node, ast.Name):
            name = self._name(node)
            return (lambda known: known.get(name)) if self._is_column(node) else (lambda known: name)
        sign = 1
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            sign, node = -1, node.operand
        if isinstance(node, ast.Constant) and isinstance(node.value, str | int | float):
            constant = node.value
            if sign == 1:
                return lambda known: constant
            if not isinstance(constant, str):
                return lambda known: -constant
        raise self._error(f"has {ast.unparse(node)!r} where a name, a number or a word should stand")


def _number(value: Value) -> float | None:
    try:
        return float(value)
    except ValueError:
        return None


def _equal(first: Value | None, second: Value | None) -> bool:
    """Whether two values are equal, as numbers where both are, else as they are written."""
    if first is None or second is None:
        return False
    if isinstance(first, float | int) and isinstance(second, float | int):
        return float(first) == float(second)
    return label(first) == label(second)


def check_selection(trials: Sequence[Trial], where: Where | None, by: Sequence[str]) -> None:
    """Raise ParameterError where a rule or a column does not fit the trials of a set, before it is scored."""
    unscored = [ScoredTrial(one, 0.0, 0.0, 0.0, False, 0) for one in trials]
    names = names_of(unscored)
    check_names(by, names, "by")
    if where is not None:
        mask = where.mask(unscored, names)
        unscored = [one for one, kept in zip(unscored, mask.tolist(), strict=True) if kept]
    for name in by:
        levels_of(name, (label(known_of(one).get(name)) for one in unscored))


def counted(score: SetScore, mask: BoolArray | None) -> SetScore:
    """The set with some of its trials; ``None``: with all."""
    if mask is None:
        return score
    trials = tuple(one for one, kept in zip(score.trials, mask.tolist(), strict=True) if kept)
    predictors = tuple(_rows(one, mask) for one in score.predictors)
    return msgspec.structs.replace(score, trials=trials, predictors=predictors)


def _rows(errors: PredictorErrors, mask: BoolArray) -> PredictorErrors:
    values = ((name, getattr(errors, name)) for name in errors.__struct_fields__)
    arrays = {name: value[mask] for name, value in values if isinstance(value, np.ndarray)}
    return msgspec.structs.replace(errors, **arrays)
