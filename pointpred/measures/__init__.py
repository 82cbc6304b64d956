"""What studies of pointing report: measures of each movement, throughput, time against difficulty."""

from pointpred.measures.fitts import Line, conditions, fitts_line, line, means, throughput
from pointpred.measures.paths import (
    Accuracy,
    accuracy,
    deviations,
    flips,
    reversals,
    sample_entropy,
    time_normalised,
)
from pointpred.measures.speeds import meyer_submovements, persistent_submovements, velocities
from pointpred.measures.trials import COLUMNS, Movement, measure, movements, table_of

__all__ = [
    "COLUMNS",
    "Accuracy",
    "Line",
    "Movement",
    "accuracy",
    "conditions",
    "deviations",
    "fitts_line",
    "flips",
    "line",
    "means",
    "measure",
    "meyer_submovements",
    "movements",
    "persistent_submovements",
    "reversals",
    "sample_entropy",
    "table_of",
    "throughput",
    "time_normalised",
    "velocities",
]
