"""Everything that is measured of trials, an array a measure: chunks of them are put together here."""

from __future__ import annotations

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.recording import Skip
from pointpred.records import EventColumns, FloatArray, PredictionColumns
from pointpred.scoring.measures import endpoint, regions, time_left
from pointpred.scoring.measures.endpoint import DECILES
from pointpred.scoring.results import TIME_FRACTIONS, PredictorErrors
from pointpred.scoring.trials import Prepared

SHARES: FloatArray = np.array(DECILES)
TIMES: FloatArray = np.array(TIME_FRACTIONS)
INSIDE = (len(DECILES), len(regions.LEVELS))


class Claimed(msgspec.Struct, frozen=True):
    """Which claims a predictor makes in a set, and whether the set has targets."""

    regions: bool
    times: bool
    intervals: bool
    """Of the time left."""
    targets: bool

    def __or__(self, other: Claimed) -> Claimed:
        return Claimed(
            self.regions or other.regions,
            self.times or other.times,
            self.intervals or other.intervals,
            self.targets or other.targets,
        )


class TrialMeasures(msgspec.Struct, frozen=True):
    """A row a trial in each array; the laws that fill them say what a row holds."""

    errors: FloatArray
    regions: FloatArray
    inside: FloatArray
    left: FloatArray
    left_inside: FloatArray
    hits: FloatArray

    @classmethod
    def empty(cls, trials: int) -> TrialMeasures:
        """Arrays to be filled."""
        shapes = (
            (endpoint.MEASURES,),
            (regions.WIDTH,),
            INSIDE,
            (time_left.WIDTH,),
            INSIDE,
            (len(TIMES),),
        )
        return cls(*(np.empty((trials, *shape)) for shape in shapes))

    def put(self, first: int, part: TrialMeasures) -> None:
        """Write the rows of a part, from row ``first`` on."""
        stop = first + len(part.errors)
        for name in self.__struct_fields__:
            getattr(self, name)[first:stop] = getattr(part, name)

    def claimed(self) -> Claimed:
        """Which claims there are in any of the trials."""
        timed = bool((self.left[:, time_left.CLAIMED] > 0.0).any())
        return Claimed(
            regions=bool((self.regions[:, regions.CLAIMED] > 0.0).any()),
            times=timed,
            intervals=timed and bool((self.left[:, time_left.SPREAD] > 0.0).any()),
            targets=bool(np.isfinite(self.hits).any()),
        )

    def predictor_errors(
        self, name: str, us_per_event: float, failed: tuple[Skip, ...], claimed: Claimed
    ) -> PredictorErrors:
        """The same as the errors of a predictor; ``None`` for what is not claimed in the whole set."""
        return PredictorErrors(
            name,
            time_averaged=self.errors[:, endpoint.TIME_AVERAGED].copy(),
            by_time=self.errors[:, endpoint.BY_TIME : endpoint.BY_PATH].copy(),
            by_path=self.errors[:, endpoint.BY_PATH : endpoint.SINGLE_AXIS].copy(),
            single_axis=self.errors[:, endpoint.SINGLE_AXIS :].copy(),
            coverage=self.errors[:, endpoint.COVERAGE].copy(),
            us_per_event=us_per_event,
            calibration=self.regions if claimed.regions else None,
            failed=failed,
            inside_by_time=self.inside if claimed.regions else None,
            time_left=self.left if claimed.times else None,
            time_inside_by_time=self.left_inside if claimed.intervals else None,
            hits=self.hits if claimed.targets else None,
        )


def measure_trials(
    prepared: Prepared,
    first: int,
    stop: int,
    events: EventColumns,
    answers: PredictionColumns,
    clock_s: float,
) -> tuple[TrialMeasures, NDArray[np.int64]]:
    """Trials ``first`` up to ``stop``, and the rows where answers were not finite."""
    out, faults = TrialMeasures.empty(stop - first), np.empty(stop - first, dtype=np.int64)
    offsets, arrivals = prepared.offsets[first : stop + 1], prepared.arrivals[first:stop]
    columns = (events.table, answers.table, offsets, arrivals)
    endpoint.measure(events.table, answers.table, endpoint.FRACTIONS, offsets, arrivals, out.errors, faults)
    regions.calibrate(*columns, out.regions)
    regions.inside_by_time(*columns, SHARES, out.inside.reshape(stop - first, -1))
    time_left.time_left(*columns, clock_s, out.left)
    time_left.inside_by_time(*columns, SHARES, out.left_inside.reshape(stop - first, -1))
    endpoint.hits(*columns, endpoint.targets(prepared.trials[first:stop]), TIMES, out.hits)
    return out, faults
