"""Which of several targets a movement is for: candidates for recorded movements, choices, their scores."""

from pointpred.scoring.target_choice import (
    ASKS,
    NEAREST,
    ChoiceSummary,
    Decisions,
    TargetDocument,
    TargetSummary,
    score_targets,
    summarise_targets,
)

__all__ = [
    "ASKS",
    "NEAREST",
    "ChoiceSummary",
    "Decisions",
    "TargetDocument",
    "TargetSummary",
    "score_targets",
    "summarise_targets",
]
