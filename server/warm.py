"""Compiled code before the first event: every predictor runs once, so that no client waits for a compiler."""

from __future__ import annotations

from collections.abc import Callable

from pointpred.columns import EventColumns
from pointpred.events import PointerEvent
from pointpred.pipeline import run
from pointpred.registry import REGISTRY, build


def warm(progress: Callable[[int, int, str], None] = lambda done, of, name: None) -> None:
    """Run each predictor over a few events, one by one and as columns; tells how many are done."""
    events = [PointerEvent(0.01 * i, 5.0 * i, 2.0 * i, 4.0, 2.0) for i in range(4)]
    for done, name in enumerate(REGISTRY):
        progress(done, len(REGISTRY), name)
        pipeline = build(name, cpi=1000.0)
        for event in events:
            pipeline.update(event)
        run(pipeline.fresh(), EventColumns.of_events(events))
    progress(len(REGISTRY), len(REGISTRY), "")
