"""What the page's own code calls of the laws."""

from __future__ import annotations

ROOTS = {
    "pointpred.differentiators.sampling": ("usable", "STARTED", "T"),
    "pointpred.differentiators.homogeneous": ("chatter", "STEPS_M", "CHATTER_MOST_M_S", "SUBSTEPS_MOST"),
    "pointpred.events": ("LARGEST", "LATEST_S"),
    "pointpred.regions": ("ellipse", "as_normal"),
    "pointpred.scoring.measures.endpoint": (
        *("measure_trial", "FRACTIONS", "MEASURES", "TIME_AVERAGED", "BY_TIME", "BY_PATH"),
        *("SINGLE_AXIS", "SOUND"),
    ),
    "pointpred.scoring.trials.cutting": (
        *(
            "cut",
            "VERDICT",
            "ROW",
            "ONSET",
            "STOP",
            "ARRIVAL",
            "CUTS",
            "ONSET_PX",
            "ARRIVAL_PX",
            "ARRIVAL_SHARE",
        ),
        *("EMPTY", "ONE_SAMPLE", "UNUSABLE", "BACKWARD", "NEVER_LEFT", "ARRIVED", "INSTANT", "GOOD"),
    ),
    "pointpred.targets.rectangles": ("complete", "MOST_TARGETS", "SMALLEST_PX", "FIELDS"),
    "pointpred.targets.choice_law": ("step", "OUTSIDE", "INSIDE", "ENTERED", "RELEASED"),
    "pointpred.targets.decision": ("rank", "decide", "NOBODY"),
    "pointpred.targets.posterior": (
        *("scores", "normalise", "FITTED", "FITTED_PAGES"),
        *("PRECISION", "ELSEWHERE", "LEAST_LEAD_S", "LEAST_WAY_PX"),
    ),
    "pointpred.targets.prefetch": (
        *("step", "contact", "inside", "FITTED", "THRESHOLD", "ELSEWHERE", "STATES", "BEGAN", "COUNT"),
        *("ARMED", "FIRED", "RESTING", "PREDICTED", "ENTERED"),
    ),
    "pointpred.targets.cursor": (
        "usable",
        "follow",
        "KNOWN",
        "T",
        "X",
        "Y",
        "PRESSED",
        "T0",
        "X0",
        "Y0",
        "SPEED",
        "STATES",
    ),
    "pointpred.transfer.assistance": ("guarded_step", "GUARDED", "END", "USUAL_GUARD"),
    "pointpred.transfer.functions": ("CONSTANT", "SIGMOID", "SLOTS", "MACOS"),
    "pointpred.transfer.pixels": ("lay_out", "SETTINGS", "USUAL_TIMES_S"),
}
"""What the page's own code calls by name, beside the laws of all predictors and differentiators."""
