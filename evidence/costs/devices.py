"""What live devices cost: ``python -m evidence costs devices``.

``realtime`` after it runs the mouse and its reader before everything else, on a machine that others use.
"""

from __future__ import annotations

import os
import time
import timeit
from functools import partial

from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.machine import machine
from pointpred.devices.hid import parse_descriptor
from tests.devices.live_mouse import Live, measure
from tests.devices.mice import ENCODERS
from tests.devices.umockdev import missing

REALTIME = "realtime"
ROUNDS, CALLS = 15, 20_000
RUNS = ((1000.0, 20.0), (8000.0, 60.0))
"""Reports a second, and for how many seconds."""
PREDICTOR = "switched"


def decoding_rows() -> list[tuple[str, ...]]:
    """Processor time of one report, in the quietest of several rounds."""
    rows = []
    for mouse, encode, _ in ENCODERS:
        decoder = parse_descriptor(mouse.descriptor)
        for report in encode(5, -7, 1, 1, -1):
            rounds = timeit.repeat(
                partial(decoder.decode, report),
                number=CALLS,
                repeat=ROUNDS,
                timer=time.process_time,
            )
            row = mouse.name, f"{len(report)}", f"{len(mouse.descriptor)}", f"{min(rounds) / CALLS * 1e6:.2f}"
            rows.append(row)
            print("  ".join(row))
    return rows


def live_rows(realtime: bool) -> list[tuple[str, ...]]:
    """Mice that report for a while; raises RuntimeError where none can be emulated."""
    if why := missing():
        raise RuntimeError(why)
    rows = []
    for rate_hz, seconds in RUNS:
        if realtime:
            os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(5))
        rows.append(_row(measure(rate_hz, seconds, PREDICTOR), seconds))
        os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))
        print("  ".join(rows[-1]))
    return rows


def _row(live: Live, seconds: float) -> tuple[str, ...]:
    return (
        f"{live.rate_hz:.0f}",
        f"{seconds:.0f}",
        f"{live.reports}",
        f"{live.dropped}",
        f"{live.lost}",
        f"{live.unreadable}",
        "yes" if live.exact else "no",
        *(f"{1e3 * each:.3f}" for each in (*live.predicted, *live.written)),
        f"{100 * live.reader_share:.0f} %",
        f"{100 * live.writer_share:.0f} %",
    )


DECODING = ("mouse", "bytes a report", "bytes of the descriptor", "us a report")
LIVE = (
    *("reports/s", "s", "reports", "dropped by the ring", "lost in the queue", "unreadable", "counts add up"),
    *(f"stamp to prediction, {which}, ms" for which in ("median", "99 %", "longest")),
    *(f"write to prediction, {which}, ms" for which in ("median", "99 %", "longest")),
    *("reader, of one core", "writer, of the other"),
)


def main(wanted: list[str]) -> None:
    realtime = wanted == [REALTIME]
    where = machine(load=True)
    if realtime:
        where += "; the mouse and its reader ran before everything else (SCHED_RR), the decoder did not"
    tables = {"decoding": Table.of(DECODING, decoding_rows()), "live": Table.of(LIVE, live_rows(realtime))}
    keep("costs", tables, part="devices", machine=where)


if __name__ == "__main__":
    main(parse(__doc__, metavar=REALTIME, choices=[REALTIME], most=1))
