"""Help from docstrings: paragraphs that flow into the terminal's width."""

from __future__ import annotations

import inspect

import typer


def flowing(words: str) -> str:
    r"""Paragraphs as one line each, for whoever shows them to wrap; none is indented.

    >>> flowing("One line\nand another.\n\nTry:\n\n  pointpred score")
    'One line and another.\n\nTry:\n\npointpred score'
    """
    return "\n\n".join(" ".join(paragraph.split()) for paragraph in words.strip().split("\n\n"))


def teach(app: typer.Typer) -> None:
    """Give every command of ``app``, and of its groups, the help that its docstring tells."""
    for command in app.registered_commands:
        if command.callback is not None and command.help is None:
            command.help = flowing(inspect.getdoc(command.callback) or "")
    for group in app.registered_groups:
        if group.typer_instance is not None:
            teach(group.typer_instance)
