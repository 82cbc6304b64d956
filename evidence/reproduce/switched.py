"""What each part of ``switched-direction`` is worth: ``python -m evidence reproduce switched``.

Scores the predictor and versions of it that lack one part each, on the embedded sample and on the
recordings that POINTPRED_RECORDINGS names.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any, cast

import numpy as np

from evidence import FIGURES
from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.scored import find, named
from evidence.thinning import save
from pointpred import Pipeline, build
from pointpred.datasets import sample
from pointpred.drawing import canvas, picture
from pointpred.recording import Recording
from pointpred.recordings import read
from pointpred.scoring import SetScore, resolution, score
from pointpred.scoring.report.figures import line_style
from pointpred.scoring.results import TIME_FRACTIONS

NAME = "switched-direction"
OTHERS = ("switched", "switched-printed", "minimum-jerk", "kalman")
SETS = ("freihaut2021", "pvplib23714", "cryslacks", "kh2017", "humanmovemouse", "gofitts_demo", "jrcalgo")
DRAWN = ("freihaut2021", "pvplib23714", "cryslacks", "kh2017")


def variants(recording: Recording) -> list[Pipeline]:
    """Versions that lack one part each, built for a recording's device and screen as ``score`` builds."""
    settings = resolution(recording, None, None)
    whole = build(NAME, **settings)
    changed = {
        "one unit: sub-movements are not told apart": {"rise": 10.0},
        "the rate at the switch is kept: nothing is learned after the peak": {"turn": 0.0},
        "no bound by the stopping distance": {"stopping": 1e6},
        "no typical time: the movement's own alone": {"own": 1.0},
        "the typical time alone": {"own": 0.0},
        "the differentiator's gains of the other predictors": {"gain_lambda": 48.0},
    }
    return [
        whole,
        *(named(label, build(NAME, **settings, **parameters)) for label, parameters in changed.items()),
    ]


def of_hold(scored: SetScore, name: str) -> str:
    """Time-averaged error as a share of that of no prediction."""
    ours, floor = (find(scored, one).time_averaged.mean() for one in (name, "hold"))
    return f"{ours / floor:.3f}"


def by_time(scored: SetScore, name: str) -> list[float]:
    """Error as a share of that of no prediction at each share of the time."""
    ours, floor = (find(scored, one).by_time.mean(axis=0) for one in (name, "hold"))
    return [float(one) for one in ours / floor]


def shares_table(scores: Iterable[SetScore], names: Iterable[str]) -> Table:
    """A row a predictor, a column a set."""
    scored = list(scores)
    rows = [
        (f"`{name}`" if " " not in name else name, *(of_hold(one, name) for one in scored)) for name in names
    ]
    return Table.of(("predictor", *(one.name for one in scored)), rows)


def deciles_table(scores: Iterable[SetScore]) -> Table:
    """The predictor against no prediction at each decile of the time, a row a set."""
    header = ("set", *(f"{fraction:.0%}" for fraction in TIME_FRACTIONS))
    rows = [(one.name, *(f"{value:.2f}" for value in by_time(one, NAME))) for one in scores]
    return Table.of(header, rows)


def draw(scores: Iterable[SetScore], file: Path) -> None:
    """Error over time as a share of that of no prediction, a panel a set."""
    shown = [one for one in scores if one.name in DRAWN]
    if not shown:
        return
    with canvas(2, 2, width=8.0, height=6.4, share=True) as (figure, panels):
        for panel, one in zip(panels, shown, strict=False):
            panel.axhline(1.0, color="#808080", linewidth=1.0, linestyle=(0, (4, 2)))
            for name in (NAME, *OTHERS):
                panel.plot(
                    100 * np.array(TIME_FRACTIONS),
                    by_time(one, name),
                    **cast("dict[str, Any]", line_style(name, (NAME, *OTHERS))),
                )
            panel.set_title(one.name)
            panel.set_ylim(0.4, 2.0)
        for panel in panels[2:]:
            panel.set_xlabel("time from onset to arrival, %")
        panels[0].set_ylabel("error / error of hold")
        panels[2].set_ylabel("error / error of hold")
        panels[0].legend(fontsize=8)
        image = picture(figure, "Error against time as a share of that of no prediction", "")
    save(image.svg, file)


def recordings() -> list[Recording]:
    """The embedded sample, and the recordings at hand."""
    folder = os.environ.get("POINTPRED_RECORDINGS")
    if not folder:
        print("POINTPRED_RECORDINGS is not set: the tables keep to the embedded sample")
        return [sample()]
    return [sample(), *(read(Path(folder) / f"{name}_samples.parquet") for name in SETS)]


def main() -> None:
    """Score, write and draw."""
    scores: list[SetScore] = []
    names: list[str] = []
    for recording in recordings():
        parts = variants(recording)
        names = [part.name for part in parts]
        scores += score([recording], [*parts, *OTHERS])
    keep(
        "reproduce",
        {
            "comparison": shares_table(scores, (NAME, *OTHERS)),
            "deciles": deciles_table(scores),
            "ablations": shares_table(scores, names),
        },
        part="switched",
    )
    draw(scores, FIGURES / "switched-time.svg")


if __name__ == "__main__":
    parse(__doc__)
    main()
