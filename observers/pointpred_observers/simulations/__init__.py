"""A plant of any kind beside its observer: simulated sample by sample, and drawn."""
