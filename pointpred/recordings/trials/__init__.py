"""Rows to trials: cutting, grouping, checks and descriptions."""
