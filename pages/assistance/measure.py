"""What right and wrong assistance does to simulated people: ``python -m pages.assistance.measure``.

Seeded; takes a minute or two, progress on stderr.
"""

from __future__ import annotations

import argparse
import sys
from math import inf

from pages import FIGURES
from pages.assistance import figure as assistance_figure
from pages.assistance.movements import (
    LEARNT,
    SKILLS,
    Outcome,
    Play,
    faster,
    looped,
    outcome,
    remark,
    scripted,
)
from pages.data import Table, keep
from pointpred import RECOMMENDED, build

FIGURE = FIGURES / "assistance.svg"
STRENGTH, RHO = 0.5, 8.0
ANGLES, FACTORS = (0.0, 5.0, 10.0, 20.0, 45.0), (0.5, 0.7, 0.85, 1.0, 1.15, 1.3, 1.5)
PREDICTORS = ("hold", "minimum-jerk", "switched", "switched-direction", "kinematic", RECOMMENDED)
PRACTICE = 20
"""Movements that the recommended predictor has heard of a person in its second rows."""
WRONG: dict[str, dict[str, float]] = {
    "right": {},
    "10 degrees off": {"angle_deg": 10.0},
    "20 degrees off": {"angle_deg": 20.0},
    "30 % short": {"factor": 0.7},
    "30 % beyond": {"factor": 1.3},
}


class Measuring:
    """Plays each way once, and prints its name."""

    def __init__(self, movements: int, people: int) -> None:
        self.movements, self.people = movements, people
        self.plain = self("no help", scripted(0.0), movements)

    def __call__(self, name: str, play: Play, movements: int | None = None) -> Outcome:
        """The outcome of one way to play."""
        print(name, file=sys.stderr, flush=True)
        return outcome(play, movements or self.movements, self.people)


def cells(outcome: Outcome, plain: Outcome) -> tuple[str, ...]:
    """Change of time by group, movements that overshoot, clicks that miss."""
    times = []
    for group in SKILLS:
        mean, half = outcome.change(plain, group)
        times.append(f"{100.0 * mean:+.0f} ± {100.0 * half:.0f} %")
    return (*times, f"{100.0 * outcome.overshot():.0f} %", f"{100.0 * outcome.missed():.0f} %")


def percent(ratio: float) -> str:
    """A time over that without help, as a change."""
    return f"{100.0 * (ratio - 1.0):+.0f} %"


HEADER = (*SKILLS, "overshot", "missed")


def right_table(measure: Measuring) -> Table:
    """A right prediction, by strength, for people who know of the help or do not."""
    plain = measure.plain
    seconds = [f"{plain.seconds(group):.2f} s" for group in SKILLS]
    zero = ("0", "-", *seconds, f"{100 * plain.overshot():.0f} %", f"{100 * plain.missed():.0f} %")
    rows = [zero]
    for strength in (0.25, 0.5, 1.0):
        for learnt in (False, True):
            outcome = measure(f"right, strength {strength}", scripted(strength, learnt=learnt))
            rows.append((f"{strength:g}", "yes" if learnt else "no", *cells(outcome, plain)))
    gain = measure("a higher gain", faster(6.0))
    rows.append(("gain 6 instead of 4, no help", "yes", *cells(gain, plain)))
    return Table.of(("strength", "used to it", *HEADER), rows)


def curves(
    measure: Measuring, name: str, places: tuple[float, ...], learnt: bool
) -> assistance_figure.Curves:
    """Changes of time by how wrong a prediction is in one way, for both claims."""
    points: dict[str, dict[str, list[tuple[float, float]]]] = {}
    for claim, spread_px in (("sure", 10.0), ("honest", None)):
        points[claim] = {group: [] for group in SKILLS}
        for place in places:
            play = scripted(STRENGTH, spread_px=spread_px, learnt=learnt, **{name: place})
            outcome = measure(f"{name} {place:g}, {claim}{', used to it' * learnt}", play)
            for group in SKILLS:
                points[claim][group].append(outcome.change(measure.plain, group))
    return assistance_figure.Curves(places, points)


def laws_table(measure: Measuring) -> tuple[Table, dict[str, dict[str, float]]]:
    """The remark as printed, bounded, and guarded; and the times for the figure."""
    laws = {
        "as printed": lambda wrong: remark(RHO, inf, **wrong),
        "bounded": lambda wrong: remark(RHO, STRENGTH, **wrong),
        "guarded": lambda wrong: scripted(STRENGTH, learnt=False, **wrong),
        "guarded, used to it": lambda wrong: scripted(STRENGTH, **wrong),
    }
    rows, times = [], {}
    for words, wrong in WRONG.items():
        outcomes = {law: measure(f"{words}, {law}", make(wrong)) for law, make in laws.items()}
        times[words] = {law: 1.0 + one.change(measure.plain)[0] for law, one in outcomes.items()}
        rows.append(
            (words, *(f"{percent(times[words][law])}, {100 * outcomes[law].missed():.0f} %" for law in laws))
        )
    return Table.of(("prediction", *laws), rows), times


def predictors_table(measure: Measuring) -> Table:
    """Predictors in the loop: they learn of the endpoint while the hand moves."""
    few = max(2, measure.movements - 2)
    plain = measure("no help", scripted(0.0), few)
    rows = []
    for name, practice in (*((one, 0) for one in PREDICTORS), (RECOMMENDED, PRACTICE)):
        pipeline = build(name, cpi=2000.0)
        words = f"`{name}`" + (f" after {practice} movements" if practice else "")
        for habit in (0.0, 0.2, LEARNT * STRENGTH):
            outcome = measure(f"{words}, habit {habit:g}", looped(pipeline, STRENGTH, habit, practice), few)
            rows.append((words, f"{habit:g}", *cells(outcome, plain)))
    return Table.of(("predictor", "expects", *HEADER), rows)


def main() -> None:
    """Write the tables and the figure."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--movements", type=int, default=6, help="movements a person (6)")
    parser.add_argument("--people", type=int, default=30, help="people of all skills (30)")
    arguments = parser.parse_args()
    measure = Measuring(arguments.movements, arguments.people)
    right = right_table(measure)
    points = {
        words: (
            curves(measure, "angle_deg", ANGLES, learnt),
            curves(measure, "factor", FACTORS, learnt),
        )
        for words, learnt in (("people used to help", True), ("people who do not know of it", False))
    }
    laws, times = laws_table(measure)
    keep("assistance", {"right": right, "laws": laws, "predictors": predictors_table(measure)})
    assistance_figure.draw(points, times, FIGURE)


if __name__ == "__main__":
    main()
