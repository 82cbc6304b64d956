"""A process that compiles: ``python -m pointpred.server.compiling.worker``; names in, a line back for each.

What it puts into the cache is only loaded by the process that serves, whose clients it keeps waiting for
nothing. A garbage collector would only look at what a compiler keeps: it runs between the parts.
"""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import threading
from contextlib import suppress
from pathlib import Path
from queue import SimpleQueue

import pointpred

ASIDE = "aside"
"""Instead of a name: whatever else runs on this machine goes first from now on; may be said again."""
NICENESS = 15


class Worker:
    """The process, seen from the one that serves."""

    def __init__(self) -> None:
        """Its input stays open while this process lives, however it ends."""
        command = [sys.executable, "-P", "-m", "pointpred.server.compiling.worker"]
        package = str(Path(pointpred.__file__).parent.parent)  # the folder of the user may hold another one
        paths = os.pathsep.join(filter(None, (package, os.environ.get("PYTHONPATH"))))
        self.process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env=os.environ | {"PYTHONPATH": paths},
        )

    def compile(self, name: str) -> bool:
        """Have a part compiled and wait for it; ``False`` where the process has ended."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        try:
            self.process.stdin.write(name.encode() + b"\n")
            self.process.stdin.flush()
        except OSError:
            return False
        return self.process.stdout.readline() == b"\n"

    def kill(self) -> None:
        """Stop it, whatever it does: the cache puts files in place at once."""
        self.process.kill()

    def end(self) -> None:
        """``kill``, and forget it."""
        self.process.kill()
        self.process.communicate()


def main() -> None:
    """Compile the parts that are named until the input ends."""
    names: SimpleQueue[str] = SimpleQueue()
    threading.Thread(target=_listen, args=(names,), daemon=True).start()
    gc.disable()
    from pointpred.server.compiling.parts import parts

    known = {part.name: part for part in parts()}
    while True:
        name = names.get()
        if name == ASIDE:
            if hasattr(os, "nice"):
                os.nice(max(0, NICENESS - os.nice(0)))  # only root may lower it
        elif name in known:
            with suppress(Exception):  # the process that serves runs it as well, and says what is wrong
                known[name].run()
        os.write(1, b"\n")
        gc.collect()


def _listen(names: SimpleQueue[str]) -> None:
    """Hand names on, and end as soon as the process that asked for help has ended, however it did."""
    rest = b""
    while more := os.read(0, 4096):  # not sys.stdin: its lock would be held when the interpreter ends
        *lines, rest = (rest + more).split(b"\n")
        for line in lines:
            names.put(line.decode())
    os._exit(1)


if __name__ == "__main__":
    main()
