"""The pages that are made from the code and from measured numbers. Nothing is measured here.

A page is a template and what its context takes from JSON or from the code. Pages that are written by people
may have made parts. The tests compare every page with what this writes.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from evidence import ROOT, data
from evidence.attacks import page as attacks
from evidence.intent import measure as intent
from evidence.reference import asyncapi
from evidence.reference import pages as reference
from evidence.rendering import filled, rendered
from evidence.reproduce import measure as reproduce
from evidence.results import page as results
from evidence.targets import page as targets

Context = Callable[[], dict[str, Any]]


def measured(page: str, part: str = "") -> dict[str, Any]:
    """The tables of a question that needs nothing else."""
    kept = data.stored(page, part)
    return {"tables": kept.tables, "machine": kept.machine, "numbers": kept.numbers}


def several(page: str, *parts: str) -> dict[str, Any]:
    """The tables of the parts of a question, by their names."""
    return {part: data.stored(page, part) for part in parts}


COSTS = ("events", "service", "load", "soak", "scale", "devices", "in_page", "page_size")
EVIDENCE_PAGES: dict[str, Context] = {
    "results": results.context,
    "person": partial(several, "person", "adaptation", "places", "regions"),
    "intent": intent.context,
    "targets": targets.context,
    "reproduce": reproduce.context,
    "costs": partial(several, "costs", *COSTS),
    "inputs": partial(measured, "inputs"),
    "attacks": attacks.context,
    "observers": partial(several, "observers", "camera", "designs"),
}
REFERENCE_PAGES: dict[str, Context] = {
    "commands": reference.command_page,
    "errors": reference.error_page,
    "licences": partial(measured, "reference", "licences"),
    "monitoring": reference.monitoring_page,
    "predictors": reference.predictor_page,
    "settings": reference.setting_page,
}
PAGES: dict[str, tuple[str, Context]] = {
    **{f"docs/evidence/{name}.md": (f"{name}/page.md", one) for name, one in EVIDENCE_PAGES.items()},
    **{f"docs/reference/{name}.md": (f"reference/{name}.md", one) for name, one in REFERENCE_PAGES.items()},
}
"""Where a page goes, its template, and what it shows."""

DOCUMENTS: dict[str, Callable[[], str]] = {
    "docs/reference/asyncapi.yaml": asyncapi.render,
    "docs/reference/openapi.json": reference.openapi_document,
}
"""Descriptions of the protocols, made from the messages and the routes."""

PARTS: dict[str, dict[str, tuple[str, Context]]] = {
    "README.md": {"scores": ("reference/scores.md", reference.readme_scores)},
    "observers/docs/example-7.md": {
        "sniffer": ("observers/sniffer.md", partial(measured, "observers", "sniffer")),
    },
}
"""Made parts of pages that are written by hand."""


def made(path: str) -> str:
    """A page as it should be."""
    if path in DOCUMENTS:
        return DOCUMENTS[path]()
    if path in PAGES:
        template, context = PAGES[path]
        return rendered(template, context())
    page = (ROOT / path).read_text(encoding="utf-8")
    for name, (template, context) in PARTS[path].items():
        page = filled(page, name, rendered(template, context()).strip())
    return page


def everything() -> list[str]:
    """Every page that is made, whole or in part."""
    return [*PAGES, *DOCUMENTS, *PARTS]


def write() -> None:
    """Write every page, and the figures of the results."""
    for path in everything():
        (ROOT / path).write_text(made(path), encoding="utf-8")
        print(f"wrote {path}")
    results.save_figures()
    print("drew the figures of the results")
