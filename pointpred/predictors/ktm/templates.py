"""Recordings as templates for kinematic template matching."""

from __future__ import annotations

import numpy as np

from pointpred.errors import ParameterError
from pointpred.predictors.ktm import matching
from pointpred.predictors.ktm.predictor import TEMPLATES_MOST, TemplatePredictor
from pointpred.recording import Recording
from pointpred.records import EventColumns, FloatArray


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
    templates = np.empty((len(recording.trials), matching.SPEEDS + matching.samples_of(longest_s)))
    for k, trial in enumerate(recording.trials):
        template = profile_of(recording.rows(k), longest_s)
        if not len(template):
            raise ParameterError(
                f"trial {trial.trial!r} of {trial.user!r} is no template: it needs {matching.POINTS_LEAST} "
                f"points and 0.05 to {longest_s:g} s, received {_size(recording.rows(k))}"
            )
        templates[k] = template[0]
    return templates


def profile_of(rows: EventColumns, longest_s: float) -> FloatArray:
    """The template of one movement; no row where it makes none."""
    pupil = TemplatePredictor(templates=1, longest_s=longest_s, shortest_px=0.0)
    motions = np.zeros((len(rows), 10))
    motions[:, :3] = rows.table[:, :3]
    pupil.walk(np.zeros(len(rows), np.bool_), motions)
    return pupil.template_table()


def _size(rows: EventColumns) -> str:
    return f"{len(rows)} points in {np.ptp(rows.t) if len(rows) else 0.0:g} s"
