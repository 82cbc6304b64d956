"""The figures of docs/evidence/simulation.md; every title says that its people are simulated."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from pages.simulation.shape import Shape, shapes, speeds
from pointpred.recording import Recording
from pointpred.regression import DynamicRegressorExtension
from pointpred.simulation.validation import corrective_signals, minimum_jerk_check


def draw(simulated: Recording, folder: Path) -> None:
    """Write all four."""
    import matplotlib as mpl

    mpl.use("Agg")
    folder.mkdir(parents=True, exist_ok=True)
    forms = shapes(simulated)
    _trials(simulated, forms, folder / "simulation-trials.png")
    _paths(simulated, folder / "simulation-paths.png")
    _corrective(folder / "simulation-corrective.png")
    _minimum_jerk(folder / "simulation-minimum-jerk.png")


def _save(figure: Any, path: Path) -> None:
    import matplotlib.pyplot as plt

    figure.savefig(path, dpi=100, metadata={"Software": None})
    plt.close(figure)


def _person(simulated: Recording, expert: bool) -> str:
    """The most or the least skilled person."""
    choose = max if expert else min
    return choose(simulated.trials, key=lambda trial: float(trial.condition["skill"])).user


def _typical(simulated: Recording, forms: list[Shape | None], user: str, one_piece: bool) -> int:
    """A trial of the user over 150 mm, with or without sub-movements, of the middle movement time."""
    candidates = [
        (form.movement_s, i)
        for i, (trial, form) in enumerate(zip(simulated.trials, forms, strict=True))
        if trial.user == user and form and trial.condition["distance_mm"] == 150.0
        if form.one_piece == one_piece
    ]
    return sorted(candidates)[len(candidates) // 2][1]


def _trials(simulated: Recording, forms: list[Shape | None], path: Path) -> None:
    """Thesis figure 2.3: a trial without and one with sub-movements."""
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(2, 2, figsize=(9.0, 5.0), sharex="col", layout="constrained")
    for column, expert in enumerate((True, False)):
        trial = _typical(simulated, forms, _person(simulated, expert), expert)
        events = simulated.rows(trial)
        grid, speed = speeds(events)
        place, pace = axes[:, column]
        place.plot(events.t, events.x, "C0", label="x")
        place.plot(events.t, events.y, "C1", label="y")
        place.set(ylabel="cursor [px]", title="experienced, one piece" if expert else "novice, sub-movements")
        place.legend()
        pace.plot(grid, speed, "C2")
        pace.set(xlabel="t [s]", ylabel="speed [px/s]", xlim=(0.0, events.t[-1]))
    figure.suptitle("Trials without and with sub-movements (simulated)")
    _save(figure, path)


def _paths(simulated: Recording, path: Path) -> None:
    """The cursor's way on the circle, the same condition for an expert and a novice."""
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2, figsize=(9.0, 4.6), layout="constrained")
    for ax, expert in zip(axes, (True, False), strict=True):
        user = _person(simulated, expert)
        for i, trial in enumerate(simulated.trials):
            wanted = {"distance_mm": 150.0, "width_mm": 7.0, "transfer": "sigmoid"}
            if trial.user != user or any(trial.condition[key] != value for key, value in wanted.items()):
                continue
            ax.plot(simulated.rows(i).x, simulated.rows(i).y, lw=0.8)
            ax.add_patch(plt.Circle((trial.target_x, trial.target_y), trial.target_w / 2, fill=False))
        ax.set(aspect="equal", xlabel="x [px]", ylabel="y [px]", title="experienced" if expert else "novice")
        ax.set(xlim=(620.0, 1340.0), ylim=(880.0, 210.0))
    figure.suptitle("Paths over 150 mm to targets of 7 mm (simulated)")
    _save(figure, path)


def _corrective(path: Path) -> None:
    """Thesis figure 2.5: the corrective phase under arctan, and what DREM makes of it."""
    import matplotlib.pyplot as plt

    signals = corrective_signals(duration_s=420.0)
    stage = DynamicRegressorExtension(3, delay_s=0.1, gamma=1.14e14)
    goal = np.full(len(signals.t), np.nan)
    for i, (t, x, v, a) in enumerate(zip(signals.t, signals.x, signals.v, signals.a, strict=True)):
        answer = stage.update((-a, -v, 1.0), x, t)
        goal[i] = np.nan if answer is None else answer.values[2]
    figure, axes = plt.subplots(2, 2, figsize=(9.0, 4.6), sharex="col", layout="constrained")
    for column, until in enumerate((3.0, 420.0)):
        place, pace = axes[:, column]
        place.plot(signals.t, signals.x, label="x")
        place.plot(signals.t, goal, label="estimate of T", lw=2.0, ls="--")
        place.set(ylabel="x [units of the model]", xlim=(0.0, until), ylim=(-30.0, 640.0))
        pace.plot(signals.t, signals.v, "C2")
        pace.set(xlabel="t [s]", ylabel="V [units/s]")
    axes[0, 1].legend(loc="lower right")
    figure.suptitle("Corrective phase (simulated): b1 = 4, b2 = 7, T = 600, PTF = arctan, h = 0.01 s")
    _save(figure, path)


def _minimum_jerk(path: Path) -> None:
    """Thesis figure 2.11: minimum jerk, and its end by doubling."""
    import matplotlib.pyplot as plt

    check = minimum_jerk_check()
    figure, (place, pace) = plt.subplots(2, 1, figsize=(7.0, 4.6), sharex=True, layout="constrained")
    place.plot(check.t, check.x, label="x")
    place.plot(check.t, check.estimate, label="2 x until the peak, then held")
    place.set(ylabel="share of the way", title="Minimum jerk: the ballistic estimate is exact at the peak")
    place.legend()
    pace.plot(check.t, check.v, "C2")
    pace.axvline(0.5, color="0.6", lw=0.8, ls="--")
    pace.set(xlabel="share of the time", ylabel="V")
    _save(figure, path)
