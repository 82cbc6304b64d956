"""Write the pages that are made from code and from measured numbers: ``make docs``. Nothing is measured here.

A page is a template, ``pages/NAME/page.md``, and what its ``context`` takes from JSON or from the code. The
README keeps its own text: one part of it is made. The tests compare every page with what this writes.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from pages import DOCS, PAGES, ROOT, data
from pages.arguments import parse
from pages.asyncapi import document as asyncapi
from pages.attacks import page as attacks
from pages.commands import page as commands
from pages.errors import page as errors
from pages.intent import figure as intent_figure
from pages.intent import page as intent
from pages.kinematic import page as kinematic
from pages.load import figure as load_figure
from pages.markdown import filled
from pages.monitoring import page as monitoring
from pages.openapi import document as openapi
from pages.predictors import page as predictors
from pages.readme import page as readme
from pages.rendering import rendered
from pages.reproduce import page as reproduce
from pages.results import page as results
from pages.settings import page as settings
from pages.soak import figure as soak_figure

Context = Callable[[], dict[str, Any]]


def measured(page: str) -> Context:
    """The tables of a page that needs nothing else."""
    return lambda: {
        "tables": data.stored(page).tables,
        "machine": data.stored(page).machine,
        "numbers": data.stored(page).numbers,
    }


def several(**parts: str) -> Context:
    """The tables of several files, by name: ``part="page/file"``."""
    return lambda: {name: data.read(PAGES / f"{where}.json", data.Tables) for name, where in parts.items()}


COSTS = (
    "events",
    "service",
    "longest_messages",
    "devices",
    "in_page",
)
PAGES_MADE: dict[str, tuple[str, Context]] = {
    "docs/evidence/results.md": ("results", results.context),
    "docs/evidence/attacks.md": ("attacks", attacks.context),
    "docs/evidence/intent.md": ("intent", intent.context),
    "docs/evidence/kinematic.md": ("kinematic", kinematic.context),
    "docs/evidence/costs.md": (
        "costs",
        several(**{part: f"costs/{part}" for part in COSTS}),
    ),
    "docs/evidence/reproduce.md": ("reproduce", reproduce.context),
    "docs/evidence/targets.md": (
        "targets",
        lambda: measured("targets")() | several(proposals="proposals/data")(),
    ),
    **{
        f"docs/evidence/{name}.md": (name, measured(name))
        for name in (
            *("accelerometer", "adaptation", "camera", "designs"),
            "inputs",
            *("load", "places", "regions", "scale", "soak"),
            *("switched", "thesis"),
        )
    },
    "docs/reference/commands.md": ("commands", commands.context),
    "docs/reference/errors.md": ("errors", errors.context),
    "docs/reference/licences.md": ("licences", measured("licences")),
    "docs/reference/monitoring.md": ("monitoring", monitoring.context),
    "docs/reference/predictors.md": ("predictors", predictors.context),
    "docs/reference/settings.md": ("settings", settings.context),
}
"""Where a page goes, the folder of its template, and what it shows."""

DOCUMENTS: dict[str, Callable[[], str]] = {
    "docs/reference/asyncapi.yaml": asyncapi.render,
    "docs/reference/openapi.json": openapi.render,
}
"""Descriptions of the protocols, made from the messages and the routes."""

PARTS: dict[str, dict[str, Callable[[], str]]] = {
    "README.md": {"scores": lambda: rendered("readme/scores.md", readme.context())},
    "docs/guide/observers/example-7.md": {
        "sniffer": lambda: rendered("observers/sniffer.md", measured("observers")()),
    },
}
"""Made parts of pages that are written by hand."""


def made(path: str) -> str:
    """A page as it should be."""
    if path in DOCUMENTS:
        return DOCUMENTS[path]()
    if path in PAGES_MADE:
        folder, context = PAGES_MADE[path]
        return rendered(f"{folder}/page.md", context())
    page = (ROOT / path).read_text(encoding="utf-8")
    for name, write in PARTS[path].items():
        page = filled(page, name, write().strip())
    return page


def everything() -> list[str]:
    """Every page that is made, whole or in part."""
    return [*PAGES_MADE, *DOCUMENTS, *PARTS]


def main() -> None:
    """Write every page, and the figures of the results."""
    for path in everything():
        file: Path = ROOT / path
        file.write_text(made(path), encoding="utf-8")
        print(f"wrote {path}")
    results.save_figures()
    intent_figure.save()
    load_figure.save()
    soak_figure.save()
    print(f"drew the results into {DOCS.relative_to(ROOT)}/figures")


if __name__ == "__main__":
    parse(__doc__)
    main()
