"""Scores as one page that people look at: figures, tables, statistics in words, the worst trials drawn."""

from pointpred.scoring.report.report import page_in, write_report, write_sets

__all__ = ["page_in", "write_report", "write_sets"]
