"""Every figure and table of both sources by its number, with what differs from the print and why.

Those of chapters 1 and 2 of the thesis are listed here; other distributions name theirs by the entry point
group ``pointpred.figures``, each a sequence of entries.
"""

from __future__ import annotations

from difflib import get_close_matches
from importlib.metadata import entry_points
from importlib.util import find_spec

from pointpred.errors import ParameterError
from pointpred.extras import install_command
from pointpred.reproduction import model_checks, transfer_functions, trials
from pointpred.reproduction.figure import THESIS, Entry, diagram
from pointpred.reproduction.trials import READS

PEOPLE = "The thesis shows people of Antoine, Malacria and Casiez 2018, whose recordings are not public"

LISTED = (
    diagram("1.1", "control feedback loop for HCI", "`pointpred simulate` plays such a loop."),
    diagram("1.2", "connected systems", "`steady_state_map` computes the map between them."),
    diagram("1.3", "observer for connected systems", "`design_observer` designs it."),
    diagram("1.4", "interconnected systems with a reference signal", "`certify_tracking` covers them."),
    diagram("1.5", "observer for interconnected systems", "`design_observer` designs it."),
    diagram("1.6", "connected systems, reversed", "`design_reduced_order` designs such an observer."),
    diagram("2.1", "closed-loop model of pointing", "`pointpred simulate` plays it with simulated people."),
    Entry(
        "2.2",
        THESIS,
        "position of the mouse, its differences and its derivatives by the homogeneous differentiator",
        f"{PEOPLE}; without a recording this is a simulated person, whose true velocity is known. The "
        "gains are the printed ones; the sign of the last discrete line is corrected, because the law "
        "diverges as printed.",
        trials.figure_2_2,
        reads=READS,
    ),
    Entry(
        "2.3",
        THESIS,
        "a trial without and one with sub-movements",
        f"{PEOPLE}; without a recording these are simulated people. The thesis does not say what a peak "
        "is; here the speed must fall by half between two.",
        trials.figure_2_3,
        reads=READS,
    ),
    diagram("2.4", "diagram of the switched model", "The predictor `switched-printed` is this law."),
    Entry(
        "2.5",
        THESIS,
        "simulation of the corrective phase, and T by DREM",
        "With PTF = arctan the cursor moves at most 1.57 px/s, so that 600 px take 382 s: the first 3 s and "
        "the whole are drawn. The delay and the rate of the regression are not printed; ours are 0.1 s and "
        "1.14e14.",
        model_checks.figure_2_5,
    ),
    Entry(
        "2.6",
        THESIS,
        "position rebuilt with the identified transfer function",
        f"{PEOPLE}, and no public recording has counts beside pixels: the movements are simulated. The "
        "printed cursor speed d/dt sqrt(x^2 + y^2) is the rate of the distance from a corner of the "
        "screen; displacements of both axes over short windows stand for it.",
        transfer_functions.figure_2_6,
    ),
    Entry(
        "2.7",
        THESIS,
        "gain curves, real and identified",
        "Simulated movements as in 2.6. c_0 is 0, because the gain PTF(V)/V is infinite at rest otherwise.",
        transfer_functions.figure_2_7,
    ),
    Entry(
        "2.8",
        THESIS,
        "the corrective model alone on a whole movement",
        f"{PEOPLE}; without a recording this is a simulated person. x counts from the start of the "
        "movement, because the printed bound 0.1 abs(x) would depend on where the screen begins.",
        trials.figure_2_8,
        reads=READS,
    ),
    Entry(
        "2.9",
        THESIS,
        "the switched model on a movement without sub-movements",
        "A person as in 2.8. Simulated people are fastest before half of the way, so that doubling at the "
        "peak falls short.",
        trials.figure_2_9,
        reads=READS,
    ),
    Entry(
        "2.10",
        THESIS,
        "the switched model on a movement with sub-movements",
        "A person as in 2.8.",
        trials.figure_2_10,
        reads=READS,
    ),
    Entry(
        "2.11",
        THESIS,
        "minimum jerk, and its end estimated at the peak of the speed",
        "Nothing differs.",
        model_checks.figure_2_11,
    ),
    Entry(
        "2.12",
        THESIS,
        "mean absolute error against the path, switched and KEP, 960 trials",
        f"{PEOPLE}; without a recording ten simulated people stand for them. On these the switched model "
        "loses to KEP at 70 and 80 % of the path, because their speed peaks before half of the way. KEP "
        "ignores zeros more than ten times the way ahead, which the thesis does not have and which helps "
        "KEP.",
        trials.figure_2_12,
        reads=READS,
        slow=True,
    ),
    Entry(
        "2.13",
        THESIS,
        "distribution of the error against the path, and its analysis of variance",
        "People as in 2.12.",
        trials.figure_2_13,
        reads=READS,
        slow=True,
    ),
)
ENTRIES: dict[str, Entry] = {
    entry.number: entry
    for entries in (LISTED, *(found.load() for found in entry_points(group="pointpred.figures")))
    for entry in entries
}
"""Every entry by what the user types: the number of the thesis, ``camera-`` and the number of the paper."""


def not_installed() -> str:
    """Which figures come with a distribution that is not installed, and the command; ``""`` where it is."""
    if find_spec("pointpred_observers"):
        return ""
    return (
        "figures of chapters 3 and 4 and of the camera paper need pointpred-observers: "
        f"{install_command(of='pointpred-observers')}"
    )


def entry_of(number: str) -> Entry:
    """The entry of a number; raises ParameterError naming the nearest ones.

    >>> entry_of("2.11").shows
    'minimum jerk, and its end estimated at the peak of the speed'
    """
    if number in ENTRIES:
        return ENTRIES[number]
    near = get_close_matches(number, ENTRIES, n=3, cutoff=0.5)
    hint = f"did you mean {' or '.join(near)}? " if near else ""
    missing = not_installed()
    raise ParameterError(
        f"no figure or table {number!r}; {hint}'pointpred reproduce' lists all{missing and f'; {missing}'}",
        field="number",
        value=number,
    )
