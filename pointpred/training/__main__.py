"""``python -m pointpred.training``: make the coefficients of `kinematic` from POINTPRED_RECORDINGS.

Without a word the package's own file is written anew, which takes minutes; ``validate PAGE`` scores people
and sets held out instead, and writes the page. Coefficients of one's own: ``pointpred train``.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from pathlib import Path

from pointpred.errors import PointpredError

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


def page_asked() -> Path | None:
    """The page to validate into, ``None`` to train; ``--help`` and mistakes end here."""
    parser = argparse.ArgumentParser(
        "python -m pointpred.training",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("what", nargs="?", choices=["validate"], help="score people and sets held out")
    parser.add_argument("page", nargs="?", type=Path, help="file to write what comes of it to")
    given = parser.parse_args()
    if given.what and given.page is None:
        parser.error("validate needs the page to write, as in: validate docs/kinematic.md")
    page: Path | None = given.page
    return page


def in_one_thread(module: str) -> None:
    """Begin anew where sums may run in several threads: in one they come in one order, and repeat."""
    if any(os.environ.get(name) != "1" for name in THREADS):
        os.environ.update(dict.fromkeys(THREADS, "1"))
        os.execv(sys.executable, [sys.executable, "-m", module, *sys.argv[1:]])


def main(page: Path | None) -> None:
    """Train, or cross-validate; progress goes to the error stream."""
    began = time.monotonic()

    def say(what: str) -> None:
        print(f"{time.monotonic() - began:6.1f} s  {what}", file=sys.stderr, flush=True)

    from pointpred.predictors import kinematic_coefficients
    from pointpred.training import people, train
    from pointpred.training.fitting import Settings

    settings = Settings()
    school = people.school(people.read_sets(people.folder()), settings.seed, say)
    if page is None:
        train.train(school, settings, kinematic_coefficients.OWN, say)
    else:
        from pointpred.training import page as writing
        from pointpred.training import validate

        page.write_text(writing.page(validate.validate(school, settings, say)), encoding="utf-8")


if __name__ == "__main__":
    asked = page_asked()
    in_one_thread("pointpred.training")
    try:
        main(asked)
    except PointpredError as error:
        sys.exit(f"python -m pointpred.training: {error}")
