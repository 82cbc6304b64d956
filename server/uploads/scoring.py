"""``POST /v1/score``: a recording in, its scores out; nothing is kept."""

from __future__ import annotations

from collections.abc import Mapping

from pointpred.errors import ParameterError
from pointpred.registry import REGISTRY
from pointpred.scoring import Document, document, score
from pointpred.server.uploads.opening import reading_of, recordings_of

NOTHING: Mapping[str, str] = {}


def score_body(body: bytes, names: tuple[str, ...], told: Mapping[str, str] = NOTHING) -> Document:
    """The document of ``pointpred score --json`` for one file; ``told`` as a query says it of a table.

    Raises ParameterError for an unknown predictor, and what ``recordings_of`` raises.
    """
    unknown = [name for name in names if name not in REGISTRY]
    if unknown:
        raise ParameterError(f"unknown predictor {unknown[0]!r}; known: {', '.join(REGISTRY)}")
    scores = score(recordings_of(body, reading_of(told)), names or tuple(REGISTRY), threads=1)
    return document(scores)
