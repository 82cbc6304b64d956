"""Predictors on simulated desktops, and how soon they recover: ``python -m pages.desktop.measure``.

Every person is simulated. The package's own coefficients are used: they were fitted to recordings of real
people and never to a simulated one.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from pages.arguments import parse
from pages.desktop.repeats import repeated
from pages.desktop.tables import FLOOR, Measured, written
from pages.simulation.frames import thinned
from pointpred import Pipeline, build
from pointpred.pipeline import run
from pointpred.records import FloatArray
from pointpred.scoring import Prepared, prepare, resolution
from pointpred.scoring.measures import endpoint
from pointpred.scoring.measures.trial_measures import measure_trials
from pointpred.simulation import people, simulate_desktop
from pointpred.simulation.desktop import SCENARIOS

PEOPLE, MOVEMENTS, SEED = 120, 120, 16
PERIOD_S = 0.008
"""Between events, as of a mouse at 125 Hz."""
ADAPTIVE = "kinematic-adaptive"
NAMED = f"`{ADAPTIVE}`, told the window"
"""It learns places in each window, and they move with it."""


def pipelines(settings: dict[str, Any]) -> dict[str, Pipeline]:
    """No prediction, the learned predictor, and the ways of adapting it."""
    return {
        FLOOR: build("hold", **settings),
        "`kinematic`": build("kinematic", **settings),
        "without places": build(ADAPTIVE, places=0, **settings),
        "places, without their order": build(ADAPTIVE, sequence=0, **settings),
        f"`{ADAPTIVE}`": build(ADAPTIVE, **settings),
        NAMED: build(ADAPTIVE, **settings),
    }


def errors_of(prepared: Prepared, pattern: Pipeline, *, named: bool = False) -> FloatArray:
    """The time-averaged error of each movement, px: one pipeline for each person, in order of recording.

    ``named``: the pipeline is told the window before each movement.
    """
    errors, mine = np.empty(len(prepared.trials)), dict[str, Pipeline]()
    for k, scored in enumerate(prepared.trials):
        pipeline = mine.setdefault(scored.trial.user, pattern.fresh())
        if named:
            of = scored.trial.condition
            pipeline.enter(str(of["window"]), float(of["window_x"]), float(of["window_y"]))
        events = prepared.rows(k)
        measures, _ = measure_trials(prepared, k, k + 1, events, run(pipeline, events), 1.0)
        errors[k] = measures.errors[0, endpoint.TIME_AVERAGED]
    return errors


def measure(scenario: str) -> Measured:
    """One scenario with everybody."""
    session = simulate_desktop(people(PEOPLE, SEED), scenario, seed=SEED, movements=MOVEMENTS)
    recording = thinned(session.recording, PERIOD_S)
    settings = {name: value for name, value in resolution(recording, None, None).items() if value is not None}
    prepared = prepare(recording, **settings)
    rows = {name: k for k, name in enumerate(dict.fromkeys(trial.user for trial in recording.trials))}
    places = tuple(np.array([[rows[one.trial.user], int(one.trial.trial)] for one in prepared.trials]).T)

    def by_person(values: FloatArray) -> FloatArray:
        table = np.full((PEOPLE, MOVEMENTS), np.nan)
        table[places] = values
        return table

    errors = {}
    for title, pattern in pipelines(settings).items():
        errors[title] = by_person(errors_of(prepared, pattern, named=title == NAMED))
        print(f"{scenario}: {title}", flush=True)
    near = {where: by_person(values) for where, values in repeated(prepared).items()}
    return Measured(scenario, session.change, errors, len(prepared.skipped), near)


if __name__ == "__main__":
    parse(__doc__)
    written([measure(scenario) for scenario in SCENARIOS])
