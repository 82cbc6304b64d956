"""Figures of claims: whether regions and intervals are as sure as they say, and the time left."""

from __future__ import annotations

from pointpred.drawing.style import GREY, MARKERS, PALETTE, Picture, canvas, legend_outside, picture
from pointpred.scoring.measures.regions import LEVELS
from pointpred.scoring.report.figures.errors import marked
from pointpred.scoring.summary import Calibration, PredictorSummary, SetSummary, TimeLeft
from pointpred.scoring.summary.document import InsideAtTime, or_nan

WORDS = {
    "calibration": ("Endpoints inside the predicted regions", "regions"),
    "time_left": ("Arrivals inside the predicted intervals", "intervals of the time left"),
}
ALLOWED = 0.03
"""How far off a share may be before a claim is called false."""


def inside_curves(summary: SetSummary, kind: str) -> Picture | None:
    """Shares inside against time, a panel a predictor; ``kind`` of WORDS. ``None`` without claims."""
    claiming = [
        (p.name, claims) for p in summary.predictors if (claims := _claims(p, kind)) and claims.by_time
    ]
    if not claiming:
        return None
    what, noun = WORDS[kind]
    title = marked(summary, what)
    rows = (len(claiming) + 1) // 2
    with canvas(rows, 2, width=8.0, height=1.1 + 2.4 * rows, share=True) as (figure, panels):
        for axes, (name, claims) in zip(panels, claiming, strict=False):
            for place, level in enumerate(LEVELS):
                band = 100 * (level - ALLOWED), 100 * (level + ALLOWED)
                axes.axhspan(*band, color=PALETTE[place], alpha=0.22, linewidth=0)
                at, inside = _inside(claims.by_time or {}, level)
                axes.plot(
                    at, inside, MARKERS[place], linestyle="-", color=PALETTE[place], label=f"{level:.0%}"
                )
            axes.set_title(name)
            axes.grid(axis="y")
            axes.tick_params(labelbottom=True)
        for axes in panels[len(claiming) :]:
            axes.set_visible(False)
        panels[0].set(ylim=(0, 101), xlim=(5, 95))
        panels[0].set_xticks(range(10, 91, 20))
        figure.supxlabel("share of the time to arrival [%]", fontsize=10.5)
        figure.supylabel("share inside [%]", fontsize=10.5)
        legend_outside(figure, panels[0], above=True, columns=3)
        words = []
        for name, claims in claiming:
            shares = "/".join(f"{100 * or_nan((claims.inside or {})[level]):.0f}" for level in LEVELS)
            words.append(f"{name} {shares} % over all the time")
        return picture(
            figure,
            f"{title} on {summary.name}: {'; '.join(words)}, wanted "
            f"{'/'.join(f'{level:.0%}' for level in LEVELS)}.",
            f"{title} of {_percentages()}, at each decile of the time, over the trials with {noun} there. "
            f"A claim is true within the band of its colour, {ALLOWED:.0%} to either side.",
            wide=True,
        )


def _percentages() -> str:
    """The levels: 50, 80 and 95 %."""
    *first, last = (f"{100 * level:g}" for level in LEVELS)
    return f"{', '.join(first)} and {last} %"


def _inside(by_time: dict[float, InsideAtTime], level: float) -> tuple[list[float], list[float]]:
    """Times and shares in percent, NaN where nothing was claimed."""
    shares = [cell.inside[level] for cell in by_time.values()]
    return [100 * t for t in by_time], [100 * or_nan(share) for share in shares]


def _claims(predictor: PredictorSummary, kind: str) -> Calibration | TimeLeft | None:
    claims: Calibration | TimeLeft | None = getattr(predictor, kind)
    return claims


def time_left_bars(summary: SetSummary) -> Picture | None:
    """Error of the time left over that of a clock, with intervals, best first; ``None`` without claims."""
    claiming = [(p.name, p.time_left) for p in summary.predictors if p.time_left and p.time_left.of_clock]
    if not claiming:
        return None
    ordered = sorted(claiming, key=lambda one: or_nan(one[1].of_clock))
    title = marked(summary, "Time left beside a clock")
    clock = 1e3 * or_nan(ordered[0][1].clock_s)
    with canvas(width=6.2, height=1.4 + 0.28 * len(ordered)) as (figure, (axes,)):
        for place, (_, left) in enumerate(ordered):
            ratio, bounds = or_nan(left.of_clock), left.interval
            low, high = bounds or (ratio, ratio)
            surely = bounds is not None and high < 1.0
            colour = PALETTE[0] if surely else PALETTE[1]
            axes.plot([low, high], [place, place], color=colour, linewidth=2.6)
            axes.plot([ratio], [place], "o" if surely else "s", color=colour, markersize=6.5)
        axes.axvline(1.0, color=GREY, linestyle="--", linewidth=1.2)
        axes.set_yticks(range(len(ordered)), [name for name, _ in ordered])
        axes.set(title=title, xlabel="share of the clock's error")
        axes.set(ylim=(len(ordered) - 0.4, -0.6))
        axes.grid(axis="x")
        words = [f"{name} {left.of_clock:.2f}" for name, left in ordered]
        return picture(
            figure,
            f"{title} on {summary.name}: {'; '.join(words)}.",
            f"Time-averaged absolute error of the time left. The clock, {clock:.0f} ms off, knows only the "
            f"median movement time of the set. Bars: {100 * summary.interval.level:g} % bootstrap interval. "
            "Where a predictor claims no time the clock is scored in its place.",
        )
