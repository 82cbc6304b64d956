"""Recorded movements as the load generator replays them: at any rate, in whole frames."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache

import numpy as np
from numpy.typing import NDArray

from evidence.sets import folder
from pointpred.datasets import sample
from pointpred.protocol.frames import NO_COUNTS
from pointpred.recording import Recording
from pointpred.recordings import read
from pointpred.records import FloatArray

SECONDS = 10.0
"""Movements of so many seconds are replayed; each client begins at another of them."""
LONGEST_S = 5.0
"""Trials with longer pauses than this are left out."""
SETS = ("kh2017", "freihaut2021", "cryslacks")
"""Sets of people, of which the first that the folder holds is used."""
EVENTS = np.dtype(
    [
        ("begin", "u1"),
        ("text_size", "u1"),
        ("x", "<f8"),
        ("y", "<f8"),
        ("dx", "<i2"),
        ("dy", "<i2"),
        ("buttons", "<u2"),
        ("text", "S102"),
    ]
)
"""An event without its time, packed as on the wire and as JSON: ``struct event`` of ``client.h``."""


@cache
def recording() -> Recording:
    """Recorded movements of people where there are any, else the embedded sample."""
    where = folder()
    files = [file for name in SETS if where for file in sorted(where.glob(f"{name}_samples.*"))]
    return read(files[0]) if files else sample()


def hello(predictor: str, encoding: str = "binary", **fields: object) -> str:
    """The first message of a session whose device is that of the recording."""
    cpi = recording().provenance.cpi
    device = {} if cpi is None else {"device": {"cpi": cpi}}
    return json.dumps(
        {"type": "hello", "version": 1, "predictor": predictor, "encoding": encoding, **device, **fields}
    )


def tables() -> Iterator[FloatArray]:
    """The trials, in an order that does not go person by person."""
    source = recording()
    for trial in np.random.default_rng(17).permutation(len(source.trials)):
        first, last = source.offsets[trial], source.offsets[trial + 1]
        table = source.events.table[first:last]
        if len(table) > 2 and table[-1, 0] - table[0, 0] <= LONGEST_S:
            yield table


def resampled(table: FloatArray, rate_hz: float) -> FloatArray:
    """A movement at another rate: positions between the recorded ones, counts that add up as recorded.

    Counts are NaN where the recording has none.
    """
    t = table[:, 0]
    times = np.arange(t[0], t[-1], 1.0 / rate_hz)
    new = np.empty((len(times), 6))
    new[:, 0] = times
    for column in (1, 2):
        new[:, column] = np.round(np.interp(times, t, table[:, column]), 2)
    for column in (3, 4):
        counts = np.cumsum(table[:, column])
        new[:, column] = np.diff(np.round(np.interp(times, t, counts)), prepend=0.0)
    new[:, 5] = table[np.searchsorted(t, times, side="right") - 1, 5]
    return new


@cache
def track(rate_hz: float, size: int) -> NDArray[np.void]:
    """Movements at ``rate_hz``, each a whole number of frames of ``size`` events."""
    parts, missing = [], SECONDS * rate_hz
    for table in tables():
        rows = resampled(table, rate_hz)
        if whole := len(rows) // size * size:
            parts.append(_packed(rows[:whole]))
            missing -= whole
        if missing <= 0:
            break
    return np.concatenate(parts)


def _packed(rows: FloatArray) -> NDArray[np.void]:
    events = np.zeros(len(rows), EVENTS)
    events["begin"][0] = 1
    for column, name in enumerate(("x", "y", "dx", "dy", "buttons"), 1):
        events[name] = np.nan_to_num(rows[:, column], nan=NO_COUNTS)
    texts = []
    for _, x, y, dx, dy, buttons in rows.tolist():
        counts = "null,null" if dx != dx or dy != dy else f"{dx:.0f},{dy:.0f}"
        texts.append(f",{x},{y},{counts},{buttons:.0f}]")
    events["text"] = texts
    events["text_size"] = [len(text) for text in texts]
    return events
