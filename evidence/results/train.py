"""Make the coefficients of `kinematic` from POINTPRED_RECORDINGS: ``python -m evidence results train``.

The package's own file is written anew, which takes minutes. Coefficients of one's own: ``pointpred train``.
"""

from __future__ import annotations

import sys
import time

from evidence.arguments import parse
from evidence.held_out import in_one_thread
from pointpred.errors import PointpredError
from pointpred.predictors.kinematic import coefficient_file
from pointpred.training import data, train
from pointpred.training.fitting import Settings


def main() -> None:
    """Train; progress goes to the error stream."""
    began = time.monotonic()

    def log(what: str) -> None:
        print(f"{time.monotonic() - began:6.1f} s  {what}", file=sys.stderr, flush=True)

    settings = Settings()
    material = data.training_data(data.read_sets(data.folder()), settings.seed, log)
    train.train(material, settings, coefficient_file.OWN, log)


if __name__ == "__main__":
    parse(__doc__)
    in_one_thread()
    try:
        main()
    except PointpredError as error:
        sys.exit(f"python -m evidence results train: {error}")
