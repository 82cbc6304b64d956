"""The single-axis error against the path: distributions, and an analysis of variance over people."""

from pointpred.scoring.statistics import (
    AnovaSeries,
    AxisProfile,
    Box,
    Effect,
    axis_anova,
    axis_profile,
)

__all__ = ["AnovaSeries", "AxisProfile", "Box", "Effect", "axis_anova", "axis_profile"]
