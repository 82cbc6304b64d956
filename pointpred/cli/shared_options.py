"""Options that several commands have: coefficients of one's own, and where a command works."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from pointpred.console import remarks
from pointpred.errors import ParameterError

PARAMETER = "coefficients"


def complete_predictors(incomplete: str) -> list[str]:
    """What the shell offers for names of predictors, of which ``a,b`` may hold several."""
    from pointpred.registry import REGISTRY, others

    begun, comma, last = incomplete.rpartition(",")
    return [f"{begun}{comma}{name}" for name in (*REGISTRY, *others()) if name.startswith(last)]


def tell_others() -> None:
    """Make the predictors of other packages known, and say which cannot be used."""
    from pointpred.registry import find_others

    for words in find_others():
        remarks().print(f"left out: {words}", style="red")


PredictorName = Annotated[
    str, typer.Option(help="A name from 'pointpred predictors'.", autocompletion=complete_predictors)
]

Coefficients = Annotated[
    Path | None,
    typer.Option(metavar="FILE", help="Coefficients for 'kinematic' names, made by 'pointpred train'."),
]

PANEL = "For long recordings"

Threads = Annotated[
    int | None,
    typer.Option(min=1, max=1024, help="Number of threads. Not given: one for each processor."),
]
ClusterAddress = Annotated[
    str | None,
    typer.Option(
        metavar="ADDRESS",
        help="A Dask cluster instead of threads: its scheduler's address, or local for processes on this "
        "machine.",
        rich_help_panel=PANEL,
    ),
]


def named_file(text: str | None) -> tuple[str, Path] | None:
    """NAME=FILE as a service is given it, of which the file is here; raises ParameterError."""
    if text is None:
        return None
    name, _, file = text.partition("=")
    if not name or not file:
        raise ParameterError(
            f"--coefficients must be NAME=FILE, as 'pointpred serve' has it, received {text!r}"
        )
    return name, Path(file)


def with_coefficients(names: list[str], file: Path | None) -> dict[str, dict[str, Any]]:
    """What ``build`` is given for each of the names that take coefficients.

    Raises ParameterError for a file that cannot be used, and where none of the names takes one.
    """
    if file is None:
        return {}
    from pointpred.registry import REGISTRY, build, settings_in, takes

    taking = [known for known, _ in map(settings_in, names) if takes(known, PARAMETER)]
    if not taking:
        takers = ", ".join(name for name in REGISTRY if takes(name, PARAMETER))
        raise ParameterError(f"--coefficients needs one of {takers}, received {', '.join(names)}")
    for name in taking:
        build(name, coefficients=file)
    return {name: {PARAMETER: file} for name in taking}
