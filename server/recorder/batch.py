"""What a session gave its recorder to write, as rows for its files."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.server.recorder.files import prediction_rows, sample_rows, trial_row

NOTHING: FloatArray = np.empty((0, 6))


class Item(msgspec.Struct, frozen=True):
    """Events with their predictions, or a trial that starts or has ended, or the session's end."""

    events: FloatArray = NOTHING
    predictions: FloatArray = NOTHING
    trial: str | None = None
    """The trial the events belong to, or the one that has ended."""
    predictor: str = ""
    parameters: str | None = None
    starts: bool = False
    ends: bool = False
    target: tuple[float, float, float] | None = None
    samples: int = 0
    closes: bool = False

    def __len__(self) -> int:
        """How many events it holds."""
        return len(self.events)


def rows_of(user: str, items: Sequence[Item]) -> Iterator[tuple[str, bytes]]:
    """The rows to append, file by file: a trial is described only after its samples are written."""
    fed = [item for item in items if len(item)]
    if fed:
        marks = [(item.trial, len(item)) for item in fed]
        yield "samples", sample_rows(user, merged(marks), np.concatenate([item.events for item in fed]))
    marked = [item for item in items if item.starts or item.ends]
    if marked:
        ended = [item for item in marked if item.ends]
        yield (
            "trials",
            b"".join(trial_row(user, item.trial or "", item.target, item.samples) for item in ended),
        )
    if fed:
        predictors = merged([(item.predictor, len(item)) for item in fed])
        parameters = merged([(item.parameters, len(item)) for item in fed])
        table = np.concatenate([item.predictions for item in fed])
        yield "predictions", prediction_rows(predictors, parameters, table)


def merged(words: Sequence[tuple[str | None, int]]) -> list[tuple[str | None, int]]:
    """Runs of the same word as one.

    >>> merged([("a", 2), ("a", 1), (None, 4)])
    [('a', 3), (None, 4)]
    """
    return [
        (word, sum(count for _, count in run)) for word, run in groupby(words, key=lambda entry: entry[0])
    ]
