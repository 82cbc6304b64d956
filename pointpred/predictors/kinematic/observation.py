"""A movement as the learned predictor remembers it; events of one time are one event."""

from __future__ import annotations

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.predictors import movement
from pointpred.predictors.kinematic import features, history, track
from pointpred.predictors.predictor import motion_at
from pointpred.rows import MotionRow

# State, relative to `at`: the movement; what is tracked and the head of the history, the same before the last
# time; the history.
TRACK = movement.STATES
BEFORE = TRACK + track.STATES
HEAD_BEFORE = BEFORE + track.STATES
HISTORY = HEAD_BEFORE + history.HEAD
STATES = HISTORY + history.STATES


@law
def rewind(memory: FloatArray, at: int, again: bool) -> None:
    """Keep what is known before a new time; go back to it where a sample of the same time comes again."""
    first, head = (BEFORE, HEAD_BEFORE) if again else (TRACK, HISTORY)
    target, head_target = (TRACK, HISTORY) if again else (BEFORE, HEAD_BEFORE)
    for i in range(track.STATES):
        memory[at + target + i] = memory[at + first + i]
    for i in range(history.HEAD):
        memory[at + head_target + i] = memory[at + head + i]


@law
def see(memory: FloatArray, at: int, m: MotionRow, out: FloatArray) -> tuple[bool, float, float, float]:
    """Take one motion in and fill the features: (accepted, reach, direction)."""
    known, last_t = memory[at + movement.KNOWN], memory[at + movement.T]
    accepted, new, _ = movement.follow(memory, at, m)
    if not accepted:
        return False, 0.0, 0.0, 0.0
    if new or m.t == memory[at + movement.T0]:
        memory[at + TRACK : at + HISTORY] = 0.0
        history.begin(memory, at + HISTORY)
    else:
        rewind(memory, at, known == 1.0 and m.t == last_t)
    since = m.t - memory[at + movement.T0]
    rx, ry = m.x - memory[at + movement.X0], m.y - memory[at + movement.Y0]
    before = at + TRACK
    history.extend(
        memory,
        at + HISTORY,
        memory[before + track.T],
        memory[before + track.X],
        memory[before + track.Y],
        since,
        rx,
        ry,
    )
    path = history.travelled(memory, at + HISTORY, rx, ry)
    _, _, path_before = history.past(memory, at + HISTORY, since, rx, ry, path, track.SPAN_S)
    track.advance(
        memory, before, since, rx, ry, path, (path - path_before) / track.SPAN_S, m.vx, m.vy, m.ax, m.ay
    )
    reach, ux, uy = features.features(memory, before, at + HISTORY, since, m.vx, m.vy, m.ax, m.ay, out)
    return True, reach, ux, uy


@law
def see_all(
    memory: FloatArray, begin: BoolArray, rows: FloatArray, out: FloatArray, frames: FloatArray
) -> None:
    """The features of a whole table of motions, as training needs them; frames: reach and direction."""
    for i in range(len(rows)):
        if begin[i]:
            memory[:] = 0.0
        _, reach, ux, uy = see(memory, 0, MotionRow(*motion_at(rows, i)), out[i])
        frames[i, 0], frames[i, 1], frames[i, 2] = reach, ux, uy
