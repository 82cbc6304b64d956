"""``pointpred predictors``: what exists, and what can be set."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from pointpred.cli.output_files import AsJson, print_json
from pointpred.cli.shared_options import complete_predictors
from pointpred.console import NARROW, results, table
from pointpred.registry import RECOMMENDED, REGISTRY, build, describe


def predictors(
    name: Annotated[
        str | None,
        typer.Argument(help="Show the parameters of this predictor.", autocompletion=complete_predictors),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """List the predictors, or show one with its parameters, units, bounds and defaults.

    Try:

      pointpred predictors

      pointpred predictors switched

      pointpred predictors --json
    """
    if name is not None:
        build(name)
    descriptions = [describe(one) for one in ([name] if name else REGISTRY)]
    if as_json:
        print_json("predictors", descriptions)
    elif name is None:
        _print_all(descriptions)
    else:
        _print_one(descriptions[0])


def _print_all(descriptions: list[dict[str, Any]]) -> None:
    wide = results().width >= NARROW
    more = ("differentiator", "reference") if wide else ()
    rows = [(one["name"], one["title"], *(one[name] for name in more)) for one in descriptions]
    results().print(table(("name", "what it does", *more), rows, whole=("name",)))
    results().print(f"\nFor a live person: {RECOMMENDED}. Parameters of one: pointpred predictors NAME")


def _print_one(one: dict[str, Any]) -> None:
    screen = results()
    screen.print(f"{one['name']}: {one['title']} ({one['reference']})")
    screen.print(f"differentiator: {one['differentiator']}\n")
    wide = screen.width >= NARROW
    whole, rows = ("parameter", *(("of", "unit") if wide else ()), "bounds", "default"), []
    for p in one["parameters"]:
        unit = p["unit"] or "-"
        last = p["meaning"] if wide or unit == "-" else f"{p['meaning']} ({unit})"
        bounds = f"[{p['low']:g}, {p['high']:g}]"
        rows.append((p["name"], *((p["of"], unit) if wide else ()), bounds, f"{p['default']}", last))
    screen.print(table((*whole, "meaning"), rows, whole=whole), markup=False)
    screen.print(f"\nIn Python:  build({one['name']!r}, parameter=value)", markup=False)
