"""The page of a report from its templates, in which every name is escaped."""

from __future__ import annotations

import platform
from collections.abc import Mapping
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from typing import TYPE_CHECKING

from pointpred.scoring.report.statistics import ALPHA
from pointpred.scoring.results import PATH_FRACTIONS

if TYPE_CHECKING:
    from jinja2 import Environment

PACKAGES = ("pointpred", "numpy", "numba", "scipy", "statsmodels", "matplotlib")
LONGEST = 80
"""Characters of a name that are shown."""
NOTHING = "–"


def page(name: str, values: Mapping[str, object]) -> str:
    """The template ``name`` filled in."""
    return environment().get_template(name).render(values)


@cache
def environment() -> Environment:
    """The templates, with escaping and the ways to write a number."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("pointpred.scoring.report"),
        autoescape=True,
        undefined=StrictUndefined,
        finalize=_printable,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(short=short, number=number, percent=percent, line=_line)
    environment.globals.update(alpha=ALPHA, shares=PATH_FRACTIONS)
    return environment


def _printable(value: object) -> object:
    """Text without characters that no page may hold; what is HTML already stays."""
    if not isinstance(value, str) or hasattr(value, "__html__"):
        return value
    return "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in value)


def short(value: object, longest: int = LONGEST) -> str:
    """A name or note, cut to ``longest`` characters."""
    shown = str(value)
    return shown if len(shown) <= longest else shown[: longest - 1] + "…"


def number(value: float | None, digits: int = 2) -> str:
    """A number for a cell, a dash where there is none."""
    return NOTHING if value is None else f"{value:.{digits}f}"


def percent(value: float | None) -> str:
    """A share in percent, a dash where there is none."""
    return NOTHING if value is None else f"{value:.0%}"


def _line(value: str) -> str:
    """The same words with one space between them; what is HTML stays HTML."""
    return type(value)(" ".join(value.split()))


def versions() -> list[tuple[str, str]]:
    """What computed the report."""
    packages = [("Python", platform.python_version())]
    for name in PACKAGES:
        try:
            packages.append((name, version(name)))
        except PackageNotFoundError:  # run from a source tree that is not installed
            packages.append((name, "not installed as a package"))
    return packages
