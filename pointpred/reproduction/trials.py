"""Figures 2.2, 2.3, 2.8 to 2.10, 2.12 and 2.13 of the thesis: movements and their predicted endpoints."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.drawing import Line, Look, Panel, beside, drawing
from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline, run
from pointpred.recording import Recording
from pointpred.recordings import read_any
from pointpred.records import METRES_PER_INCH, EventColumns, FloatArray
from pointpred.registry import build
from pointpred.reproduction.figure import Reproduction, Value
from pointpred.scoring import Prepared, SetScore, prepare, resolution, score
from pointpred.scoring.report.figures import boxes
from pointpred.scoring.results import AXIS_FRACTIONS
from pointpred.scoring.statistics import AxisProfile, axis_anova, axis_profile
from pointpred.scoring.trials import PEAK_RATIO
from pointpred.simulation import Aim, Condition, Person, Setup, people, simulate_circle, thesis_setup
from pointpred.simulation.movement import move
from pointpred.transfer import ConstantGain

SEED = 1
CPI = 2000.0
"""Counts per inch of the thesis's mouse and of the simulated one."""
CONDITION = Condition(150.0, 7.0, "constant")
"""The larger distance and width in mm, with the constant gain of 4."""
READS = "a recording"


class Movements(msgspec.Struct, frozen=True):
    """The scored trials of a recording, the settings that its pipelines need, and whose they are."""

    recording: Recording
    prepared: Prepared
    settings: dict[str, Any]
    words: str

    def first(self, *, divided: bool) -> int:
        """The first trial with or without sub-movements; raises ParameterError where there is none."""
        for k, trial in enumerate(self.prepared.trials):
            if trial.submovements == divided:
                return k
        kind = "with" if divided else "without"
        raise ParameterError(
            f"{self.recording.name} has no trial {kind} sub-movements: name another recording"
        )


def novice_and_expert() -> tuple[Person, Person]:
    """The least and the most skilled of ten simulated people."""
    ten = sorted(people(10, SEED), key=lambda one: one.traits.skill)
    return ten[0], ten[-1]


def movements(data: Path | None) -> Movements:
    """The named recording, or one circle of a simulated novice and of a simulated expert."""
    if data is None:
        return _prepared(simulate_circle(novice_and_expert(), [CONDITION], seed=SEED, name="two people"))
    return _prepared(_read(data))


def experiment(data: Path | None) -> Movements:
    """The named recording, or the thesis's experiment of 960 trials with ten simulated people."""
    return _prepared(thesis_setup(SEED) if data is None else _read(data))


def _read(data: Path) -> Recording:
    found = read_any(data)
    if len(found) > 1:
        names = ", ".join(one.name for one in found[:5])
        more = ", ..." if len(found) > 5 else ""
        raise ParameterError(f"{data} holds {len(found)} recordings ({names}{more}): name one of them")
    return found[0]


def _prepared(recording: Recording) -> Movements:
    given = resolution(recording, None, None)
    settings = {name: value for name, value in given.items() if value is not None}
    whose = "simulated people" if recording.provenance.simulated else recording.name
    return Movements(recording, prepare(recording, **settings), settings, whose)


SWITCHED, KEP = "switched-printed", "kep-quartic-gated"
DPI = 96.0
REACH_PX = 567.0
"""150 mm at 96 px per inch, the larger distance of the thesis's experiment."""
WIDTH_PX = 26.5


def longer_axis(rows: EventColumns) -> str:
    """The axis along which a movement goes farther, x or y."""
    return "x" if abs(rows.x[-1] - rows.x[0]) >= abs(rows.y[-1] - rows.y[0]) else "y"


def hand_path(rows: EventColumns, axis: str, settings: dict[str, Any]) -> FloatArray:
    """The way of the hand along an axis in m: counts where the recording has them, otherwise pixels."""
    steps = rows.dx if axis == "x" else rows.dy
    if "cpi" in settings and np.isfinite(steps).all():
        return np.asarray(np.cumsum(steps) * (METRES_PER_INCH / settings["cpi"]))
    place = getattr(rows, axis)
    return np.asarray((place - place[0]) * (METRES_PER_INCH / settings.get("dpi", DPI)))


def filtered_path(rows: EventColumns, axis: str, path: FloatArray, settings: dict[str, Any]) -> FloatArray:
    """z_1 of the differentiator in m; after a gap in the events it begins again at the measured place."""
    differentiator = HomogeneousDifferentiator(**settings)
    which, begun, filtered = "xy".index(axis), 0.0, np.empty(len(path))
    steps_s = np.diff(rows.t, prepend=-np.inf)
    for i, event in enumerate(rows.events()):
        differentiator.update(event)
        if steps_s[i] > differentiator.gap_s:
            begun = float(path[i])
        filtered[i] = begun + differentiator.position[which]
    return filtered


def figure_2_2(data: Path | None) -> Reproduction:
    """Position of the hand and its derivatives: differences of the counts, and the differentiator."""
    if data is None:
        setup, aim = Setup(ConstantGain(4.0)), Aim(REACH_PX, 0.0, WIDTH_PX)
        moved = move(novice_and_expert()[1], setup, aim, np.random.default_rng(SEED))
        rows, whose = moved.events(), "a simulated person"
        settings: dict[str, Any] = {"cpi": CPI, "dpi": DPI}
        truth: tuple[FloatArray, FloatArray] | None = (moved.column("t"), moved.column("vx"))
    else:
        some = movements(data)
        rows, settings, whose = some.prepared.rows(some.first(divided=False)), some.settings, some.words
        truth = None
    axis = longer_axis(rows)
    path = hand_path(rows, axis, settings)
    t = rows.t - rows.t[0]
    motion = HomogeneousDifferentiator(**settings).run(rows)
    v, a = getattr(motion, f"v{axis}"), getattr(motion, f"a{axis}")
    raw = np.diff(path, prepend=path[0]) / np.diff(rows.t, prepend=rows.t[0] - 1.0)
    filtered = filtered_path(rows, axis, path, settings)
    panels = (
        Panel("x_m [m]", beside(t, (path, "counted", "truth"), (filtered, "differentiator", "second"))),
        Panel("V_mx [m/s]", beside(t, (raw, "differences", "first"), (v, "differentiator", "second"))),
        Panel("a_x [m/s^2]", beside(t, (a, "differentiator", "second"))),
    )
    gains = HomogeneousDifferentiator().gains or ()
    values = [
        Value(f"k_{i + 1} for lambda = 5, xi = 2", float(gain), text)
        for i, (gain, text) in enumerate(zip(gains, ("75", "1750", "15000", "40000"), strict=True))
    ]
    values.append(Value("largest distance of the filtered from the counted position",
                        1e3 * float(np.abs(filtered - path).max()), None, "mm"))  # fmt: skip
    if truth is not None:
        true = np.interp(rows.t, *truth)
        values += [
            Value(f"RMS error of {name}", float(np.sqrt(np.mean((one - true) ** 2))), None, "m/s")
            for name, one in (("differences", raw), ("the differentiator's velocity", v))
        ]
    return Reproduction(tuple(values), drawing("Figure 2.2: position and its derivatives", panels), whose)


def figure_2_3(data: Path | None) -> Reproduction:
    """A movement without and one with sub-movements: cursor and hand speed along the longer axis."""
    some = movements(data)
    drawn = []
    for divided in (False, True):
        rows = some.prepared.rows(some.first(divided=divided))
        axis = longer_axis(rows)
        motion = HomogeneousDifferentiator(**some.settings).run(rows)
        t = rows.t - rows.t[0]
        title = "with sub-movements" if divided else "without sub-movements"
        drawn.append((title, t, getattr(rows, axis), getattr(motion, f"v{axis}")))
    panels = [
        *(Panel("x [px]", beside(t, (place, "", "first")), title=title) for title, t, place, _ in drawn),
        *(Panel("V_mx [m/s]", beside(t, (v, "", "second"))) for _, t, _, v in drawn),
    ]
    shares = sum(one.submovements for one in some.prepared.trials) / len(some.prepared.trials)
    values = (
        Value("ratio of speed peaks at which a trial has no sub-movements", PEAK_RATIO, "5"),
        Value("share of the trials with sub-movements", shares),
    )
    title = "Figure 2.3: trials without and with sub-movements"
    return Reproduction(values, drawing(title, panels, columns=2), some.words)


def _predicted(some: Movements, trial: int, pipeline: Pipeline, number: str, what: str) -> Reproduction:
    """One trial: the cursor with its predicted endpoint, and the velocity of the hand."""
    rows = some.prepared.rows(trial)
    axis = longer_axis(rows)
    place = getattr(rows, axis)
    sign = float(np.sign(place[-1] - place[0]))
    end = sign * (getattr(run(pipeline.fresh(), rows), axis) - place[0])
    v = sign * getattr(pipeline.differentiator.fresh().run(rows), f"v{axis}")
    t, way, goal = rows.t - rows.t[0], sign * (place - place[0]), float(abs(place[-1] - place[0]))
    panels = (
        Panel(
            "displacement [px]",
            beside(
                t,
                (way, "x", "truth"),
                (end, "T^", "second"),
                (np.full(len(t), goal), "T", "limit"),
            ),
            limits=(-0.2 * goal, 2.0 * goal),
        ),
        Panel("V_mx [m/s]", beside(t, (v, "", "first"))),
    )
    peak = int(np.argmax(v))
    values = (
        Value("T", goal, None, "px"),
        Value("x / T at the peak of the speed", float(way[peak]) / goal),
        Value("T^ / T at the peak of the speed", float(end[peak]) / goal),
        Value("T^ / T at the end", float(end[-1]) / goal),
    )
    return Reproduction(values, drawing(f"Figure {number}: {what}", panels), some.words)


def figure_2_8(data: Path | None) -> Reproduction:
    """The corrective model alone, over the whole movement."""
    some = movements(data)
    alone = build(SWITCHED, threshold=10.0, **some.settings)
    return _predicted(some, some.first(divided=False), alone, "2.8", "corrective model alone")


def figure_2_9(data: Path | None) -> Reproduction:
    """The switched model on a movement without sub-movements."""
    some = movements(data)
    pipeline = build(SWITCHED, **some.settings)
    return _predicted(some, some.first(divided=False), pipeline, "2.9", "switched model, one movement")


def figure_2_10(data: Path | None) -> Reproduction:
    """The switched model on a movement with sub-movements."""
    some = movements(data)
    pipeline = build(SWITCHED, **some.settings)
    return _predicted(some, some.first(divided=True), pipeline, "2.10", "switched model, sub-movements")


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
