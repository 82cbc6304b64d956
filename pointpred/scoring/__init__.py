"""How good a predictor is: trials, replay, metrics, statistics, report."""
