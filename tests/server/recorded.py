"""What the tests of the recorder share: sessions fed from the embedded sample."""

from __future__ import annotations

from collections.abc import Callable
from datetime import UTC, datetime

import numpy as np

from pointpred import build, run
from pointpred.datasets import sample
from pointpred.protocol.client_messages import Device, Goal, Hello, Screen
from pointpred.recorder.writer import Recorder, SessionRecorder
from pointpred.recording import Recording
from pointpred.records import EventColumns, PredictionColumns

HELLO = Hello(1, "switched", device=Device(cpi=800.0), screen=Screen(dpi=110.0))
BEGUN = datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC)
"""The day of the recorders that ``opened`` makes."""
Opened = Callable[..., Recorder]


def begin(recorder: Recorder, name: str = "one", hello: Hello = HELLO) -> SessionRecorder:
    session = recorder.open(name, hello)
    assert session is not None
    return session


def feed(session: SessionRecorder, events: EventColumns, pieces: int = 7) -> PredictionColumns:
    """Send events piece by piece with their predictions."""
    pipeline = build("switched", cpi=800.0, dpi=110.0)
    answers = []
    for rows in np.array_split(events.table, pieces):
        part = EventColumns(rows)
        answers.append(run(pipeline, part).table)
        session.events(part, PredictionColumns(answers[-1]))
    return PredictionColumns(np.concatenate(answers))


def record(recorder: Recorder, trials: range, *, marks: bool) -> tuple[SessionRecorder, Recording]:
    source = sample()
    session = begin(recorder)
    for index in trials:
        known = source.trials[index]
        if marks:
            session.trial("start", Goal(known.target_x, known.target_y, known.target_w))
        feed(session, source.rows(index))
        if marks:
            session.trial("end")
    session.close()
    return session, source
