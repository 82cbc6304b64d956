"""A set that was scored in chunks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import msgspec
import numpy as np

from pointpred.pipeline import Pipeline
from pointpred.scoring import SetScore, SetSummary, prepare
from pointpred.scoring.batch.part_store import PartStore
from pointpred.scoring.batch.plan import Chunk, read
from pointpred.scoring.replay import answers_to
from pointpred.scoring.results import WorstTrial, WorstTrials
from pointpred.scoring.scorer import Scoring, with_trials, worst_of
from pointpred.scoring.summary import summarise_parts


class ScoredSet(msgspec.Struct, frozen=True):
    """One recording scored; the rows of its trials are in ``store``, chunk by chunk."""

    about: SetScore
    """Everything that has no row a trial."""
    chunks: Sequence[Chunk]
    store: PartStore
    scoring: Scoring
    pipelines: Mapping[str, Pipeline]

    @property
    def name(self) -> str:
        """The recording's."""
        return self.about.name

    def parts(self) -> Iterator[SetScore]:
        """The set chunk by chunk, from the first one on."""
        for number in range(len(self.chunks)):
            yield with_trials(self.about, [self.store.part(number)])

    def summary(self) -> SetSummary:
        """Its numbers, with one chunk in memory at a time."""
        return summarise_parts(self.about, self.parts)

    def joined(self, worst: int = 0) -> SetScore:
        """The set in memory, about 1 kB for each trial and predictor, with its ``worst`` trials."""
        whole = with_trials(self.about, map(self.store.part, range(len(self.chunks))))
        return msgspec.structs.replace(whole, worst=self._worst(whole, worst)) if worst else whole

    def _worst(self, whole: SetScore, count: int) -> WorstTrials:
        """The worst trials; the chunks that hold them are read again."""
        errors, numbers = worst_of(whole, count)
        ends = np.cumsum([len(self.store.part(number).trials) for number in range(len(self.chunks))])
        worst = []
        for k in numbers:
            number = int(np.searchsorted(ends, k, side="right"))
            prepared = prepare(
                read(self.chunks[number]), cpi=self.scoring.cpi, dpi=self.scoring.dpi, threads=1
            )
            own = k - (int(ends[number - 1]) if number else 0)
            answers = answers_to(prepared, self.pipelines[errors.name], own)
            worst.append(
                WorstTrial(whole.trials[k], prepared.rows(own), answers, float(errors.time_averaged[k]))
            )
        return WorstTrials(errors.name, tuple(worst))
