"""Score every predictor on every set at hand and write ``docs/evidence/results.md``: ``make results``.

Sets are the embedded sample and the recordings in the folder that POINTPRED_RECORDINGS names. A set that is
absent, or that cannot be read, is left out, and the page says so. What has learned from recordings is judged
by coefficients that did not see the set, or the person: ``held_out`` fits them, which takes minutes once.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec

from benchmarks.arguments import words
from pages import DOCS, held_out, sets
from pages import __main__ as pages
from pages.held_out import HeldOut
from pages.results import ktm as results_ktm
from pages.results import page as results_page
from pages.results import targets as results_targets
from pages.results.scores import scored
from pointpred import REGISTRY
from pointpred.datasets import listing
from pointpred.recording import Recording
from pointpred.report.choice import highlighted
from pointpred.report.figures.claims import inside_curves, time_left_bars
from pointpred.report.figures.errors import cost, curves
from pointpred.report.figures.style import Picture
from pointpred.scoring import SetSummary, summary

Json = dict[str, Any]
SEED = 0


def described(recording: Recording, predictors: Sequence[str], held: HeldOut) -> Json:
    """The summary of one set, with the protocol of template matching under ``ktm``."""
    began = time.monotonic()
    print(f"scoring {recording.name}: {len(recording.events)} events", flush=True)
    one = summary(scored(recording, predictors, held, SEED))
    one["ktm"] = results_ktm.measured(recording, predictors, held) if one["trials"] else []
    print(f"{recording.name}: {time.monotonic() - began:.0f} s", flush=True)
    return one


def drawings(described: Json) -> dict[str, Picture | None]:
    """The figures of a set by what they show; ``None`` where there is nothing to show."""
    one = msgspec.convert(described, SetSummary, str_keys=True)
    told = tuple(p for p in one.predictors if not p.name.endswith(held_out.PEOPLE_OUT))
    shown = highlighted(msgspec.structs.replace(one, predictors=told))
    return {
        "by-time": curves(one, shown, "by_time", "of_hold"),
        "by-path": curves(one, shown, "by_path", "of_hold"),
        "cost": cost(one),
        "regions": inside_curves(one, "calibration"),
        "times": inside_curves(one, "time_left"),
        "time-left": time_left_bars(one),
    }


def write_figures(one: Json, folder: Path) -> dict[str, str]:
    """Draw a set's figures; returns Markdown by what they show."""
    folder.mkdir(parents=True, exist_ok=True)
    found = {}
    for kind, drawn in drawings(one).items():
        if drawn is not None:
            file = f"{one['name']}-{kind}.svg"
            (folder / file).write_text(drawn.svg, encoding="utf-8")
            found[kind] = f"![{drawn.alt}](figures/{file})\n\n*{one['name']}. {drawn.caption}*"
    return found


def write(folder: Path | None, predictors: Sequence[str], docs: Path, *, choices: bool = True) -> Path:
    """Score, draw and write the page; returns its path. ``choices``: among targets as well."""
    unread: dict[str, str] = {}
    learns = any(name in held_out.trained() for name in predictors)
    held = held_out.held_out(folder if learns else None)
    found = [described(one, predictors, held) for one in sets.recordings(folder, unread)]
    drawn = {one["name"]: write_figures(one, docs / "figures") for one in found if one["trials"]}
    chosen = results_targets.measured(list(sets.recordings(folder, {})), held) if choices else []
    known = {entry.name: entry for entry in listing()}
    absent = [name for name in known if name not in {one["name"] for one in found}]
    page = docs / "evidence" / "results.md"
    text = results_page.page(found, drawn, known, absent, unread, results_targets.section(chosen))
    page.write_text(text, encoding="utf-8")
    return page


def main() -> None:
    """Write the page of this project from all that is at hand."""
    began = time.monotonic()
    written = write(sets.folder(), list(REGISTRY), DOCS)
    print(f"wrote {written} in {time.monotonic() - began:.0f} s")
    pages.main([])  # the README quotes the page


if __name__ == "__main__":
    words(__doc__)
    main()
