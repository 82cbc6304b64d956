"""Measure choices among targets: ``python -m evidence intent targets``.

Evidence and learned predictor are fitted anew for each set without that set; the last fit of the evidence,
on all sets as predicted by networks that did not know them, is what comes with pointpred. Recordings come
from the folder named by POINTPRED_RECORDINGS.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from evidence import FIGURES
from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.held_out import HeldOut, held_out, trained_predictors, training_sets
from evidence.intent import targets_fit
from evidence.thinning import save
from pointpred.drawing import GREY, PALETTE, canvas, legend_outside, picture
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.registry import REGISTRY
from pointpred.scoring.results import TIME_FRACTIONS
from pointpred.scoring.target_choice import (
    NEAREST,
    Decisions,
    TargetSummary,
    score_targets,
    summarise_targets,
)
from pointpred.targets.posterior import NEAR
from pointpred.training.data import folder

SHOWN = tuple(name for name in ("kalman", "minimum-jerk", "kinematic") if name in REGISTRY)
WITHOUT = Path(__file__).with_name("data") / "without.json"
"""The evidence that was fitted without each set."""
LEAST_LEAD_S = 0.05
"""A proposal later than this before the entry was none in these tables."""
Situations = tuple[targets_fit.Cases, targets_fit.Cases]
"""Of a set: as seen with a claimed law, and without one."""


def apart(recording: Recording) -> Iterator[Recording]:
    """The recording by device, where it holds several."""
    devices = [str(trial.condition.get("device", "")) for trial in recording.trials]
    for device in sorted(set(devices)):
        if len(set(devices)) == 1:
            yield recording
            return
        chosen = [k for k, own in enumerate(devices) if own == device]
        parts, trials = [recording.rows(k) for k in chosen], [recording.trials[k] for k in chosen]
        name = f"{recording.name}, {device}"
        yield Recording.of(name, parts, trials, provenance=recording.provenance)


def unseen(recording: Recording, name: str, held: HeldOut) -> str | Pipeline | None:
    """The predictor as it is without the recording; ``None`` where there is none."""
    if name not in trained_predictors() or recording.name not in training_sets():
        return name
    return held.of_set(name, recording)


def measured(
    sets: Sequence[Recording], held: HeldOut
) -> tuple[list[TargetSummary], list[Situations], dict[str, list[float]]]:
    """Every set and layout, evidence and predictor fitted without it.

    Returns the situations of each set to fit to as well, and the evidence that was fitted without each set.

    Sets whose predictor cannot be had without them are left out.
    """
    sets = [one for one in sets if one.name in targets_fit.SETS or one.provenance.simulated]
    cases: dict[str, Situations] = {}
    for one in sets:
        if (claiming := unseen(one, targets_fit.CLAIMING, held)) is not None:
            silent = targets_fit.cases(one, (targets_fit.SILENT,))
            cases[one.name] = (targets_fit.cases(one, (claiming,)), silent)
    fitted_to = {name: case for name, case in cases.items() if name not in targets_fit.SCORED_ONLY}
    if len(fitted_to) < 2:
        return [], list(fitted_to.values()), {}  # nothing to fit the evidence to
    summaries, without = [], {}
    for recording in (one for one in sets if one.name in cases):
        others = [case for name, case in fitted_to.items() if name != recording.name]
        ours, near = targets_fit.coefficients(others), targets_fit.coefficients(others, [NEAR])
        without[recording.name] = ours.tolist()
        judged = [unseen(recording, name, held) for name in SHOWN]
        for part in apart(recording):
            print(f"choosing among targets: {part.name}", flush=True)
            names = [one for one in judged if one is not None]
            scored = score_targets(part, names, coefficients=ours, nearest=near, least_lead_s=LEAST_LEAD_S)
            summaries += [summarise_targets(one) for one in scored]
    return summaries, list(fitted_to.values()), without


def right(sets: list[TargetSummary]) -> Table:
    """Share of movements whose likeliest target is right, by time."""
    rows = [
        (one.name, one.layout, f"`{p.name}`" if p.name != NEAREST else NEAREST,
         *(f"{100 * p.right[t]:.0f}" for t in TIME_FRACTIONS), f"{np.mean(list(p.log_loss.values())):.2f}")
        for one in sets for p in one.predictors
    ]  # fmt: skip
    return Table.of(("set", "targets", "predictor", *(f"{t:.0%}" for t in TIME_FRACTIONS), "log loss"), rows)


def decisions(sets: list[TargetSummary], chosen: str) -> Table:
    """What proposals came to: with the dial at 0.8, or where 80 % of proposals were right."""
    rows = []
    for one in sets:
        for p in one.predictors:
            d = p.decisions[0.8] if chosen == "dial" else p.at_precision[0.8]
            name = NEAREST if p.name == NEAREST else f"`{p.name}`"
            rows.append((one.name, one.layout, name, *_cells(d)))
    heads = ("dial", "right", "before entry", "lead to entry", "per movement", "to click", "proposals")
    return Table.of(("set", "targets", "predictor", *heads), rows)


def _cells(d: Decisions | None) -> tuple[str, ...]:
    if d is None or d.precision is None:
        return ("-",) * 7
    lead = (
        f"{1e3 * getattr(d, key):.0f} ms" if getattr(d, key) is not None else "-"
        for key in ("lead_entry_s", "lead_a_movement_s", "lead_click_s")
    )
    shares = (f"{getattr(d, key):.0%}" for key in ("precision", "before_entry"))
    return (f"{d.asked:g}", *shares, *lead, f"{d.proposals:.2f}")


def draw(sets: list[TargetSummary]) -> None:
    """Share right against time, a panel a set."""
    with canvas(2, 4, width=11.0, height=5.6, share=True) as (figure, axes):
        for ax, one in zip(axes, sets, strict=False):
            for place, p in enumerate(one.predictors):
                near = p.name == NEAREST
                ax.plot([100 * t for t in TIME_FRACTIONS], [100 * p.right[t] for t in TIME_FRACTIONS],
                        color=GREY if near else PALETTE[place], linestyle="--" if near else "-",
                        marker="osD^"[place % 4], label=p.name)  # fmt: skip
            ax.set_title(f"{one.name}\n{one.layout}")
            ax.grid(True)
        legend_outside(figure, axes[0], columns=4)
        figure.supxlabel("% of the time from onset to arrival")
        figure.supylabel("% right")
        alt = "Share of movements whose likeliest target is right, against time, for each set."
        image = picture(figure, alt, "Which target it is, by share of the time.", wide=True)
    save(image.svg, FIGURES / "targets.svg")


def main() -> None:
    """Write the coefficients, the figure and the generated parts of the page."""
    sets, cases, without = measured(targets_fit.recordings(), held_out(folder()))
    targets_fit.write(cases)
    WITHOUT.write_text(json.dumps(without, indent=1) + "\n", encoding="utf-8")
    draw(sets)
    keep(
        "intent",
        {
            "right": right(sets),
            "decisions": decisions(sets, "precision"),
            "dial": decisions(sets, "dial"),
        },
        part="targets",
    )


if __name__ == "__main__":
    parse(__doc__)
    main()
