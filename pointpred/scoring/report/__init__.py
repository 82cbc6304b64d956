"""Scores as one page that people look at: figures, tables, statistics in words, the worst trials drawn."""

from pointpred.scoring.report.report import write_report

__all__ = ["write_report"]
