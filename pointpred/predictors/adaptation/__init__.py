"""The learned predictor for one person: it learns from each movement that they finish."""
