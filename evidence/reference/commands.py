"""What docs/reference/commands.md shows: every command with its arguments and options, from the code."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import msgspec
import typer

from pointpred.cli.app import DONE, INTERRUPTED, NOTHING, WRONG_USE, app
from pointpred.cli.help_text import VALUES


class Setting(msgspec.Struct, frozen=True):
    """An argument or an option."""

    name: str
    default: str
    meaning: str


class Command(msgspec.Struct, frozen=True):
    """A command as it is typed."""

    name: str
    summary: str
    settings: tuple[Setting, ...]


def commands(group: Any, name: str) -> Iterator[Command]:
    """Every command below a group."""
    for key, one in group.commands.items():
        whole = f"{name} {key}"
        if hasattr(one, "commands"):
            yield from commands(one, whole)
        else:
            summary = (one.help or "").split("\n\n")[0].replace("\n", " ")
            yield Command(whole, summary, tuple(_settings(one)))


def _settings(command: Any) -> Iterator[Setting]:
    for one in command.params:
        if getattr(one, "hidden", False) or one.name == "help":
            continue
        if one.param_type_name == "argument":
            name = (one.metavar or one.name).upper()
        else:
            value = (
                ""
                if one.is_flag
                else f" {one.metavar or VALUES.get(one.type_descriptor.annotation, 'VALUE')}"
            )
            name = ", ".join([*one.opts, *one.secondary_opts]) + value
        shown = "" if one.default in (None, False, ()) or callable(one.default) else f"`{one.default}`"
        yield Setting(name, shown, " ".join((getattr(one, "help", "") or "").split()))


def context() -> dict[str, Any]:
    """What the template needs."""
    return {
        "commands": list(commands(typer.main.get_command(app), "pointpred")),
        "exits": {"done": DONE, "nothing": NOTHING, "wrong_use": WRONG_USE, "interrupted": INTERRUPTED},
    }
