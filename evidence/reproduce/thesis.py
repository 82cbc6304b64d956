"""The thesis's comparison of section 2.6.3, on simulated people: ``python -m evidence reproduce thesis``.

Simulates its setup (10 people, 2 distances, 2 widths, 2 transfer functions, 12 movements each: 960 trials at
1 kHz and 2000 CPI), scores the longer axis against the path.
With recordings at hand it also measures what the print leaves open.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.scored import find, named
from pointpred import Pipeline, build
from pointpred.recording import Recording
from pointpred.recordings import read
from pointpred.records import FloatArray
from pointpred.scoring import Prepared, SetScore, prepare, score
from pointpred.scoring.results import AXIS_FRACTIONS
from pointpred.scoring.statistics import axis_anova, axis_profile
from pointpred.scoring.trials import resolution
from pointpred.simulation import thesis_setup

SEED = 1
CPI = 2000.0
OURS, THEIRS = "switched-printed", "kep-quartic-gated"
NAMES = ("hold", OURS, "switched", THEIRS, "kep-quartic", "kep-quadratic-gated", "kep-quadratic")
DECILES = tuple(range(1, 20, 2))  # places of 10 % ... 100 % in AXIS_FRACTIONS
OPEN = {
    "as chosen: delay 0.1 s, gamma 1e4 1/s": {},
    "no corrective phase (gamma 0)": {"gamma": 0.0},
    "gamma 1e2": {"gamma": 1e2},
    "gamma 1e6": {"gamma": 1e6},
    "delay 0.02 s": {"delay_s": 0.02},
    "bound 1 instead of the printed 0.1": {"bound": 1.0},
    "position held between samples, not on the line": {"between": "hold"},
    "held, and no corrective phase": {"between": "hold", "gamma": 0.0},
}
OPEN_SETS = ("freihaut2021", "pvplib23714", "cryslacks", "kh2017")


def unbounded_kep() -> Pipeline:
    """The thesis's KEP without our bound on how far ahead the polynomial's zero may lie."""
    return named(f"{THEIRS}, any zero", build(THEIRS, cpi=CPI, reach=1e6))


def corrective_alone() -> Pipeline:
    """The corrective model without a ballistic phase, figure 2.8."""
    return named("corrective-alone", build(OURS, cpi=CPI, threshold=10.0))


def cells(values: Iterable[float]) -> tuple[str, ...]:
    """Numbers of a row, one decimal."""
    return tuple(f"{value:.1f}" for value in values)


def errors_table(scored: SetScore, quantity: str) -> Table:
    """Mean absolute error along the longer axis in px, a row a predictor, a column a decile of the path."""
    header = ("predictor", *(f"{AXIS_FRACTIONS[i]:.0%}" for i in DECILES))
    rows = []
    for errors in scored.predictors:
        profile = axis_profile(errors)
        values = profile.mae if quantity == "all" else profile.mae_replaced
        rows.append((f"`{errors.name}`", *cells(values[i] for i in DECILES)))
    return Table.of(header, rows)


class Loss(msgspec.Struct, frozen=True):
    """The deciles of the path at which a switched predictor is no better than KEP."""

    replaced: bool
    """Mean with outliers replaced"""
    switched: str
    kep: str
    at: list[float]


def losses(scored: SetScore) -> list[Loss]:
    """The deciles at which a switched predictor's mean error is not below that of KEP."""
    rows = []
    for quantity in ("mae", "mae_replaced"):
        for ours in (OURS, "switched"):
            for theirs in (THEIRS, "kep-quadratic"):
                left = getattr(axis_profile(find(scored, ours)), quantity)
                right = getattr(axis_profile(find(scored, theirs)), quantity)
                lost = [AXIS_FRACTIONS[i] for i in DECILES if left[i] >= right[i]]
                rows.append(Loss(quantity == "mae_replaced", ours, theirs, lost))
    return rows


def anova_table(scored: SetScore) -> tuple[Table, dict[str, Any]]:
    """The effect of the model at each decile, with all errors and with outliers replaced."""
    series = axis_anova(scored, (OURS, THEIRS))
    header = ("path", "F", "p", "partial eta squared", "F, outliers replaced", "p", "partial eta squared")
    rows = []
    for i in DECILES:
        row: list[str] = [f"{AXIS_FRACTIONS[i]:.0%}"]
        for effects in (series.effects[i], series.effects_replaced[i]):
            model = next(effect for effect in effects if effect.factors == ("model",))
            row += [f"F({model.df1:g}, {model.df2:g}) = {model.f:.2f}", f"{model.p:.2g}", f"{model.eta2:.2f}"]
        rows.append(tuple(row))
    about = {"users": series.users, "factors": list(series.factors), "notes": list(series.notes)}
    return Table.of(header, rows), about


def open_choices(folder: Path) -> Table:
    """Time-averaged error over hold's of ``switched-printed`` with each open choice made differently."""
    rows = []
    recordings = [read(folder / f"{name}_samples.parquet") for name in OPEN_SETS]
    patterns = [named(label, build(OURS, **changed)) for label, changed in OPEN.items()]
    scores = score(recordings, patterns)
    for label in OPEN:
        shares = []
        for scored in scores:
            floor = find(scored, "hold").time_averaged.mean()
            shares.append(f"{find(scored, label).time_averaged.mean() / floor:.3f}")
        rows.append((label, *shares))
    return Table.of(("choice", *OPEN_SETS), rows)


def peaks_table(simulated: Recording, folder: Path | None) -> Table:
    """How much of the way is done when the speed of the hand peaks, along the line from start to end."""
    sets = {"simulated": simulated}
    for name in OPEN_SETS if folder else ():
        sets[name] = read(Path(folder or "") / f"{name}_samples.parquet")
    rows = []
    for name, recording in sets.items():
        prepared = prepare(recording, **resolution(recording, None, None))
        motions = build("switched", **resolution(recording, None, None)).differentiator.run(prepared.events)
        speed = np.hypot(motions.vx, motions.vy)
        shares = np.array([peak_share(prepared, speed, k) for k in range(len(prepared.trials))])
        whole = np.array([not trial.submovements for trial in prepared.trials])
        cut = [np.quantile(part, [0.25, 0.5, 0.75]) for part in (shares, shares[whole])]
        rows.append((name, *(f"{middle:.2f} ({low:.2f}-{high:.2f})" for low, middle, high in cut)))
    return Table.of(("people", "all trials", "without sub-movements"), rows)


def peak_share(prepared: Prepared, speed: FloatArray, k: int) -> float:
    """The progress of trial ``k`` at its highest speed."""
    rows = prepared.rows(k)
    at = int(speed[prepared.offsets[k] : prepared.offsets[k + 1]].argmax())
    way = np.array([rows.x[-1] - rows.x[0], rows.y[-1] - rows.y[0]])
    progress = np.array([rows.x[at] - rows.x[0], rows.y[at] - rows.y[0]])
    return float(progress @ way / (way @ way))


def main() -> None:
    """Simulate, score, keep the numbers."""
    print("simulating 960 trials and scoring them; this takes about half a minute")
    recording = thesis_setup(SEED)
    patterns = [*(build(name, cpi=CPI) for name in NAMES[1:]), unbounded_kep(), corrective_alone()]
    scored = score([recording], patterns)[0]
    anova, about = anova_table(scored)
    tables = {
        "errors": errors_table(scored, "all"),
        "replaced": errors_table(scored, "replaced"),
        "anova": anova,
    }
    folder = os.environ.get("POINTPRED_RECORDINGS")
    if folder:
        tables |= {"open": open_choices(Path(folder)), "peaks": peaks_table(recording, Path(folder))}
    else:
        print("POINTPRED_RECORDINGS is not set: the tables of recorded people stay as they were")
    keep("reproduce", tables, part="thesis", numbers={"losses": losses(scored), "anova": about})


if __name__ == "__main__":
    parse(__doc__)
    main()
