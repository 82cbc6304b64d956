"""Offsets of the numbers of one simulated trial in its flat memory: parameters first, then the state."""

from __future__ import annotations

from pointpred.stage import offsets
from pointpred.transfer import functions, pixels

# The setup: report period s, Euler sub-steps a report, px on the screen a metre of PTF output, metres a count
# (0: no sensor, the cursor is continuous and seen at once), assisted term 1/s and its bound as a share of the
# hand's own motion, then the PTF.
PERIOD_S, SUBSTEPS, PX_PER_METRE, METRES_PER_COUNT, RHO, STRENGTH, FUNCTION = range(7)

# The person: friction 1/s; feedback in m/s^2 a px, 0 where it follows from RATE (1/s) and the gain felt; lag
# of the muscles s; delay of the eyes s; noise as a share of the speed; tremor m/s.
B1 = FUNCTION + functions.SLOTS
B2, RATE, MUSCLE_S, DELAY_S, NOISE, TREMOR = range(B1 + 1, B1 + 7)

# The trial, px from its start: target's centre and radius, aim of the last phase; times s; then the pieces.
TARGET_X, TARGET_Y, RADIUS, AIM_X, AIM_Y = range(TREMOR + 1, TREMOR + 6)
REACTION_S, VERIFY_S, PRESS_S, PATIENCE_S, PIECES, PIECE = range(AIM_Y + 1, AIM_Y + 7)

# Of each piece (sub-movement): share of the way that remains, duration s, skew of its speed, turn and
# curvature rad, and the share of its duration after which the next piece or the corrective phase begins.
SHARE, DURATION_S, SKEW, TURN, CURVE, UNTIL, PIECE_SLOTS = range(7)
PIECES_MOST = 4
SETTINGS = PIECE + PIECE_SLOTS * PIECES_MOST

# State: reports so far, phase and when it began (s), number, amplitude (m) and angle (rad) of the piece;
TICK, PHASE, SINCE, NUMBER, AMPLITUDE, ANGLE, FEEDBACK = range(SETTINGS, SETTINGS + 7)
# hand: position m, velocity m/s, acceleration m/s^2, wandering (dimensionless);
U, V, VX, VY, AX, AY, WANDER_X, WANDER_Y = range(FEEDBACK + 1, FEEDBACK + 9)
# cursor in px from the start, counts reported so far, fractions of a px that the hand and the assisted term
# have not moved yet, and what the eyes have yet to see.
RING_ROWS, RING_SLOTS = 256, 4
_, X, Y, COUNTED_X, COUNTED_Y, CARRY, PULLED, RING, SIZE = offsets(
    WANDER_Y + 1, 1, 1, 1, 1, pixels.CARRIED, pixels.CARRIED, RING_ROWS * RING_SLOTS
)

WAITING, BALLISTIC, CORRECTIVE, VERIFYING, PRESSING, DONE = 0.0, 1.0, 2.0, 3.0, 4.0, 5.0
