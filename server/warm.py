"""Compiled code before the first event: every predictor runs once, so that no client waits for a compiler.

Where nothing is compiled yet, another process (``python -m
pointpred.server.warm``) compiles from the last one on: what it puts into the cache is only loaded here.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pointpred
from pointpred.columns import EventColumns
from pointpred.compiled import awaits_compiling
from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.events import PointerEvent
from pointpred.pipeline import run
from pointpred.registry import RECOMMENDED, REGISTRY, build
from pointpred.server.protocol.records import EVENT
from pointpred.server.sessions.session import Session
from pointpred.server.settings import Settings
from pointpred.targets import Chooser, around

Frame = dict[str, Any] | bytes
DEAREST = 2
"""The last predictors take longest to compile; the helper does what sessions need after them."""


def warm(progress: Callable[[int, int, str], bool] = lambda done, of, name: True) -> None:
    """Run each predictor over a few events, one by one and as columns.

    ``progress`` is told how many of how many are done and what comes next, and says whether to go on.
    """
    with ExitStack() as until_done:
        if awaits_compiling(HomogeneousDifferentiator.step) and _processors() > 1:
            until_done.callback(_end, _helper())
        for done, name in enumerate(REGISTRY):
            if not progress(done, len(REGISTRY), name):
                return
            warm_one(name)
        warm_session()
    progress(len(REGISTRY), len(REGISTRY), "")


def _processors() -> int:
    """How many this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def warm_one(name: str) -> None:
    """Run one predictor, and what is around it."""
    events = [PointerEvent(0.01 * i, 5.0 * i, 2.0 * i, 4.0, 2.0) for i in range(4)]
    pipeline, chooser = build(name, cpi=1000.0), Chooser([around("any", 200.0, 80.0, 20.0)])
    for event in events:
        chooser.update(pipeline.update(event), event)
    pipeline.reset()  # one that learns its person concludes the movement
    table = EventColumns.of_events(events)
    chooser.reset()
    chooser.follow(table.table, run(pipeline.fresh(), table).table)
    pipeline.fresh().advance_all(table.begin, table.table)


def warm_session() -> None:
    """What clients ask for beside a prediction: a scored trial, targets, packed frames, a helped cursor."""
    hello: dict[str, Any] = {"type": "hello", "version": 1, "predictor": RECOMMENDED, "device": {"cpi": 1000}}
    packed: list[Frame] = [bytes(EVENT.itemsize), bytes(2 * EVENT.itemsize)]
    events: list[Frame] = [{"type": "events", "events": [reach(i) for i in range(60)]}]
    trial: list[Frame] = [
        {"type": "targets", "targets": [{"id": "any", "x": 380, "y": 80, "width": 40, "height": 40}]},
        {"type": "trial", "action": "start"},
        *events,
        {"type": "trial", "action": "end", "target": {"x": 400, "y": 100, "width": 40}},
    ]
    talk([hello, *trial])
    talk([{**hello, "encoding": "binary", "reply": "event"}, *packed, *events])
    talk([{**hello, "assist": {}}, *packed, *events])


def talk(frames: Sequence[Frame]) -> None:
    """Say frames to a session, and let it do the work that they make."""
    session = Session("warm", Settings().limits, 0.0)
    for frame in frames:
        session.receive(frame if isinstance(frame, bytes) else json.dumps(frame), 0.0)
        while session.work is not None:
            session.finish(session.work())
        session.outbox.take()


def reach(i: int) -> list[float]:
    """An event of a movement of 400 px in half a second, in JSON's order."""
    s = min(i / 50, 1.0)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    return [i / 100, 400 * way, 100 * way, 4, 1, 0]


def _helper() -> subprocess.Popen[bytes]:
    """Its input stays open while this process lives, however it ends."""
    command = [sys.executable, "-P", "-m", "pointpred.server.warm"]
    package = str(Path(pointpred.__file__).parent.parent)  # the folder of the user may hold another one
    found = os.pathsep.join(filter(None, (package, os.environ.get("PYTHONPATH"))))
    quiet = subprocess.DEVNULL
    return subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=quiet, stderr=quiet, env=os.environ | {"PYTHONPATH": found}
    )


def _end(helper: subprocess.Popen[bytes]) -> None:
    helper.kill()  # what it has written is whole: the cache puts files in place at once
    helper.communicate()


def _leave_with_parent() -> None:
    """End as soon as the process that asked for help has ended, however it did."""
    while os.read(0, 4096):  # not sys.stdin: its lock would be held when the interpreter ends
        pass
    os._exit(1)


if __name__ == "__main__":
    threading.Thread(target=_leave_with_parent, daemon=True).start()
    for number, predictor in enumerate(reversed(REGISTRY)):
        if number == DEAREST:
            warm_session()
        warm_one(predictor)
