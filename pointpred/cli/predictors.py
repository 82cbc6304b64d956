"""``pointpred predictors``: what exists, and what can be set."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer
from rich.table import Table

from pointpred.cli.screen import results, write_json
from pointpred.registry import REGISTRY, build, describe


def predictors(
    name: Annotated[str | None, typer.Argument(help="Show everything about this one.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
) -> None:
    """List the predictors, or show one with its parameters, units, bounds and defaults.

    Try:

      pointpred predictors

      pointpred predictors switched

      pointpred predictors --json
    """
    if name is not None:
        build(name)
    described = [describe(known) for known in ([name] if name else REGISTRY)]
    if as_json:
        write_json({"version": 1, "predictors": described}, Path("-"))
    elif name is None:
        _print_all(described)
    else:
        _print_one(described[0])


def _print_all(described: list[dict[str, Any]]) -> None:
    table = Table(box=None, pad_edge=False)
    for column in ("name", "what it does", "differentiator", "reference"):
        table.add_column(column, no_wrap=column == "name")
    for one in described:
        table.add_row(one["name"], one["title"], one["differentiator"], one["reference"])
    results().print(table)
    results().print("\nParameters of one:  pointpred predictors NAME")


def _print_one(one: dict[str, Any]) -> None:
    screen = results()
    screen.print(f"{one['name']}: {one['title']} ({one['reference']})")
    screen.print(f"differentiator: {one['differentiator']}\n")
    table = Table(box=None, pad_edge=False)
    for column in ("parameter", "of", "unit", "bounds", "default", "meaning"):
        table.add_column(column, no_wrap=column == "parameter")
    for p in one["parameters"]:
        bounds = f"[{p['low']:g}, {p['high']:g}]"
        table.add_row(p["name"], p["of"], p["unit"] or "-", bounds, str(p["default"]), p["meaning"])
    screen.print(table, markup=False)
    screen.print(f"\nIn Python:  build({one['name']!r}, parameter=value)", markup=False)
