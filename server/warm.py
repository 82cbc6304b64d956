"""Compiled code before the first event: every predictor runs once, so that no client waits for a compiler.

Where the first predictor shows that nothing is compiled yet, another process (``python -m
pointpred.server.warm``) compiles from the last one on: what it puts into the cache is only loaded here.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack

from pointpred.columns import EventColumns
from pointpred.events import PointerEvent
from pointpred.pipeline import run
from pointpred.registry import REGISTRY, build
from pointpred.server.records import EVENT, unpack
from pointpred.targets import Chooser, around
from pointpred.transfer import ConstantGain, GuardedTransfer

COMPILES_S = 1.0
"""A predictor that takes longer was not in the cache."""


def warm(progress: Callable[[int, int, str], bool] = lambda done, of, name: True) -> None:
    """Run each predictor over a few events, one by one and as columns.

    ``progress`` is told how many of how many are done and what comes next, and says whether to go on.
    """
    with ExitStack() as until_done:
        for done, name in enumerate(REGISTRY):
            if not progress(done, len(REGISTRY), name):
                return
            began = time.monotonic()
            warm_one(name)
            if done == 0 and time.monotonic() - began > COMPILES_S and (os.cpu_count() or 1) > 1:
                until_done.callback(_end, _helper())
        unpack(bytes(2 * EVENT.itemsize))
        GuardedTransfer(ConstantGain(), cpi=1000.0).advance(0.0, 4.0, 2.0)
    progress(len(REGISTRY), len(REGISTRY), "")


def warm_one(name: str) -> None:
    """Run one predictor, and what is around it."""
    events = [PointerEvent(0.01 * i, 5.0 * i, 2.0 * i, 4.0, 2.0) for i in range(4)]
    pipeline, chooser = build(name, cpi=1000.0), Chooser([around("any", 200.0, 80.0, 20.0)])
    for event in events:
        chooser.update(pipeline.update(event), event)
    pipeline.reset()  # one that learns its person concludes the movement
    table = EventColumns.of_events(events)
    run(pipeline.fresh(), table)
    pipeline.fresh().advance_all(table.begin, table.table)


def _helper() -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "pointpred.server.warm"]
    quiet = subprocess.DEVNULL
    return subprocess.Popen(command, stdin=quiet, stdout=quiet, stderr=quiet)


def _end(helper: subprocess.Popen[bytes]) -> None:
    helper.kill()  # what it has written is whole: the cache puts files in place at once
    helper.wait()


if __name__ == "__main__":
    for predictor in reversed(REGISTRY):
        warm_one(predictor)
