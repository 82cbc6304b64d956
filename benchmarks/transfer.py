"""Identify the thesis's two transfer functions from simulated counts: ``python -m benchmarks.transfer``.

Prints the errors and writes docs/transfer.md with its two figures (thesis figures 2.6 and 2.7).
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from pointpred.columns import EventColumns, FloatArray
from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.transfer import (
    ConstantGain,
    PixelTransfer,
    PolynomialFunction,
    PolynomialIdentifier,
    SigmoidGain,
    TransferFunction,
    averaged_gain,
    differentiated_speeds,
    euler_speeds,
)

CPI, DPI = 2000.0, 96.0
METRES_PER_COUNT, METRES_PER_PX = 0.0254 / CPI, 0.0254 / DPI
DISTANCES_M = (0.075, 0.150)
TRIALS = 48
ORDER = 5
SPEEDS = np.linspace(0.0127, 0.3, 400)
TRIAL = 13
DOCS = Path(__file__).parent.parent / "docs"


def simulate_trial(
    function: TransferFunction, peak: float, distance: float, rng: np.random.Generator
) -> EventColumns:
    """One straight minimum-jerk movement of the hand that takes the cursor ``distance`` m over the screen.

    2000 CPI, reports every 1 ms with 5 % jitter of their real times, whole counts, whole pixels.
    """
    u = np.linspace(0.0, 1.0, 2001)
    bell = 16.0 * u**2 * (1.0 - u) ** 2
    duration = distance / float(np.trapezoid(function.cursor_speed(peak * bell), u))
    h = 0.001 * np.clip(1.0 + 0.05 * rng.standard_normal(int(1200 * duration) + 50), 0.5, 1.5)
    t = np.cumsum(h)
    t = t[t < duration + 0.02]
    s = np.clip(t / duration, 0.0, 1.0)
    path = peak * duration / 1.875 * (10.0 * s**3 - 15.0 * s**4 + 6.0 * s**5)
    angle = rng.uniform(0.0, 2.0 * np.pi)
    place = np.trunc(np.outer(path, [np.cos(angle), np.sin(angle)]) / METRES_PER_COUNT)
    counts = np.diff(place, axis=0, prepend=0.0)
    moved = PixelTransfer(function, cpi=CPI, dpi=DPI).run(t, counts[:, 0], counts[:, 1])
    x, y = 900.0 + np.cumsum(moved[:, 0]), 600.0 + np.cumsum(moved[:, 1])
    begin = np.zeros(len(t), np.bool_)
    begin[0] = True
    return EventColumns.of(t, x, y, counts[:, 0], counts[:, 1], begin=begin)


def simulate_trials(function: TransferFunction, seed: int, count: int = TRIALS) -> list[EventColumns]:
    """Trials over 75 and 150 mm in turn, peak speeds of the hand spread evenly over 0.03 ... 0.31 m/s."""
    rng = np.random.default_rng(seed)
    peaks = rng.permutation(np.linspace(0.03, 0.31, count))
    return [simulate_trial(function, peak, DISTANCES_M[i % 2], rng) for i, peak in enumerate(peaks)]


def identify(trials: list[EventColumns], way: str) -> PolynomialFunction:
    """The polynomial from trials, one of four ways."""
    identifier = PolynomialIdentifier(order=ORDER, cpi=CPI, dpi=DPI)
    for events in trials:
        if way.startswith("windows"):
            identifier.run(events)
            continue
        if way == "euler":
            pairs = euler_speeds(events, cpi=CPI, dpi=DPI)
        else:
            motor, cursor = HomogeneousDifferentiator(cpi=CPI), HomogeneousDifferentiator(dpi=DPI)
            pairs = differentiated_speeds(events, motor, cursor)
        for speed, cursor_speed in zip(*pairs, strict=True):
            identifier.learn(float(speed), float(cursor_speed))
    found = identifier.identify("gain" if way == "windows, gain" else "samples").function
    if found is None:
        raise RuntimeError("the trials do not excite all powers")
    return found


class GainError(NamedTuple):
    """Relative error of a gain curve over 0.0127 ... 0.3 m/s."""

    median: float
    largest: float
    at: float


def gain_error(found: TransferFunction, truth: TransferFunction) -> GainError:
    error = np.abs(found.gain(SPEEDS) / truth.gain(SPEEDS) - 1.0)
    return GainError(float(np.median(error)), float(error.max()), float(SPEEDS[error.argmax()]))


def best_polynomial(truth: TransferFunction) -> PolynomialFunction:
    """The polynomial with c_0 = 0 whose largest relative gain error is smallest: a linear programme."""
    from scipy.optimize import linprog

    rows = SPEEDS[:, None] ** np.arange(ORDER) / truth.gain(SPEEDS)[:, None]
    bound = np.ones((len(SPEEDS), 1))
    sides = np.block([[rows, -bound], [-rows, -bound]])
    limits = np.concatenate([np.ones(len(SPEEDS)), -np.ones(len(SPEEDS))])
    cost = np.eye(ORDER + 1)[-1]
    answer = linprog(cost, A_ub=sides, b_ub=limits, bounds=[(None, None)] * (ORDER + 1))
    return PolynomialFunction([0.0, *answer.x[:-1]])


def rebuild(function: TransferFunction, events: EventColumns) -> FloatArray:
    """The cursor's path in px from V_m alone: model (2.1) with a transfer function, no rounding to pixels."""
    counts = events.table[1:, 3:5]
    speed = np.hypot(counts[:, 0], counts[:, 1]) * METRES_PER_COUNT / np.diff(events.t)
    steps = function.gain(speed)[:, None] * counts * (DPI / CPI)
    start = events.table[:1, 1:3]
    return np.concatenate([start, start + np.cumsum(steps, axis=0)])


def rebuilding_errors(function: TransferFunction, fresh: list[EventColumns]) -> FloatArray:
    """The largest distance in px between rebuilt and true path, one number a fresh trial."""
    return np.array([np.hypot(*(rebuild(function, e) - e.table[:, 1:3]).T).max() for e in fresh])


WAYS = {
    "windows, gain": "displacements over 5 ms, largest gain error kept small (default)",
    "windows, samples": "displacements over 5 ms, all samples alike",
    "euler": "Euler differences over 20 ms, all samples alike",
    "differentiator": "HOMD on counts and on the cursor's path, all samples alike",
}


def report() -> None:
    """Print and write everything."""
    seeds = range(11, 19)  # bands and windows were chosen on seeds 1 to 6
    truths = {"constant gain 4": ConstantGain(4.0), "sigmoid": SigmoidGain()}
    lines = []
    for title, truth in truths.items():
        trials = [simulate_trials(truth, seed) for seed in seeds]
        fresh = simulate_trials(truth, 1000)
        for way, meaning in WAYS.items():
            found = [identify(t, way) for t in trials]
            errors = [gain_error(f, truth) for f in found]
            off = np.concatenate([rebuilding_errors(f, fresh) for f in found])
            median, mean, worst = (
                np.median([e.median for e in errors]),
                np.mean([e.largest for e in errors]),
                max(e.largest for e in errors),
            )
            lines.append(
                f"| {title} | {meaning} | {100 * median:.2f} | {100 * mean:.1f} | {100 * worst:.1f} "
                f"| {np.median(off):.1f} | {np.quantile(off, 0.95):.1f} |"
            )
            print(lines[-1])
    best = gain_error(best_polynomial(truths["sigmoid"]), truths["sigmoid"])
    known = [rebuilding_errors(f, simulate_trials(f, 1000)) for f in truths.values()]
    draw(truths)
    page = PAGE.format(
        rows="\n".join(lines),
        best=100 * best.largest,
        allowed=150 * best.largest,
        slow=averaged_gain(truths["sigmoid"], 0.1),
        fast=averaged_gain(truths["sigmoid"], 0.3),
        floor=max(float(np.median(k)) for k in known),
    )
    (DOCS / "transfer.md").write_text(page)


def draw(truths: dict[str, TransferFunction]) -> None:
    """The two figures."""
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    (DOCS / "figures").mkdir(parents=True, exist_ok=True)
    found = {t: identify(simulate_trials(f, 1), "windows, gain") for t, f in truths.items()}
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    for ax, (title, truth) in zip(axes, truths.items(), strict=True):
        ax.plot(SPEEDS, truth.gain(SPEEDS), "k", label="true")
        ax.plot(SPEEDS, found[title].gain(SPEEDS), "C0", label="identified, order 5")
        if title == "sigmoid":
            ax.plot(SPEEDS, best_polynomial(truth).gain(SPEEDS), "C1--", lw=1, label="best of order 5")
        ax.set(
            title=title, xlabel="speed of the hand V_m [m/s]", ylabel="gain", ylim=(0, 1.15 * truth.gain(0.3))
        )
        ax.legend(loc="lower right")
    figure.suptitle("Gain after 48 simulated trials")
    figure.savefig(DOCS / "figures" / "transfer-gain.png", dpi=110)
    plt.close(figure)
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    for ax, (title, truth) in zip(axes, truths.items(), strict=True):
        events = simulate_trials(truth, 1000)[TRIAL]
        path = rebuild(found[title], events)
        for column, name in enumerate("xy"):
            ax.plot(events.t, events.table[:, 1 + column], f"C{column}", label=f"{name}, cursor")
            ax.plot(events.t, path[:, column], "k--", lw=1, label=f"{name}, rebuilt from V_m")
        ax.set(title=title, xlabel="t [s]", ylabel="position [px]")
        ax.legend(fontsize="small")
    figure.suptitle("Position of a fresh simulated trial, rebuilt with the identified function")
    figure.savefig(DOCS / "figures" / "transfer-position.png", dpi=110)
    plt.close(figure)


PAGE = """# Identifying the transfer function (simulated)

Written by `python -m benchmarks.transfer`; do not edit. No public recording has counts beside pixels, so all
of this is **simulated**: 48 straight minimum-jerk movements over 75 and 150 mm of screen, the hand's peak
speeds spread evenly over 0.03 to 0.31 m/s, 2000 CPI, 1 kHz with 5 % jitter, whole counts, whole pixels with
the remainder carried. A polynomial of order 5 with c_0 = 0 is identified and judged over 0.0127 to 0.3 m/s,
for eight seeds that no setting was chosen on; positions are those of 48 fresh trials, rebuilt from the
counts alone.

| function | way | gain error: median % | largest %, mean | largest %, worst | off by: median px | 95 % px |
| --- | --- | --- | --- | --- | --- | --- |
{rows}

A position is off by what it is at the worst moment of a trial; rounding to whole pixels alone makes
{floor:.1f} px (median, with the true function instead of the identified one).

The best polynomial of order 5 for the sigmoid has a largest gain error of {best:.1f} % (linear programme);
the bar is 1.5 times that, {allowed:.1f} %. The corner at 0.05 m/s is where the identified one is worst.

- Whole pixels ruin Euler differences between single reports: the speed is nearly all rounding, and the
  length of a rounded step is too long on average. Differences over 20 ms are better; displacements of each
  axis over short windows are linear in the coefficients, and rounding cannot bias them.
- Samples that count alike follow metres per second, not gains: the sigmoid's low end is then wrong. Weighing
  bands of speed by their relative error costs some of the median and of the fast trials' positions, and wins
  in the largest error.
- The differentiator with its printed gains smooths both signals, and a curved function of a smoothed speed is
  not the smoothed function: its gain is wrong near the corner and wherever speed changes quickly.

The averaged gain of a ballistic movement, c = 1 / (2 Vmax) int_0^pi PTF(Vmax sin phi) dphi, is {slow:.2f} for
the sigmoid at Vmax = 0.1 m/s and {fast:.2f} at 0.3 m/s.

![Gain curves, simulated](figures/transfer-gain.png)

![Positions rebuilt, simulated](figures/transfer-position.png)
"""

if __name__ == "__main__":
    report()
