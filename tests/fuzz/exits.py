"""How short programs that read a table end: ``python -m tests.fuzz.exits [PROCESSES]``, Linux only.

An Arrow thread that needs the interpreter while it ends aborts the process, one time in thirty on a busy
machine. Here it is made likely: every process reads a CSV file on one processor, with all threads but the
first at the lowest priority, and ends at once. Where Arrow held a Python file, 6 of 40 aborted. It takes long
where others compute on that processor, too.
"""

from __future__ import annotations

import importlib
import os
import shutil
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

from evidence.arguments import parse
from pointpred.recordings import read_any

PROCESSES = 2000
ROWS = "user,trial,t_s,x_px,y_px\n" + "".join(f"a,1,{0.01 * i:.2f},{i},0\n" for i in range(200))


def main(many: int) -> None:
    for name in ("pyarrow.csv", "pyarrow.parquet", "pointpred.recordings.own"):
        importlib.import_module(name)  # once, for all processes that are forked from this one
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    folder = Path(tempfile.mkdtemp())
    table = folder / "one.csv"
    table.write_text(ROWS, encoding="utf-8")
    codes: Counter[int] = Counter()
    began = time.perf_counter()
    for _ in range(many):
        child = os.fork()
        if not child:
            read_starved(table)
            return  # as any program ends: the interpreter is taken down
        codes[os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])] += 1
    shutil.rmtree(folder)
    print(f"{many} processes in {time.perf_counter() - began:.0f} s by exit code: {dict(codes)}")
    sys.exit(codes[0] != many)


def read_starved(table: Path) -> None:
    """Read with Arrow's threads, which the first reading starts, at the lowest priority."""
    read_any(table)
    for task in Path("/proc/self/task").iterdir():
        if int(task.name) != os.getpid():
            os.sched_setscheduler(int(task.name), os.SCHED_IDLE, os.sched_param(0))
    read_any(table)


if __name__ == "__main__":
    given = parse(__doc__, metavar="PROCESSES", most=1)
    main(int(given[0]) if given else PROCESSES)
