"""What a message costs the service: ``python -m evidence costs service``.

Servers on one core, the compiled load generator on another, loopback between them. Eight clients have one
frame each under way. All that is compared takes turns of a twentieth of a second within one run; the cost is
that of the quietest tenth of the turns, because whatever else the machine does can only add, and a ratio is
the median of those of neighbouring turns. ``--before COMMIT`` measures another build as well.
"""

from __future__ import annotations

import argparse
import itertools
import json
import sys
from collections.abc import Sequence
from contextlib import ExitStack

import numpy as np

from evidence.costs.load.generator import Group, Plan, hello, recording, run
from evidence.costs.load.servers import Server, checkout, echo, service
from evidence.data import Table, keep
from evidence.machine import LAST, machine, on_cores

TURN_S, ROUNDS, QUIET = 0.05, 40, 10.0
"""The length of a turn, turns of each group, and the percentile of the turns that is used."""
WARM = 4
"""Rounds at the start that do not count."""
CLIENTS = 8
ENCODINGS, SIZES = ("binary", "json"), (1, 8, 32)
PREDICTORS = ("hold", "switched", "kinematic", "kinematic-adaptive")
PREDICTORS_BEFORE = ("switched", "kinematic")
RAW, ASGI = "raw TCP echo", "bare ASGI echo"
RATIOS = (("`switched`", ASGI), ("`kinematic`", "`switched`"), ("`kinematic-adaptive`", "`switched`"))
TARGETS = (0, 1, 20, 100)


Turns = dict[str, list[float]]
"""The processor time of each turn by group, us a frame."""


def in_turns(groups: Sequence[Group]) -> tuple[Turns, float]:
    """The turns of each group, and the load generator's share of its core."""
    result = run(Plan(tuple(groups), turn=TURN_S, rounds=WARM + ROUNDS), LAST)
    return {counts.name: counts.turns_us[WARM:] for counts in result.groups}, result.own_share


def quiet(turns: Sequence[float]) -> str:
    """The cost in the quietest tenth."""
    return f"{np.percentile(turns, QUIET):.1f}"


def ratio(turns: Turns, name: str, beside: str) -> str:
    """What one costs beside another, with the quartiles."""
    low, middle, high = np.percentile(np.divide(turns[name], turns[beside]), [25, 50, 75])
    return f"{middle:.2f} ({low:.2f} to {high:.2f})"


def compared(one: Server, old: Server | None, encoding: str, size: int) -> tuple[Turns, float]:
    """Echoes and sessions in turns, for frames of one kind."""
    words = {"json": encoding == "json", "size": size, "clients": CLIENTS}
    sessions = [(f"`{name}`", name, one) for name in PREDICTORS]
    if old is not None:
        sessions += [(f"`{name}`, before", name, old) for name in PREDICTORS_BEFORE]
    with echo("raw") as raw, echo("asgi") as asgi:
        groups = [Group(RAW, raw.port, raw.pids, "raw", **words)]
        groups += [Group(ASGI, asgi.port, asgi.pids, "echo", **words)]
        groups += [
            Group(label, where.port, where.pids, greeting=(hello(name, encoding),), **words)
            for label, name, where in sessions
        ]
        return in_turns(groups)


def cost_tables(one: Server, old: Server | None) -> dict[str, Table]:
    """Every server by encoding and frame, and the ratios of some."""
    cells: dict[str, list[str]] = {}
    ratios: dict[str, list[str]] = {}
    for encoding, size in itertools.product(ENCODINGS, SIZES):
        turns, share = compared(one, old, encoding, size)
        for name, of_name in turns.items():
            cells.setdefault(name, []).append(quiet(of_name))
        ratios.setdefault("load generator, share of a core", []).append(f"{100 * share:.0f} %")
        for name, beside in RATIOS:
            ratios.setdefault(f"{name} / {beside}", []).append(ratio(turns, name, beside))
    heads = [f"{encoding}, {size}" for encoding, size in itertools.product(ENCODINGS, SIZES)]
    return {
        "cost": Table.of(("us a frame", *heads), [(name, *some) for name, some in cells.items()]),
        "ratios": Table.of(("ratio (quartiles)", *heads), [(name, *some) for name, some in ratios.items()]),
    }


def targets(count: int) -> str:
    """So many targets, in rows of eight."""
    size = {"width": 60.0, "height": 40.0}
    listed = [{"id": str(i), "x": 200.0 * (i % 8), "y": 150.0 * (i // 8), **size} for i in range(count)]
    return json.dumps({"type": "targets", "targets": listed})


def target_table(one: Server) -> Table:
    """Processor time of a frame of one event, by the number of targets."""
    rows: dict[int, list[str]] = {count: [] for count in TARGETS}
    for encoding in ENCODINGS:
        greeting = hello("switched", encoding)
        groups = [
            Group(
                f"{count}",
                one.port,
                one.pids,
                clients=CLIENTS,
                json=encoding == "json",
                greeting=(greeting, targets(count)) if count else (greeting,),
            )
            for count in TARGETS
        ]
        turns, _ = in_turns(groups)
        for count in TARGETS:
            rows[count].append(quiet(turns[f"{count}"]))
    return Table.of(
        ("targets", *(f"{encoding}, us" for encoding in ENCODINGS)),
        [(f"{count}", *cells) for count, cells in rows.items()],
    )


def main(before: str | None) -> None:
    """Measure, and write the page's numbers."""
    print("measuring what a message costs; this takes about three minutes", file=sys.stderr)
    where = machine(load=True)
    with ExitStack() as stack:
        stack.enter_context(on_cores(LAST))
        one = stack.enter_context(service(raised=True))
        old = stack.enter_context(service(root=checkout(before), raised=True)) if before else None
        tables = {**cost_tables(one, old), "targets": target_table(one)}
    numbers = {"before": before or "", "recording": recording().name}
    keep("costs", tables, part="service", machine=where, numbers=numbers)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--before", metavar="COMMIT", help="another build to measure in turns with this one")
    main(parser.parse_args().before)
