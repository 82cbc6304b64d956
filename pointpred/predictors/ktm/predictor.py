"""Kinematic template matching (KTM): the movement that began most like this one says how far it goes."""

from __future__ import annotations

import copy
from math import hypot, nan
from typing import Any

import numpy as np

from pointpred.compiled import law
from pointpred.errors import ParameterError
from pointpred.parameter import option, parameter
from pointpred.predictors import movement
from pointpred.predictors.ktm import matching
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, FloatArray, MotionRow, Row, TenFloats, endpoint

TEMPLATES_MOST = 1000


@law
def distance(memory: FloatArray, at: int) -> float:
    """How far the cursor is from the movement's start, px."""
    away_x = memory[at + movement.X] - memory[at + movement.X0]
    return hypot(away_x, memory[at + movement.Y] - memory[at + movement.Y0])


@law
def conclude(memory: FloatArray) -> None:
    """The movement has ended: keep it as a template."""
    at = matching.counts(memory) + matching.LEARNED
    matching.keep(memory, at, distance(memory, at))


@law
def resample(memory: FloatArray, at: int, since: float, x_before: float, y_before: float) -> None:
    """Take in the samples that have fallen due since the motion before the last one."""
    most = memory[matching.LONGEST] + matching.TAPS
    now = memory[at + movement.T] - memory[at + movement.T0]
    x, y = memory[at + movement.X], memory[at + movement.Y]
    due = memory[at + matching.SAMPLES] * matching.STEP_S
    while due <= now + matching.STAMP_S and memory[at + matching.SAMPLES] < most:
        back = min(max((now - due) / since, 0.0), 1.0)
        grid_x, grid_y = x + back * (x_before - x), y + back * (y_before - y)
        way = hypot(grid_x - memory[at + matching.GRID_X], grid_y - memory[at + matching.GRID_Y])
        memory[at + matching.GRID_X], memory[at + matching.GRID_Y] = grid_x, grid_y
        matching.sample(memory, at, way * matching.RATE_HZ)
        due = memory[at + matching.SAMPLES] * matching.STEP_S


@law
def step(memory: FloatArray, motion: Row) -> TenFloats:
    """Follow the speed profile and go as far as the template that is most like it."""
    m = MotionRow(*motion)
    at = matching.counts(memory) + matching.LEARNED
    last_distance = distance(memory, at)
    x_before, y_before = memory[at + movement.X], memory[at + movement.Y]
    fault, new, dt = movement.follow(memory, at, m)
    if fault != FINE:
        return movement.refuse(memory, at, m, fault)
    phase = movement.phase(memory, at, m)
    if new:
        matching.keep(memory, at, last_distance)
        memory[at + movement.STATES :] = 0.0
        memory[at + matching.POINTS] = 1.0
        matching.sample(memory, at, 0.0)
    if new or m.t == memory[at + movement.T0]:
        memory[at + matching.GRID_X], memory[at + matching.GRID_Y] = m.x, m.y
    if dt > 0.0:
        memory[at + matching.POINTS] += 1.0
        resample(memory, at, dt, x_before, y_before)
    away = distance(memory, at)
    best = -1
    if memory[at + matching.POINTS] >= matching.POINTS_LEAST:
        best = matching.winner(memory, at, 1.0 if dt > 0.0 else 0.0)
    if best < 0 or not away > 0.0:
        return endpoint(m.t, nan, nan, phase)
    ahead = memory[matching.template(memory, best) + matching.DISTANCE] / away - 1.0
    x0, y0 = memory[at + movement.X0], memory[at + movement.Y0]
    return endpoint(m.t, m.x + ahead * (m.x - x0), m.y + ahead * (m.y - y0), phase)


class TemplatePredictor(Predictor):
    """Kinematic template matching (KTM): as far as the earlier movement whose speed profile is most alike.

    Assumes that a person repeats movements: it can only name distances that it has seen, and the direction
    is where the cursor has gone so far. Where distances vary it is worse than no prediction until the library
    is large. Profiles are smoothed so much (350 ms) that in a short movement little but the mean speed
    remains.
    In the first 50 ms every score is 0, so the first template answers.

    Speeds v of cursor px at 20 Hz, the first one 0; G smooths with 43 taps of a Gaussian, sigma 7 samples,
    both profiles cut to the samples 0 .. n so far. Score of template k = mean over 0 .. n of
    abs((G v)_i - (G v_k)_i), with (G v_k)_i = 0 after the template's end; from the 4th point on it is added
    to the template's running sum at every motion; endpoint = start + d_k in the direction start -> cursor,
    with d_k the straight distance of the template whose sum is lowest.

    ``library``: templates given for good, as ``templates_of`` makes them of a recording. Besides, the last
    ``templates`` movements of the session are learned as they end (by ``reset``, a row marked ``begin`` or
    ``Motion.start``): those of at least ``shortest_px`` and at most ``longest_s``; ``fresh`` forgets them.
    ``None`` without any template, before the 4th point, and where the cursor is at its start. A movement
    longer than ``longest_s`` by 1.1 s is followed no further. A second motion of the same time moves the
    cursor, but changes neither profile nor sums.

    Parameters: ``templates`` 0 to 1000 with those of the library, ``longest_s`` 0.2 to 30 s, ``shortest_px``.
    Memory: 5756 floats; 87 for each template and 188 more, with the defaults. A sample costs time in
    proportion to the templates, a motion between two samples hardly anything. Claims neither region nor time.
    Raises ParameterError, and EventError from ``update``.

    Reference: Pasqual, Wobbrock 2014, with the constants of their program.

    >>> from pointpred import Motion
    >>> predictor = TemplatePredictor()
    >>> for trial in range(2):
    ...     for i in range(21):  # 300 px to the right, then 300 px down
    ...         way, t = 15.0 * i, trial + i / 40
    ...         x, y = (way, 0.0) if trial == 0 else (300.0, way)
    ...         motion = Motion(t, x, y, 0.0, 0.0, 0.0, 0.0, True, start=i == 0)
    ...         prediction = predictor.update(motion)
    ...         if i == 10:
    ...             print(prediction and (round(prediction.x, 6), round(prediction.y, 6)))
    None
    (300.0, 300.0)
    """

    templates: int = parameter(
        "", 0, TEMPLATES_MOST, "movements of the session that are remembered", default=64, whole=True
    )
    longest_s: float = parameter("s", 0.2, 30.0, "longest movement that becomes a template", default=3.0)
    shortest_px: float = parameter("px", 0.0, 1e6, "straight distance of the shortest", default=10.0)
    library: FloatArray | None = option("templates that stay, as `templates_of` makes them", default=None)
    step = staticmethod(step)
    claims_time = False
    conclude = staticmethod(conclude)
    fill = staticmethod(matching.fill)
    sizes = staticmethod(matching.sizes)

    def declare(self, **values: Any) -> None:
        """Check the values, and the templates of the library; raises ParameterError."""
        super().declare(**values)
        self._library = _checked(values.get("library"), self.longest_s)

    def settings(self) -> FloatArray:
        """The numbers, the kernel and the library; how much is learned and remembered follows from them."""
        library, longest = self._library, matching.samples_of(self.longest_s)
        templates = int(self.templates)
        if templates + len(library) > TEMPLATES_MOST:
            raise ParameterError(
                f"at most {TEMPLATES_MOST} templates, received {len(library)} in the library and {templates}",
                field="templates",
                value=templates,
            )
        wide = np.zeros((len(library), matching.SPEEDS + longest))
        wide[:, : library.shape[1]] = library
        count, self.learned, states = matching.sizes(self.values())
        self.states = states + len(library) * matching.MATCH
        settings = self.filled(count)
        settings[matching.LIBRARY] = len(library)
        return np.concatenate([settings, wide.ravel()])

    def template_table(self) -> FloatArray:
        """The templates it would compare with after a reset, in the order in which ties are decided."""
        twin = copy.copy(self)
        twin.reset()
        first = matching.template(twin._memory, 0)
        wide = matching.SPEEDS + int(twin._memory[matching.LONGEST])
        count = matching.template_count(twin._memory)
        return twin._memory[first : first + count * wide].reshape(count, wide).copy()


def _checked(library: FloatArray | None, longest_s: float) -> FloatArray:
    """The library, checked."""
    if library is None:
        return np.empty((0, matching.SPEEDS))
    most = matching.samples_of(longest_s)
    try:
        table = np.asarray(library, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise ParameterError(
            f"library must be a table of numbers: {error}", field="library", value=library
        ) from error
    if table.ndim != 2 or not matching.SPEEDS < table.shape[1] <= matching.SPEEDS + most:
        raise ParameterError(
            f"library needs a row a template with at most {most} samples (longest_s is {longest_s:g} s), "
            f"received shape {table.shape}",
            field="library",
        )
    lengths = table[:, matching.LENGTH]
    longest = table.shape[1] - matching.SPEEDS
    if not (np.isfinite(table).all() and (lengths >= 1.0).all() and (lengths <= longest).all()):
        raise ParameterError(
            f"library needs finite numbers and templates of 1 to {longest} samples", field="library"
        )
    return table
