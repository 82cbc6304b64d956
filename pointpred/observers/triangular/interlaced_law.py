"""The observer (4.16) as compiled laws: w' = A w + L (y - C w) followed exactly, then the maps evaluated."""

from __future__ import annotations

from math import ceil

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law, layout
from pointpred.observers.triangular import program as triangular_program

TAKEN, BACKWARDS = 0, 1
"""What became of a sample."""

# Parameters: states of the generator q, outputs p, rows of the program, where they begin, where the answers
# begin and how many there are, where the state begins, the longest interval over which outputs are joined by
# a line (s), the largest row sums of A - L C and of A (1/s); start, A and A - L C (q x q), L (q x p).
Q, P, ROWS, PROGRAM, ANSWERS, ANSWERED, STATE, GAP_S, FAST, SLOW, START = 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10
# The state: whether there was a sample, its time, whether its outputs were there, they (p), the estimate (q).
STARTED, T, SEEN, Y = 0, 1, 2, 3

ORDER = 14
"""Terms of the exponential series; with a norm of at most 1/2 the rest lies below 1e-16."""
NEGLIGIBLE = 1e-18
"""Share of the estimate below which the rest of the series cannot be seen in it."""
STEPS_MOST = 4096
"""Sub-steps of one interval; after a longer one the estimate begins anew."""


@layout
def settings(q: int, p: int) -> int:
    """Floats before the program."""
    return START + q + 2 * q * q + q * p


@layout
def states(q: int, p: int) -> int:
    """Floats of the state, with two vectors to compute in, before what the program computes."""
    return Y + p + 3 * q


@law
def drive(memory: FloatArray, i: int, k: int, passed: float, share: float, sample: FloatArray) -> float:
    """What L y adds to row i of the first two derivatives, y on a line from the last sample to this one."""
    q, p = int(memory[Q]), int(memory[P])
    gain, last = START + q + 2 * q * q + i * p, int(memory[STATE]) + Y
    total = 0.0
    for j in range(p):
        rise = sample[j] - memory[last + j]
        total += memory[gain + j] * (memory[last + j] + passed * rise if k == 1 else share * rise)
    return total


@law
def follow(memory: FloatArray, matrix: int, h: float, steps: int, sample: FloatArray, driven: bool) -> None:
    """Follow w' = M w + L y over ``h`` s by the exponential series; without L y unless ``driven``."""
    q = int(memory[Q])
    w = int(memory[STATE]) + Y + int(memory[P])
    term, after = w + q, w + 2 * q
    for n in range(steps):
        for k in range(1, ORDER + 1):
            source = w if k == 1 else term
            for i in range(q):
                total = drive(memory, i, k, n / steps, 1.0 / steps, sample) if driven and k <= 2 else 0.0
                for j in range(q):
                    total += memory[matrix + i * q + j] * memory[source + j]
                memory[after + i] = total * h / (steps * k)
            moved, most = 0.0, 0.0
            for i in range(q):
                memory[term + i] = memory[after + i]
                memory[w + i] += memory[after + i]
                moved = max(moved, abs(memory[after + i]))
                most = max(most, abs(memory[w + i]))
            if k > 2 and moved <= NEGLIGIBLE * most:
                break


@law
def step(memory: FloatArray, t: float, sample: FloatArray, out: FloatArray) -> int:
    """Take in outputs at ``t`` (NaN: not measured), the answers to ``out``; time backwards changes nothing.

    Over an interval longer than ``gap_s``, or with an end that was not measured, the generator runs alone.
    """
    q, p, state = int(memory[Q]), int(memory[P]), int(memory[STATE])
    w, a, h = state + Y + p, START + q, t - memory[state + T]
    started = memory[state + STARTED] == 1.0
    if started and h < 0.0:
        return BACKWARDS
    measured = True
    for j in range(p):
        if sample[j] != sample[j]:
            measured = False
    driven = measured and memory[state + SEEN] == 1.0 and h <= memory[GAP_S]
    steps = max(1.0, ceil(2.0 * h * memory[FAST if driven else SLOW]))
    if started and steps <= STEPS_MOST:
        follow(memory, a + q * q if driven else a, h, int(steps), sample, driven)
    else:
        for i in range(q):
            memory[w + i] = memory[START + i]
    memory[state + STARTED], memory[state + T] = 1.0, t
    memory[state + SEEN] = 1.0 if measured else 0.0
    for j in range(p):
        memory[state + Y + j] = sample[j] if measured else 0.0
    triangular_program.execute(memory, int(memory[PROGRAM]), int(memory[ROWS]))
    for i in range(q):
        out[i] = memory[w + i]
    for i in range(int(memory[ANSWERED])):
        out[q + i] = memory[int(memory[ANSWERS]) + i]
    return TAKEN


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table of time and outputs; a row that is not taken keeps NaN."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        step(memory, rows[i, 0], rows[i, 1:], out[i])
