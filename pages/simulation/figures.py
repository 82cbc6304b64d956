"""The paths on docs/evidence/simulation.md; the title says that the people are simulated."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pointpred.recording import Recording


def draw(simulated: Recording, folder: Path) -> None:
    """Draw the paths."""
    import matplotlib as mpl

    mpl.use("Agg")
    folder.mkdir(parents=True, exist_ok=True)
    _paths(simulated, folder / "simulation-paths.png")


def _save(figure: Any, path: Path) -> None:
    import matplotlib.pyplot as plt

    figure.savefig(path, dpi=100, metadata={"Software": None})
    plt.close(figure)


def _person(simulated: Recording, expert: bool) -> str:
    """The most or the least skilled person."""
    choose = max if expert else min
    return choose(simulated.trials, key=lambda trial: float(trial.condition["skill"])).user


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
