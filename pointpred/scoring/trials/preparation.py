"""What a trial is: from the onset of the movement to the selecting click or the last sample."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.recording import Recording, Skip
from pointpred.records import EventColumns, FloatArray
from pointpred.scoring.results import ScoredTrial
from pointpred.scoring.trials import clean_trials, cutting, submovements

REASONS = {
    cutting.EMPTY: "has no events",
    cutting.ONE_SAMPLE: "has one sample, a movement needs two",
    cutting.UNUSABLE: "a value is not finite or out of range",
    cutting.BACKWARD: "time runs backwards",
    cutting.NEVER_LEFT: f"ends within {cutting.ONSET_PX:g} px of its start",
    cutting.ARRIVED: (
        f"never leaves the {cutting.ARRIVAL_PX:g} px (or {cutting.ARRIVAL_SHARE:.0%}) around its endpoint "
        "after the onset"
    ),
    cutting.INSTANT: "takes no time from onset to arrival",
}


class Prepared(msgspec.Struct, frozen=True):
    """The trials of a recording that can be scored, ready to be replayed.

    ``events`` holds the rows from each onset to each end; rows ``offsets[i]`` up to ``offsets[i + 1]`` are
    ``trials[i]``, the first of them is marked ``begin``; ``arrivals[i]`` is its row of arrival.
    """

    name: str
    events: EventColumns
    offsets: NDArray[np.int64]
    arrivals: NDArray[np.int64]
    trials: tuple[ScoredTrial, ...]
    skipped: tuple[Skip, ...]

    def rows(self, trial: int) -> EventColumns:
        """The events of one trial."""
        return self.events.rows(int(self.offsets[trial]), int(self.offsets[trial + 1]))


def prepare(
    recording: Recording,
    *,
    cpi: float | None = None,
    dpi: float | None = None,
    threads: int | None = None,
) -> Prepared:
    """Cut every trial of a recording to what is scored, and say why the others are left out.

    The trial ends with the selecting click: the last press of the primary button more than 3 px from the
    start; without one, with its last sample. Its last position is the endpoint. The onset is the last sample
    within 3 px of the first position: earlier rows are cut, and distance and progress count from there. The
    arrival is the first sample after which the cursor stays within max(8 px, 3 % of the distance) of the
    endpoint.

    Onset, endpoint and arrival are known only afterwards: they say where to read errors, and no pipeline
    sees them, save that it is reset at the onset. A movement that passes its start again begins there.

    ``cpi`` and ``dpi`` (counts and px per inch) replace the recording's own values; they matter only
    to the speed that decides on sub-movements.

    >>> from pointpred.records import EventColumns, FloatArray
    >>> from pointpred.recording import Trial
    >>> path = EventColumns.of(t=[0.0, 0.1, 0.2, 0.3], x=[0, 1, 60, 100], y=[0, 0, 0, 0])
    >>> trial = prepare(Recording.of("one", [path], [Trial("ann", "1")])).trials[0]
    >>> trial.onset_s, trial.distance_px, round(trial.arrival_s, 9), trial.events
    (0.1, 99.0, 0.2, 3)
    """
    cuts = _cuts(recording)
    good = np.flatnonzero(cuts[:, cutting.VERDICT] == cutting.GOOD)
    onset, stop = cuts[good, cutting.ONSET], cuts[good, cutting.STOP]
    offsets = np.concatenate([[0], np.cumsum(stop - onset)]).astype(np.int64)
    source = np.repeat(onset - offsets[:-1], stop - onset) + np.arange(offsets[-1])
    begin = np.zeros(len(source), dtype=np.bool_)
    begin[offsets[:-1]] = True
    events = EventColumns(recording.events.table[source], begin)
    arrivals = cuts[good, cutting.ARRIVAL] - onset + offsets[:-1]
    divided = submovements(events, offsets, threads=threads, **resolution(recording, cpi, dpi))
    first, last = offsets[:-1], offsets[1:] - 1
    distance = np.hypot(events.x[last] - events.x[first], events.y[last] - events.y[first])
    judged = [recording.trials[k].clean for k in good.tolist()]
    ruled = clean_trials(events, offsets).tolist()
    clean = [rule if own is None else own for own, rule in zip(judged, ruled, strict=True)]
    measured = zip(
        good.tolist(),
        distance.tolist(),
        (events.t[first] - recording.events.t[recording.offsets[good]]).tolist(),
        (events.t[arrivals] - events.t[first]).tolist(),
        divided.tolist(),
        np.diff(offsets).tolist(),
        clean,
        strict=True,
    )
    trials = tuple(ScoredTrial(recording.trials[k], *values) for k, *values in measured)
    skipped = (*recording.skipped, *_skips(recording, cuts))
    return Prepared(recording.name, events, offsets, arrivals, trials, skipped)


def durations_s(recording: Recording) -> FloatArray:
    """The times from onset to arrival of the trials that can be scored, s: what ``prepare`` finds of them."""
    cuts, t = _cuts(recording), recording.events.t
    good = cuts[cuts[:, cutting.VERDICT] == cutting.GOOD]
    spans: FloatArray = t[good[:, cutting.ARRIVAL]] - t[good[:, cutting.ONSET]]
    return spans


def _cuts(recording: Recording) -> cutting.Cuts:
    """Where each trial begins, ends and arrives, a row a trial."""
    cuts = np.empty((len(recording.trials), cutting.CUTS), dtype=np.int64)
    cutting.cut(recording.events.table, recording.offsets, cuts)
    return cuts


def resolution(recording: Recording, cpi: float | None, dpi: float | None) -> dict[str, Any]:
    """The device's and the screen's resolution: the arguments, otherwise the recording's values."""
    provenance = recording.provenance
    return {"cpi": provenance.cpi if cpi is None else cpi, "dpi": provenance.dpi if dpi is None else dpi}


def _skips(recording: Recording, cuts: cutting.Cuts) -> list[Skip]:
    """A skip for each trial that cannot be scored; a faulty event is named by its number in the trial."""
    skips = []
    for k in np.flatnonzero(cuts[:, cutting.VERDICT] != cutting.GOOD).tolist():
        verdict, row = int(cuts[k, cutting.VERDICT]), int(cuts[k, cutting.ROW])
        reason = REASONS[verdict]
        if verdict in (cutting.UNUSABLE, cutting.BACKWARD):
            values = ", ".join(
                f"{name} {value:g}"
                for name, value in zip(EventColumns.names, recording.events.table[row].tolist(), strict=True)
            )
            reason = f"event {row - int(recording.offsets[k])} of the trial: {reason} ({values})"
        skips.append(Skip(recording.trials[k].trial, reason, user=recording.trials[k].user))
    return skips
