"""Every figure and table of both sources by its number, with what differs from the print and why."""

from __future__ import annotations

from difflib import get_close_matches

from pointpred.errors import ParameterError
from pointpred.reproduction import (
    camera,
    comparison,
    interconnected,
    interlaced,
    model_checks,
    reversed_connection,
    transfer_functions,
    trials,
)
from pointpred.reproduction.figure import CAMERA, THESIS, Entry
from pointpred.reproduction.people import READS

CONTROL = ("report", "observers")
"""Extras of what designs or integrates an observer."""
PEOPLE = "The thesis shows people of Antoine, Malacria and Casiez 2018, whose recordings are not public"


def _diagram(number: str, shows: str, where: str) -> Entry:
    return Entry(number, THESIS, shows, f"A diagram, nothing is computed. {where}")


LISTED = (
    _diagram("1.1", "control feedback loop for HCI", "`pointpred simulate` plays such a loop."),
    _diagram("1.2", "connected systems", "`steady_state_map` computes the map between them."),
    _diagram("1.3", "observer for connected systems", "`design_observer` designs it."),
    _diagram("1.4", "interconnected systems with a reference signal", "`certify_tracking` covers them."),
    _diagram("1.5", "observer for interconnected systems", "`design_observer` designs it."),
    _diagram("1.6", "connected systems, reversed", "`design_reduced_order` designs such an observer."),
    _diagram("2.1", "closed-loop model of pointing", "`pointpred simulate` plays it with simulated people."),
    Entry(
        "2.2",
        THESIS,
        "position of the mouse, its differences and its derivatives by the homogeneous differentiator",
        f"{PEOPLE}; without --recordings this is a simulated person, whose true velocity is known. The "
        "gains are the printed ones; the sign of the last discrete line is corrected, because the law "
        "diverges as printed.",
        trials.figure_2_2,
        reads=READS,
    ),
    Entry(
        "2.3",
        THESIS,
        "a trial without and one with sub-movements",
        f"{PEOPLE}; without --recordings these are simulated people. The thesis does not say what a peak "
        "is; here the speed must fall by half between two.",
        trials.figure_2_3,
        reads=READS,
    ),
    _diagram("2.4", "diagram of the switched model", "The predictor `switched-printed` is this law."),
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
        f"{PEOPLE}; without --recordings this is a simulated person. x counts from the start of the "
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
        f"{PEOPLE}; without --recordings ten simulated people stand for them. On these the switched model "
        "loses to KEP at 70 and 80 % of the path, because their speed peaks before half of the way. KEP "
        "ignores zeros more than ten times the way ahead, which the thesis does not have and which helps "
        "KEP.",
        comparison.figure_2_12,
        reads=READS,
        slow=True,
    ),
    Entry(
        "2.13",
        THESIS,
        "distribution of the error against the path, and its analysis of variance",
        "People as in 2.12.",
        comparison.figure_2_13,
        reads=READS,
        slow=True,
    ),
    _diagram("3.1", "interconnected systems with a reference signal", "As figure 1.4."),
    _diagram("3.2", "interconnected systems with a reference signal", "As figure 1.4."),
    Entry(
        "3.3",
        THESIS,
        "example 1: outputs and states with their estimates",
        "J has one row, 3/2 1/2, because H has one. The printed P, Q, Gamma, Xi and U satisfy no "
        "certificate; the printed gain M has another one. P^-1 U differs from the printed M by no more than "
        "the rounding of P and U. The noise is not printed: uniform within 0.05, seed 1.",
        interconnected.figure_3_3,
        CONTROL,
    ),
    Entry(
        "3.4",
        THESIS,
        "example 2: x and Pi w of the bioreactor",
        "Pi holds but is not unique: S_in1 = S_in2 is assumed. The period of the inflow is not printed: 40 "
        "s. Where the inflow jumps, (Pi w)2 jumps and x2 does not.",
        interconnected.figure_3_4,
        CONTROL,
    ),
    Entry(
        "3.5",
        THESIS,
        "example 2: the observer of w",
        "With the printed gain and without projection the estimate becomes negative and stays there; with "
        "projection it converges more slowly than without any gain. (3.10) and (3.11) do not hold.",
        interconnected.figure_3_5,
        CONTROL,
    ),
    Entry(
        "3.6",
        THESIS,
        "example 3: the robotic arm, its observer and the reference",
        "The observer converges as printed. From the printed start the arm comes back to the reference; "
        "from w(0) = (1, 1, 1, 1), drawn beside it, it does not: assumption 3.2.3 fails with the real B, "
        "which drives the motor only.",
        interconnected.figure_3_6,
        CONTROL,
    ),
    Entry(
        "3.7",
        THESIS,
        "example 4: two circuits and the observer with the printed gain",
        "The first entry of L1 is -20/7, printed without its sign. The printed W is indefinite, so it "
        "bounds no sector, and no certificate covers the trajectory; the printed gain converges all the "
        "same.",
        interconnected.figure_3_7,
        CONTROL,
    ),
    Entry(
        "3.8",
        THESIS,
        "example 5: the reduced-order observer of two masses",
        "A0[4, 4] is -a1 - a2, as the printed S0 needs it, and Q has a second column for u1. The printed F "
        "and W are impossible; Upsilon = diag(-1, 1) has a certificate everywhere and is drawn beside the "
        "print.",
        reversed_connection.figure_3_8,
        CONTROL,
    ),
    Entry(
        "3.9",
        THESIS,
        "example 6: nonlinear regression (the caption says example 2)",
        "The estimates converge, but the condition of theorem 3.3.3 does not hold on this example. The "
        "start of the estimate is not printed: 0.",
        reversed_connection.figure_3_9,
        CONTROL,
    ),
    Entry(
        "3.10",
        THESIS,
        "example 7: parameters of the sniffer data by recursive least squares",
        "Without sniffer.csv a simulated stand-in is used. (3.61) is singular for the first three samples: "
        "ours starts exactly from the fourth, and ends in ordinary least squares; a ridge of 1 does not. "
        "The parameters are not printed as numbers.",
        reversed_connection.figure_3_10,
        CONTROL,
        reads=reversed_connection.SNIFFER,
    ),
    Entry(
        "3.11",
        THESIS,
        "example 7: given and estimated signal",
        "As 3.10.",
        reversed_connection.figure_3_11,
        CONTROL,
        reads=reversed_connection.SNIFFER,
    ),
    _diagram("4.1", "connected systems", "As figure 1.2."),
    Entry(
        "4.2",
        THESIS,
        "example 8: an interlaced system, its steady state and its observer",
        "The final list prints pi_4 = w2 + w1^2; the text before it has w2 + w1^3, which is right. The "
        "numerator of u lacks w1^3 + w2 in the print. The strength of the noise "
        "is not printed: uniform within 0.2.",
        interlaced.figure_4_2,
        CONTROL,
    ),
    _diagram("4.3", "schematics of example 9", "The masses of figure 4.4."),
    Entry(
        "4.4",
        THESIS,
        "example 9: two masses on springs, their steady state and its estimate",
        "tau1 and tau2 are other polynomials: the printed ones do not satisfy the equations of the masses. "
        "The linear part of u is right. The noise is not printed: uniform within 0.05.",
        interlaced.figure_4_4,
        CONTROL,
    ),
    Entry(
        "camera-1",
        CAMERA,
        "errors of chi and eta without noise",
        "The printed observer is unstable and passes the unknown input; ours has the corrected signs of "
        "(12) to (18) and (27). With (45) as printed the start is wrong in v_z by 0.1 m/s, and that error "
        "stays, because no measurement corrects chi and eta. With cos for sin in v_z, over 63 s, the "
        "printed errors come out within 2 %: the authors probably ran this. Focal length and length are "
        "not printed: 800 px and 10 s.",
        camera.figure_1,
    ),
    Entry(
        "camera-2",
        CAMERA,
        "real and estimated velocities without noise",
        "As camera-1. v_z is the integral of the accelerometer from its start; v_x and v_y are divided by "
        "chi, so that they are wrong until chi has converged.",
        camera.figure_2,
    ),
    Entry(
        "camera-table-1",
        CAMERA,
        "RMSE of each variable by the noise of the image",
        "As camera-1: the printed scenario cannot give this table. v_x and v_y grow with noise over focal "
        "length, which is not printed; no focal length fits both.",
        camera.table_1,
    ),
)
ENTRIES = {entry.number: entry for entry in LISTED}
"""Every entry by what the user types: the number of the thesis, ``camera-`` and the number of the paper."""


def entry_of(number: str) -> Entry:
    """The entry of a number; raises ParameterError naming the nearest ones.

    >>> entry_of("3.4").shows
    'example 2: x and Pi w of the bioreactor'
    """
    if number in ENTRIES:
        return ENTRIES[number]
    near = get_close_matches(number, ENTRIES, n=3, cutoff=0.5)
    hint = f"did you mean {' or '.join(near)}? " if near else ""
    raise ParameterError(
        f"no figure or table {number!r}; {hint}'pointpred reproduce --list' lists all",
        field="number",
        value=number,
    )
