"""What an accelerometer on the mouse gains on simulated people: ``python -m pages.accelerometer.measure``."""

from __future__ import annotations

from collections.abc import Callable

import msgspec
import numpy as np

from pages.arguments import parse
from pages.data import Table, keep
from pointpred import Pipeline, build
from pointpred.differentiators.inertial import InertialDifferentiator
from pointpred.recording import Recording
from pointpred.scoring.replay import replay
from pointpred.scoring.trials import Prepared, prepare
from pointpred.simulation import Condition, Setup, people, simulate_circle
from pointpred.simulation.accelerometer import Accelerometer
from pointpred.transfer import ConstantGain

Sensor = Callable[[np.random.Generator], Accelerometer]

CPI = 2000.0
SEED, PEOPLE, TRIALS = 1801, 12, 12
CONDITIONS = (Condition(150.0, 7.0, "constant"), Condition(75.0, 7.0, "sigmoid"))
PREDICTORS = ("hold", "minimum-jerk", "switched", "switched-direction", "kinematic")
SMOOTHED_S = 0.01


def changed(**values: float) -> Sensor:
    """The drawn sensor of each person with some of its numbers replaced."""
    return lambda generator: msgspec.structs.replace(Accelerometer.drawn(generator), **values)


SENSORS: dict[str, Sensor] = {
    "as drawn": Accelerometer.drawn,
    "without any error": lambda _: Accelerometer(),
    "without vibration and turning": changed(vibration=0.0, yaw_rad_m=0.0),
    "vibration 3 1/s": changed(vibration=3.0),
    "turning 10 rad/m": changed(yaw_rad_m=10.0),
    "clock 5 ms behind": changed(offset_s=0.005),
    "clock 5 ms ahead": changed(offset_s=-0.005),
    "200 samples a second": changed(rate_hz=200.0),
}


def recording(sensor: Sensor, period_s: float = 0.001) -> Recording:
    """The circle by people of a seed of their own; the same movements whatever the sensor."""
    setup = Setup(ConstantGain(4.0), period_s=period_s)
    return simulate_circle(
        people(PEOPLE, SEED), CONDITIONS, seed=SEED, trials=TRIALS, setup=setup, accelerometer=sensor
    )


def pipeline(name: str, differentiator: str) -> Pipeline:
    """A predictor behind a differentiator; ``inertial`` by its class."""
    if not differentiator.startswith("inertial"):
        return build(name, cpi=CPI, differentiator=differentiator)
    smoothing = {"smoothing_s": SMOOTHED_S} if differentiator.endswith("ms") else {}
    return Pipeline(name, InertialDifferentiator(cpi=CPI, **smoothing), build(name, cpi=CPI).predictor)


def error(prepared: Prepared, name: str, differentiator: str) -> float:
    """Mean over the trials of the time-averaged error, px; raises where a trial failed."""
    errors = replay(prepared, pipeline(name, differentiator), threads=1)
    if errors.failed:
        raise RuntimeError(f"{name} behind {differentiator} failed: {errors.failed[0].reason}")
    return float(errors.time_averaged.mean())


DIFFERENTIATORS = ("homogeneous", "kalman", "inertial", "inertial, 10 ms")


def predictors(period_s: float) -> Table:
    """Each predictor behind each differentiator, as a share of the error of no prediction."""
    prepared = prepare(recording(Accelerometer.drawn, period_s))
    nothing = error(prepared, "hold", "homogeneous")
    rows = [
        (f"`{name}`", *(f"{error(prepared, name, one) / nothing:.3f}" for one in DIFFERENTIATORS))
        for name in PREDICTORS
    ]
    return Table.of(("predictor", *(f"`{one}`" for one in DIFFERENTIATORS)), rows)


def sensors() -> Table:
    """The sensor's errors one by one."""
    rows = []
    for title, sensor in SENSORS.items():
        prepared = prepare(recording(sensor))
        nothing = error(prepared, "hold", "homogeneous")
        shares = (error(prepared, name, "inertial") / nothing for name in ("hold", "switched", "kinematic"))
        rows.append((title, *(f"{share:.3f}" for share in shares)))
    return Table.of(("sensor", "`hold`", "`switched`", "`kinematic`"), rows)


def main() -> None:
    """Measure."""
    tables = {"fast": predictors(0.001), "slow": predictors(0.008), "sensors": sensors()}
    keep("accelerometer", tables, numbers={"people": PEOPLE, "trials": TRIALS * len(CONDITIONS)})


if __name__ == "__main__":
    parse(__doc__)
    main()
