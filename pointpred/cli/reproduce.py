"""``pointpred reproduce``: a figure or table of the thesis or of the camera paper, made again."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import msgspec
import typer

from pointpred.cli.output_files import Force, Numbers, check_targets, write_json
from pointpred.console import remark, remarks, results, table
from pointpred.errors import ParameterError
from pointpred.extras import require
from pointpred.files import write_whole

if TYPE_CHECKING:
    from pointpred.reproduction.figure import Entry, Reproduction, Value

AGREES = {True: "agrees", False: "differs", None: ""}


def reproduce(
    number: Annotated[
        str | None,
        typer.Argument(
            help="Number of the figure, as 2.12 or 3.4; camera-1, camera-2, camera-table-1. Not given: all "
            "are listed."
        ),
    ] = None,
    recordings: Annotated[
        Path | None,
        typer.Argument(
            help="A recording of people in place of simulated ones (2.2, 2.3, 2.8 to 2.10, 2.12, 2.13), or "
            "the folder that holds sniffer.csv (3.10, 3.11)."
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="SVG file to draw (thesis-2.12.svg, camera-1.svg)."),
    ] = None,
    json: Numbers = None,
    force: Force = False,
) -> None:
    """Make a figure or table of the thesis or of the camera paper again, with its numbers beside the print.

    Draws an SVG file, prints each number of ours beside the printed one, and says what differs and why.
    Figures need the extra 'report'; those of chapters 3 and 4 and of the camera paper come with
    pointpred-observers. Where one is missing, an error shows the command that installs it.

    Try:

      pointpred reproduce

      pointpred reproduce 2.11

      pointpred reproduce 2.12 study_samples.parquet --out error.svg
    """
    from pointpred.reproduction.catalogue import ENTRIES, entry_of, not_installed

    if number is None:
        _print_list(list(ENTRIES.values()))
        if missing := not_installed():
            remarks().print(missing, soft_wrap=True)
        return
    entry = entry_of(number)
    if entry.make is None:
        results().print(f"{_title(entry)}. {entry.differs}", soft_wrap=True)
        return
    target = _target(entry, out, recordings, json, force)
    require("report", entry.number)
    if entry.slow:
        remarks().print("scoring a whole experiment, which takes some seconds")
    made = entry.make(recordings)
    if made.draw is not None and target is not None:
        write_whole(target, made.draw().svg.encode())
    if json is not None:
        values = tuple(ValueDocument(v.name, v.printed, v.ours, v.unit, v.agrees) for v in made.values)
        about = entry.number, entry.source, entry.shows, made.data, entry.differs
        write_json(ReproductionDocument(1, *about, values), json)
    if json is None or str(json) != "-":
        _print(entry, made)
    if target is not None:
        remark(f"drawn: {target}")


def _target(entry: Entry, out: Path | None, data: Path | None, json: Path | None, force: bool) -> Path | None:
    """The file to draw, ``None`` for a table; raises ParameterError where something cannot be used."""
    if data is not None and not entry.reads:
        raise ParameterError(f"{entry.number} is computed without recordings: leave {data} out")
    if data is not None and not data.exists():
        raise ParameterError(f"no such file or folder: {data}")
    if entry.is_table and out is not None:
        raise ParameterError(f"{entry.number} is a table, which is printed: leave --out out")
    target = None if entry.is_table else out or Path(entry.file_name)
    if target is not None and target.suffix != ".svg":
        raise ParameterError(f"--out must name a file that ends in .svg, received {target}")
    check_targets({"--out": target, "--json": json}, [] if data is None else [data], force)
    return target


def _title(entry: Entry) -> str:
    thesis = entry.source == "thesis"
    named = f"Thesis, figure {entry.number}" if thesis else entry.number.replace("-", " ").capitalize()
    return f"{named}: {entry.shows}"


def _print_list(entries: list[Entry]) -> None:
    rows = []
    for one in entries:
        note = "diagram" if one.make is None else one.reads and f"can read {one.reads}"
        rows.append((one.number, one.shows, note))
    results().print(table(("number", "shows", "reads"), rows, whole=("number",)))


def _print(entry: Entry, made: Reproduction) -> None:
    screen = results()
    screen.print(_title(entry), style="bold")
    screen.print(f"from: {made.data}")
    rows = [
        (value.name, value.printed or "-", shown(value), value.unit, AGREES[value.agrees])
        for value in made.values
    ]
    headings = ("value", "printed", "ours", "unit", "")
    screen.print(table(headings, rows, right=("printed", "ours")))
    screen.print(f"What differs: {entry.differs}", soft_wrap=True)


def shown(value: Value) -> str:
    """Our number with five digits; what is rounding of 0 is 0."""
    return "0" if abs(value.ours) < 1e-12 else f"{value.ours:.5g}"


class ValueDocument(msgspec.Struct, frozen=True):
    """A number of ``--json``; ``printed`` and ``agrees`` are null where the source prints none."""

    name: str
    printed: str | None
    ours: float
    unit: str
    agrees: bool | None


class ReproductionDocument(msgspec.Struct, frozen=True):
    """What ``pointpred reproduce --json`` writes."""

    version: int
    number: str
    source: str
    shows: str
    data: str
    differs: str
    values: tuple[ValueDocument, ...]
