"""The live page as files for any static host: it predicts by itself, so nothing else is needed."""

from __future__ import annotations

import shutil
from pathlib import Path

import msgspec

from pointpred.datasets import sample
from pointpred.recording import Recording
from pointpred.recordings import write
from pointpred_server import samples
from pointpred_server.page import WEB, page

MOVEMENTS = 12
"""Movements of the embedded sample that go with the page."""
LEFT_OUT = (
    *("index.html", "study.html", "package.json", "README.md", "*.d.ts", "example.*"),
    *("entries", "frameworks", "human", "script"),
)
"""The page without its links, and what is for pages of other people."""


def write_demo(folder: Path) -> None:
    """Write the page, its modules and some movements into a folder; files of the same names are replaced."""
    shutil.copytree(WEB, folder / "web", ignore=shutil.ignore_patterns(*LEFT_OUT), dirs_exist_ok=True)
    (folder / "index.html").write_text(page(service=False), encoding="utf-8")
    _write_samples(folder / "samples")


def _write_samples(folder: Path) -> None:
    """Some movements: what the service would answer, and a recording to open in the page."""
    folder.mkdir(exist_ok=True)
    listing = samples.listing()
    listing["samples"] = listing["samples"][:MOVEMENTS]
    (folder / "index.json").write_bytes(msgspec.json.encode(listing))
    for one in listing["samples"]:
        (folder / f"{one['name']}.json").write_bytes(msgspec.json.encode(samples.trial(one["name"])))
    whole = sample()
    rows = [whole.rows(i) for i in range(MOVEMENTS)]
    part = Recording.of(whole.name, rows, whole.trials[:MOVEMENTS], provenance=whole.provenance)
    write(part, folder / "sample_samples.csv")
