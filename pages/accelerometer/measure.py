"""What an accelerometer on the mouse gains on simulated people: ``python -m pages.accelerometer.measure``.

``python -m pages.accelerometer.measure tune`` repeats the choice of the differentiator's averaging time, on
other people.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import msgspec
import numpy as np

from pages.accelerometer.smoother import Smoother
from pages.arguments import parse
from pages.data import Table, keep
from pointpred import Pipeline, build
from pointpred.differentiators.bounds import SENSED_BOUNDS, measure_sensed
from pointpred.differentiators.signals import SENSED_SIGNALS
from pointpred.recording import Recording
from pointpred.records import FloatArray
from pointpred.scoring.replay import replay
from pointpred.scoring.summary.bootstrap import ratio_intervals
from pointpred.scoring.trials import Prepared, prepare
from pointpred.simulation import Condition, Setup, people, simulate_circle
from pointpred.simulation.accelerometer import Accelerometer
from pointpred.transfer import ConstantGain

Sensor = Callable[[np.random.Generator], Accelerometer]

CPI = 2000.0
SEED, PEOPLE, TRIALS = 1901, 24, 12
"""People on whom nothing was chosen."""
TUNING_SEED, TUNING_PEOPLE = 2901, 12
CONDITIONS = (Condition(150.0, 7.0, "constant"), Condition(75.0, 7.0, "sigmoid"))
PREDICTORS = ("minimum-jerk", "switched", "switched-direction", "kinematic")
POSITIONS = ("homogeneous", "kalman")
FUSED, FUTURE = "inertial", "smoother"
COMPARED = (*POSITIONS, FUSED, FUTURE)
SMOOTHINGS_S = (0.003, 0.005, 0.01, 0.015, 0.02, 0.03)


def changed(**values: float) -> Sensor:
    """The drawn sensor of each person with some of its numbers replaced."""
    return lambda generator: msgspec.structs.replace(Accelerometer.drawn(generator), **values)


SENSORS: dict[str, Sensor] = {
    "as drawn": Accelerometer.drawn,
    "without any error": lambda _: Accelerometer(),
    "vibration 3 1/s": changed(vibration=3.0),
    "turning 10 rad/m": changed(yaw_rad_m=10.0),
    "clock 5 ms behind": changed(offset_s=0.005),
    "clock 5 ms ahead": changed(offset_s=-0.005),
    "samples come 10 ms late": changed(late_s=0.01),
    "200 samples a second": changed(rate_hz=200.0),
}


def recording(sensor: Sensor, period_s: float = 0.001, seed: int = SEED, count: int = PEOPLE) -> Recording:
    """The circle by people of a seed of their own; the same movements whatever the sensor."""
    setup = Setup(ConstantGain(4.0), period_s=period_s)
    return simulate_circle(
        people(count, seed), CONDITIONS, seed=seed, trials=TRIALS, setup=setup, accelerometer=sensor
    )


def each_alone(one: Recording) -> Recording:
    """The same trials, each by somebody who has not moved before."""
    trials = [msgspec.structs.replace(trial, user=f"{trial.user} {k}") for k, trial in enumerate(one.trials)]
    return msgspec.structs.replace(one, trials=tuple(trials))


def pipeline(name: str, differentiator: str, **parameters: float) -> Pipeline:
    """A predictor behind a differentiator."""
    if differentiator != FUTURE:
        return build(name, cpi=CPI, differentiator=differentiator, **parameters)
    return Pipeline(name, Smoother(cpi=CPI), build(name, cpi=CPI).predictor)


def errors(prepared: Prepared, name: str, differentiator: str, **parameters: float) -> FloatArray:
    """The time-averaged error of each trial, px; raises where a trial failed."""
    scored = replay(prepared, pipeline(name, differentiator, **parameters), threads=1)
    if scored.failed:
        raise RuntimeError(f"{name} behind {differentiator} failed: {scored.failed[0].reason}")
    return scored.time_averaged


def ratio(above: FloatArray, below: FloatArray, users: Sequence[str]) -> str:
    """The ratio of two means and its interval over people."""
    bounds = ratio_intervals(above[:, None], below[:, None], users)
    return f"{above.mean() / below.mean():.3f} ({bounds.low[0]:.3f} to {bounds.high[0]:.3f})"


def predictors(one: Recording, *, alone: bool = False) -> Table:
    """Each predictor behind each differentiator, as a share of no prediction, and one beside another."""
    users = [scored.trial.user for scored in prepare(one).trials]
    prepared = prepare(each_alone(one) if alone else one)
    nothing = errors(prepared, "hold", "homogeneous")
    rows = []
    for name in PREDICTORS:
        by = {each: errors(prepared, name, each) for each in COMPARED}
        shares = (f"{by[each].mean() / nothing.mean():.3f}" for each in COMPARED)
        beside = (ratio(by[FUSED], by[each], users) for each in POSITIONS)
        rows.append((f"`{name}`", *shares, *beside))
    columns = ("predictor", *(f"`{each}`" for each in (*POSITIONS, FUSED)), "smoother that sees ahead")
    return Table.of((*columns, *(f"`{FUSED}` / `{each}`" for each in POSITIONS)), rows)


def sensors() -> Table:
    """The sensor's errors one by one, each beside the Kalman filter on the same movements."""
    rows = []
    for title, sensor in SENSORS.items():
        one = recording(sensor)
        prepared = prepare(one)
        users = [scored.trial.user for scored in prepared.trials]
        cells = (
            ratio(errors(prepared, name, FUSED), errors(prepared, name, "kalman"), users)
            for name in ("minimum-jerk", "kinematic")
        )
        rows.append((title, *cells))
    return Table.of(("sensor", "`minimum-jerk`", "`kinematic`"), rows)


def tuning() -> Table:
    """The averaging time of the acceleration, on people who are not in the other tables."""
    one = recording(Accelerometer.drawn, seed=TUNING_SEED, count=TUNING_PEOPLE)
    prepared = prepare(one)
    nothing = errors(prepared, "hold", "homogeneous").mean()
    rows = [
        (
            f"{1e3 * seconds:g}",
            *(
                f"{errors(prepared, name, FUSED, smoothing_s=seconds).mean() / nothing:.3f}"
                for name in PREDICTORS
            ),
        )
        for seconds in SMOOTHINGS_S
    ]
    return Table.of(("averaged over ms", *(f"`{name}`" for name in PREDICTORS)), rows)


def bounds() -> Table:
    """Errors of velocity and acceleration with samples, with the bounds that the tests hold them to."""
    rows = []
    for title, signal in SENSED_SIGNALS.items():
        for name, row in SENSED_BOUNDS.items():
            got, most = measure_sensed(name, signal()), row[title]
            pairs = [
                (got.velocity_rms, most.velocity_rms),
                (got.velocity_largest, most.velocity_largest),
                (got.acceleration_rms, most.acceleration_rms),
                (got.acceleration_largest, most.acceleration_largest),
            ]
            late = f"{1e3 * (got.delay_s or 0.0):+.1f} ({1e3 * (most.delay_s or 0.0):.1f})"
            rows.append((f"`{name}`", title, *(f"{value:.2g} ({bound:.2g})" for value, bound in pairs), late))
    names = "velocity RMS m/s", "largest", "acceleration RMS m/s²", "largest", "peak late ms"
    return Table.of(("differentiator", "signal", *names), rows)


def main(parts: Sequence[str]) -> None:
    """Measure."""
    if parts:
        keep("accelerometer", {"tuning": tuning()}, numbers={"tuning_people": TUNING_PEOPLE})
        return
    fast = recording(Accelerometer.drawn)
    tables = {
        "bounds": bounds(),
        "fast": predictors(fast),
        "slow": predictors(recording(Accelerometer.drawn, 0.008)),
        "first": predictors(fast, alone=True),
        "sensors": sensors(),
    }
    keep("accelerometer", tables, numbers={"people": PEOPLE, "trials": TRIALS * len(CONDITIONS)})


if __name__ == "__main__":
    main(parse(__doc__, metavar="PART", choices=("tune",), most=1))
