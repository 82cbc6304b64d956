"""Score every predictor on every set at hand and write ``docs/results.md``: ``make results``.

Sets are the embedded sample and the recordings in the folder that POINTPRED_RECORDINGS names. A set that is
absent, or that cannot be read, is left out, and the page says so.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from benchmarks import pages, results_page
from pointpred import REGISTRY
from pointpred.datasets import listing, sample
from pointpred.errors import RecordingError
from pointpred.recording import Recording
from pointpred.report.choice import highlighted
from pointpred.report.figures import curves
from pointpred.scoring import score, summary
from pointpred.sources import read

ROOT = Path(__file__).parents[1]
VARIABLE = "POINTPRED_RECORDINGS"
SEED = 0
DRAWN = ("by_time", "by_path")


def recordings(folder: Path | None, unread: dict[str, str]) -> Iterator[Recording]:
    """The embedded sample, then one set after the other; what cannot be read goes into ``unread``."""
    yield sample()
    for file in sorted(folder.glob("*_samples.*")) if folder else []:
        try:
            yield read(file)
        except RecordingError as error:
            # The message begins with the file's whole path, which is nobody's business but the machine's.
            unread[file.name] = str(error).replace(str(file), file.name)


def described(sets: Iterable[Recording], predictors: Sequence[str]) -> Iterator[dict[str, Any]]:
    """The summary of each set that has a trial to score; only one set is in memory at a time."""
    for recording in sets:
        print(f"scoring {recording.name}: {len(recording.events)} events")
        for scored in score([recording], predictors, seed=SEED):
            yield summary(scored)


def write_figures(one: dict[str, Any], folder: Path) -> dict[str, str]:
    """Draw error against time and against path, as a share of hold's; returns Markdown by kind."""
    folder.mkdir(parents=True, exist_ok=True)
    names = {}
    for kind in DRAWN:
        file = f"{one['name']}-{kind.replace('_', '-')}.svg"
        drawn = curves(one, highlighted(one), kind, "of_hold")
        (folder / file).write_text(drawn.svg, encoding="utf-8")
        names[kind] = f"![{drawn.alt}](figures/{file})\n\n*{one['name']}. {drawn.caption}*"
    return names


def write(folder: Path | None, predictors: Sequence[str], docs: Path) -> Path:
    """Score, draw and write the page; returns its path."""
    unread: dict[str, str] = {}
    scored = list(described(recordings(folder, unread), predictors))
    drawn = {one["name"]: write_figures(one, docs / "figures") for one in scored if one["trials"]}
    known = {entry.name: entry for entry in listing()}
    absent = [name for name in known if name not in {one["name"] for one in scored}]
    page = docs / "results.md"
    page.write_text(results_page.page(scored, drawn, known, absent, unread), encoding="utf-8")
    return page


def main() -> None:
    """Write the page of this project from all that is at hand."""
    named = os.environ.get(VARIABLE)
    if named is None:
        print(f"{VARIABLE} names no folder: only the embedded sample is scored")
    elif not Path(named).is_dir():
        raise SystemExit(f"{VARIABLE} must name a folder, received {named!r}")
    print(f"wrote {write(Path(named) if named else None, list(REGISTRY), ROOT / 'docs')}")
    pages.main([])  # the README quotes the page


if __name__ == "__main__":
    main()
