"""``python -m pointpred.training``: make the coefficients of `kinematic` from POINTPRED_RECORDINGS.

The package's own file is written anew, which takes minutes. Coefficients of one's own: ``pointpred train``.
"""

from __future__ import annotations

import argparse
import os
import sys
import time

from pointpred.errors import PointpredError

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


def in_one_thread(module: str) -> None:
    """Start again where sums may run in several threads: in one thread their order, and they, repeat."""
    if any(os.environ.get(name) != "1" for name in THREADS):
        os.environ.update(dict.fromkeys(THREADS, "1"))
        os.execv(sys.executable, [sys.executable, "-m", module, *sys.argv[1:]])


def main() -> None:
    """Train; progress goes to the error stream."""
    began = time.monotonic()

    def log(what: str) -> None:
        print(f"{time.monotonic() - began:6.1f} s  {what}", file=sys.stderr, flush=True)

    from pointpred.predictors.kinematic import coefficient_file
    from pointpred.training import data, train
    from pointpred.training.fitting import Settings

    settings = Settings()
    material = data.training_data(data.read_sets(data.folder()), settings.seed, log)
    train.train(material, settings, coefficient_file.OWN, log)


def parse_arguments() -> None:
    """Answer ``--help``; refuse everything else."""
    argparse.ArgumentParser(
        "python -m pointpred.training",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    ).parse_args()


if __name__ == "__main__":
    parse_arguments()
    in_one_thread("pointpred.training")
    try:
        main()
    except PointpredError as error:
        sys.exit(f"python -m pointpred.training: {error}")
