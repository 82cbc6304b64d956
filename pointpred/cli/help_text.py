"""Help from docstrings: paragraphs that flow into the terminal's width, examples that can be copied."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any, get_args

import typer
from typer.core import TyperArgument, TyperCommand, TyperGroup, TyperOption

EXAMPLES = "\n\nTry:\n\n"
"""Where the examples of a docstring begin; they are its end."""
VALUES = {str: "TEXT", int: "INTEGER", float: "NUMBER"}
"""What stands for a value of each type."""


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


class _Group(TyperGroup):
    """A group of commands."""

    def get_params(self, ctx: Any) -> list[Any]:
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

    app.info.cls = _Group
    for command in app.registered_commands:
        command.cls = _Command
        if command.callback is not None and command.help is None:
            words, _, _ = (inspect.getdoc(command.callback) or "").partition(EXAMPLES)
            command.help = escape(flowing(words))
    for group in app.registered_groups:
        if group.typer_instance is not None:
            add_help(group.typer_instance)
