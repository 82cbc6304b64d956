"""Kinematic template matching: the templates in the memory, and how a movement is compared with each.

A speed profile is sampled at 20 Hz and begins with a zero. What is compared are smoothed profiles; smoothing
is linear, so that the difference of two profiles is smoothed instead, one sample at a time: a new sample
changes the last 21 smoothed values and adds one, and what lies farther back is final.
"""

from __future__ import annotations

from math import exp

from pointpred.compiled import law, layout
from pointpred.predictors import movement
from pointpred.records import FloatArray
from pointpred.stage import offsets

RATE_HZ = 20.0
STEP_S = 1.0 / RATE_HZ
STAMP_S = 1e-6
"""A sample is due a microsecond early: no clock hits a multiple of 50 ms exactly."""
SIGMA = 7.0
TAPS = 22
"""The kernel's taps from its middle to one end: 43 in all."""
KERNEL = tuple(exp(-0.5 * (i / SIGMA) ** 2) for i in range(TAPS))
"""Half of it. Its sum is not 1: a factor on every score alike decides nothing."""
POINTS_LEAST = 4

# Settings, the kernel, then the templates: those of the library, those learned, and how many were learned.
LEARNED_MOST, LIBRARY, LONGEST, SHORTEST_PX, HALF, STORE = offsets(1, 1, 1, 1, TAPS)
# A template: samples of its profile (0: an empty place), straight distance px, speeds px/s.
LENGTH, DISTANCE, SPEEDS = range(3)
# After the templates: how many were learned, and the place of the next.
COUNT, NEXT, LEARNED = range(3)
# The movement, after `movement`'s own state: its points, its samples, the last of them, the last 22 speeds,
# the whole profile; then for each template the running sum, the final part of its score, its score and the
# last 22 smoothed differences.
_, POINTS, SAMPLES, GRID_X, GRID_Y, RECENT, PROFILE = offsets(movement.STATES, 1, 1, 1, 1, TAPS)
SUM, FINAL, SCORE, SMOOTH, MATCH = offsets(1, 1, 1, TAPS)


# The values of the parameters.
TEMPLATES_OF, LONGEST_OF, SHORTEST_OF = range(3)


@layout
def samples_of(longest_s: float) -> int:
    """Samples in the profile of the longest movement: one for each 50 ms, and the zero before them."""
    return int((longest_s + STAMP_S) / STEP_S) + 1


@layout
def fill(values: FloatArray, memory: FloatArray) -> None:
    """The settings and the kernel, without a library."""
    memory[LEARNED_MOST], memory[LIBRARY] = values[TEMPLATES_OF], 0.0
    memory[LONGEST], memory[SHORTEST_PX] = samples_of(values[LONGEST_OF]), values[SHORTEST_OF]
    for k in range(TAPS):
        memory[HALF + k] = KERNEL[k]


@layout
def sizes(values: FloatArray) -> tuple[int, int, int]:
    """How many settings, learned floats and states of a movement there are without a library."""
    templates, longest = int(values[TEMPLATES_OF]), samples_of(values[LONGEST_OF])
    states = PROFILE + longest + templates * MATCH
    if templates == 0:
        return STORE, 0, states + LEARNED
    return STORE, templates * (SPEEDS + longest) + LEARNED, states


@law
def template(memory: FloatArray, k: int) -> int:
    """Place of the k-th template."""
    return STORE + k * (SPEEDS + int(memory[LONGEST]))


@law
def counts(memory: FloatArray) -> int:
    """Place of the counts of learned templates: after the last of them."""
    return template(memory, int(memory[LIBRARY]) + int(memory[LEARNED_MOST]))


@law
def template_count(memory: FloatArray) -> int:
    """How many templates there are to compare with."""
    return int(memory[LIBRARY]) + int(memory[counts(memory) + COUNT])


@law
def score(memory: FloatArray, n: int, speed: float, own: float, place: int, match: int) -> None:
    """One template's mean absolute smoothed difference over samples 0 to n."""
    length, smooth = int(memory[place + LENGTH]), match + SMOOTH
    difference = speed - memory[place + SPEEDS + n] if n < length else speed
    memory[match + FINAL] += abs(memory[smooth])
    total = memory[match + FINAL]
    oldest = max(0, TAPS - 1 - n)
    for k in range(oldest, TAPS - 1):
        memory[smooth + k] = memory[smooth + k + 1] + memory[HALF + TAPS - 1 - k] * difference
        total += abs(memory[smooth + k])
    newest = own
    if n < length:  # a template's smoothed speed is 0 after its end: there the movement's own stands alone
        for k in range(oldest, TAPS):
            newest -= memory[HALF + TAPS - 1 - k] * memory[place + SPEEDS + n - (TAPS - 1) + k]
    memory[smooth + TAPS - 1] = newest
    memory[match + SCORE] = (total + abs(newest)) / (n + 1)


@law
def sample(memory: FloatArray, at: int, speed: float) -> None:
    """Take in the next sample of the movement's speed, and score every template."""
    n, longest, recent = int(memory[at + SAMPLES]), int(memory[LONGEST]), at + RECENT
    for k in range(TAPS - 1):
        memory[recent + k] = memory[recent + k + 1]
    memory[recent + TAPS - 1] = speed
    if n < longest:
        memory[at + PROFILE + n] = speed
    own = 0.0
    for k in range(TAPS):
        own += memory[HALF + TAPS - 1 - k] * memory[recent + k]
    for j in range(template_count(memory)):
        place, match = template(memory, j), at + PROFILE + longest + j * MATCH
        score(memory, n, speed, own, place, match)
    memory[at + SAMPLES] = n + 1.0


@law
def winner(memory: FloatArray, at: int, times: float) -> int:
    """Add each score that many times to its running sum; the first with the lowest sum, -1 without any."""
    first, best = at + PROFILE + int(memory[LONGEST]), -1
    for j in range(template_count(memory)):
        match = first + j * MATCH
        memory[match + SUM] += times * memory[match + SCORE]
        if best < 0 or memory[match + SUM] < memory[first + best * MATCH + SUM]:
            best = j
    return best


@law
def keep(memory: FloatArray, at: int, distance: float) -> None:
    """Store the movement as a template, replacing the oldest learned one, if its length is within bounds."""
    most, samples = int(memory[LEARNED_MOST]), int(memory[at + SAMPLES])
    if most == 0 or memory[at + POINTS] < POINTS_LEAST or not 2 <= samples <= memory[LONGEST]:
        return
    if not distance >= memory[SHORTEST_PX]:
        return
    place_of_counts = counts(memory)
    place = template(memory, int(memory[LIBRARY]) + int(memory[place_of_counts + NEXT]))
    memory[place + LENGTH], memory[place + DISTANCE] = samples, distance
    for k in range(int(memory[LONGEST])):
        memory[place + SPEEDS + k] = memory[at + PROFILE + k]  # zeros behind the last sample
    memory[place_of_counts + NEXT] = (memory[place_of_counts + NEXT] + 1.0) % most
    memory[place_of_counts + COUNT] = min(memory[place_of_counts + COUNT] + 1.0, most)
