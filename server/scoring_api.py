"""``POST /v1/score``: a recording in our format in, its scores out; nothing is kept."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from pointpred.errors import ParameterError, PointpredError
from pointpred.registry import REGISTRY
from pointpred.scoring import score, summary
from pointpred.server.unpacking import PARQUET, check_most, check_unpacked
from pointpred.sources import read_any

MOST_TRIALS = 5000
"""Statistics of many trials take longer than the predictions: so many take some seconds."""


def score_body(body: bytes, names: tuple[str, ...]) -> dict[str, Any]:
    """The document of ``pointpred score --json`` for one CSV or Parquet file of samples.

    The file lies in a temporary folder only while it is read. Raises ParameterError for an unknown
    predictor, RecordingError, without the folder's name, for what is no recording, and UploadError for one
    that is too large.
    """
    unknown = [name for name in names if name not in REGISTRY]
    if unknown:
        raise ParameterError(f"unknown predictor {unknown[0]!r}; known: {', '.join(REGISTRY)}")
    check_unpacked(body)
    with tempfile.TemporaryDirectory(prefix="pointpred-") as folder:
        ending = "parquet" if body.startswith(PARQUET) else "csv"
        path = Path(folder) / f"recording_samples.{ending}"
        path.write_bytes(body)
        try:
            recordings = read_any(path)
        except PointpredError as error:
            raise type(error)(str(error).replace(str(path), "the recording")) from None
    for recording in recordings:
        check_most("trials", len(recording.trials) + len(recording.skipped), MOST_TRIALS)
    scores = score(recordings, names or tuple(REGISTRY), threads=1)
    return {"version": 1, "sets": [summary(one) for one in scores], "unread": []}
