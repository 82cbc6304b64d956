"""The law of observers of Persidskii form: w' (or the next w) = N w + L f(Jw + R i) + K i, and its output."""

from __future__ import annotations

from math import ceil

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.stage import loop_into
from pointpred_observers import nonlinearity

# Parameters: states q, components k, inputs, outputs, discrete?, step, gap after which the law starts again,
# longest interval that it bridges; then codes (k), N (q, q), L (q,
# k), J (k, q), K (q, inputs), R0 (outputs, q), R1 (outputs, k), R (k, inputs), R2 (outputs, inputs) and the
# start (q). Then what replaces missing inputs: whether it is a value (inputs), V0 (inputs, q), V1 (inputs,
# k), V2 (inputs, inputs), and their start (inputs). The state: whether there was a sample, t, w minus its
# start (q), the last inputs, scratch space for an integration step, and whether each of the last inputs was
# missing.
STATES, COMPONENTS, INPUTS, OUTPUTS, DISCRETE, STEP, GAP, BRIDGED, CODES = range(9)

ACCEPTED, REPEATED, BACKWARDS, TOO_LONG, SKIPPED = 0, 1, 2, 3, 4
STEPS_MOST = 100_000
"""Most steps between two samples."""


@law
def injected_at(q: int, k: int, inputs: int, outputs: int) -> int:
    """Offset of R, through which inputs enter the nonlinearity; R2 follows it."""
    return CODES + k + q * q + 2 * q * k + q * inputs + outputs * (q + k)


@law
def start_at(q: int, k: int, inputs: int, outputs: int) -> int:
    """Offset of the start."""
    return injected_at(q, k, inputs, outputs) + (k + outputs) * inputs


@law
def replaced_at(q: int, k: int, inputs: int, outputs: int) -> int:
    """Offset of what replaces missing inputs."""
    return start_at(q, k, inputs, outputs) + q


@law
def state_at(q: int, k: int, inputs: int, outputs: int) -> int:
    """Offset of the state."""
    return replaced_at(q, k, inputs, outputs) + inputs * (2 + q + k + inputs)


@law
def room(q: int, k: int, inputs: int) -> int:
    """Number of floats of scratch space."""
    return 4 * (q + inputs) + k


@law
def floats(q: int, k: int, inputs: int) -> int:
    """Number of floats of the state."""
    return 2 + q + inputs + room(q, k, inputs) + inputs


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
def replace(memory: FloatArray, w: int, inputs: int, nonlinear: int, absent: int) -> None:
    """Write the missing inputs that are values, V0 w + V1 f(Jw + R i), of which R reads V0 w only."""
    q, k, m = int(memory[STATES]), int(memory[COMPONENTS]), int(memory[INPUTS])
    valued = replaced_at(q, k, m, int(memory[OUTPUTS]))
    j_at, r_at = CODES + k + q * q + q * k, injected_at(q, k, m, int(memory[OUTPUTS]))
    v0, v1 = valued + m, valued + m + m * q
    for j in range(m):
        if memory[absent + j] == 1.0 and memory[valued + j] == 1.0:
            value = 0.0
            for i in range(q):
                value += memory[v0 + j * q + i] * memory[w + i]
            memory[inputs + j] = value
    for j in range(k):
        s = 0.0
        for i in range(q):
            s += memory[j_at + j * q + i] * memory[w + i]
        for i in range(m):
            s += memory[r_at + j * m + i] * memory[inputs + i]
        memory[nonlinear + j] = nonlinearity.value(memory[CODES + j], s)
    for j in range(m):
        if memory[absent + j] == 1.0 and memory[valued + j] == 1.0:
            for i in range(k):
                memory[inputs + j] += memory[v1 + j * k + i] * memory[nonlinear + i]


@law
def onward(memory: FloatArray, j: int, w: int, inputs: int, nonlinear: int) -> float:
    """V0 w + V1 f + V2 i: the rate of a missing input, in discrete time its next value."""
    q, k, m = int(memory[STATES]), int(memory[COMPONENTS]), int(memory[INPUTS])
    v0 = replaced_at(q, k, m, int(memory[OUTPUTS])) + m
    v1, v2 = v0 + m * q, v0 + m * (q + k)
    total = 0.0
    for i in range(q):
        total += memory[v0 + j * q + i] * memory[w + i]
    for i in range(k):
        total += memory[v1 + j * k + i] * memory[nonlinear + i]
    for i in range(m):
        total += memory[v2 + j * m + i] * memory[inputs + i]
    return total


@law
def bridge(memory: FloatArray, w: int, row: FloatArray, length: float, h: float, absent: int) -> None:
    """A step of ``flow`` for inputs of which some are missing: these follow what replaces them.

    ``length`` s are left until the sample ``row``; the step takes ``h`` s. The inputs behind w are states
    here.
    """
    q, k, m = int(memory[STATES]), int(memory[COMPONENTS]), int(memory[INPUTS])
    valued = replaced_at(q, k, m, int(memory[OUTPUTS]))
    size = q + m
    total = w + size
    stage, change, first = total + size, total + 2 * size, total + 3 * size
    nonlinear = total + 4 * size
    for i in range(size):
        memory[first + i] = memory[w + i]
        memory[stage + i] = memory[w + i]
        memory[total + i] = 0.0
    for part in range(4):
        replace(memory, stage, stage + q, nonlinear, absent)
        slope(memory, stage, stage + q, nonlinear, change)
        for j in range(m):
            if memory[absent + j] == 0.0:
                memory[change + q + j] = (row[1 + j] - memory[first + q + j]) / length
            elif memory[valued + j] == 1.0:
                memory[change + q + j] = 0.0
            else:
                memory[change + q + j] = onward(memory, j, stage, stage + q, nonlinear)
        weight = 1.0 if part == 0 or part == 3 else 2.0
        ahead = h if part == 2 else 0.5 * h
        for i in range(size):
            memory[total + i] += weight * memory[change + i]
            memory[stage + i] = memory[first + i] + ahead * memory[change + i]
    for i in range(size):
        memory[w + i] = memory[first + i] + h / 6.0 * memory[total + i]


@law
def move(memory: FloatArray, row: FloatArray, w: int, absent: int, missing: bool) -> None:
    """Carry w, and missing inputs, from the last sample to ``row``."""
    q, k, m = int(memory[STATES]), int(memory[COMPONENTS]), int(memory[INPUTS])
    last, space, h = w + q, w + q + m, row[0] - memory[w - 1]
    if memory[DISCRETE] == 1.0:
        nonlinear, following = space + 4 * q, space + 4 * q + k
        slope(memory, w, last, nonlinear, space)
        for j in range(m):
            memory[following + j] = onward(memory, j, w, last, nonlinear) if missing else 0.0
        for i in range(q):
            memory[w + i] = memory[space + i]
        for j in range(m):
            memory[last + j] = memory[following + j]
        return
    count = max(1, ceil(min(h / memory[STEP], STEPS_MOST)))
    for i in range(count):
        if missing:
            bridge(memory, w, row, h * (count - i) / count, h / count, absent)
        else:
            flow(memory, w, row, i / count, 1.0 / count)


@law
def advance(memory: FloatArray, row: FloatArray) -> int:
    """Process the sample (t, inputs), NaN for a missing one; a repeated t replaces the inputs it has.

    A sample after more than the longest interval that is bridged is refused, in discrete time one whose index
    is not the next: a sample is one step.
    """
    q, k, m = int(memory[STATES]), int(memory[COMPONENTS]), int(memory[INPUTS])
    outputs = int(memory[OUTPUTS])
    start, started = start_at(q, k, m, outputs), state_at(q, k, m, outputs)
    t, w = started + 1, started + 2
    last, space = w + q, w + q + m
    absent = space + room(q, k, m)
    h = row[0] - memory[t]
    if memory[started] == 1.0 and h < 0.0:
        return BACKWARDS
    if memory[started] == 1.0 and h == 0.0:
        for j in range(m):
            if row[1 + j] == row[1 + j]:
                memory[last + j], memory[absent + j] = row[1 + j], 0.0
        return REPEATED
    if memory[started] == 1.0 and memory[DISCRETE] == 1.0 and h != 1.0:
        return SKIPPED
    missing = False
    begin = memory[started] == 0.0 or (memory[DISCRETE] == 0.0 and h > memory[GAP])
    if not begin and memory[DISCRETE] == 0.0 and h > memory[BRIDGED]:
        return TOO_LONG
    for j in range(m):
        if row[1 + j] != row[1 + j]:
            memory[absent + j] = 1.0
        if memory[absent + j] == 1.0:
            missing = True
    if begin:
        for i in range(q):
            memory[w + i] = memory[start + i]
        first = replaced_at(q, k, m, outputs) + m * (1 + q + k + m)
        for j in range(m):
            memory[last + j] = memory[first + j]
    else:
        for i in range(q):
            memory[w + i] += memory[start + i]
        move(memory, row, w, absent, missing)
    if missing:
        for j in range(m):
            if row[1 + j] == row[1 + j]:
                memory[last + j], memory[absent + j] = row[1 + j], 0.0
        replace(memory, w, last, space + 4 * q, absent)
    else:
        for j in range(m):
            memory[last + j] = row[1 + j]
    for i in range(q):
        memory[w + i] -= memory[start + i]
    memory[started], memory[t] = 1.0, row[0]
    return ACCEPTED


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
    w = state_at(q, k, m, p) + 2
    last, nonlinear = w + q, w + q + m + 4 * q
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
    """Integrate to the sample (t, inputs) and return the outputs; a t that is refused changes nothing."""
    verdict = advance(memory, row)
    if verdict < BACKWARDS:
        read(memory, out)
    return verdict


loop = loop_into(step)
