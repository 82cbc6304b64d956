"""The benchmark: public sets of the catalogue, and predictors whose coefficients did not see them.

``docs/guide/benchmark.md`` states the protocol; ``pointpred benchmark`` runs it.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pointpred.datasets import DataSet, listing
from pointpred.drawing import GREY, PALETTE, Picture, canvas, picture
from pointpred.files import write_whole
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.registry import build, settings_in, takes
from pointpred.scoring import FLOOR, SetSummary, resolution

if TYPE_CHECKING:
    import pandas as pd

SET_OUT = " (set left out)"
"""What is added to the name of a predictor whose coefficients were fitted to other sets than this."""
LEFT_OUT = Path(__file__).parent / "datasets" / "set_left_out"
"""A file of coefficients for each set, fitted to the other sets of the results page."""


def benchmark_sets() -> tuple[DataSet, ...]:
    """The sets that a program can fetch, check and read as they are.

    >>> [entry.name for entry in benchmark_sets()]
    ['kh2017', 'gofitts_demo', 'jrcalgo']
    """
    return tuple(entry for entry in listing() if entry.verified and entry.reading is not None)


def judged_on(recording: Recording, names: Sequence[str]) -> list[str | Pipeline]:
    """What ``score`` is given for a benchmark set: names, or a pipeline where other coefficients are needed.

    A predictor that takes coefficients gets those that were fitted without the set of the recording's name,
    and that is added to its name. Raises ParameterError for an unknown name.
    """
    coefficients = LEFT_OUT / f"{recording.name}.npz"
    chosen: list[str | Pipeline] = []
    for spelled in names:
        name, settings = settings_in(spelled)
        if coefficients.is_file() and takes(name, "coefficients") and "coefficients" not in settings:
            own = {**resolution(recording, None, None), **settings, "coefficients": coefficients}
            pipeline = build(name, **own)
            pipeline.name = spelled + SET_OUT
            chosen.append(pipeline)
        else:
            chosen.append(spelled)
    return chosen


def table_of_sets(sets: Sequence[SetSummary]) -> pd.DataFrame:
    """Time-averaged errors as shares of hold's: a row a predictor, for each set the share and its interval.

    Needs pandas.
    """
    import pandas as pd

    rows: dict[str, dict[str, object]] = {}
    for one in sets:
        for p in one.predictors:
            low, high = p.time_averaged.interval or (None, None)
            own = {one.name: p.time_averaged.of_hold, f"{one.name} from": low, f"{one.name} to": high}
            rows.setdefault(p.name, {"predictor": p.name}).update(own)
    return pd.DataFrame(list(rows.values()))


def draw_sets(sets: Sequence[SetSummary]) -> Picture:
    """The same as a figure, a panel a set."""
    names = list(dict.fromkeys(p.name for one in sets for p in one.predictors))
    size = {"width": 1.8 + 2.0 * len(sets), "height": 1.2 + 0.28 * len(names)}
    with canvas(1, len(sets), **size, share=True) as (figure, panels):
        for axes, one in zip(panels, sets, strict=True):
            for p in one.predictors:
                share, interval = p.time_averaged.of_hold, p.time_averaged.interval
                if share is None:
                    continue
                low, high = interval or (share, share)
                better = interval is not None and high < 1.0
                colour = GREY if p.name == FLOOR else PALETTE[0] if better else PALETTE[1]
                place = names.index(p.name)
                axes.plot([low, high], [place, place], color=colour, linewidth=2.6)
                axes.plot([share], [place], "o" if better else "s", color=colour, markersize=6.5)
            axes.axvline(1.0, color=GREY, linestyle="--", linewidth=1.2)
            axes.set_yticks(range(len(names)), names)
            axes.set(title=one.name, ylim=(len(names) - 0.4, -0.6))
            axes.grid(axis="x")
        figure.supxlabel("share of hold's error (left is better)", fontsize=10.5)
        caption = (
            "Time-averaged error, share of hold, with 95 % bootstrap intervals over people, or over trials "
            "where a set has one person. Blue circle: the interval lies below 1; square: it does not."
        )
        return picture(figure, caption, caption, wide=True)


def write_sets(sets: Sequence[SetSummary], folder: Path) -> None:
    """Write the table as CSV and LaTeX and the figure as SVG and PDF, all named ``all-sets``."""
    made, figure = table_of_sets(sets), draw_sets(sets)
    tex = made.to_latex(
        index=False, escape=True, float_format="%.2f", na_rep="--", label="tab:all-sets",
        caption=r"Time-averaged error, share of the error of hold, with 95\% bootstrap intervals",
    )  # fmt: skip
    for ending, content in (
        ("csv", made.to_csv(index=False, lineterminator="\n").encode()),
        ("tex", tex.encode()),
        ("svg", figure.svg.encode()),
        ("pdf", figure.pdf()),
    ):
        write_whole(folder / f"all-sets.{ending}", content)
