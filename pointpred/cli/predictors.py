"""``pointpred predictors``: what exists, and what can be set."""

from __future__ import annotations

from inspect import signature
from typing import TYPE_CHECKING, Annotated, Any

import typer

from pointpred.cli.output_files import AsJson, print_json
from pointpred.cli.shared_options import complete_predictors, tell_others
from pointpred.console import NARROW, results, table
from pointpred.errors import SourceError
from pointpred.registry import RECOMMENDED, REGISTRY, build, describe, others

if TYPE_CHECKING:
    from pointpred.plugins import Kept


def predictors(
    name: Annotated[
        str | None,
        typer.Argument(help="Show the parameters of this predictor.", autocompletion=complete_predictors),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """List the predictors, or show one with its parameters, units, bounds and defaults.

    One of another package is also checked: whether it keeps the laws that the predictors of this one keep.

    Try:

      pointpred predictors

      pointpred predictors switched

      pointpred predictors --json
    """
    if name is None:
        tell_others()
    else:
        build(name)
    descriptions = [describe(one) for one in ([name] if name else REGISTRY)]
    kept = _checked(name) if name in others() else []
    if kept:
        descriptions[0]["laws"] = {one.law: one.trouble or None for one in kept}
    if as_json:
        print_json("predictors", descriptions)
    elif name is None:
        _print_all(descriptions)
    else:
        _print_one(descriptions[0])
        for one in kept:
            words = f"{one.law}: {one.trouble}" if one.trouble else one.law
            results().print(f"{'breaks' if one.trouble else 'keeps '}  {words}")
    if broken := sum(bool(one.trouble) for one in kept):
        raise SourceError(f"{name} breaks {broken} of {len(kept)} laws, each named above")


def _checked(name: str) -> list[Kept]:
    from pointpred.plugins import check

    return check(name)


def _print_all(descriptions: list[dict[str, Any]]) -> None:
    wide = results().width >= NARROW
    more = ("differentiator", "reference") if wide else ()
    rows = [(one["name"], one["title"], *(one[name] for name in more)) for one in descriptions]
    results().print(table(("name", "what it does", *more), rows, whole=("name",)))
    results().print(f"\nFor a live person: {RECOMMENDED}. Parameters of one: pointpred predictors NAME")


def _print_one(one: dict[str, Any]) -> None:
    screen = results()
    screen.print(f"{one['name']}: {one['title']} ({one['reference']})")
    if (make := REGISTRY[one["name"]].make) is not None:
        screen.print(f"made by {make.__name__}{signature(make)}\n")
        return
    screen.print(f"differentiator: {one['differentiator']}\n")
    wide = screen.width >= NARROW
    whole, rows = ("parameter", *(("of", "unit") if wide else ()), "bounds", "default"), []
    for p in one["parameters"]:
        unit = p["unit"] or "-"
        last = p["meaning"] if wide or unit == "-" else f"{p['meaning']} ({unit})"
        bounds = f"[{p['low']:g}, {p['high']:g}]"
        rows.append((p["name"], *((p["of"], unit) if wide else ()), bounds, f"{p['default']}", last))
    screen.print(table((*whole, "meaning"), rows, whole=whole))
    screen.print(f"\nIn Python:  build({one['name']!r}, parameter=value)")
