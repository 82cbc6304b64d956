"""The results of a set as they are kept: ``data/SET.json``, one file a set."""

from __future__ import annotations

from pathlib import Path

import msgspec

from evidence import data
from evidence.held_out import PEOPLE_OUT, SET_OUT
from pointpred.errors import ParameterError
from pointpred.scoring import SetSummary
from pointpred.scoring.summary import PredictorSummary

FOLDER = Path(__file__).parent / "data"


class SetResults(msgspec.Struct, frozen=True):
    """Every predictor on one set."""

    versions: dict[str, str]
    """Of the libraries that the numbers depend on."""
    summary: SetSummary

    @property
    def judged(self) -> dict[str, PredictorSummary]:
        """Predictors by name; what has learned is judged by coefficients that did not see the set.

        Those without memory stand beside what they are compared with: ``without_memory``.
        """
        rows = {one.name.removesuffix(SET_OUT): one for one in self.summary.predictors if not one.ablates}
        return {name: one for name, one in rows.items() if not name.endswith(PEOPLE_OUT)}

    def without_memory(self, name: str) -> PredictorSummary | None:
        """The same predictor without its memory of ends and distances; ``None`` where it has none."""
        rows = {one.ablates.removesuffix(SET_OUT): one for one in self.summary.predictors if one.ablates}
        return rows.get(name)

    def scored(self, name: str) -> PredictorSummary:
        """One predictor, by its name in the registry; raises ParameterError where it was not scored."""
        if name not in self.judged:
            raise ParameterError(
                f"{name} was not scored on {self.summary.name}; run `make results`", code="unknown"
            )
        return self.judged[name]


def stored(folder: Path = FOLDER) -> list[SetResults]:
    """Every set that has been scored: simulated ones first."""
    results = [data.read(file, SetResults) for file in sorted(folder.glob("*.json"))]
    return sorted(results, key=lambda one: not one.summary.simulated)


def write(one: SetResults, folder: Path = FOLDER) -> Path:
    """Keep the results of a set."""
    file = folder / f"{one.summary.name}.json"
    data.write(one, file)
    return file
