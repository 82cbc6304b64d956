"""Where a command works: threads, processes, or a Dask cluster."""

from __future__ import annotations

from typing import Annotated

import typer

PANEL = "For long recordings"

Threads = Annotated[
    int | None,
    typer.Option(min=1, max=1024, help="Number of threads. Not given: one for each processor."),
]
Processes = Annotated[
    int | None,
    typer.Option(min=1, max=1024, help="Number of processes instead of threads.", rich_help_panel=PANEL),
]
ClusterAddress = Annotated[
    str | None,
    typer.Option(
        metavar="ADDRESS",
        help="A Dask cluster instead of threads: its scheduler's address, or local.",
        rich_help_panel=PANEL,
    ),
]
