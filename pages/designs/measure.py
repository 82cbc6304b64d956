"""Count what becomes of random problems at every door: ``python -m pages.designs.measure [doors|facts]``."""

from __future__ import annotations

import zlib
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from typing import Any

import numpy as np

from benchmarks.machine import machine
from pages.arguments import parse
from pages.data import Table, keep
from pages.designs.facts import facts
from pages.designs.plants import DOORS, KINDS, Problem
from pointpred.errors import InfeasibleError, PointpredError

COUNT = 20
"""Problems of each kind at each door."""
CLOSE = 1e-2
"""A gap that counts as a minimum."""


def outcome(door: str, kind: str, seed: int) -> tuple[str, float | None]:
    """What becomes of one problem, and the gap of the design."""
    random = np.random.default_rng([zlib.crc32(door.encode()), KINDS.index(kind), seed])
    try:
        design = DOORS[door](Problem(kind, random))
    except InfeasibleError:
        return "refused", None
    except PointpredError as error:
        return type(error).__name__, None
    return "designed", gap(design)


def gap(design: Any) -> float | None:
    """The gap of an answer, None where nothing is minimised."""
    certificate = getattr(design, "certificate", None)
    return getattr(design, "gap", None) if hasattr(design, "gap") else getattr(certificate, "gap", None)


def cell(door: str, kind: str) -> tuple[Counter[str], list[bool]]:
    """What becomes of the problems of one kind at one door, and whether the gap of each design is small."""
    counts, close = Counter[str](), []
    for seed in range(COUNT):
        what, one = outcome(door, kind, seed)
        counts[what if what in ("designed", "refused") else "undecided"] += 1
        if what == "designed" and one is not None:
            close.append(one <= CLOSE)
    return counts, close


def doors() -> dict[str, Table]:
    """A row a door: designed / refused / undecided of each kind, in problems."""
    rows, shares, gaps = [], Counter[str](), []
    places = [(door, kind) for door in DOORS for kind in KINDS]
    with ProcessPoolExecutor() as pool:
        results = dict(zip(places, pool.map(cell, *zip(*places, strict=True)), strict=True))
    for door in DOORS:
        cells, close = [], []
        for kind in KINDS:
            counts, small = results[door, kind]
            shares += counts
            close += small
            cells.append(f"{counts['designed']} / {counts['refused']} / {counts['undecided']}")
        gaps += close
        rows.append([door, *cells, f"{np.mean(close):.0%}" if close else "-"])
        print(" | ".join(rows[-1]), flush=True)
    whole = sum(shares.values())
    numbers = {
        "problems": whole,
        "count": COUNT,
        **{name: shares[name] / whole for name in ("designed", "refused", "undecided")},
        "close": float(np.mean(gaps)),
    }
    keep("designs", {}, numbers=numbers, machine=machine())
    columns = ["call", *KINDS, "gap <= 1 %"]
    return {"doors": Table.of(columns, rows)}


def main(parts: list[str]) -> None:
    for name, measured in (("doors", doors), ("facts", facts)):
        if not parts or name in parts:
            keep("designs", measured())


if __name__ == "__main__":
    main(parse(__doc__, metavar="part", choices=("doors", "facts")))
