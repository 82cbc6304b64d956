"""The nonlinear regressor (3.49)-(3.51) as compiled laws in a flat array."""

from __future__ import annotations

from math import ceil

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law, layout
from pointpred.observers import nonlinearity
from pointpred.observers.regressors import gradient_law

TAKEN, BACKWARDS, TOO_FAST, UNUSABLE = 0, 1, 2, 3
"""What became of a sample."""
STEPS_MOST = 10_000
"""Bound on the cost of one sample."""
STEP_MOST = 0.5
"""Longest step of the integration, in units of the fastest time constant."""

# Parameters: unknowns n, outputs r, gain, code of f, its steepest slope, then the start (n). The state
# behind them: known, time, the estimate less its start (n), the last sample, then room for one in
# between (a sample is r rows of J, r outputs, the weight D1) and for the integration (3 n).
COUNT, OUTPUTS, GAIN, CODE, STEEPEST, START = 0, 1, 2, 3, 4, 5


@layout
def width(n: int, r: int) -> int:
    """Floats of a sample."""
    return r * n + r + 1


@layout
def states(n: int, r: int) -> int:
    """Floats of the state."""
    return 2 + n + 2 * width(n, r) + 3 * n


@law
def pace(sample: FloatArray, at: int, n: int, r: int) -> float:
    """The sum of the squares of J, which bounds the eigenvalues of J'J."""
    total = 0.0
    for i in range(r * n):
        total += sample[at + i] * sample[at + i]
    return total


@law
def slope(memory: FloatArray, theta: int, sample: int, to: int) -> None:
    """Write g J'(y - (1 - D1) J theta - D1 f(J theta)) at ``to``; theta without its start."""
    n, r = int(memory[COUNT]), int(memory[OUTPUTS])
    weight = memory[sample + r * n + r]
    for i in range(n):
        memory[to + i] = 0.0
    for row in range(r):
        s = 0.0
        for i in range(n):
            s += memory[sample + row * n + i] * (memory[theta + i] + memory[START + i])
        error = memory[sample + r * n + row] - (1.0 - weight) * s
        error -= weight * nonlinearity.value(memory[CODE], s)
        for i in range(n):
            memory[to + i] += memory[GAIN] * memory[sample + row * n + i] * error


@law
def flow(
    memory: FloatArray, sample: FloatArray, theta: int, last: int, begin: float, h: float, dt: float
) -> None:
    """A step of the classical Runge-Kutta method over the share ``h`` of the interval ``dt``."""
    n, r = int(memory[COUNT]), int(memory[OUTPUTS])
    wide = width(n, r)
    between, room = last + wide, last + 2 * wide
    for i in range(n):
        memory[room + i] = memory[theta + i]
        memory[room + 2 * n + i] = 0.0
    for part in range(4):
        at = begin + (0.0 if part == 0 else h if part == 3 else 0.5 * h)
        for i in range(wide):
            memory[between + i] = memory[last + i] + at * (sample[i] - memory[last + i])
        slope(memory, room, between, room + n)
        weight = 1.0 if part == 0 or part == 3 else 2.0
        ahead = h * dt if part == 2 else 0.5 * h * dt
        for i in range(n):
            memory[room + 2 * n + i] += weight * memory[room + n + i]
            memory[room + i] = memory[theta + i] + ahead * memory[room + n + i]
    for i in range(n):
        memory[theta + i] += h * dt / 6.0 * memory[room + 2 * n + i]


@law
def step(memory: FloatArray, t: float, sample: FloatArray, out: FloatArray) -> int:
    """Take in a sample at ``t``, the estimate to ``out``; a sample that is not taken changes nothing."""
    n, r = int(memory[COUNT]), int(memory[OUTPUTS])
    known = START + n
    theta, last = known + 2, known + 2 + n
    if not gradient_law.finite(t, sample) or not 0.0 <= sample[r * n + r] <= 1.0:
        return UNUSABLE
    if memory[known] == 1.0:
        dt = t - memory[known + 1]
        if dt < 0.0:
            return BACKWARDS
        steep = max(pace(memory, last, n, r), pace(sample, 0, n, r))
        needed = memory[GAIN] * steep * memory[STEEPEST] * dt / STEP_MOST
        if not needed <= STEPS_MOST:
            return TOO_FAST
        steps = max(1, ceil(needed))
        if dt > 0.0:
            for i in range(steps):
                flow(memory, sample, theta, last, i / steps, 1.0 / steps, dt)
    memory[known], memory[known + 1] = 1.0, t
    for i in range(width(n, r)):
        memory[last + i] = sample[i]
    for i in range(n):
        out[i] = memory[theta + i] + memory[START + i]
    return TAKEN


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table of time and sample; a row that is not taken keeps NaN."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        step(memory, rows[i, 0], rows[i, 1:], out[i])
