"""Identify the thesis's two transfer functions from simulated counts: ``python -m pages.transfer.measure``.

Prints the errors; `pages.reproduce.measure` draws thesis figures 2.6 and 2.7.
"""

from __future__ import annotations

import numpy as np

from pages.arguments import parse
from pages.data import Table, keep
from pointpred.reproduction.transfer_trials import (
    best_polynomial,
    gain_error,
    identify,
    rebuilding_errors,
    simulate_trials,
)
from pointpred.transfer import ConstantGain, SigmoidGain, averaged_gain

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
    """Measure and print everything."""
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


if __name__ == "__main__":
    parse(__doc__)
    report()
