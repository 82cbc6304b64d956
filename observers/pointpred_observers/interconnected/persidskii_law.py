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
    """Codes of f (k), its arguments' (J R), then what acts on (w, f, inputs), by rows.

    (N L K) of w, (R0 R1 R2) of the outputs, and (V0 V1 V2) of missing inputs; the start of w; whether a
    missing input is a value, and the start of the inputs.
    """

    codes: FloatArray
    inner: FloatTable
    change: FloatTable
    shown: FloatTable
    missing: FloatTable
    start: FloatArray
    valued: FloatArray
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
    wide = q + k + m
    change_at = k + k * (q + m)
    shown_at = change_at + q * wide
    missing_at = shown_at + p * wide
    start_at = missing_at + m * wide
    valued_at = start_at + q
    first_at = valued_at + m
    clock_at = first_at + m
    both_at = clock_at + 2
    total_at = both_at + q + m
    stage_at = total_at + q + m
    moved_at = stage_at + q + m
    step_at = moved_at + q + m
    f_at = step_at + q + m
    absent_at = f_at + k
    matrices = Matrices(
        memory.rest[:k],
        memory.rest[k:change_at].reshape(k, q + m),
        memory.rest[change_at:shown_at].reshape(q, wide),
        memory.rest[shown_at:missing_at].reshape(p, wide),
        memory.rest[missing_at:start_at].reshape(m, wide),
        memory.rest[start_at:valued_at],
        memory.rest[valued_at:first_at],
        memory.rest[first_at:clock_at],
    )
    state = State(
        memory.rest[clock_at:both_at],
        memory.rest[both_at:total_at],
        memory.rest[total_at:stage_at],
        memory.rest[stage_at:moved_at],
        memory.rest[moved_at:step_at],
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
def along_all(row: FloatArray, w: FloatArray, nonlinear: FloatArray, inputs: FloatArray) -> float:
    """A row of a matrix times (w, f, inputs)."""
    q, k = len(w), len(nonlinear)
    return along(along(along(0.0, row[:q], w), row[q : q + k], nonlinear), row[q + k :], inputs)


@law
def bend(m: Matrices, w: FloatArray, inputs: FloatArray, to: FloatArray) -> None:
    """f(Jw + R i)."""
    q = len(w)
    for j in range(len(m.codes)):
        row = m.inner[j]
        to[j] = nonlinearity.value(m.codes[j], along(along(0.0, row[:q], w), row[q:], inputs))


@law
def slope(m: Matrices, w: FloatArray, inputs: FloatArray, nonlinear: FloatArray, to: FloatArray) -> None:
    """N w + L f(Jw + R i) + K i, with f in ``nonlinear``."""
    bend(m, w, inputs, nonlinear)
    for i in range(len(m.start)):
        to[i] = along_all(m.change[i], w, nonlinear, inputs)


@law
def replace(
    m: Matrices, w: FloatArray, inputs: FloatArray, nonlinear: FloatArray, absent: FloatArray
) -> None:
    """Write the missing inputs that are values, V0 w + V1 f(Jw + R i), of which R reads V0 w only."""
    q, k = len(w), len(nonlinear)
    for j in range(len(inputs)):
        if absent[j] == 1.0 and m.valued[j] == 1.0:
            row = m.missing[j]
            inputs[j] = along(0.0, row[:q], w)
    bend(m, w, inputs, nonlinear)
    for j in range(len(inputs)):
        if absent[j] == 1.0 and m.valued[j] == 1.0:
            row = m.missing[j]
            inputs[j] = along(inputs[j], row[q : q + k], nonlinear)


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
                s.change[q + j] = along_all(m.missing[j], w, s.nonlinear, given)
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
            s.total[q + j] = along_all(m.missing[j], w, s.nonlinear, last) if missing else 0.0
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
    q, k = len(m.start), len(m.codes)
    w, last = s.both[:q], s.both[q:]
    for j in range(k):
        inner = m.inner[j]
        argument = along_both(along(0.0, inner[q:], last), inner[:q], w, m.start)
        s.nonlinear[j] = nonlinearity.value(m.codes[j], argument)
    for i in range(len(m.shown)):
        shown = m.shown[i]
        linear = along_both(0.0, shown[:q], w, m.start)
        out[i] = along(along(linear, shown[q : q + k], s.nonlinear), shown[q + k :], last)
    return verdict


loop = loop_into(step)
