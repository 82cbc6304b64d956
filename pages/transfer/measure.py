"""Identify the thesis's two transfer functions from simulated counts: ``python -m pages.transfer.measure``.

Prints the errors and draws two figures (thesis figures 2.6 and 2.7).
"""

from __future__ import annotations

import numpy as np

from pages import FIGURES
from pages.arguments import parse
from pages.data import Table, keep
from pages.transfer.trials import (
    SPEEDS,
    best_polynomial,
    gain_error,
    identify,
    rebuild,
    rebuilding_errors,
    simulate_trials,
)
from pointpred.transfer import ConstantGain, SigmoidGain, TransferFunction, averaged_gain

DRAWN_TRIAL = 13

WAYS = {
    "windows, gain": "displacements over 5 ms, largest gain error kept small (default)",
    "windows, samples": "displacements over 5 ms, all samples alike",
    "euler": "Euler differences over 20 ms, all samples alike",
    "linear": "linear observer (alpha 0, lambda 20/s) on counts and on the cursor's path, all alike",
    "differentiator": "HOMD as printed on counts and on the cursor's path, all alike",
}


HEADER = (
    "function",
    "way",
    "gain error: median %",
    "largest %, mean",
    "largest %, worst",
    "off by: median px",
    "95 % px",
)


def report() -> None:
    """Measure, print and draw everything."""
    seeds = range(100, 140)  # bands and windows were chosen on seeds 1 to 6
    truths = {"constant gain 4": ConstantGain(4.0), "sigmoid": SigmoidGain()}
    rows, within = [], 0
    bar = 1.5 * gain_error(best_polynomial(truths["sigmoid"]), truths["sigmoid"]).largest
    for title, truth in truths.items():
        trials = [simulate_trials(truth, seed) for seed in seeds]
        fresh = simulate_trials(truth, 1000)
        for way, meaning in WAYS.items():
            estimates = [identify(t, way) for t in trials]
            errors = [gain_error(f, truth) for f in estimates]
            if (title, way) == ("sigmoid", "windows, gain"):
                within = sum(e.largest < bar for e in errors)
            off = np.concatenate([rebuilding_errors(f, fresh) for f in estimates])
            median, mean, worst = (
                np.median([e.median for e in errors]),
                np.mean([e.largest for e in errors]),
                max(e.largest for e in errors),
            )
            shares = (f"{100 * median:.2f}", f"{100 * mean:.1f}", f"{100 * worst:.1f}")
            rows.append((title, meaning, *shares, f"{np.median(off):.1f}", f"{np.quantile(off, 0.95):.1f}"))
            print("  ".join(rows[-1]))
    baseline = [rebuilding_errors(f, simulate_trials(f, 1000)) for f in truths.values()]
    draw(truths)
    numbers = {
        "best": 100 * bar / 1.5,
        "allowed": 100 * bar,
        "within": within,
        "seeds": len(seeds),
        "slow": averaged_gain(truths["sigmoid"], 0.1),
        "fast": averaged_gain(truths["sigmoid"], 0.3),
        "floor": max(float(np.median(k)) for k in baseline),
    }
    keep("transfer", {"errors": Table.of(HEADER, rows)}, numbers=numbers)


def draw(truths: dict[str, TransferFunction]) -> None:
    """The two figures."""
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    FIGURES.mkdir(parents=True, exist_ok=True)
    estimates = {t: identify(simulate_trials(f, 1), "windows, gain") for t, f in truths.items()}
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    for ax, (title, truth) in zip(axes, truths.items(), strict=True):
        ax.plot(SPEEDS, truth.gain(SPEEDS), "k", label="true")
        ax.plot(SPEEDS, estimates[title].gain(SPEEDS), "C0", label="identified, order 5")
        if title == "sigmoid":
            ax.plot(SPEEDS, best_polynomial(truth).gain(SPEEDS), "C1--", lw=1, label="best of order 5")
        ax.set(
            title=title, xlabel="speed of the hand V_m [m/s]", ylabel="gain", ylim=(0, 1.15 * truth.gain(0.3))
        )
        ax.legend(loc="lower right")
    figure.suptitle("Gain after 48 simulated trials")
    figure.savefig(FIGURES / "transfer-gain.png", dpi=110)
    plt.close(figure)
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    for ax, (title, truth) in zip(axes, truths.items(), strict=True):
        events = simulate_trials(truth, 1000)[DRAWN_TRIAL]
        path = rebuild(estimates[title], events)
        for column, name in enumerate("xy"):
            ax.plot(events.t, events.table[:, 1 + column], f"C{column}", label=f"{name}, cursor")
            ax.plot(events.t, path[:, column], "k--", lw=1, label=f"{name}, rebuilt from V_m")
        ax.set(title=title, xlabel="t [s]", ylabel="position [px]")
        ax.legend(fontsize="small")
    figure.suptitle("Position of a fresh simulated trial, rebuilt with the identified function")
    figure.savefig(FIGURES / "transfer-position.png", dpi=110)
    plt.close(figure)


if __name__ == "__main__":
    parse(__doc__)
    report()
