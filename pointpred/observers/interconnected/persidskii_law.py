"""The law of observers of Persidskii form: w' (or the next w) = N w + L f(Jw + R i) + K i, and its output."""

from __future__ import annotations

from math import ceil

from pointpred.columns import FloatArray
from pointpred.compiled import law, layout
from pointpred.observers import nonlinearity
from pointpred.stage import loop_into

# Parameters: states q, components k, inputs, outputs, discrete?, step, gap; then codes (k), N (q, q), L (q,
# k), J (k, q), K (q, inputs), R0 (outputs, q), R1 (outputs, k), R (k, inputs), R2 (outputs, inputs) and the
# start (q). The state: whether there was a sample, t, w minus its start (q), the last inputs, and scratch
# space for an integration step.
STATES, COMPONENTS, INPUTS, OUTPUTS, DISCRETE, STEP, GAP, CODES = range(8)

ACCEPTED, REPEATED, BACKWARDS = 0, 1, 2


@layout
def injected_at(q: int, k: int, inputs: int, outputs: int) -> int:
    """Offset of R, through which inputs enter the nonlinearity; R2 follows it."""
    return CODES + k + q * q + 2 * q * k + q * inputs + outputs * (q + k)


@layout
def start_at(q: int, k: int, inputs: int, outputs: int) -> int:
    """Offset of the start."""
    return injected_at(q, k, inputs, outputs) + (k + outputs) * inputs


@layout
def floats(q: int, k: int, inputs: int) -> int:
    """Number of floats of the state."""
    return 2 + q + inputs + 4 * q + k + inputs


@law
def slope(memory: FloatArray, w: int, inputs: int, nonlinear: int, to: int) -> None:
    """N w + L f(Jw + R i) + K i, read at three offsets of the memory and written at a fourth."""
    q, k, m = int(memory[STATES]), int(memory[COMPONENTS]), int(memory[INPUTS])
    n_at = CODES + k
    l_at = n_at + q * q
    j_at = l_at + q * k
    k_at = j_at + q * k
    r_at = injected_at(q, k, m, int(memory[OUTPUTS]))
    for j in range(k):
        s = 0.0
        for i in range(q):
            s += memory[j_at + j * q + i] * memory[w + i]
        for i in range(m):
            s += memory[r_at + j * m + i] * memory[inputs + i]
        memory[nonlinear + j] = nonlinearity.value(memory[CODES + j], s)
    for i in range(q):
        change = 0.0
        for j in range(q):
            change += memory[n_at + i * q + j] * memory[w + j]
        for j in range(k):
            change += memory[l_at + i * k + j] * memory[nonlinear + j]
        for j in range(m):
            change += memory[k_at + i * m + j] * memory[inputs + j]
        memory[to + i] = change


@law
def flow(memory: FloatArray, w: int, row: FloatArray, begin: float, h: float) -> None:
    """One step of the classical Runge-Kutta method at w, with inputs linear between the last ones and row.

    ``begin`` and ``h`` are fractions of the interval between the two samples, whose length is row[0] - t.
    """
    q, k, m = int(memory[STATES]), int(memory[COMPONENTS]), int(memory[INPUTS])
    last, room = w + q, w + q + m
    total, stage, change, first = room, room + q, room + 2 * q, room + 3 * q
    nonlinear, inputs = room + 4 * q, room + 4 * q + k
    length = h * (row[0] - memory[w - 1])
    for i in range(q):
        value = memory[w + i]
        memory[first + i] = value
        memory[stage + i] = value
        memory[total + i] = 0.0
    for part in range(4):
        at = begin + (0.0 if part == 0 else h if part == 3 else 0.5 * h)
        for j in range(m):
            memory[inputs + j] = memory[last + j] + at * (row[1 + j] - memory[last + j])
        slope(memory, stage, inputs, nonlinear, change)
        weight = 1.0 if part == 0 or part == 3 else 2.0
        ahead = length if part == 2 else 0.5 * length
        for i in range(q):
            memory[total + i] += weight * memory[change + i]
            memory[stage + i] = memory[first + i] + ahead * memory[change + i]
    for i in range(q):
        memory[w + i] = memory[first + i] + length / 6.0 * memory[total + i]


@law
def advance(memory: FloatArray, row: FloatArray) -> int:
    """Process the sample (t, inputs): continue or start; a repeated t replaces its inputs."""
    q, k, m = int(memory[STATES]), int(memory[COMPONENTS]), int(memory[INPUTS])
    start = start_at(q, k, m, int(memory[OUTPUTS]))
    started = start + q
    t, w = started + 1, started + 2
    last, room = w + q, w + q + m
    h = row[0] - memory[t]
    verdict = ACCEPTED
    if memory[started] == 1.0 and h < 0.0:
        return BACKWARDS
    if memory[started] == 0.0 or (memory[DISCRETE] == 0.0 and h > memory[GAP]):
        for i in range(q):
            memory[w + i] = 0.0
    elif h == 0.0:
        verdict = REPEATED
    else:
        for i in range(q):
            memory[w + i] += memory[start + i]
        if memory[DISCRETE] == 1.0:
            slope(memory, w, last, room + 4 * q, room)
            for i in range(q):
                memory[w + i] = memory[room + i]
        else:
            count = max(1, ceil(h / memory[STEP]))
            for i in range(count):
                flow(memory, w, row, i / count, 1.0 / count)
        for i in range(q):
            memory[w + i] -= memory[start + i]
    memory[started], memory[t] = 1.0, row[0]
    for j in range(m):
        memory[last + j] = row[1 + j]
    return verdict


@law
def read(memory: FloatArray, out: FloatArray) -> None:
    """R0 w + R1 f(Jw + R i) + R2 i."""
    q, k, m, p = int(memory[STATES]), int(memory[COMPONENTS]), int(memory[INPUTS]), int(memory[OUTPUTS])
    start = start_at(q, k, m, p)
    j_at = CODES + k + q * q + q * k
    r0_at = j_at + q * k + q * m
    r1_at = r0_at + p * q
    r_at = injected_at(q, k, m, p)
    r2_at = r_at + k * m
    w, last, nonlinear = start + q + 2, start + q + 2 + q, start + q + 2 + q + m + 4 * q
    for j in range(k):
        s = 0.0
        for i in range(m):
            s += memory[r_at + j * m + i] * memory[last + i]
        for i in range(q):
            s += memory[j_at + j * q + i] * (memory[w + i] + memory[start + i])
        memory[nonlinear + j] = nonlinearity.value(memory[CODES + j], s)
    for row in range(p):
        value = 0.0
        for i in range(q):
            value += memory[r0_at + row * q + i] * (memory[w + i] + memory[start + i])
        for j in range(k):
            value += memory[r1_at + row * k + j] * memory[nonlinear + j]
        for j in range(m):
            value += memory[r2_at + row * m + j] * memory[last + j]
        out[row] = value


@law
def step(memory: FloatArray, row: FloatArray, out: FloatArray) -> int:
    """Integrate to the sample (t, inputs) and return the outputs; an earlier t changes nothing."""
    verdict = advance(memory, row)
    if verdict != BACKWARDS:
        read(memory, out)
    return verdict


loop = loop_into(step)
