"""A movement as the learned predictor remembers it; events of one time are one event."""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.predictors import movement
from pointpred.predictors.kinematic import features, history, track
from pointpred.predictors.kinematic.features import Frame
from pointpred.predictors.kinematic.history import Point
from pointpred.records import FINE, BoolArray, FloatArray, MotionRow, row_at
from pointpred.stage import offsets

# State, relative to `at`: the movement; the track and the head of the history, and both as they were before
# the last time; the history.
_, TRACK, TRACK_BEFORE, HEAD_BEFORE, HISTORY, STATES = offsets(
    movement.STATES, track.STATES, track.STATES, history.HEAD, history.STATES
)


@law
def rewind(memory: FloatArray, at: int, again: bool) -> None:
    """Copy the track before a new time; go back to the copy where a sample of the same time comes again."""
    source, head = (TRACK_BEFORE, HEAD_BEFORE) if again else (TRACK, HISTORY)
    target, head_target = (TRACK, HISTORY) if again else (TRACK_BEFORE, HEAD_BEFORE)
    for i in range(track.STATES):
        memory[at + target + i] = memory[at + source + i]
    for i in range(history.HEAD):
        memory[at + head_target + i] = memory[at + head + i]


@law
def follow(memory: FloatArray, at: int, m: MotionRow) -> tuple[int, Point]:
    """Take one motion in: its fault, and where the cursor is."""
    started, last_t = memory[at + movement.KNOWN], memory[at + movement.T]
    fault, new, _ = movement.follow(memory, at, m)
    if fault != FINE:
        return fault, Point(0.0, 0.0, 0.0, 0.0)
    if new or m.t == memory[at + movement.T0]:
        memory[at + TRACK : at + HISTORY] = 0.0
        history.begin(memory, at + HISTORY)
    else:
        rewind(memory, at, started == 1.0 and m.t == last_t)
    here = at + TRACK
    last = memory[here + track.T], memory[here + track.X], memory[here + track.Y]
    t0, x0, y0 = memory[at + movement.T0], memory[at + movement.X0], memory[at + movement.Y0]
    point = history.extend(memory, at + HISTORY, last, (m.t - t0, m.x - x0, m.y - y0))
    _, _, path_before = history.past(memory, at + HISTORY, point, track.SPAN_S)
    track.advance(memory, here, point, m, (point.path - path_before) / track.SPAN_S)
    return FINE, point


@law
def observe(memory: FloatArray, at: int, m: MotionRow, out: FloatArray) -> tuple[int, Frame]:
    """Take one motion in and compute the features: its fault, and their frame."""
    fault, point = follow(memory, at, m)
    if fault != FINE:
        return fault, Frame(0.0, 0.0, 0.0, 0.0)
    here = at + TRACK
    frame = features.frame_of(memory, here, point, m)
    if frame.reach > 0.0:
        features.fill_shape(memory, here, point, frame, out)
        features.fill_pace(memory, here, point, m, frame, out)
        features.fill_lags(memory, at + HISTORY, point, frame, out)
    return FINE, frame


@law
def observe_all(
    memory: FloatArray, begin: BoolArray, rows: FloatArray, out: FloatArray, frames: FloatArray
) -> None:
    """The features of a whole table of motions, as training needs them; frames: reach and direction."""
    for i in range(len(rows)):
        if begin[i]:
            memory[:] = 0.0
        _, frame = observe(memory, 0, MotionRow(*row_at(rows, i)), out[i])
        frames[i, 0], frames[i, 1], frames[i, 2] = frame.reach, frame.ux, frame.uy
