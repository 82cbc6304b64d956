"""Compiled code before the first event: every predictor runs once, so that no client waits for a compiler."""

from __future__ import annotations

from collections.abc import Callable

from pointpred.columns import EventColumns
from pointpred.events import PointerEvent
from pointpred.pipeline import run
from pointpred.registry import REGISTRY, build
from pointpred.server.records import EVENT, unpack
from pointpred.targets import Chooser, around


def warm(progress: Callable[[int, int, str], bool] = lambda done, of, name: True) -> None:
    """Run each predictor over a few events, one by one and as columns.

    ``progress`` is told how many of how many are done and what comes next, and says whether to go on.
    """
    events = [PointerEvent(0.01 * i, 5.0 * i, 2.0 * i, 4.0, 2.0) for i in range(4)]
    for done, name in enumerate(REGISTRY):
        if not progress(done, len(REGISTRY), name):
            return
        pipeline, chooser = build(name, cpi=1000.0), Chooser([around("any", 200.0, 80.0, 20.0)])
        for event in events:
            chooser.update(pipeline.update(event), event)
        pipeline.reset()  # one that learns its person concludes the movement
        table = EventColumns.of_events(events)
        run(pipeline.fresh(), table)
        pipeline.fresh().advance_all(table.begin, table.table)
    unpack(bytes(2 * EVENT.itemsize))
    progress(len(REGISTRY), len(REGISTRY), "")
