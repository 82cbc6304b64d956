"""``python -m pointpred.training``: make the coefficients from POINTPRED_RECORDINGS."""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


def main() -> None:
    """Train, or cross-validate; progress goes to the error stream."""
    began = time.monotonic()

    def say(what: str) -> None:
        print(f"{time.monotonic() - began:6.1f} s  {what}", file=sys.stderr, flush=True)

    from pointpred.predictors import kinematic_coefficients
    from pointpred.training import people, train
    from pointpred.training.fitting import Settings

    settings = Settings()
    school = people.school(people.read_sets(people.folder()), settings.seed, say)
    if sys.argv[1:2] == ["validate"]:
        from pointpred.training import page, validate

        Path(sys.argv[2]).write_text(page.page(validate.validate(school, settings, say)), encoding="utf-8")
    else:
        train.train(school, settings, kinematic_coefficients.OWN, say)


if __name__ == "__main__":
    if any(os.environ.get(name) != "1" for name in THREADS):
        # Sums in one thread come in one order: the same machine makes the same numbers.
        os.environ.update(dict.fromkeys(THREADS, "1"))
        os.execv(sys.executable, [sys.executable, "-m", "pointpred.training", *sys.argv[1:]])
    main()
