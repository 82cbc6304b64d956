"""``make fuzz``: every parser in turn, for FUZZ_SECONDS each, by a fuzzer that their coverage guides.

``python -m tests.fuzz.campaign [NAME ...]`` runs some of the targets. A corpus is afterwards as small as it
can be while it reaches the same code, and at most 32 KiB, smallest inputs first. The numbers go into
``evidence/attacks/data/fuzz.json``. An input that breaks a parser is named and kept in ``tests/fuzz/broken``;
the command then ends in an error.
"""

from __future__ import annotations

import argparse
import datetime
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from evidence.attacks.page import Run
from evidence.data import file_of, read, write
from evidence.machine import computer
from tests.fuzz.corpus import corpora, smallest, write_corpora
from tests.fuzz.targets import TARGETS

BROKEN = Path(__file__).parent / "broken"
FILE = file_of("attacks", "fuzz")
TIMEOUT_S, MEMORY_MIB = 20, 2048
"""An input that takes longer, or a process that takes more, is a breach."""
REACHED = re.compile(r"cov: (\d+)")


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", metavar="NAME", help="targets; all where none is named")
    parser.add_argument("--seconds", type=int, default=int(os.environ.get("FUZZ_SECONDS") or 240))
    parser.add_argument("--out", type=Path, default=FILE, help="the numbers, instead of the page's JSON")
    given = parser.parse_args()
    unknown = sorted(set(given.names) - TARGETS.keys())
    if unknown:
        parser.error(f"unknown target {unknown[0]!r}; known: {', '.join(TARGETS)}")
    breaches = 0
    for name in given.names or TARGETS:
        run = fuzz(name, given.seconds)
        breaches += run.breaches
        runs = read(given.out, dict[str, Run]) if given.out.exists() else {}
        runs[name] = run
        write({one: runs[one] for one in TARGETS if one in runs}, given.out)
        print(
            f"{name}: {run.executions} inputs in {run.seconds} s, {run.edges} edges, {run.breaches} breaches"
        )
    raise SystemExit(breaches > 0)


def fuzz(name: str, seconds: int) -> Run:
    """Fuzz one target, and make its corpus small."""
    with tempfile.TemporaryDirectory(prefix="fuzz-") as folder:
        reached, small = Path(folder) / "reached", Path(folder) / "small"
        reached.mkdir()
        small.mkdir()
        artifacts = Path(folder) / "broken"
        artifacts.mkdir()
        limits = [f"-timeout={TIMEOUT_S}", f"-rss_limit_mb={MEMORY_MIB}", f"-artifact_prefix={artifacts}/"]
        log = atheris(name, f"-max_total_time={seconds}", "-print_final_stats=1", *limits, str(reached))
        if not (executions := _statistic(log, "number_of_executed_units")):
            raise SystemExit(f"{name} was not fuzzed:\n{log[-3000:]}")
        broken = sorted(artifacts.iterdir())
        for one in broken:
            BROKEN.mkdir(exist_ok=True)
            shutil.copy(one, BROKEN / f"{name}-{one.name}")
            print(f"{name}: {BROKEN / f'{name}-{one.name}'}\n{log[-3000:]}", file=sys.stderr)
        if not broken:
            atheris(name, "-merge=1", str(small), str(reached))
            kept = {**corpora(), name: smallest(one.read_bytes() for one in small.iterdir())}
            write_corpora({one: kept[one] for one in TARGETS if one in kept})
        return Run(
            seconds,
            executions,
            max((int(one) for one in REACHED.findall(log)), default=0),
            _statistic(log, "peak_rss_mb"),
            len(broken),
            datetime.date.today().isoformat(),
            computer(),
        )


def atheris(name: str, *options: str) -> str:
    """Run the fuzzer in a process of its own; returns what it wrote."""
    command = [sys.executable, "-m", "tests.fuzz.run", name, *options]
    return subprocess.run(command, capture_output=True, text=True, errors="replace", check=False).stderr


def _statistic(log: str, name: str) -> int:
    found = re.search(rf"stat::{name}:\s+(\d+)", log)
    return int(found[1]) if found else 0


if __name__ == "__main__":
    main()
