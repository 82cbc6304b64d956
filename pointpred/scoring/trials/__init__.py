"""What a trial is: where it begins, ends and arrives, whether it is clean and has sub-movements."""

from pointpred.scoring.trials.preparation import Prepared, prepare, resolution

__all__ = ["Prepared", "prepare", "resolution"]
