"""Kinematic template matching (KTM): the movement that began most like this one says how far it goes.

A speed profile is sampled at 20 Hz and begins with a zero. What is compared are smoothed profiles; smoothing
is linear, so that the difference of two profiles is smoothed instead, one sample at a time: a new sample
changes the last 21 smoothed values and adds one, and what lies farther back is final.
"""

from __future__ import annotations

import copy
from math import exp, hypot, nan
from typing import Annotated, Any

import numpy as np

from pointpred.compiled import law
from pointpred.errors import ParameterError
from pointpred.layout import Layout, clear
from pointpred.parameter import option, parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.recording import Recording
from pointpred.records import FINE, FloatArray, MotionRow, TenFloats, endpoint

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


class Settings(Layout):
    """Most templates to learn and those of the library, samples of the longest, the shortest; the kernel."""

    learned_most: float
    templates_given: float
    longest: float
    shortest_px: float
    half: Annotated[FloatArray, TAPS]


class Memory(Layout):
    """The settings; then the templates, the library's first, what is ``Learned``, and the ``State``."""

    settings: Settings
    rest: Annotated[FloatArray, None]


class Template(Layout):
    """Samples of its profile (0: an empty place), straight distance in px, speeds in px/s."""

    samples: float
    distance: float
    speeds: Annotated[FloatArray, None]


class Learned(Layout):
    """How many templates were learned, and the place of the next."""

    count: float
    next: float


class Samples(Layout):
    """Of the movement: its points, its samples, the place of the last of them, the last speeds."""

    points: float
    count: float
    x: float
    y: float
    recent: Annotated[FloatArray, TAPS]


class State(Layout):
    """The movement; then its whole profile, and a ``Match`` for each template."""

    movement: movement.State
    samples: Samples
    rest: Annotated[FloatArray, None]


class Match(Layout):
    """Of a template: running sum, final part of the score, score, the last smoothed differences."""

    sum: float
    final: float
    score: float
    smooth: Annotated[FloatArray, TAPS]


# The values of the parameters.
TEMPLATES_OF, LONGEST_OF, SHORTEST_OF = range(3)


@law
def samples_of(longest_s: float) -> int:
    """Samples in the profile of the longest movement: one for each 50 ms, and the zero before them."""
    return int((longest_s + STAMP_S) / STEP_S) + 1


@law
def fill(values: FloatArray, settings: Settings) -> None:
    """The settings and the kernel, without a library."""
    settings.learned_most, settings.templates_given = values[TEMPLATES_OF], 0.0
    settings.longest, settings.shortest_px = samples_of(values[LONGEST_OF]), values[SHORTEST_OF]
    for k in range(TAPS):
        settings.half[k] = KERNEL[k]


@law
def sizes(values: FloatArray) -> tuple[int, int, int]:
    """How many settings, learned floats and states of a movement there are without a library."""
    templates, longest = int(values[TEMPLATES_OF]), samples_of(values[LONGEST_OF])
    states = State.length + longest + templates * Match.length
    if templates == 0:
        return Settings.length, 0, states + Learned.length
    return Settings.length, templates * (Template.length + longest) + Learned.length, states


@law
def place_of_template(settings: Settings, k: int) -> int:
    """Place of the k-th template."""
    return k * (Template.length + int(settings.longest))


@law
def place_of_learned(settings: Settings) -> int:
    """Place of what is learned: after the last template."""
    return place_of_template(settings, int(settings.templates_given) + int(settings.learned_most))


@law
def template_count(memory: Memory) -> int:
    """How many templates there are to compare with."""
    learned = Learned(memory.rest, place_of_learned(memory.settings))
    return int(memory.settings.templates_given) + int(learned.count)


@law
def score(settings: Settings, n: int, speed: float, own: float, template: Template, match: Match) -> None:
    """One template's mean absolute smoothed difference over samples 0 to n."""
    length = int(template.samples)
    difference = speed - template.speeds[n] if n < length else speed
    match.final += abs(match.smooth[0])
    total = match.final
    oldest = max(0, TAPS - 1 - n)
    for k in range(oldest, TAPS - 1):
        match.smooth[k] = match.smooth[k + 1] + settings.half[TAPS - 1 - k] * difference
        total += abs(match.smooth[k])
    newest = own
    if n < length:  # a template's smoothed speed is 0 after its end: there the movement's own stands alone
        for k in range(oldest, TAPS):
            newest -= settings.half[TAPS - 1 - k] * template.speeds[n - (TAPS - 1) + k]
    match.smooth[TAPS - 1] = newest
    match.score = (total + abs(newest)) / (n + 1)


@law
def sample(memory: Memory, s: State, speed: float) -> None:
    """Take in the next sample of the movement's speed, and score every template."""
    settings, samples = memory.settings, s.samples
    n, longest = int(samples.count), int(settings.longest)
    for k in range(TAPS - 1):
        samples.recent[k] = samples.recent[k + 1]
    samples.recent[TAPS - 1] = speed
    if n < longest:
        s.rest[n] = speed
    own = 0.0
    for k in range(TAPS):
        own += settings.half[TAPS - 1 - k] * samples.recent[k]
    for j in range(template_count(memory)):
        template = Template(memory.rest, place_of_template(settings, j))
        score(settings, n, speed, own, template, Match(s.rest, longest + j * Match.length))
    samples.count = n + 1.0


@law
def winner(memory: Memory, s: State, times: float) -> int:
    """Add each score that many times to its running sum; the first with the lowest sum, -1 without any."""
    best, lowest = -1, 0.0
    for j in range(template_count(memory)):
        match = Match(s.rest, int(memory.settings.longest) + j * Match.length)
        match.sum += times * match.score
        if best < 0 or match.sum < lowest:
            best, lowest = j, match.sum
    return best


@law
def keep(memory: Memory, s: State, distance: float) -> None:
    """Store the movement as a template, replacing the oldest learned one, if its length is within bounds."""
    settings = memory.settings
    most, samples = int(settings.learned_most), int(s.samples.count)
    if most == 0 or s.samples.points < POINTS_LEAST or not 2 <= samples <= settings.longest:
        return
    if not distance >= settings.shortest_px:
        return
    learned = Learned(memory.rest, place_of_learned(settings))
    template = Template(
        memory.rest, place_of_template(settings, int(settings.templates_given) + int(learned.next))
    )
    template.samples, template.distance = samples, distance
    for k in range(int(settings.longest)):
        template.speeds[k] = s.rest[k]  # zeros behind the last sample
    learned.next = (learned.next + 1.0) % most
    learned.count = min(learned.count + 1.0, most)


@law
def forget(settings: Settings, s: State) -> None:
    """Nothing is known of the movement but what all predictors know."""
    clear(s.samples)
    matches = int(settings.templates_given) + int(settings.learned_most)
    s.rest[: int(settings.longest) + matches * Match.length] = 0.0


TEMPLATES_MOST = 1000


@law
def distance(s: movement.State) -> float:
    """How far the cursor is from the movement's start, px."""
    return hypot(s.x - s.x0, s.y - s.y0)


@law
def conclude(memory: Memory) -> None:
    """The movement has ended: keep it as a template."""
    s = State(memory.rest, place_of_learned(memory.settings) + Learned.length)
    keep(memory, s, distance(s.movement))


@law
def resample(memory: Memory, s: State, since: float, x_before: float, y_before: float) -> None:
    """Take in the samples that have fallen due since the motion before the last one."""
    samples, most = s.samples, memory.settings.longest + TAPS
    now = s.movement.t - s.movement.t0
    x, y = s.movement.x, s.movement.y
    due = samples.count * STEP_S
    while due <= now + STAMP_S and samples.count < most:
        back = min(max((now - due) / since, 0.0), 1.0)
        grid_x, grid_y = x + back * (x_before - x), y + back * (y_before - y)
        way = hypot(grid_x - samples.x, grid_y - samples.y)
        samples.x, samples.y = grid_x, grid_y
        sample(memory, s, way * RATE_HZ)
        due = samples.count * STEP_S


@law
def step(memory: Memory, motion: TenFloats) -> TenFloats:
    """Follow the speed profile and go as far as the template that is most like it."""
    m = MotionRow(*motion)
    s = State(memory.rest, place_of_learned(memory.settings) + Learned.length)
    last_distance = distance(s.movement)
    x_before, y_before = s.movement.x, s.movement.y
    fault, new, dt = movement.follow(s.movement, m)
    if fault != FINE:
        return movement.refuse(s.movement, m, fault)
    phase = movement.phase(s.movement, m)
    if new:
        keep(memory, s, last_distance)
        forget(memory.settings, s)
        s.samples.points = 1.0
        sample(memory, s, 0.0)
    if new or m.t == s.movement.t0:
        s.samples.x, s.samples.y = m.x, m.y
    if dt > 0.0:
        s.samples.points += 1.0
        resample(memory, s, dt, x_before, y_before)
    away = distance(s.movement)
    best = -1
    if s.samples.points >= POINTS_LEAST:
        best = winner(memory, s, 1.0 if dt > 0.0 else 0.0)
    if best < 0 or not away > 0.0:
        return endpoint(m.t, nan, nan, phase)
    template = Template(memory.rest, place_of_template(memory.settings, best))
    ahead = template.distance / away - 1.0
    x0, y0 = s.movement.x0, s.movement.y0
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
    fill = staticmethod(fill)
    sizes = staticmethod(sizes)

    def declare(self, **values: Any) -> None:
        """Check the values, and the templates of the library; raises ParameterError."""
        super().declare(**values)
        self._library = _checked(values.get("library"), self.longest_s)

    def settings(self) -> FloatArray:
        """The numbers, the kernel and the library; how much is learned and remembered follows from them."""
        library, longest = self._library, samples_of(self.longest_s)
        templates = int(self.templates)
        if templates + len(library) > TEMPLATES_MOST:
            raise ParameterError(
                f"at most {TEMPLATES_MOST} templates, received {len(library)} in the library and {templates}",
                field="templates",
                value=templates,
            )
        wide = np.zeros((len(library), Template.length + longest))
        wide[:, : library.shape[1]] = library
        count, self.learned, states = sizes(self.values())
        self.states = states + len(library) * Match.length
        settings = self.filled(count)
        Settings(settings).templates_given = len(library)
        return np.concatenate([settings, wide.ravel()])

    def template_table(self) -> FloatArray:
        """The templates it would compare with after a reset, in the order in which ties are decided."""
        twin = copy.copy(self)
        twin.reset()
        memory = Memory(twin._memory)
        wide, count = Template.length + int(memory.settings.longest), template_count(memory)
        return memory.rest[: count * wide].reshape(count, wide).copy()


def _checked(library: FloatArray | None, longest_s: float) -> FloatArray:
    """The library, checked."""
    if library is None:
        return np.empty((0, Template.length))
    most = samples_of(longest_s)
    try:
        table = np.asarray(library, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise ParameterError(
            f"library must be a table of numbers: {error}", field="library", value=library
        ) from error
    if table.ndim != 2 or not Template.length < table.shape[1] <= Template.length + most:
        raise ParameterError(
            f"library needs a row a template with at most {most} samples (longest_s is {longest_s:g} s), "
            f"received shape {table.shape}",
            field="library",
        )
    lengths = table[:, 0]
    longest = table.shape[1] - Template.length
    if not (np.isfinite(table).all() and (lengths >= 1.0).all() and (lengths <= longest).all()):
        raise ParameterError(
            f"library needs finite numbers and templates of 1 to {longest} samples", field="library"
        )
    return table


def templates_of(recording: Recording, *, longest_s: float = 3.0) -> FloatArray:
    """A template for each trial, in order: the number of its samples, its straight distance, its profile.

    Raises ParameterError for more than 1000 trials, and where a trial has fewer than 4 points of different
    time, takes less than 50 ms, or takes longer than ``longest_s``.

    >>> from pointpred.records import EventColumns
    >>> from pointpred.recording import Trial
    >>> path = EventColumns.of(t=[0.0, 0.04, 0.08, 0.12], x=[0, 4, 8, 12], y=[0, 0, 0, 0])
    >>> templates_of(Recording.of("one", [path], [Trial("ann", "1")]), longest_s=0.2).tolist()
    [[3.0, 12.0, 0.0, 100.0, 100.0, 0.0, 0.0]]
    """
    if not 1 <= len(recording.trials) <= TEMPLATES_MOST:
        raise ParameterError(
            f"a library needs 1 to {TEMPLATES_MOST} trials, received {len(recording.trials)}"
        )
    templates = np.empty((len(recording.trials), Template.length + samples_of(longest_s)))
    for k, trial in enumerate(recording.trials):
        rows = recording.rows(k)
        pupil = TemplatePredictor(templates=1, longest_s=longest_s, shortest_px=0.0)
        motions = np.zeros((len(rows), len(MotionRow._fields)))
        motions[:, :3] = rows.table[:, :3]
        pupil.walk(np.zeros(len(rows), np.bool_), motions)
        learned = pupil.template_table()
        if not len(learned):
            seconds = np.ptp(rows.t) if len(rows) else 0.0
            raise ParameterError(
                f"trial {trial.trial!r} of {trial.user!r} is no template: it needs {POINTS_LEAST} "
                f"points and 0.05 to {longest_s:g} s, received {len(rows)} points in {seconds:g} s"
            )
        templates[k] = learned[0]
    return templates
