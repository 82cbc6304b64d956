"""Help from docstrings that flow into the terminal's width, and plain words for a wrong option."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from typing import Any, get_args

import typer
from typer.core import TyperArgument, TyperCommand, TyperGroup, TyperOption

EXAMPLES = "\n\nTry:\n\n"
"""Where the examples of a docstring begin; they are its end."""
VALUES = {str: "TEXT", int: "INTEGER", float: "NUMBER"}
"""What stands for a value of each type."""

BOUNDS = {
    "greater_than_equal": "must be at least {ge:g}",
    "less_than_equal": "must be at most {le:g}",
    "greater_than": "must be above {gt:g}",
    "less_than": "must be below {lt:g}",
    "int_parsing": "must be a whole number",
    "int_from_float": "must be a whole number",
    "float_parsing": "must be a number",
    "finite_number": "must be a finite number",
    "bool_parsing": "must be true or false",
    "literal_error": "must be {expected}",
    "string_too_short": "must have at least {min_length} characters",
}
"""By pydantic's type of an error: what was expected, with the details that come with it."""


def flowing(words: str) -> str:
    r"""Paragraphs as one line each, for whoever shows them to wrap; none is indented.

    >>> flowing("One line\nand another.\n\n  A second paragraph.")
    'One line and another.\n\nA second paragraph.'
    """
    return "\n\n".join(" ".join(paragraph.split()) for paragraph in words.strip().split("\n\n"))


def examples(command: Callable[..., Any] | None) -> list[str]:
    """The examples in the docstring of a command."""
    _, _, text = (inspect.getdoc(command) or "").partition(EXAMPLES)
    return [line.strip() for line in text.splitlines() if line.strip()]


class _Argument(TyperArgument):
    """An argument shown without its type, for which typer has no setting."""

    def display_type_rich(self, ctx: Any) -> None:
        """No type."""


class _Command(TyperCommand):
    """A command whose help ends with its examples, each on one line: a broken one could not be copied."""

    def get_params(self, ctx: Any) -> list[Any]:
        return _named(super().get_params(ctx))

    def format_help(self, ctx: Any, formatter: Any) -> None:
        super().format_help(ctx, formatter)
        if lines := examples(self.callback):
            formatter.write("\n".join(["", " Try:", "", *(f"   {line}" for line in lines), ""]))


class Group(TyperGroup):
    """A group of commands."""

    def get_params(self, ctx: Any) -> list[Any]:
        """Its options."""
        return _named(super().get_params(ctx))


def _named(parameters: list[Any]) -> list[Any]:
    """Parameters with plain words in the place of Python's types: none for a flag and for an argument."""
    for one in parameters:
        about = one.type_descriptor
        if isinstance(one, TyperArgument):
            one.__class__ = _Argument
        elif isinstance(one, TyperOption) and one.metavar is None and not about.is_choice:
            kind = get_args(about.annotation)[0] if about.is_list else about.annotation
            one.metavar = "" if one.is_flag else VALUES.get(kind)
    return parameters


def add_help(app: typer.Typer) -> None:
    """Set the help of every command of ``app``, and of its groups, from its docstring."""
    from rich.markup import escape

    app.info.cls = Group
    for command in app.registered_commands:
        command.cls = _Command
        if command.callback is not None and command.help is None:
            words, _, _ = (inspect.getdoc(command.callback) or "").partition(EXAMPLES)
            command.help = escape(flowing(words))
    for group in app.registered_groups:
        if group.typer_instance is not None:
            add_help(group.typer_instance)


def option_error(name: str, problem: Mapping[str, Any]) -> str:
    """A sentence on the option ``name``, from one entry of a ``ValidationError``'s ``errors()``.

    >>> option_error("--threads", {"type": "greater_than_equal", "ctx": {"ge": 1}, "input": "0"})
    "--threads must be at least 1, received '0'"
    """
    if problem["type"] == "value_error":  # our own words
        return f"{name}: {problem['ctx']['error']}"
    words = BOUNDS.get(problem["type"], "is refused: {msg}")
    received = "" if "token" in name else f", received {problem['input']!r}"
    return f"{name} {words.format(msg=problem.get('msg'), **problem.get('ctx', {}))}{received}"


def bad_value(error: BaseException, name: str, message: str) -> str:
    """The same for an error of the command line, whose cause may be a ``ValidationError``."""
    problems = getattr(error.__cause__, "errors", None)
    return option_error(name, problems()[0]) if problems is not None else f"{name}: {message}"
