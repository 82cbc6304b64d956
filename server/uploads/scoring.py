"""``POST /v1/score``: a recording in our format in, its scores out; nothing is kept."""

from __future__ import annotations

from typing import Any

import msgspec

from pointpred.errors import ParameterError, PointpredError
from pointpred.recording import Recording
from pointpred.registry import REGISTRY
from pointpred.scoring import score, summary
from pointpred.server.uploads.spooling import NAME, spooled
from pointpred.server.uploads.unpacking import check_most, check_unpacked
from pointpred.sources import read_any

MOST_TRIALS = 5000
"""Statistics of many trials take longer than the predictions: so many take some seconds."""


def score_body(body: bytes, names: tuple[str, ...]) -> dict[str, Any]:
    """The document of ``pointpred score --json`` for one CSV or Parquet file of samples.

    Raises ParameterError for an unknown predictor, RecordingError, without the file's place, for what is no
    recording, and UploadError for one that is too large.
    """
    unknown = [name for name in names if name not in REGISTRY]
    if unknown:
        raise ParameterError(f"unknown predictor {unknown[0]!r}; known: {', '.join(REGISTRY)}")
    check_unpacked(body)
    with spooled(body) as path:
        try:
            found = read_any(path)
        except PointpredError as error:
            raise type(error)(str(error).replace(str(path), "the recording")) from None
    recordings = [_named(one, path.stem) for one in found]
    for recording in recordings:
        check_most("trials", len(recording.trials) + len(recording.skipped), MOST_TRIALS)
    scores = score(recordings, names or tuple(REGISTRY), threads=1)
    return {"version": 1, "sets": [summary(one) for one in scores], "unread": []}


def _named(recording: Recording, stem: str) -> Recording:
    """A recording that says no name of its own has that of its file, which here is a number."""
    return msgspec.structs.replace(recording, name=NAME) if recording.name == stem else recording
