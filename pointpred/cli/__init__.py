"""The command line: the one place that joins sources, predictors, scoring and the server."""

from pointpred.cli.app import app, main

__all__ = ["app", "main"]
