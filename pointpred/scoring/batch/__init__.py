"""Recordings scored in chunks: a plan, an executor, a checkpoint a chunk, and results that stay on disk."""

from pointpred.scoring.batch.scored_set import ScoredSet
from pointpred.scoring.batch.scoring import score_in_chunks

__all__ = ["ScoredSet", "score_in_chunks"]
