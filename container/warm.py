"""Compile every predictor once, both ways of use: a container then starts with its cache full."""

from __future__ import annotations

import numpy as np

from pointpred import EventColumns, PointerEvent, build, run
from pointpred.datasets import sample
from pointpred.registry import REGISTRY
from pointpred.scoring import prepare, replay


def main() -> None:
    """Run every pipeline on a trial as a table and event by event, and score it."""
    recording = sample()
    events = EventColumns(np.ascontiguousarray(recording.rows(0).table[:200]))
    for name in REGISTRY:
        pipeline = build(name, cpi=recording.provenance.cpi, dpi=recording.provenance.dpi)
        run(pipeline, events)
        pipeline.reset()
        for event in events.events():
            pipeline.update(event)
        pipeline.update(PointerEvent(1e6, 0.0, 0.0))
        replay(prepare(recording, threads=1), pipeline, threads=1)
    print(f"{len(REGISTRY)} predictors are compiled")


if __name__ == "__main__":
    main()
