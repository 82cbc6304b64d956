"""Recordings scored in chunks: a plan, an executor, a checkpoint a chunk, and results that stay on disk."""

from pointpred.scoring.chunks import ScoredSet, score_in_chunks

__all__ = ["ScoredSet", "score_in_chunks"]
