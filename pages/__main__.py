"""Write the generated parts of the pages: ``make docs``.

The tests compare each part with the code, except the README's score table: that takes a scoring run, and
``python -m pages scores`` writes it as well.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec

from benchmarks.arguments import words
from pages import DOCS, ROOT
from pages.asyncapi import document as asyncapi
from pages.markdown import filled, table
from pages.openapi import document as openapi
from pages.predictors.which import which
from pages.results.verdict import recorded
from pointpred.differentiators import DIFFERENTIATORS
from pointpred.registry import GAINS, REGISTRY, describe
from pointpred.registry import parameters as values_of

HEADER = ("parameter", "unit", "bounds", "default", "meaning")


def predictors() -> str:
    """Every name of the registry in one table."""
    described = [describe(name) for name in REGISTRY]
    rows = [(f"[`{one['name']}`](#{one['name']})", one["title"], one["reference"]) for one in described]
    return table(("name", "what it does", "reference"), rows)


def parameters() -> str:
    """A section a predictor, with its own parameters and the preset values of its differentiator."""
    sections = []
    for name, entry in REGISTRY.items():
        one = describe(name)
        own = [_row(p) for p in one["parameters"] if p["of"] == "predictor"]
        listed = table(HEADER, own) if own else "No parameters."
        gains = ", ".join(f"`{key}` {value:g}" for key, value in own_gains(name).items())
        own_names = {parameter.name for parameter in entry.predictor.parameters}
        preset = [f"`{key}` {value:g}" for key, value in entry.preset.items() if key in own_names]
        sets = f" It sets {', '.join(preset)}." if preset else ""
        head = f"{one['title']}. Differentiator: `{one['differentiator']}` with {gains}.{sets}"
        sections.append(f"### {name}\n\n{head[0].upper()}{head[1:]}\n\n{listed}")
    return "\n\n".join(sections)


def own_gains(name: str) -> dict[str, float]:
    """What ``build(name)`` gives its differentiator, where the registry says it."""
    stage = DIFFERENTIATORS[REGISTRY[name].differentiator]
    said = GAINS | REGISTRY[name].preset
    return {p.name: values_of(name)[p.name][1] for p in stage.parameters if p.name in said}


def gains() -> str:
    """Which names use which gains: the classes' defaults in the tables below them are not used."""
    groups: dict[str, list[str]] = {}
    for name in REGISTRY:
        values = ", ".join(f"`{key}` {value:g}" for key, value in own_gains(name).items())
        groups.setdefault(values, []).append(f"`{name}`")
    told = "; ".join(f"{values} for {', '.join(names)}" for values, names in groups.items())
    return f"The defaults below are those of the classes. `build(name)` sets {told}."


def differentiators() -> str:
    """A section a differentiator."""
    sections = []
    for name, stage in DIFFERENTIATORS.items():
        rows = [_row(msgspec.structs.asdict(p)) for p in stage.parameters]
        summary = (stage.__doc__ or "").strip().splitlines()[0]
        sections.append(f"### {name}\n\n{summary}\n\n{table(HEADER, rows)}")
    return "\n\n".join(sections)


def _row(p: dict[str, Any]) -> tuple[str, ...]:
    bounds = f"[{p['low']:g}, {p['high']:g}]"
    return (f"`{p['name']}`", p["unit"] or "-", bounds, f"`{p['default']}`", p["meaning"])


def settings() -> str:
    """Every setting of the service."""
    from pointpred.server.settings import Settings

    rows = [
        (
            f"`--{name.replace('_', '-')}`",
            f"`POINTPRED_{name.upper()}`",
            _shown(field.default),
            field.description or "",
        )
        for name, field in Settings.model_fields.items()
    ]
    return table(("flag", "environment", "default", "meaning"), rows)


def _shown(default: object) -> str:
    return "-" if default is None or default == () else f"`{default}`"


PARTS: dict[str, dict[str, Callable[[], str]]] = {
    "docs/reference/predictors.md": {
        "which": lambda: which(DOCS),
        "predictors": predictors,
        "parameters": parameters,
        "gains": gains,
        "differentiators": differentiators,
    },
    "docs/guide/service.md": {"settings": settings},
    "README.md": {"recorded": lambda: recorded(DOCS / "evidence" / "results.md")},
}
"""What the tests compare with the code: page, part, and the function that writes it."""


WHOLE: dict[str, Callable[[], str]] = {
    "docs/reference/asyncapi.yaml": asyncapi.render,
    "docs/reference/openapi.json": openapi.render,
}
"""Files that are written as a whole."""


def rendered(path: str) -> str:
    """A page as it should be."""
    if path in WHOLE:
        return WHOLE[path]()
    page = (ROOT / path).read_text(encoding="utf-8")
    for name, write in PARTS[path].items():
        page = filled(page, name, write())
    return page


def main(arguments: list[str]) -> None:
    """Write every page; with ``scores``, the README's score table as well."""
    for path in (*PARTS, *WHOLE):
        (ROOT / path).write_text(rendered(path), encoding="utf-8")
        print(f"wrote {path}")
    if "scores" in arguments:
        from pages.readme.scores import write_scores

        print(f"wrote {write_scores(ROOT)}")


if __name__ == "__main__":
    main(words(__doc__, named="scores", known=["scores"]))
