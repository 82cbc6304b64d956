"""The gradient estimators (3.46) and (3.58) as compiled laws in a flat array."""

from __future__ import annotations

from math import inf

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law, layout
from pointpred.regression import gradient

CONTINUOUS, DISCRETE, NORMALISED = 0.0, 1.0, 2.0
"""Kinds of law, as they stand in the memory."""
TAKEN, BACKWARDS, TOO_STEEP, UNUSABLE = 0, 1, 2, 3
"""What became of a sample."""

# Parameters: unknowns n, outputs p, kind of law, then the start (n) and the gain (n x n). The state
# behind them: whether there was a sample, its time, the estimate less its start (n), the last sample,
# the sample in between.
COUNT, OUTPUTS, KIND, START = 0, 1, 2, 3


@layout
def width(n: int, p: int) -> int:
    """Floats of a sample: p rows of the regressor, then p outputs."""
    return p * n + p


@layout
def known(n: int) -> int:
    """Where the state begins."""
    return START + n + n * n


@layout
def states(n: int, p: int) -> int:
    """Floats of the state."""
    return 2 + n + 2 * width(n, p)


@law
def finite(t: float, sample: FloatArray) -> bool:
    """Whether a time and every number of a sample are finite."""
    for i in range(len(sample)):
        if not abs(sample[i]) < inf:
            return False
    return abs(t) < inf


@law
def steepness(memory: FloatArray, sample: FloatArray, n: int, p: int) -> float:
    """The trace of D G D': the sum of the decay rates of the errors of the outputs, in 1/s or per sample."""
    gain = START + n
    total = 0.0
    for row in range(p):
        w = row * n
        for i in range(n):
            for j in range(n):
                total += sample[w + i] * memory[gain + i * n + j] * sample[w + j]
    return total


@law
def flow(memory: FloatArray, n: int, p: int, sample: int, h: float) -> None:
    """Follow (3.46) over ``h`` s: exact for one output, several there and back, of second order."""
    theta = known(n) + 2
    for i in range(2 * p):
        row = i if i < p else 2 * p - 1 - i
        output = memory[sample + p * n + row]
        for j in range(n):
            output -= memory[sample + row * n + j] * memory[START + j]
        gradient.descend_along(memory, theta, sample + row * n, n, START + n, output, 0.5 * h)


@law
def jump(memory: FloatArray, n: int, p: int, sample: int, share: float) -> None:
    """One step of (3.58) with ``share`` of the gain; the outputs at ``sample`` become their errors."""
    theta, gain, errors = known(n) + 2, START + n, sample + p * n
    for row in range(p):
        for j in range(n):
            memory[errors + row] -= memory[sample + row * n + j] * (memory[START + j] + memory[theta + j])
    for row in range(p):
        for i in range(n):
            for j in range(n):
                way = memory[gain + i * n + j] * memory[sample + row * n + j]
                memory[theta + i] += share * way * memory[errors + row]


@law
def step(memory: FloatArray, t: float, sample: FloatArray, out: FloatArray) -> int:
    """Take in a sample at ``t``, the estimate to ``out``; a sample that is not taken changes nothing."""
    n, p = int(memory[COUNT]), int(memory[OUTPUTS])
    state, wide = known(n), width(n, p)
    last = state + 2 + n
    middle = last + wide
    if not finite(t, sample):
        return UNUSABLE
    started, h = memory[state] == 1.0, t - memory[state + 1]
    if started and h < 0.0:
        return BACKWARDS
    if memory[KIND] == CONTINUOUS:
        for i in range(wide):
            memory[middle + i] = 0.5 * (memory[last + i] + sample[i])
        if started:
            flow(memory, n, p, middle, h)
    else:
        steep = steepness(memory, sample, n, p)
        if memory[KIND] == DISCRETE and not steep < 2.0:
            return TOO_STEEP
        for i in range(wide):
            memory[middle + i] = sample[i]
        jump(memory, n, p, middle, 1.0 / (1.0 + steep) if memory[KIND] == NORMALISED else 1.0)
    for i in range(wide):
        memory[last + i] = sample[i]
    memory[state], memory[state + 1] = 1.0, t
    for i in range(n):
        out[i] = memory[START + i] + memory[state + 2 + i]
    return TAKEN


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table of time and sample; a row that is not taken keeps NaN."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        step(memory, rows[i, 0], rows[i, 1:], out[i])
