"""The law of observers of Persidskii form: w' (or the next w) = N w + L f(Jw + R i) + K i, and its output."""

from __future__ import annotations

from math import ceil
from typing import Annotated, NamedTuple

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import FloatArray, FloatTable
from pointpred.stage import loop_into
from pointpred_observers.plants import nonlinearity

ACCEPTED, REPEATED, BACKWARDS, TOO_LONG, SKIPPED = 0, 1, 2, 3, 4
STEPS_MOST = 100_000
"""Most steps between two samples."""


class Memory(Layout):
    """Sizes q, k, of inputs and outputs; times; then ``Matrices`` and ``State``, whose sizes follow."""

    states: float
    components: float
    inputs: float
    outputs: float
    discrete: float
    step_s: float
    gap_s: float
    """After a longer gap the law starts again."""
    bridged_s: float
    """The longest interval that it bridges."""
    rest: Annotated[FloatArray, None]


class Matrices(NamedTuple):
    """Codes of f (k); N (q, q), L (q, k), J (k, q), K (q, inputs); R0, R1, R and R2 of the outputs.

    Then what replaces missing inputs: whether it is a value (inputs), V0 (inputs, q), V1 (inputs, k), V2
    (inputs, inputs), and their start.
    """

    codes: FloatArray
    N: FloatTable
    L: FloatTable
    J: FloatTable
    K: FloatTable
    R0: FloatTable
    R1: FloatTable
    R: FloatTable
    R2: FloatTable
    start: FloatArray
    valued: FloatArray
    V0: FloatTable
    V1: FloatTable
    V2: FloatTable
    first: FloatArray


class State(NamedTuple):
    """Whether there was a sample, and t; w minus its start, then the last inputs; which inputs were missing.

    Between them the numbers of a step, each of w and the inputs, and f (k).
    """

    clock: FloatArray
    both: FloatArray
    total: FloatArray
    stage: FloatArray
    change: FloatArray
    first: FloatArray
    nonlinear: FloatArray
    absent: FloatArray


@law
def parts_of(memory: Memory) -> tuple[Matrices, State]:
    """The matrices and the state in their places."""
    q, k, m, p = int(memory.states), int(memory.components), int(memory.inputs), int(memory.outputs)
    n_at = k
    l_at = n_at + q * q
    j_at = l_at + q * k
    k_at = j_at + k * q
    r0_at = k_at + q * m
    r1_at = r0_at + p * q
    r_at = r1_at + p * k
    r2_at = r_at + k * m
    start_at = r2_at + p * m
    valued_at = start_at + q
    v0_at = valued_at + m
    v1_at = v0_at + m * q
    v2_at = v1_at + m * k
    first_at = v2_at + m * m
    clock_at = first_at + m
    both_at = clock_at + 2
    total_at = both_at + q + m
    stage_at = total_at + q + m
    change_at = stage_at + q + m
    step_at = change_at + q + m
    f_at = step_at + q + m
    absent_at = f_at + k
    matrices = Matrices(
        memory.rest[:n_at],
        memory.rest[n_at:l_at].reshape(q, q),
        memory.rest[l_at:j_at].reshape(q, k),
        memory.rest[j_at:k_at].reshape(k, q),
        memory.rest[k_at:r0_at].reshape(q, m),
        memory.rest[r0_at:r1_at].reshape(p, q),
        memory.rest[r1_at:r_at].reshape(p, k),
        memory.rest[r_at:r2_at].reshape(k, m),
        memory.rest[r2_at:start_at].reshape(p, m),
        memory.rest[start_at:valued_at],
        memory.rest[valued_at:v0_at],
        memory.rest[v0_at:v1_at].reshape(m, q),
        memory.rest[v1_at:v2_at].reshape(m, k),
        memory.rest[v2_at:first_at].reshape(m, m),
        memory.rest[first_at:clock_at],
    )
    state = State(
        memory.rest[clock_at:both_at],
        memory.rest[both_at:total_at],
        memory.rest[total_at:stage_at],
        memory.rest[stage_at:change_at],
        memory.rest[change_at:step_at],
        memory.rest[step_at:f_at],
        memory.rest[f_at:absent_at],
        memory.rest[absent_at : absent_at + m],
    )
    return matrices, state


@law
def along(total: float, row: FloatArray, vector: FloatArray) -> float:
    """A total and a row of a matrix times a vector."""
    for i in range(len(vector)):
        total += row[i] * vector[i]
    return total


@law
def bend(m: Matrices, w: FloatArray, inputs: FloatArray, to: FloatArray) -> None:
    """f(Jw + R i)."""
    for j in range(len(m.codes)):
        to[j] = nonlinearity.value(m.codes[j], along(along(0.0, m.J[j], w), m.R[j], inputs))


@law
def slope(m: Matrices, w: FloatArray, inputs: FloatArray, nonlinear: FloatArray, to: FloatArray) -> None:
    """N w + L f(Jw + R i) + K i, with f in ``nonlinear``."""
    bend(m, w, inputs, nonlinear)
    for i in range(len(m.start)):
        to[i] = along(along(along(0.0, m.N[i], w), m.L[i], nonlinear), m.K[i], inputs)


@law
def replace(
    m: Matrices, w: FloatArray, inputs: FloatArray, nonlinear: FloatArray, absent: FloatArray
) -> None:
    """Write the missing inputs that are values, V0 w + V1 f(Jw + R i), of which R reads V0 w only."""
    for j in range(len(inputs)):
        if absent[j] == 1.0 and m.valued[j] == 1.0:
            inputs[j] = along(0.0, m.V0[j], w)
    bend(m, w, inputs, nonlinear)
    for j in range(len(inputs)):
        if absent[j] == 1.0 and m.valued[j] == 1.0:
            inputs[j] = along(inputs[j], m.V1[j], nonlinear)


@law
def onward(m: Matrices, j: int, w: FloatArray, inputs: FloatArray, nonlinear: FloatArray) -> float:
    """V0 w + V1 f + V2 i: the rate of a missing input, in discrete time its next value."""
    return along(along(along(0.0, m.V0[j], w), m.V1[j], nonlinear), m.V2[j], inputs)


@law
def flow(m: Matrices, s: State, row: FloatArray, length: float, h: float, missing: bool) -> None:
    """One step of the classical Runge-Kutta method, of ``h`` s, where ``length`` s are left until ``row``.

    The inputs behind w are states, linear up to those of ``row``; missing ones follow what replaces them.
    """
    q, size = len(m.start), len(s.both)
    w, given = s.stage[:q], s.stage[q:]
    for i in range(size):
        s.first[i] = s.both[i]
        s.stage[i] = s.both[i]
        s.total[i] = 0.0
    for part in range(4):
        if missing:
            replace(m, w, given, s.nonlinear, s.absent)
        slope(m, w, given, s.nonlinear, s.change)
        for j in range(len(m.first)):
            if s.absent[j] == 0.0:
                s.change[q + j] = (row[1 + j] - s.first[q + j]) / length
            elif m.valued[j] == 1.0:
                s.change[q + j] = 0.0
            else:
                s.change[q + j] = onward(m, j, w, given, s.nonlinear)
        weight = 1.0 if part == 0 or part == 3 else 2.0
        ahead = h if part == 2 else 0.5 * h
        for i in range(size):
            s.total[i] += weight * s.change[i]
            s.stage[i] = s.first[i] + ahead * s.change[i]
    for i in range(size):
        s.both[i] = s.first[i] + h / 6.0 * s.total[i]


@law
def move(memory: Memory, m: Matrices, s: State, row: FloatArray, missing: bool) -> None:
    """Carry w, and missing inputs, from the last sample to ``row``."""
    h = row[0] - s.clock[1]
    if memory.discrete == 1.0:
        q = len(m.start)
        w, last = s.both[:q], s.both[q:]
        slope(m, w, last, s.nonlinear, s.total)
        for j in range(len(m.first)):
            s.total[q + j] = onward(m, j, w, last, s.nonlinear) if missing else 0.0
        for i in range(len(s.both)):
            s.both[i] = s.total[i]
        return
    count = max(1, ceil(min(h / memory.step_s, STEPS_MOST)))
    for i in range(count):
        flow(m, s, row, h * (count - i) / count, h / count, missing)


@law
def measure(s: State, last: FloatArray, row: FloatArray) -> None:
    """Take over the inputs that a sample has."""
    for j in range(len(last)):
        if row[1 + j] == row[1 + j]:
            last[j], s.absent[j] = row[1 + j], 0.0


@law
def advance(memory: Memory, m: Matrices, s: State, row: FloatArray) -> int:
    """Process the sample (t, inputs), NaN for a missing one; a repeated t replaces the inputs it has.

    A sample after more than the longest interval that is bridged is refused, in discrete time one whose index
    is not the next: a sample is one step.
    """
    q, inputs = len(m.start), len(m.first)
    w, last = s.both[:q], s.both[q:]
    started, discrete, h = s.clock[0] == 1.0, memory.discrete == 1.0, row[0] - s.clock[1]
    if started and h < 0.0:
        return BACKWARDS
    if started and h == 0.0:
        measure(s, last, row)
        return REPEATED
    if started and discrete and h != 1.0:
        return SKIPPED
    missing = False
    begin = not started or (not discrete and h > memory.gap_s)
    if not begin and not discrete and h > memory.bridged_s:
        return TOO_LONG
    for j in range(inputs):
        if row[1 + j] != row[1 + j]:
            s.absent[j] = 1.0
        if s.absent[j] == 1.0:
            missing = True
    if begin:
        for i in range(q):
            w[i] = m.start[i]
        for j in range(inputs):
            last[j] = m.first[j]
    else:
        for i in range(q):
            w[i] += m.start[i]
        move(memory, m, s, row, missing)
    measure(s, last, row)
    if missing:
        replace(m, w, last, s.nonlinear, s.absent)
    for i in range(q):
        w[i] -= m.start[i]
    s.clock[0], s.clock[1] = 1.0, row[0]
    return ACCEPTED


@law
def along_both(total: float, row: FloatArray, one: FloatArray, other: FloatArray) -> float:
    """A total and a row of a matrix times the sum of two vectors."""
    for i in range(len(one)):
        total += row[i] * (one[i] + other[i])
    return total


@law
def step(memory: Memory, row: FloatArray, out: FloatArray) -> int:
    """Integrate to the sample (t, inputs) and write R0 w + R1 f(Jw + R i) + R2 i to ``out``.

    A t that is refused changes nothing.
    """
    m, s = parts_of(memory)
    verdict = advance(memory, m, s, row)
    if verdict >= BACKWARDS:
        return verdict
    q = len(m.start)
    w, last = s.both[:q], s.both[q:]
    for j in range(len(m.codes)):
        argument = along_both(along(0.0, m.R[j], last), m.J[j], w, m.start)
        s.nonlinear[j] = nonlinearity.value(m.codes[j], argument)
    for i in range(len(m.R0)):
        out[i] = along(along(along_both(0.0, m.R0[i], w, m.start), m.R1[i], s.nonlinear), m.R2[i], last)
    return verdict


loop = loop_into(step)
