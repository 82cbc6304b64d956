"""Fit the prefetch policy to recordings: ``python -m evidence intent fit``.

First the evidence (``evidence.intent.evidence``), then the policy's settings: as few firings, as many
movements that fire before the entry and twice the median lead of ForesightJS's rule, on every layout at
once; the layout that is worst off counts. Fitted once without each group of sets, for the measurement, and
once to all, which is what comes with pointpred: evidence is written to pointpred/targets/coefficients.py,
settings are printed. Recordings come from the folder named by POINTPRED_RECORDINGS. About an hour.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import exp, log
from pathlib import Path

import msgspec
import numpy as np

from evidence import ROOT
from evidence.arguments import parse
from evidence.data import file_of, write
from evidence.data import read as stored
from evidence.held_out import held_out
from evidence.intent.evidence import CLAIMING, SILENT, coefficients
from evidence.intent.foresight import FRAME_S
from evidence.intent.movements import Movement, movements
from evidence.intent.scores import Score, by_policy, by_rule, score, shares_of
from pointpred.recordings import read
from pointpred.records import FloatArray
from pointpred.targets import posterior, prefetch
from pointpred.training.data import folder

GROUPS = {
    "pvplib23714": 0,
    "gofitts_demo": 1,
    "freihaut2021": 1,
    "jrcalgo": 1,
    "cryslacks": 2,
    "kh2017": 2,
    "humanmovemouse": 2,
}
"""Sets that are left out together; none has people or blocks of another."""
SPREAD = (0.4, 0.2, 0.05, 0.15, 0.1, 0.3, 0.3, 0.5, 0.01, 0.05)
"""How far each setting is varied at first."""
GENERATIONS, CHILDREN, PARENTS = 60, 16, 5
WORST = 120.0
"""How sharply the worst layout decides."""


class Fitted(msgspec.Struct, frozen=True):
    """Coefficients of the evidence, and settings of the policy."""

    evidence: list[float]
    settings: list[float]


class Fits(msgspec.Struct, frozen=True):
    """To all sets, and without each group of GROUPS."""

    whole: Fitted
    without: list[Fitted]


def fits() -> Fits:
    """What was fitted last."""
    return stored(file_of("intent", "fits"), Fits)


def recorded(predictors: Sequence[str]) -> list[Movement]:
    """The movements of all sets over every layout."""
    where = folder()
    held = held_out(where)
    return [
        one for name in GROUPS for one in movements(read(where / f"{name}_samples.parquet"), predictors, held)
    ]


def margin(ours: dict[str, Score], rule: dict[str, Score]) -> float:
    """How far the policy is from what is asked of it on its worst layouts, as a logarithm; 0 reaches it."""
    parts = [
        part
        for layout, own in ours.items()
        for part in (
            1.3 * log(rule[layout].firings / own.firings),
            log(max(own.lead_s, 1e-3) / (2.0 * rule[layout].lead_s)),
            10.0 * (own.before - rule[layout].before),
        )
    ]
    return -log(sum(exp(-WORST * max(part, -1.0)) for part in parts) / len(parts)) / WORST


def by_layout(chosen: Sequence[Movement], fired: Sequence[FloatArray]) -> dict[str, Score]:
    """The score of each layout."""
    places: dict[str, list[int]] = {}
    for i, one in enumerate(chosen):
        places.setdefault(one.layout, []).append(i)
    return {
        layout: score([chosen[i] for i in own], [fired[i] for i in own]) for layout, own in places.items()
    }


def settings(chosen: Sequence[Movement], shares: Sequence[FloatArray]) -> list[float]:
    """The settings of largest margin, searched from those that come with pointpred."""
    rule = by_layout(chosen, [by_rule(one, FRAME_S) for one in chosen])

    def worth(values: FloatArray) -> float:
        fired = [by_policy(one, own, values, FRAME_S) for one, own in zip(chosen, shares, strict=True)]
        return margin(by_layout(chosen, fired), rule)

    best: list[float] = searched(worth, np.array(prefetch.FITTED), np.array(SPREAD)).tolist()
    return best


def searched(worth: Callable[[FloatArray], float], start: FloatArray, spread: FloatArray) -> FloatArray:
    """The best of an evolution strategy: the mean of the better children, and how far these lie apart."""
    generator = np.random.default_rng(1)
    middle, best, reached = start, start, worth(start)
    for _ in range(GENERATIONS):
        children = middle + spread * generator.standard_normal((CHILDREN, len(start)))
        worths = np.array([worth(child) for child in children])
        order = np.argsort(-worths)
        if worths[order[0]] > reached:
            best, reached = children[order[0]], float(worths[order[0]])
        parents = children[order[:PARENTS]]
        middle = parents.mean(axis=0)
        spread = np.maximum(0.8 * spread + 0.2 * parents.std(axis=0), 0.02 * np.array(SPREAD))
    print(f"margin {reached:.4f}", flush=True)
    return best


def write_evidence(values: Sequence[float], file: Path) -> None:
    """Put the coefficients into the package."""
    half, features = posterior.SET, posterior.FEATURES
    parts = {}
    for prefix, part in (("PAGES_", values[:half]), ("PAGES_UNCLAIMED_", values[half:])):
        parts[f"{prefix}SLOW"], parts[f"{prefix}FAST"] = part[:features], part[features : 2 * features]
        parts[f"{prefix}NONE"] = part[2 * features :]
    lines = file.read_text(encoding="utf-8").splitlines()
    for i, line in enumerate(lines):
        name = line.split(" = ")[0]
        if name in parts:
            lines[i] = f"{name} = ({', '.join(f'{value:.4g}' for value in parts[name])})"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")


def fit(everything: Sequence[Movement]) -> Fits:
    """The fits to these movements; settings are fitted to shares by evidence that does not know the group."""
    groups = sorted(set(GROUPS.values()))
    apart = [coefficients([one for one in everything if GROUPS[one.set] != k], GROUPS) for k in groups]
    shares = [shares_of(one, CLAIMING, apart[GROUPS[one.set]], FRAME_S) for one in everything]

    def without(group: int | None) -> list[float]:
        chosen = [i for i, one in enumerate(everything) if GROUPS[one.set] != group]
        return settings([everything[i] for i in chosen], [shares[i] for i in chosen])

    whole = Fitted(coefficients(everything, GROUPS).tolist(), without(None))
    return Fits(whole, [Fitted(apart[k].tolist(), without(k)) for k in groups])


def main() -> None:
    """Fit without each group and to all."""
    done = fit(recorded((CLAIMING, SILENT)))
    write(done, file_of("intent", "fits"))
    write_evidence(done.whole.evidence, ROOT / "pointpred" / "targets" / "coefficients.py")
    print("settings:", ", ".join(f"{value:.4g}" for value in done.whole.settings))


if __name__ == "__main__":
    parse(__doc__)
    main()
