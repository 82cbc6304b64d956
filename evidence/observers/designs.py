"""Count what becomes of random problems: ``python -m evidence observers designs [doors | facts | CALL ...]``.

``doors`` are all calls of the table; a call, such as "certify_tracking", measures its row only.
"""

from __future__ import annotations

import zlib
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from typing import Any

import numpy as np

from evidence.arguments import parse
from evidence.data import Table, keep, stored
from evidence.machine import machine
from evidence.observers.facts import facts
from evidence.observers.plants import DOORS, KINDS, Problem
from pointpred.errors import InfeasibleError, PointpredError

COUNT = 20
"""Problems of each kind at each door."""
OUTCOMES = ("designed", "refused", "undecided")
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


def doors(measured: list[str]) -> dict[str, Table]:
    """A row a door: designed / refused / undecided of each kind, in problems; rows not measured stay."""
    old = stored("observers", "designs").tables.get("doors")
    rows = {str(row[0]): [str(one) for one in row] for row in (old.rows if old else [])}
    places = [(door, kind) for door in measured for kind in KINDS]
    with ProcessPoolExecutor() as pool:
        results = dict(zip(places, pool.map(cell, *zip(*places, strict=True)), strict=True))
    for door in measured:
        cells = [" / ".join(str(results[door, kind][0][name]) for name in OUTCOMES) for kind in KINDS]
        close = [one for kind in KINDS for one in results[door, kind][1]]
        rows[door] = [door, *cells, f"{np.mean(close):.0%}" if close else "-"]
        print(" | ".join(rows[door]), flush=True)
    listed = [rows[door] for door in DOORS if door in rows]
    counts = np.array([[one.split(" / ") for one in row[1:-1]] for row in listed], int).sum(axis=(0, 1))
    shares = dict(zip(OUTCOMES, (counts / counts.sum()).tolist(), strict=True))
    numbers = {"problems": int(counts.sum()), "count": COUNT, **shares}
    keep("observers", {}, part="designs", numbers=numbers, machine=machine())
    return {"doors": Table.of(["call", *KINDS, "gap <= 1 %"], listed)}


CALLS = {door.replace("`", ""): door for door in DOORS}
"""The doors by the names that the command takes."""


def main(parts: list[str]) -> None:
    if not parts or "doors" in parts:
        keep("observers", doors(list(DOORS)), part="designs")
    elif calls := [CALLS[one] for one in parts if one in CALLS]:
        keep("observers", doors(calls), part="designs")
    if not parts or "facts" in parts:
        keep("observers", facts(), part="designs")


if __name__ == "__main__":
    main(parse(__doc__, metavar="part", choices=("doors", "facts", *CALLS)))
