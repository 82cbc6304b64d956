"""What a trial is: where it begins, ends and arrives, whether it is clean and has sub-movements."""

from pointpred.scoring.trials import Prepared, durations_s, prepare, resolution

__all__ = ["Prepared", "durations_s", "prepare", "resolution"]
