"""Pointpred's own recordings."""
