"""``make fuzz``: look for bytes that break the report-descriptor decoder, guided by its coverage.

Arguments are libFuzzer's: ``python -m tests.fuzz.run -max_total_time=600 tests/fuzz/corpus``. What reaches
new code is kept in the corpus, which an ordinary test replays. atheris is no dependency of the project.
"""

from __future__ import annotations

import sys

import atheris

DECODER = [
    f"pointpred.hid.{module}" for module in ("report_descriptor", "descriptor_items", "report_decoder")
]

with atheris.instrument_imports(include=DECODER):
    from tests.fuzz.report_descriptor import check


def one(data: bytes) -> None:
    """One input."""
    check(data)


def main() -> None:
    """Fuzz until the options say to stop; a breach ends it and leaves its input in a file."""
    atheris.Setup(sys.argv, one)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
