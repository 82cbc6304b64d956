"""The ``pointpred`` command: its groups, and how every expected failure becomes one line and an exit code."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Callable
from importlib.metadata import entry_points
from pathlib import Path
from typing import Annotated, NoReturn

import typer

import pointpred
from pointpred.cli import INTERRUPTED
from pointpred.cli.convert import convert
from pointpred.cli.datasets import app as datasets
from pointpred.cli.devices import app as devices
from pointpred.cli.doctor import doctor
from pointpred.cli.help_text import add_help, bad_value
from pointpred.cli.live import live
from pointpred.cli.predictors import predictors
from pointpred.cli.recordings import app as recordings
from pointpred.cli.replay import replay
from pointpred.cli.reproduce import reproduce
from pointpred.cli.score import score
from pointpred.cli.simulate import simulate
from pointpred.cli.train import train
from pointpred.console import plain
from pointpred.errors import ParameterError, PointpredError
from pointpred.extras import missing_distribution
from pointpred.registry import find_others

DONE, NOTHING, WRONG_USE = 0, 1, 2
ELSEWHERE = {
    **dict.fromkeys(("demo", "serve"), "pointpred-server"),
    **dict.fromkeys(("camera", "observers"), "pointpred-observers"),
}
"""Commands of distributions that may not be installed."""
ANYTHING = {"ignore_unknown_options": True, "allow_extra_args": True}


def _absent(name: str, distribution: str) -> Callable[[], None]:
    """What stands for a command of a distribution that is not installed: it says how to install it."""

    def command() -> None:
        raise missing_distribution(distribution, f"'pointpred {name}'")

    return command


app = typer.Typer(
    name="pointpred",
    help="Predict where a pointing movement will end while it is still going on.",
    epilog="Start with:  pointpred score     (the embedded sample, nothing to download)",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
for command in (score, train, simulate, convert, predictors, replay, reproduce, live, doctor):
    app.command()(command)
app.add_typer(datasets, name="datasets")
app.add_typer(devices, name="devices")
app.add_typer(recordings, name="recordings")
installed = entry_points(group="pointpred.commands")  # of the distributions installed beside this one
for entry in sorted(installed):
    command = entry.load()
    if isinstance(command, typer.Typer):
        app.add_typer(command, name=entry.name)
    else:
        app.command(entry.name)(command)
for name, distribution in ELSEWHERE.items():
    if name not in installed.names:
        app.command(name, hidden=True, add_help_option=False, context_settings=ANYTHING)(
            _absent(name, distribution)
        )
add_help(app)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"pointpred {pointpred.__version__}")
        raise typer.Exit(DONE)


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    pass


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run the command line and leave with its exit code: 0 done, 1 nothing to show for it, 2 wrong use."""
    _open_streams()
    find_others()
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
        return f"{_words(error).rstrip('.')}. See '{command} --help'."
    if isinstance(error, OSError) and error.strerror:
        return f"{error.strerror}: {error.filename}" if error.filename else error.strerror
    return str(error)


def _words(error: typer.TyperException) -> str:
    """An error of the command line; of an option's value, in our words."""
    options = getattr(getattr(error, "param", None), "opts", None)
    if type(error) is typer.BadParameter and options:
        return bad_value(error, options[0], error.message)
    return error.format_message()
