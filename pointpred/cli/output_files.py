"""Files that a command writes: JSON results, and whether a file can be written before work begins."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryFile
from typing import Annotated

import msgspec
import typer

from pointpred.errors import ParameterError, RecordingError
from pointpred.files import write_whole

Out = Annotated[Path, typer.Option(metavar="FILE", help="Samples file to write: .parquet or .csv.")]
Force = Annotated[bool, typer.Option("--force", help="Replace files that exist.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON with everything known.")]
Seed = Annotated[int, typer.Option(min=0, help="Seed; the same seed gives the same result.")]
Numbers = Annotated[
    Path | None,
    typer.Option(metavar="FILE", help="Write all numbers as JSON to this file; - for stdout."),
]
"""Where the numbers that are printed go as JSON."""
Report = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE|FOLDER",
        help="Write a report as one HTML file; to a folder (a name without .html), with every figure as SVG "
        "and PDF and every table as CSV and LaTeX.",
    ),
]
PLANTS_AND_DESIGNS = "pointpred observers"
"""The "format" of the files of pointpred-observers, which no result replaces."""


def write_json(value: object, target: Path) -> None:
    """Write JSON to a file, or to stdout for ``-``; UTF-8, whatever the terminal speaks."""
    encoded = msgspec.json.format(msgspec.json.encode(value), indent=2) + b"\n"
    if str(target) == "-":
        sys.stdout.flush()
        sys.stdout.buffer.write(encoded)
        sys.stdout.buffer.flush()
    else:
        write_whole(target, encoded)


def print_json(name: str, value: object) -> None:
    """Print a document of version 1 that holds one thing."""
    write_json({"version": 1, name: msgspec.to_builtins(value)}, Path("-"))


def check_target(target: Path | None) -> None:
    """Raise ParameterError now where a file could not be written later."""
    if target is None or str(target) == "-":
        return
    if target.is_dir() or not target.parent.is_dir():
        raise ParameterError(
            f"cannot write {target}: its folder must exist and it must not be a folder itself"
        )
    try:
        if not target.exists():
            with TemporaryFile(dir=target.parent):
                pass
        elif not os.access(target, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    except OSError as error:
        raise ParameterError(f"cannot write {target}: {error.strerror}; name another file") from error


def check_targets(targets: dict[str, Path | None], inputs: Sequence[Path], force: bool) -> None:
    """Raise ParameterError where a result could not be written, or would replace what must stay.

    That is: what the command reads (``inputs``, the trials beside samples, links to either), a recording,
    with ``--json`` a plant or a design, or another result, whatever ``force`` says; without it, any file.
    ``targets`` by the option that names them.
    """
    from pointpred.recordings.own import trials_beside

    outputs: dict[Path, str] = {}
    beside = [trials_beside(path) for path in inputs if path.is_file()]
    read = [path for path in (*inputs, *beside) if path is not None]
    for option, target in targets.items():
        check_target(target)
        if target is None or str(target) == "-":
            continue
        if target.resolve() in outputs:
            raise ParameterError(f"{option} and {outputs[target.resolve()]} both name {target}")
        outputs[target.resolve()] = option
        if any(target.exists() and path.exists() and target.samefile(path) for path in read):
            raise ParameterError(
                f"{option} {target} would replace a file that this command reads; name another file"
            )
        if target.is_file() and _is_recording(target):
            raise ParameterError(f"{option} {target} would replace a recording; name another file")
        if option == "--json" and target.is_file() and _is_plant_or_design(target):
            raise ParameterError(f"{option} {target} would replace a plant or a design; name another file")
        check_free(target, force, option)


def check_free(target: Path, force: bool, option: str = "--out") -> None:
    """Raise ParameterError where a file exists and --force was not given.

    ``option``: the one that names another file. Whether it can be written, ``check_targets`` says.
    """
    if target.is_file() and not force:
        raise ParameterError(f"{target} exists: choose another {option}, or --force to replace it")


def _is_recording(path: Path) -> bool:
    """Whether a file is a recording by its content; JSON of no format of its own is rather a result."""
    from pointpred.recordings import format_of

    try:
        form = format_of(path)
        if form is not None and form.key == "delimited":
            return not _is_table_of_trials(path)
        return form is not None and not form.tabular
    except RecordingError:  # empty or not to be read: no recording is lost
        return False


def _is_table_of_trials(path: Path) -> bool:
    """Whether a table is one of ``measures`` or ``score --trials``, by its heading: it holds no samples."""
    with path.open("rb") as file:
        heading = file.readline()
    return b"movement_time_s" in heading or b"time_averaged_px" in heading


class _Formatted(msgspec.Struct):
    format: str


def _is_plant_or_design(path: Path) -> bool:
    try:
        formatted = msgspec.json.decode(path.read_bytes(), type=_Formatted)
    except (msgspec.DecodeError, OSError):
        return False
    return formatted.format == PLANTS_AND_DESIGNS


def check_recording(out: Path, force: bool) -> None:
    """Raise ParameterError before any work where the result could not be written, or not without --force."""
    check_target(out)
    from pointpred.recordings.own import EXTENSIONS
    from pointpred.recordings.writing import check_free

    if out.suffix not in EXTENSIONS:
        raise ParameterError(
            f"--out {out}: cannot write {out.suffix or 'no extension'}, expected .parquet or .csv"
        )
    if not force:
        check_free(out)
