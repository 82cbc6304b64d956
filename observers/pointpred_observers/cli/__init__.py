"""``pointpred observers`` and ``pointpred camera``."""
