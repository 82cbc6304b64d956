"""The laws of identification: reports gathered into short windows of displacement, then learnt.

A cursor moves in whole pixels, so its speed between two reports at 1 kHz is nearly all rounding, and the
length of a rounded step is biased. Over a window, the displacement of an axis is
sum of h (V_x / V) PTF(V) = sum_i c_i (sum of h V_x V^(i-1)): linear in c, and wrong by a pixel at most.
"""

from __future__ import annotations

from math import hypot

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.events import LARGEST, LATEST_S, ROUNDING_S
from pointpred.regression import least_squares
from pointpred.transfer import bands
from pointpred.transfer.known import COEFFICIENTS_MOST

# Parameters: number of coefficients, the power of the first (0 or 1), ...
N, POWER, METRES_PER_COUNT, METRES_PER_PX, WINDOW_S, GAP_S, FORGETTING, SPEED_LOW, BAND_WIDTH = range(9)
SETTINGS = 9
# State: the last report, counts that wait for the time to pass, the window so far, what was left out.
KNOWN, T, X, Y, WAITING_X, WAITING_Y = 9, 10, 11, 12, 13, 14
START_X, START_Y, PATH, DURATION, SKIPPED, ROW_X = 15, 16, 17, 18, 19, 20
ROW_Y = ROW_X + COEFFICIENTS_MOST
ROW = ROW_Y + COEFFICIENTS_MOST
SOLVER = ROW + COEFFICIENTS_MOST
BANDS = SOLVER + least_squares.states(COEFFICIENTS_MOST)
STATES = BANDS + bands.states(COEFFICIENTS_MOST) - SETTINGS

REFUSED, TAKEN, LEFT_OUT = -1.0, 0.0, 1.0


@law
def learn(memory: FloatArray, row: int, output: float, speed: float) -> None:
    """Take in output = row . c at a speed of the hand, into the recursion and into its band."""
    n = int(memory[N])
    for j in range(n):
        memory[SOLVER + least_squares.REGRESSOR + j] = memory[row + j]
    least_squares.advance(memory, SOLVER, n, memory[FORGETTING], output)
    band = (speed - memory[SPEED_LOW]) / memory[BAND_WIDTH]
    linear = 1 - int(memory[POWER])
    bands.learn(memory, BANDS, n, linear, band, memory[FORGETTING], row, output)


@law
def learn_speeds(memory: FloatArray, speed: float, cursor_speed: float) -> None:
    """Take in one pair of speeds in m/s, as in section 2.5.1: the regressor is made of powers of V."""
    value = 1.0 if memory[POWER] == 0.0 else speed
    for j in range(int(memory[N])):
        memory[ROW + j] = value
        value *= speed
    learn(memory, ROW, cursor_speed, speed)


@law
def open_window(memory: FloatArray) -> None:
    """Start a window at the last report."""
    memory[START_X], memory[START_Y] = memory[X], memory[Y]
    memory[PATH] = 0.0
    memory[DURATION] = 0.0
    memory[ROW_X:ROW] = 0.0


@law
def gather(memory: FloatArray, dt: float, dx: float, dy: float) -> None:
    """Add one report's path to the rows of both axes."""
    u, v = dx * memory[METRES_PER_COUNT], dy * memory[METRES_PER_COUNT]
    path = hypot(u, v)
    memory[PATH] += path
    memory[DURATION] += dt
    if path == 0.0:
        return
    speed = path / dt
    factor = 1.0 / speed if memory[POWER] == 0.0 else 1.0
    for j in range(int(memory[N])):
        memory[ROW_X + j] += u * factor
        memory[ROW_Y + j] += v * factor
        factor *= speed


@law
def step(memory: FloatArray, t: float, x: float, y: float, dx: float, dy: float) -> float:
    """One report of the device with the cursor's position after it: refused, taken or left out."""
    if not (abs(t) <= LATEST_S and abs(x) + abs(y) + abs(dx) + abs(dy) <= LARGEST):
        return REFUSED
    known, dt = memory[KNOWN] == 1.0, t - memory[T]
    if known and dt < 0.0:
        return REFUSED
    memory[KNOWN] = 1.0
    memory[T], memory[X], memory[Y] = t, x, y
    if not known or dt > memory[GAP_S] + ROUNDING_S:
        memory[SKIPPED] += 1.0
        memory[WAITING_X], memory[WAITING_Y] = 0.0, 0.0
        open_window(memory)
        return LEFT_OUT
    memory[WAITING_X] += dx
    memory[WAITING_Y] += dy
    if dt == 0.0:
        return TAKEN
    gather(memory, dt, memory[WAITING_X], memory[WAITING_Y])
    memory[WAITING_X], memory[WAITING_Y] = 0.0, 0.0
    if memory[DURATION] >= memory[WINDOW_S]:
        if memory[PATH] > 0.0:
            speed = memory[PATH] / memory[DURATION]
            learn(memory, ROW_X, (x - memory[START_X]) * memory[METRES_PER_PX], speed)
            learn(memory, ROW_Y, (y - memory[START_Y]) * memory[METRES_PER_PX], speed)
        open_window(memory)
    return TAKEN


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table of events; a row marked ``begin`` starts a trial, it forgets no speeds."""
    for i in range(len(rows)):
        if begin[i]:
            memory[KNOWN] = 0.0
        r = rows[i]
        out[i, 0] = step(memory, r[0], r[1], r[2], r[3], r[4])
