"""Regressions that learn sample by sample: used by transfer, predictors and observers alike."""
