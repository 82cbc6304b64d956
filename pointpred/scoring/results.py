"""What a scoring run yields: a row a trial, so that every table and figure is a view of the same numbers."""

from __future__ import annotations

import msgspec
import numpy as np

from pointpred.recording import Skip, Trial
from pointpred.records import EventColumns, FloatArray, PredictionColumns

PATH_FRACTIONS = (0.10, 0.25, 0.50, 0.75, 0.90, 0.95, 1.00)
"""Shares of the way along the line from start to end at which the 2-D error is read."""
TIME_FRACTIONS = (0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
"""Shares of the time from onset to arrival at which the 2-D error is read."""
AXIS_FRACTIONS = tuple(round(0.05 * i, 2) for i in range(1, 21))
"""Shares of the way along the longer axis in the thesis's single-axis protocol."""
WITH_TARGETS = " + targets"
"""What is added to the name of a predictor that is given the recording's targets."""


class ScoredTrial(msgspec.Struct, frozen=True):
    """A trial that was scored, with what the statistics group by. Distances px, times s."""

    trial: Trial
    distance_px: float
    onset_s: float
    arrival_s: float
    """Time from onset to arrival."""
    submovements: bool
    """Whether the highest speed peak is less than 5 times the next."""
    events: int
    """Events scored: from the onset on."""
    clean: bool = False
    """As the recording judges; where it does not, by the rule of ``clean_trials``."""
    end_repeats: bool = False
    """Whether the person ended a movement before near this end; see ``repeats``."""
    distance_repeats: bool = False
    """Whether a movement before was as long."""


class PredictorErrors(msgspec.Struct, frozen=True):
    """Errors of one predictor in px, a row a trial of the set, in the set's order."""

    name: str
    time_averaged: FloatArray
    """(trials,)"""
    by_time: FloatArray
    """(trials, TIME_FRACTIONS)"""
    by_path: FloatArray
    """(trials, PATH_FRACTIONS)"""
    single_axis: FloatArray
    """(trials, AXIS_FRACTIONS): absolute error along the longer axis"""
    coverage: FloatArray
    """(trials,): share of events with a prediction; elsewhere the cursor's position was scored"""
    us_per_event: float
    """Cost of the whole pipeline in the batch, microseconds of one core."""
    calibration: FloatArray | None = None
    """(trials, 5) as ``calibration`` describes them; ``None`` where no prediction came with a region"""
    failed: tuple[Skip, ...] = ()
    """Trials in which the pipeline failed; they were scored as if it had never answered there."""
    inside_by_time: FloatArray | None = None
    """(trials, DECILES, LEVELS): whether regions held the endpoint; ``None`` where there never was one"""
    time_left: FloatArray | None = None
    """(trials, 7) as ``time_left`` describes them; ``None`` where no prediction came with a time"""
    time_inside_by_time: FloatArray | None = None
    """(trials, DECILES, LEVELS): whether intervals of the time left held the arrival"""
    hits: FloatArray | None = None
    """(trials, TIME_FRACTIONS): whether the prediction lay in the target; ``None`` where none is known"""
    seen: bool = False
    """Whether the predictor was fitted to people of a set of this name: its errors are too low."""
    learns: bool = False
    """Whether it learns from one movement of a person to the next."""
    ablates: str = ""
    """The predictor that this one is without the memory of ends and distances; "" for any other."""


class WorstTrial(msgspec.Struct, frozen=True):
    """One trial with the answers of one predictor, to be drawn."""

    trial: ScoredTrial
    events: EventColumns
    """From the onset on."""
    answers: PredictionColumns
    """A row an event."""
    error_px: float
    """Time-averaged."""

    @property
    def answered(self) -> float:
        """Share of events with an answer."""
        return float(np.isfinite(self.answers.x).mean())


class WorstTrials(msgspec.Struct, frozen=True):
    """The trials with the largest errors of one predictor, the worst first."""

    predictor: str
    trials: tuple[WorstTrial, ...]


class SetScore(msgspec.Struct, frozen=True):
    """One recording scored with several predictors."""

    name: str
    trials: tuple[ScoredTrial, ...]
    skipped: tuple[Skip, ...]
    predictors: tuple[PredictorErrors, ...]
    simulated: bool = False
    """True where people were simulated, which every title states."""
    seed: int = 0
    """Seed of the resampling behind every interval."""
    notes: tuple[str, ...] = ()
    """What the reader of the recording saw and mended."""
    unit: str = "px"
    """Of positions and errors: ``"counts"`` where the recording holds a device's counts and no cursor."""
    candidates: dict[str, int] | None = None
    """What the candidates were, in words, and of how many trials; ``None`` where none were asked for"""
    worst: WorstTrials | None = None
    """Of the best predictor; ``None`` where ``score`` was not asked for them."""
    by: tuple[str, ...] = ()
    """Columns whose levels are groups of trials."""
    contrast: tuple[str, ...] = ()
    """The two predictors that statistics compares; ``("all",)``: every pair; none: nobody asked."""

    def __repr__(self) -> str:
        names = ", ".join(one.name for one in self.predictors)
        return f"<SetScore {self.name}: {len(self.trials)} trials, {len(self.skipped)} skipped; {names}>"
