"""A recording in memory: what a source yields and the scorer consumes. All trials lie in one event table."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import RecordingError
from pointpred.records import EventColumns

if TYPE_CHECKING:
    import pandas as pd

UNKNOWN = float("nan")
ABOUT = ("user", "trial", "target_x", "target_y", "target_w", "clean")
"""Of a trial, beside its conditions."""
DETAIL = re.compile(r"""'[^']*'|"[^"]*"|[+-]?\b\d[\d.]*(e[+-]?\d+)?\b""")
"""What differs between reasons of one kind: numbers and quoted words."""


class Trial(msgspec.Struct, frozen=True):
    """Who moved, towards what. The target's centre and width are px, NaN where unknown.

    ``clean`` is the set's own judgement for papers that exclude trials, ``None`` where nobody judged;
    ``condition`` holds whatever else the recording knows (device, block, distance, transfer function).
    """

    user: str
    trial: str
    target_x: float = UNKNOWN
    target_y: float = UNKNOWN
    target_w: float = UNKNOWN
    clean: bool | None = None
    condition: dict[str, str | float] = {}


class Skip(msgspec.Struct, frozen=True):
    """A trial that was left out, and why; ``row`` counts the file's data rows from 0."""

    trial: str
    reason: str
    row: int | None = None
    user: str | None = None

    @property
    def place(self) -> str:
        """Where it was, in words."""
        row = "" if self.row is None else f", data row {self.row} (counted from 0)"
        return f"trial {self.trial}" + ("" if self.user is None else f" of {self.user}") + row


def kinds_of(skips: Iterable[Skip]) -> list[tuple[str, list[Skip]]]:
    """Skips by the kind of their reason, the most frequent first; reasons of a kind differ in details only.

    >>> kinds_of([Skip("1", "4 cells, expected 3"), Skip("2", "5 cells, expected 3")])[0][0]
    '... cells, expected ...'
    """
    kinds: dict[str, list[Skip]] = {}
    for skip in skips:
        kinds.setdefault(DETAIL.sub("...", skip.reason), []).append(skip)
    often = sorted(kinds.items(), key=lambda kind: -len(kind[1]))
    return [(some[0].reason if len({s.reason for s in some}) == 1 else kind, some) for kind, some in often]


class Provenance(msgspec.Struct, frozen=True):
    """What the file said about itself, before it was brought to px, y down and seconds."""

    format: str
    unit: str = "px"
    origin: str = "top left"
    y_axis: str = "down"
    clock: str = "seconds from the trial's start"
    dpi: float = 96.0
    cpi: float | None = None
    simulated: bool = False


IN_MEMORY = Provenance("memory")


class Recording(msgspec.Struct, frozen=True):
    """Trials one after another: rows ``offsets[i]`` up to ``offsets[i + 1]`` are ``trials[i]``.

    ``notes`` say what a reader saw and mended without leaving a trial out.
    """

    name: str
    events: EventColumns
    offsets: NDArray[np.int64]
    trials: tuple[Trial, ...]
    skipped: tuple[Skip, ...] = ()
    provenance: Provenance = IN_MEMORY
    notes: tuple[str, ...] = ()

    @classmethod
    def of(
        cls,
        name: str,
        parts: Sequence[EventColumns],
        trials: Sequence[Trial],
        skipped: Sequence[Skip] = (),
        provenance: Provenance = IN_MEMORY,
        notes: Sequence[str] = (),
    ) -> Recording:
        """A recording from one table a trial; raises RecordingError when the numbers do not match."""
        if len(parts) != len(trials):
            raise RecordingError(f"{name}: {len(parts)} event tables for {len(trials)} trials")
        offsets = np.concatenate([[0], np.cumsum([len(part) for part in parts])]).astype(np.int64)
        table = np.concatenate([part.table for part in parts]) if parts else np.empty((0, 6))
        begin = np.zeros(len(table), dtype=np.bool_)
        begin[offsets[:-1][np.diff(offsets) > 0]] = True
        return cls(
            name, EventColumns(table, begin), offsets, tuple(trials), tuple(skipped), provenance, tuple(notes)
        )

    def __repr__(self) -> str:
        users = len({trial.user for trial in self.trials})
        simulated = ", simulated" if self.provenance.simulated else ""
        skipped = f", {len(self.skipped)} skipped" if self.skipped else ""
        counts = f"{len(self.trials)} trials of {users} people{skipped}, {len(self.events)} events"
        return f"<Recording {self.name}: {counts}{simulated}>"

    def to_pandas(self) -> pd.DataFrame:
        """A ``pandas.DataFrame`` with a row an event.

        Columns: ``user, trial, t_s, x_px, y_px, dx_counts, dy_counts, buttons, begin``, then what is known of
        the trial, ``target_x, target_y, target_w`` (px), ``clean`` and its conditions. ``read_any`` reads it.
        """
        frame = self.events.to_pandas()
        counts = np.diff(self.offsets)
        names = list(dict.fromkeys(name for trial in self.trials for name in trial.condition))
        about: dict[str, list[object]] = {name: [getattr(one, name) for one in self.trials] for name in ABOUT}
        about |= {name: [one.condition.get(name) for one in self.trials] for name in names}
        for place, (name, cells) in enumerate(about.items()):
            column = np.repeat(np.array(cells, dtype=object), counts)
            at = place if name in ABOUT[:2] else len(frame.columns)
            frame.insert(at, name, column)
        return frame.infer_objects()

    def rows(self, trial: int) -> EventColumns:
        """The events of one trial."""
        return self.events.rows(int(self.offsets[trial]), int(self.offsets[trial + 1]))

    def part(self, first: int, stop: int) -> Recording:
        """Trials ``first`` up to ``stop``, without copies; skips and notes stay with the whole."""
        rows = slice(int(self.offsets[first]), int(self.offsets[stop]))
        return msgspec.structs.replace(
            self,
            events=self.events[rows],
            offsets=self.offsets[first : stop + 1] - self.offsets[first],
            trials=self.trials[first:stop],
            skipped=(),
            notes=(),
        )
