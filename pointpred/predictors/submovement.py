"""The sub-movement under way: where it started, where its speed peaked, and when the next one begins."""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.records import FloatArray

# State, relative to `at`: highest speed in m/s; where it was; lowest speed since then; where that was; where
# the sub-movement started.
PEAK, PEAK_X, PEAK_Y, VALLEY, VALLEY_X, VALLEY_Y, START_X, START_Y, STATES = range(9)


@law
def begin(memory: FloatArray, at: int, x: float, y: float) -> None:
    """A movement starts at rest at (x, y)."""
    memory[at + PEAK], memory[at + VALLEY] = 0.0, 0.0
    memory[at + PEAK_X], memory[at + PEAK_Y] = x, y
    memory[at + VALLEY_X], memory[at + VALLEY_Y] = x, y
    memory[at + START_X], memory[at + START_Y] = x, y


@law
def follow(memory: FloatArray, at: int, rise: float, x: float, y: float, speed: float) -> None:
    """Take one sample in; a rise of the speed by ``rise`` of the peak out of a valley is a new sub-movement.

    It started in the valley. Two samples of one time are one: the later place replaces.
    """
    peak, valley = memory[at + PEAK], memory[at + VALLEY]
    if speed < peak and speed <= valley + rise * peak:
        if speed <= valley:
            memory[at + VALLEY] = speed
            memory[at + VALLEY_X], memory[at + VALLEY_Y] = x, y
        return
    if speed < peak:
        memory[at + START_X], memory[at + START_Y] = memory[at + VALLEY_X], memory[at + VALLEY_Y]
    memory[at + PEAK], memory[at + VALLEY] = speed, speed
    memory[at + PEAK_X], memory[at + PEAK_Y] = x, y
    memory[at + VALLEY_X], memory[at + VALLEY_Y] = x, y
