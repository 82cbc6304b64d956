"""The ``pointpred`` command: its groups, and how every expected failure becomes one line and an exit code."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Callable
from functools import partial
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Annotated, Any, NoReturn

import typer
from typer.core import TyperCommand
from typer.main import get_command, get_group

import pointpred
from pointpred.cli import INTERRUPTED
from pointpred.cli.help_text import Group, add_help, bad_value
from pointpred.console import plain
from pointpred.errors import ParameterError, PointpredError
from pointpred.extras import missing_distribution

DONE, NOTHING, WRONG_USE = 0, 1, 2
FIRST = """\
Predict where a pointing movement will end while it is still going on. Start with one of these:

  pointpred score          the predictors compared on an embedded sample; nothing to download
  pointpred score FILE     the same on a recording of yours, in nearly any format
  pointpred live           predictions of your mouse while you move it, in this terminal
  pointpred serve          the same on a page in your browser
  pointpred doctor         what works on this machine, and what to do about the rest

pointpred --help lists every command, and pointpred COMMAND --help shows examples of one.
"""
"""What ``pointpred`` alone prints."""
GROUP = "pointpred.commands"
"""The entry points of commands: of the distributions installed beside this one."""
COMMANDS = {
    "score": "Score predictors on recordings, compared with making no prediction.",
    "measures": "Measure recorded movements: times, speeds, paths, sub-movements, accuracy, errors and "
    "throughput.",
    "train": "Fit the coefficients of 'kinematic' to your own recordings, and score them beside the shipped "
    "ones.",
    "simulate": "Write a recording of simulated people pointing at targets on a circle.",
    "convert": "Convert recordings to pointpred's own format, and list what was skipped and why.",
    "predictors": "List the predictors, or show one with its parameters, units, bounds and defaults.",
    "replay": "Play a recording to a service, or as the mouse of a page in a browser.",
    "reproduce": "Make a figure or table of the thesis or of the camera paper again, with its numbers beside "
    "the print.",
    "live": "Predict where the mouse attached to this machine is heading, while it moves.",
    "doctor": "Check the installation: what works, what is missing, and what to do about it.",
    "datasets": "Public recordings: which exist, and how to get them.",
    "devices": "The mice of this machine: which can be read, how to get permission, and what they send.",
    "recordings": "Sessions that 'pointpred serve --record FOLDER' has kept.",
}
"""Each command of this distribution, or group of them, by the first line of its help.

Its function, or its ``app``, is in the module of its name, which is imported when the command is asked for.
"""
ELSEWHERE = {
    "camera": (
        "pointpred-observers",
        "Depth and velocity of a camera from one tracked point and an inertial sensor.",
    ),
    "demo": (
        "pointpred-server",
        "Write the live page as files that any static host can serve, under any path.",
    ),
    "observers": ("pointpred-observers", "Observers with proofs: design, audit and simulate from files."),
    "serve": (
        "pointpred-server",
        "Serve the live page and the WebSocket; prints the address once the page can be opened.",
    ),
}
"""Commands of distributions that may not be installed: where they are, and the first line of their help."""
GROUPED = ("datasets", "devices", "recordings")
SUMMARIES = {**COMMANDS, **{name: about for name, (_, about) in ELSEWHERE.items()}}


class LazyCommand(TyperCommand):
    """A command by its line in the list; the rest is imported when it is asked for."""

    def __init__(self, name: str, load: Callable[[], Any], about: str, *, hidden: bool = False) -> None:
        super().__init__(name, help=about, hidden=hidden)
        self._load = load

    def make_context(self, info_name: str | None, args: list[str], parent: Any = None, **extra: Any) -> Any:
        """The context of the command itself."""
        return self.loaded().make_context(info_name, args, parent, **extra)

    def loaded(self) -> Any:
        """The command, or the group of commands."""
        found = self._load()
        if isinstance(found, typer.Typer):
            found.info.help = SUMMARIES.get(self.name or "", found.info.help)
            add_help(found)
            return get_group(found)
        single = typer.Typer(add_completion=False)
        single.command(self.name)(found)
        add_help(single)
        return get_command(single)


class Commands(Group):
    """All commands, those of other distributions among them."""

    def __init__(self, **attributes: Any) -> None:
        super().__init__(**attributes)
        for name, about in COMMANDS.items():
            place = f"pointpred.cli.{name}:{'app' if name in GROUPED else name}"
            self.add_command(LazyCommand(name, EntryPoint(name, place, GROUP).load, about))
        installed = entry_points(group=GROUP)
        for entry in sorted(installed):
            about = SUMMARIES.get(entry.name, f"A command of {entry.module.partition('.')[0]}.")
            self.add_command(LazyCommand(entry.name, entry.load, about))
        for name, (distribution, about) in ELSEWHERE.items():
            if name not in installed.names:
                self.add_command(LazyCommand(name, partial(_absent, name, distribution), about, hidden=True))


def _absent(name: str, distribution: str) -> NoReturn:
    """In the place of a command whose distribution is not installed: how to install it."""
    raise missing_distribution(distribution, f"'pointpred {name}'")


app = typer.Typer(
    name="pointpred",
    cls=Commands,
    help="Predict where a pointing movement will end while it is still going on.",
    epilog="Start with:  pointpred score     (the embedded sample, nothing to download)",
    invoke_without_command=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"pointpred {pointpred.__version__}")
        raise typer.Exit(DONE)


@app.callback()
def _options(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    if context.invoked_subcommand is None:
        typer.echo(FIRST, nl=False)
        raise typer.Exit(WRONG_USE)


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run the command line and leave with its exit code: 0 done, 1 nothing to show for it, 2 wrong use."""
    _open_streams()
    try:
        code = app(args=arguments, prog_name="pointpred", standalone_mode=False)
        sys.stdout.flush()
    except (BrokenPipeError, SystemExit) as left:
        # typer turns a closed pipe into SystemExit(1)
        if not isinstance(left if isinstance(left, OSError) else left.__context__, BrokenPipeError):
            raise
        code = DONE
        # The reader of our output has closed it (``| head``); this is no error.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except typer.Abort:  # Ctrl-C, or the end of what was asked for
        print("pointpred: interrupted", file=sys.stderr)
        code = INTERRUPTED
    except (typer.TyperException, PointpredError, OSError) as error:
        if os.environ.get("POINTPRED_DEBUG") == "1":
            raise
        if sentence := _sentence(error):
            print(f"pointpred: {plain(sentence)}", file=sys.stderr)
        code = WRONG_USE if isinstance(error, typer.TyperException | ParameterError) else NOTHING
    sys.exit(code or DONE)


def _open_streams() -> None:
    """Closed streams (``>&-``) lead nowhere; what a stream cannot write is escaped."""
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open(mode, encoding="utf-8"))  # noqa: SIM115
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def _sentence(error: Exception) -> str:
    """What was wrong, where, and what to do next."""
    if isinstance(error, typer.TyperException):
        context = getattr(error, "ctx", None)
        command = context.command_path if context is not None else "pointpred"
        if not error.format_message():  # the help stands there already
            return ""
        words = _words(error).rstrip(".")
        return f"{words}{'' if words.endswith('?') else '.'} See '{command} --help'."
    if isinstance(error, OSError) and error.strerror:
        return f"{error.strerror}: {error.filename}" if error.filename else error.strerror
    return str(error)


def _words(error: typer.TyperException) -> str:
    """An error of the command line; of an option's value, in our words."""
    options = getattr(getattr(error, "param", None), "opts", None)
    if type(error) is typer.BadParameter and options:
        return bad_value(error, options[0], error.message)
    return error.format_message()
