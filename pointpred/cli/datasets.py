"""``pointpred datasets``."""

from __future__ import annotations

import typer

app = typer.Typer(no_args_is_help=True, help="Public recordings: which exist, and how to get them.")


@app.command("list")
def list_sets() -> None:
    """List."""


@app.command("fetch")
def fetch_set() -> None:
    """Fetch."""
