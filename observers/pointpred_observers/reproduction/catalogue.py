"""The figures and tables of chapters 3 and 4 and of the camera paper, for ``pointpred reproduce``."""

from __future__ import annotations

from pointpred.reproduction.figure import CAMERA, THESIS, Entry, diagram
from pointpred_observers.reproduction import camera, interconnected, interlaced, reversed_connection

LISTED = (
    diagram("3.1", "interconnected systems with a reference signal", "As figure 1.4."),
    diagram("3.2", "interconnected systems with a reference signal", "As figure 1.4."),
    Entry(
        "3.3",
        THESIS,
        "example 1: outputs and states with their estimates",
        "J has one row, 3/2 1/2, because H has one. The printed P, Q, Gamma, Xi and U satisfy no "
        "certificate; the printed gain M has another one. P^-1 U differs from the printed M by no more than "
        "the rounding of P and U. The noise is not printed: uniform within 0.05, seed 1.",
        interconnected.figure_3_3,
    ),
    Entry(
        "3.4",
        THESIS,
        "example 2: x and Pi w of the bioreactor",
        "Pi holds but is not unique: S_in1 = S_in2 is assumed. The period of the inflow is not printed: 40 "
        "s. Where the inflow jumps, (Pi w)2 jumps and x2 does not.",
        interconnected.figure_3_4,
    ),
    Entry(
        "3.5",
        THESIS,
        "example 2: the observer of w",
        "With the printed gain and without projection the estimate becomes negative and stays there; with "
        "projection it converges more slowly than without any gain. (3.10) and (3.11) do not hold.",
        interconnected.figure_3_5,
    ),
    Entry(
        "3.6",
        THESIS,
        "example 3: the robotic arm, its observer and the reference",
        "The observer converges as printed. From the printed start the arm comes back to the reference; "
        "from w(0) = (1, 1, 1, 1), drawn beside it, it does not: assumption 3.2.3 fails with the real B, "
        "which drives the motor only.",
        interconnected.figure_3_6,
    ),
    Entry(
        "3.7",
        THESIS,
        "example 4: two circuits and the observer with the printed gain",
        "The first entry of L1 is -20/7, printed without its sign. The printed W is indefinite, so it "
        "bounds no sector, and no certificate covers the trajectory; the printed gain converges all the "
        "same.",
        interconnected.figure_3_7,
    ),
    Entry(
        "3.8",
        THESIS,
        "example 5: the reduced-order observer of two masses",
        "A0[4, 4] is -a1 - a2, as the printed S0 needs it, and Q has a second column for u1. The printed F "
        "and W are impossible; Upsilon = diag(-1, 1) has a certificate everywhere and is drawn beside the "
        "print.",
        reversed_connection.figure_3_8,
    ),
    Entry(
        "3.9",
        THESIS,
        "example 6: nonlinear regression (the caption says example 2)",
        "The estimates converge, but the condition of theorem 3.3.3 does not hold on this example. The "
        "start of the estimate is not printed: 0.",
        reversed_connection.figure_3_9,
    ),
    Entry(
        "3.10",
        THESIS,
        "example 7: parameters of the sniffer data by recursive least squares",
        "Without sniffer.csv a simulated stand-in is used. (3.61) is singular for the first three samples: "
        "ours starts exactly from the fourth, and ends in ordinary least squares; a ridge of 1 does not. "
        "The parameters are not printed as numbers.",
        reversed_connection.figure_3_10,
        reads=reversed_connection.SNIFFER,
    ),
    Entry(
        "3.11",
        THESIS,
        "example 7: given and estimated signal",
        "As 3.10.",
        reversed_connection.figure_3_11,
        reads=reversed_connection.SNIFFER,
    ),
    diagram("4.1", "connected systems", "As figure 1.2."),
    Entry(
        "4.2",
        THESIS,
        "example 8: an interlaced system, its steady state and its observer",
        "The final list prints pi_4 = w2 + w1^2; the text before it has w2 + w1^3, which is right. The "
        "numerator of u lacks w1^3 + w2 in the print. The strength of the noise "
        "is not printed: uniform within 0.2.",
        interlaced.figure_4_2,
    ),
    diagram("4.3", "schematics of example 9", "The masses of figure 4.4."),
    Entry(
        "4.4",
        THESIS,
        "example 9: two masses on springs, their steady state and its estimate",
        "tau1 and tau2 are other polynomials: the printed ones do not satisfy the equations of the masses. "
        "The linear part of u is right. The noise is not printed: uniform within 0.05.",
        interlaced.figure_4_4,
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
