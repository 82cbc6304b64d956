"""``pointpred simulate`` and ``pointpred convert``: recordings out of nothing, and out of other formats."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def simulate(
    out: Annotated[Path, typer.Option(help="Samples file to write, .parquet or .csv.")] = Path(
        "simulated.parquet"
    ),
    people: Annotated[int, typer.Option(min=1, max=10_000, help="Number of simulated people.")] = 10,
    seed: Annotated[int, typer.Option(min=0, help="The same seed gives the same bytes.")] = 1,
) -> None:
    """Simulate."""


def convert() -> None:
    """Convert."""
