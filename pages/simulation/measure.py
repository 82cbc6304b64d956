"""Compare the simulated people with recorded ones: ``python -m pages.simulation.measure``.

Recordings come from the folder named by POINTPRED_RECORDINGS; a
set that is absent is left out of the table, and the page names it.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np

from pages import FIGURES
from pages.arguments import parse
from pages.data import Table, keep
from pages.simulation import figures as simulation_figures
from pages.simulation.frames import thinned
from pages.simulation.shape import Shape, shapes
from pointpred import build, recordings
from pointpred.recording import Recording
from pointpred.regression import DynamicRegressorExtension
from pointpred.simulation import Aim, Setup, people, thesis_setup
from pointpred.simulation.movement import Movement, move, move_assisted
from pointpred.simulation.validation import corrective_signals
from pointpred.transfer import ConstantGain

SETS = ("freihaut2021", "gofitts_demo", "humanmovemouse", "cryslacks")
NEAREST_PX = 150.0
FRAME_S = 0.017
SEED = 0
NUMBERS: dict[str, Callable[[Shape], float]] = {
    "movement time s": lambda s: s.movement_s,
    "peak at share of time": lambda s: s.peak_share,
    "path / distance": lambda s: s.path_ratio,
    "peak speed x time / distance": lambda s: s.sharpness,
}


def row(title: str, recording: Recording, chosen: Callable[[int], bool] = lambda _: True) -> tuple[str, ...]:
    """Quartiles of each number over the movements of at least 150 px."""
    group = [s for i, s in enumerate(shapes(recording)) if s and chosen(i) and s.distance_px >= NEAREST_PX]
    cells = []
    for number in NUMBERS.values():
        low, middle, high = np.quantile([number(s) for s in group], [0.25, 0.5, 0.75])
        cells.append(f"{middle:.2f} ({low:.2f}-{high:.2f})")
    whole = 100 * np.mean([s.one_piece for s in group])
    return (title, str(len(group)), *cells, f"{whole:.0f} %")


def comparison(simulated: Recording) -> tuple[Table, list[str]]:
    """The table of simulated and recorded people, and the sets that are not there."""
    slow = thinned(simulated, FRAME_S)
    skills = [float(trial.condition["skill"]) for trial in simulated.trials]
    rows = [
        row("simulated, all, 60 Hz", slow),
        row("simulated, skill > 0.8, 60 Hz", slow, lambda i: skills[i] > 0.8),
        row("simulated, skill < 0.2, 60 Hz", slow, lambda i: skills[i] < 0.2),
        row("simulated, all, 1 kHz", simulated),
    ]
    folder, absent = os.environ.get("POINTPRED_RECORDINGS"), []
    for name in SETS:
        path = Path(folder or "") / f"{name}_samples.parquet"
        if folder and path.exists():
            rows.append(row(f"recorded, {name}", recordings.read(path)))
        else:
            absent.append(name)
    header = ("people", "movements", *NUMBERS, "one piece")
    return Table.of(header, rows), absent


def assistance() -> Table:
    """Time to the click with an assisted transfer function, by how far its estimate is off."""
    persons, target = people(10, SEED), Aim(520.0, -226.0, 26.0)

    def cell(rho: float, strength: float, off_px: float) -> str:
        setup = Setup(ConstantGain(4.0), rho=rho, strength=strength)
        endpoint = (target.x, target.y + off_px)
        return click_times(
            [move(p, setup, target, np.random.default_rng([SEED, i, k]), endpoint)
             for i, p in enumerate(persons) for k in range(20)], target
        )  # fmt: skip

    rows = []
    for rho, strength in ((0.0, 0.5), (2.0, 0.5), (8.0, 0.5), (2.0, np.inf), (8.0, np.inf)):
        bound = "-" if rho == 0.0 else f"{strength:g}"
        rows.append((f"{rho:g}", bound, *(cell(rho, strength, off) for off in (0.0, 20.0, 60.0, 150.0))))
    for name in ("minimum-jerk", "hold"):
        pipeline = build(name, cpi=2000.0)
        setup = Setup(ConstantGain(4.0), rho=2.0, strength=0.5)
        movements = [
            move_assisted(p, setup, target, np.random.default_rng([SEED, i, k]), pipeline)
            for i, p in enumerate(persons)
            for k in range(3)
        ]
        rows.append(("2", "0.5", f"`{name}` in the loop: {click_times(movements, target)}", "", "", ""))
    return Table.of(("rho 1/s", "bound", "true endpoint", "20 px off", "60 px off", "150 px off"), rows)


def click_times(movements: list[Movement], target: Aim) -> str:
    """Mean time to the click, and the share of clicks outside the target."""
    ends = np.array([one.table[-1, 1:3] for one in movements]) - (target.x, target.y)
    missed = float((np.hypot(*ends.T) > target.width / 2).mean())
    return f"{np.mean([one.click_s for one in movements]):.2f} s, {100 * missed:.0f} % missed"


def recovered() -> Table:
    """T, b1/b2 and 1/b2 from the signals of section 2.6.2 by DREM."""
    signals = corrective_signals(duration_s=5.0)
    rows = []
    for delay_s in (0.1, 0.02):
        stage = DynamicRegressorExtension(3, delay_s=delay_s, gamma=1.14e14)
        for t, x, v, a in zip(signals.t, signals.x, signals.v, signals.a, strict=True):
            answer = stage.update((-a, -v, 1.0), x, t)
        assert answer is not None
        inverse, ratio, goal = answer.values
        rows.append((f"{delay_s:g}", f"{goal:.2f}", f"{ratio:.5f}", f"{inverse:.5f}"))
    rows.append(("true", "600", f"{4 / 7:.5f}", f"{1 / 7:.5f}"))
    return Table.of(("delay tau s", "T px", "b1 / b2", "1 / b2"), rows)


def main() -> None:
    """Measure, and draw the figures."""
    simulated = thesis_setup(SEED)
    compared, absent = comparison(simulated)
    tables = {"comparison": compared, "assistance": assistance(), "recovered": recovered()}
    keep("simulation", tables, numbers={"absent": absent})
    simulation_figures.draw(simulated, FIGURES)


if __name__ == "__main__":
    parse(__doc__)
    main()
