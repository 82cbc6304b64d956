"""Tables and figure of docs/evidence/desktop.md."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import msgspec
import numpy as np

from pages import FIGURES
from pages.data import Table, keep
from pages.desktop import recovery
from pages.desktop.recovery import BLOCK
from pages.thinning import save
from pointpred.drawing.style import GREY, MARKERS, PALETTE, canvas, legend_outside, picture
from pointpred.records import FloatArray

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FIGURE = FIGURES / "desktop.svg"
FLOOR, STEADY = "`hold`", "steady"


class Measured(msgspec.Struct, frozen=True):
    """A scenario: time-averaged errors in px by predictor, (people, movements), NaN where none was scored."""

    scenario: str
    change: int | None
    errors: dict[str, FloatArray]
    skipped: int
    repeated: dict[str, FloatArray]
    """``repeats.repeated``, (people, movements), NaN where none was scored."""

    def shares(self, name: str) -> FloatArray:
        """``recovery.shares`` of a predictor."""
        return recovery.shares(self.errors[name], self.errors[FLOOR])

    @property
    def predictors(self) -> list[str]:
        """All but ``hold``."""
        return [name for name in self.errors if name != FLOOR]


def blocks(movements: int) -> dict[str, slice]:
    """The blocks of ten movements by what a column is called."""
    starts = range(0, movements - BLOCK + 1, BLOCK)
    return {f"{start + 1}-{start + BLOCK}": slice(start, start + BLOCK) for start in starts}


def by_block(measured: Sequence[Measured]) -> Table:
    """Median over people of the error over that of ``hold``, in blocks of ten movements."""
    columns = blocks(measured[0].errors[FLOOR].shape[1])
    rows = []
    for one in measured:
        for name in one.predictors:
            medians = np.median(one.shares(name), axis=0)
            rows.append((one.scenario, name, *(f"{medians[part.start]:.2f}" for part in columns.values())))
    return Table.of(("scenario", "predictor", *columns), rows)


def repeats(measured: Sequence[Measured]) -> Table:
    """The share of ends near an earlier end of the person, in blocks of ten movements."""
    columns = blocks(next(iter(measured[0].repeated.values())).shape[1])
    rows = []
    for one in measured:
        for where, near in one.repeated.items():
            cells = (f"{100 * float(np.nanmean(near[:, part])):.0f}" for part in columns.values())
            rows.append((one.scenario, where, *cells, f"{100 * float(np.nanmean(near)):.0f}"))
    return Table.of(("scenario", "where", *columns, "all"), rows)


def whole(measured: Sequence[Measured]) -> Table:
    """The error over all movements of each scenario, beside that of ``hold``."""
    rows = []
    for one in measured:
        floor = float(np.nansum(one.errors[FLOOR]))
        cells = [f"{float(np.nansum(one.errors[name])) / floor:.3f}" for name in one.predictors]
        hold = f"{float(np.nanmean(one.errors[FLOOR])):.0f} px"
        rows.append((one.scenario, str(one.skipped), hold, *cells))
    return Table.of(("scenario", "not scored", FLOOR, *measured[0].predictors), rows)


def recoveries(measured: Sequence[Measured]) -> Table:
    """For each change and predictor: before it, after it, and the movements until it is as without it."""
    steady = next(one for one in measured if one.scenario == STEADY)
    rows = []
    for one in measured:
        if one.change is None:
            continue
        for name in one.predictors:
            changed, calm = one.shares(name), steady.shares(name)
            middle = [np.median(part, axis=0) for part in (changed, calm)]
            last = changed.shape[1] - 1
            count = recovery.movements_until(changed, calm, one.change)
            low, high = recovery.interval(changed, calm, one.change)
            rows.append(
                (
                    one.scenario,
                    name,
                    f"{middle[0][one.change - BLOCK]:.2f}",
                    f"{middle[0][one.change]:.2f} ({middle[1][one.change]:.2f})",
                    f"{middle[0][last]:.2f} ({middle[1][last]:.2f})",
                    _counted(count, last - one.change),
                    f"{_counted(low, last - one.change)} to {_counted(high, last - one.change)}",
                )
            )
    header = ("change", "predictor", "10 before", "10 after (steady)", "last 10 (steady)")
    return Table.of((*header, "movements to recover", "95 % interval"), rows)


def _counted(count: int | None, most: int) -> str:
    return f"over {most}" if count is None else str(count)


def figure(measured: Sequence[Measured]) -> None:
    """The error over that of ``hold`` in the ten movements from each one on, with and without the change."""
    steady = next(one for one in measured if one.scenario == STEADY)
    changes = [one for one in measured if one.change is not None]
    with canvas(1, len(changes), width=9.0, height=4.2, share=True) as (drawing, panels):
        for axes, one in zip(panels, changes, strict=True):
            _panel(axes, one, steady)
        panels[0].set_ylabel("error over that of hold")
        legend_outside(drawing, panels[0], columns=3)
        image = picture(drawing, "error over that of hold, by movement, with and without a change", "")
    save(image.svg, FIGURE)


def _panel(axes: Axes, one: Measured, steady: Measured) -> None:
    """One change: a line for each predictor, the steady desktop's dotted, from the change on."""
    for place, name in enumerate(one.predictors):
        medians = np.median(one.shares(name), axis=0)[::BLOCK]
        calm = np.median(steady.shares(name), axis=0)[::BLOCK]
        at = np.arange(len(medians)) * BLOCK + 0.5 * (BLOCK + 1)
        colour = PALETTE[place % len(PALETTE)]
        axes.plot(at, medians, color=colour, marker=MARKERS[place], markersize=4, label=name.replace("`", ""))
        axes.plot(at, calm, color=colour, linestyle="dotted", linewidth=1.2)
    assert one.change is not None
    axes.axvline(one.change + 0.5, color=GREY, linewidth=0.8)
    axes.set(title=f"{one.scenario} (dotted: steady)", xlabel="movement of the person")


def written(measured: Sequence[Measured]) -> None:
    """Keep the tables and draw the figure."""
    people, movements = measured[0].errors[FLOOR].shape
    tables = {
        "repeats": repeats(measured),
        "whole": whole(measured),
        "by block": by_block(measured),
        "recovery": recoveries(measured),
    }
    keep("desktop", tables, numbers={"people": people, "movements": movements})
    figure(measured)
