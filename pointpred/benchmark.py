"""The benchmark: public sets of the catalogue, and predictors whose coefficients did not see them.

``docs/guide/benchmark.md`` states the protocol; ``pointpred benchmark`` runs it.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from pointpred.datasets import DataSet, listing
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.registry import build, takes
from pointpred.scoring import resolution

SET_OUT = " (set left out)"
"""What is added to the name of a predictor whose coefficients were fitted to other sets than this."""
LEFT_OUT = Path(__file__).parent / "datasets" / "set_left_out"
"""A file of coefficients for each set, fitted to the other sets of the results page."""


def benchmark_sets() -> tuple[DataSet, ...]:
    """The sets that a program can fetch, check and read as they are.

    >>> [entry.name for entry in benchmark_sets()]
    ['kh2017', 'gofitts_demo', 'jrcalgo']
    """
    return tuple(entry for entry in listing() if entry.verified and entry.reading is not None)


def judged_on(recording: Recording, names: Sequence[str]) -> list[str | Pipeline]:
    """What ``score`` is given for a benchmark set: names, or a pipeline where other coefficients are needed.

    A predictor that takes coefficients gets those that were fitted without the set of the recording's name,
    and that is added to its name. Raises ParameterError for an unknown name.
    """
    coefficients = LEFT_OUT / f"{recording.name}.npz"
    chosen: list[str | Pipeline] = []
    for name in names:
        if coefficients.is_file() and takes(name, "coefficients"):
            pipeline = build(name, coefficients=coefficients, **resolution(recording, None, None))
            pipeline.name = name + SET_OUT
            chosen.append(pipeline)
        else:
            chosen.append(name)
    return chosen
