"""What prediction in a page costs: ``python -m evidence costs in_page``.

The sizes of ``evidence.costs.page_size``, the costs of ``page_cost.mjs`` in Node's V8 and the shares
of a core of ``evidence.costs.page_cost``. Needs node, npm and Chromium.
"""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

from evidence.arguments import parse
from evidence.costs import page_cost, page_size
from evidence.data import Table, keep
from evidence.machine import machine

SIZED = ("minimum-jerk", "switched-direction", "switched", "kinematic-adaptive")
IN_VIEW = (1000, 100)


def sizes() -> Table:
    """What is loaded for ``onIntent`` with a predictor, its coefficients included."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name in SIZED:
            count, plain, bundled = page_size.sizes("intent/register.js", name, Path(folder))
            if bundled is None:
                raise SystemExit("npm cannot fetch esbuild: the size of a bundle is not known")
            rows.append((f"`{name}`", str(count), f"{plain / 1000.0:.1f}", f"{bundled / 1000.0:.1f}"))
    return Table.of(("predictor", "files", "plain files, kB", "one minified file, kB"), rows)


def events() -> Table:
    """What an event costs, alone and with 100 targets."""
    script = Path(__file__).with_name("page_cost.mjs")
    done = subprocess.run(["node", str(script)], capture_output=True, text=True, check=True)
    rows = [line.split() for line in done.stdout.splitlines()]
    columns = ("predictor", "an event, us", "with 100 targets, us")
    return Table.of(columns, [(f"`{name}`", *numbers) for name, *numbers in rows])


def pages() -> Table:
    """The share of a core of a page while its mouse moves at 1 kHz."""
    rows = []
    for in_view in IN_VIEW:
        rows += [
            (str(in_view), name, f"{100.0 * one.process:.1f}", f"{100.0 * one.more:.1f}")
            for name, one in page_cost.costs(in_view).items()
        ]
    columns = ("in view", "registered with", "process, %", "more than without, %")
    return Table.of(columns, rows)


def main() -> None:
    """Measure, print and write."""
    where = machine(load=True)
    tables = {"sizes": sizes(), "in_page_events": events(), "in_page_share": pages()}
    for table in tables.values():
        for row in table.rows:
            print("  ".join(map(str, row)))
    keep("costs", tables, part="in_page", machine=where)


if __name__ == "__main__":
    parse(__doc__)
    main()
