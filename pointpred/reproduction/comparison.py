"""Figures 2.12 and 2.13 of the thesis: the switched predictor beside KEP over a whole experiment."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np

from pointpred.drawing import Line, Look, Panel, drawing
from pointpred.registry import build
from pointpred.reproduction.figure import Reproduction, Value
from pointpred.reproduction.people import Movements, experiment
from pointpred.scoring import SetScore, score
from pointpred.scoring.report.figures import boxes
from pointpred.scoring.results import AXIS_FRACTIONS
from pointpred.scoring.statistics import AxisProfile, axis_anova, axis_profile

SWITCHED, KEP = "switched-printed", "kep-quartic-gated"
LOOKS: dict[str, Look] = {"hold": "limit", SWITCHED: "first", KEP: "second"}
HALF = AXIS_FRACTIONS.index(0.5)


def scored(some: Movements) -> SetScore:
    """Both predictors of the comparison, and no prediction, on every trial."""
    return score([some.recording], [build(name, **some.settings) for name in (SWITCHED, KEP)])[0]


def profiles(one: SetScore) -> dict[str, AxisProfile]:
    """Errors along the longer axis by the name of the predictor."""
    return {errors.name: axis_profile(errors) for errors in one.predictors}


def figure_2_12(data: Path | None) -> Reproduction:
    """Mean absolute error against the share of the path."""
    some = experiment(data)
    by_name = profiles(scored(some))
    percent = 100.0 * np.array(AXIS_FRACTIONS)
    lines = tuple(Line(percent, by_name[name].mae, name, look) for name, look in LOOKS.items())
    top = 1.05 * max(float(np.nanmax(line.y)) for line in lines)
    panel = Panel("mean absolute error [px]", lines, x="share of the longer axis done [%]", limits=(0.0, top))
    switched, kep = by_name[SWITCHED].mae, by_name[KEP].mae
    values = (
        Value("trials", float(by_name[KEP].boxes[-1].count), "960"),
        Value("error at the end of the path, switched", float(switched[-1]), "9.6", "px"),
        Value("error at the end of the path, KEP", float(kep[-1]), "69.9", "px"),
        Value("error at 50 % of the path, switched", float(switched[HALF]), None, "px"),
        Value("error at 50 % of the path, KEP", float(kep[HALF]), None, "px"),
        Value("fractions of 20 at which switched is better", float((switched < kep).sum()), "20"),
    )
    return Reproduction(
        values, drawing("Figure 2.12: error against the path, all trials", [panel]), some.words
    )


def figure_2_13(data: Path | None) -> Reproduction:
    """The distribution of the error, and the analysis of variance over people."""
    some = experiment(data)
    one = scored(some)
    by_name = profiles(one)
    values = [
        Value(f"error at the end, outliers replaced, {name}", float(by_name[key].mae_replaced[-1]), text,
              "px")
        for name, key, text in (("switched", SWITCHED, "5.2"), ("KEP", KEP, "6.4"))
    ]  # fmt: skip
    series = axis_anova(one, (SWITCHED, KEP))
    printed = (
        (series.effects, "", "38.81", "0.81"),
        (series.effects_replaced, ", outliers replaced", "15.70", "0.64"),
    )
    for effects, note, f, eta2 in printed:
        model = next((effect for effect in effects[HALF] if effect.factors == ("model",)), None)
        if model is not None:
            values += [
                Value(f"F of the model at 50 %{note}", model.f, f),
                Value(f"partial eta squared of the model at 50 %{note}", model.eta2, eta2),
            ]
    pair = [by_name[SWITCHED], by_name[KEP]]
    draw = partial(boxes, one.name, pair, (SWITCHED, KEP), simulated=some.recording.provenance.simulated)
    return Reproduction(tuple(values), draw, some.words)
