"""``pointpred datasets``: public recordings of people, which the project names but does not ship."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from pointpred.cli.output_files import AsJson, print_json
from pointpred.console import WIDE, remark, results, table

BOUNDLESS = 1000
"""Columns of the list where nobody looks at it: no address is cut."""

BY_HAND = "by hand, address below"

app = typer.Typer(no_args_is_help=True)


def _complete(incomplete: str) -> list[str]:
    from pointpred.datasets import listing

    return [one.name for one in listing() if one.fetchable and one.name.startswith(incomplete)]


@app.command("list")
def list_sets(
    as_json: AsJson = False,
) -> None:
    """List the public sets of the catalogue, with licence and how to get each.

    Try:

      pointpred datasets list

      pointpred datasets list --json | jq '.sets[].citation'
    """
    from pointpred.datasets import listing

    sets = listing()
    if as_json:
        print_json("sets", sets)
        return
    screen = results()
    if not screen.is_terminal:  # a line a set, however long, for whoever cuts it up
        screen.width = BOUNDLESS
    wide = screen.width >= WIDE
    by_hand = [one for one in sets if not one.fetchable]
    headings = ("name", "people", "trials", *(("sampling", "licence") if wide else ()), "to get it")
    rows = []
    for one in sets:
        way = f"pointpred datasets fetch {one.name}" if one.fetchable else one.page if wide else BY_HAND
        more = (one.sampling, one.licence) if wide else ()
        rows.append((one.name, _count(one.users), _count(one.trials), *more, way))
    screen.print(table(headings, rows, whole=("name",), overflow="fold"))
    for one in () if wide else by_hand:
        screen.print(f"{one.name}: {one.page}", soft_wrap=True)
    if not wide:
        screen.print("Sampling and licences: a wider terminal, or --json.", style="dim")


@app.command("fetch")
def fetch_set(
    name: Annotated[
        str, typer.Argument(help="A name from 'pointpred datasets list'.", autocompletion=_complete)
    ],
    folder: Annotated[
        Path, typer.Option(metavar="FOLDER", file_okay=False, help="Where to put it; made if missing.")
    ] = Path("recordings"),
) -> None:
    """Download a public set over https, and check each file by its digest.

    The licence is printed before anything is fetched. A file that is already there is checked and kept.

    Try:

      pointpred datasets fetch gofitts_demo

      pointpred datasets fetch gofitts_demo --folder recordings
    """
    from pointpred.cli.progress import following
    from pointpred.datasets import fetch, find

    entry = find(name)
    into = folder / entry.name
    with following() as progress:
        fetched = fetch(entry, into, progress=progress, say=remark)
    for file in fetched:
        typer.echo(file.path)
    if entry.importer is not None:
        remark(f"Then:  pointpred score {into}")


def _count(value: Any) -> str:
    return "-" if value is None else str(value)
