"""A process that compiles: ``python -m pointpred_server.compiling.process``; names in, a line back for each.

The serving process only loads what this one puts into the cache, so its clients need not wait for a compiler.
Garbage is collected between the parts: collections during compiling free nothing.
"""

from __future__ import annotations

import gc
import os
import subprocess
import threading
from contextlib import suppress
from queue import SimpleQueue

from pointpred_server.child_processes import command, environment

LOW_PRIORITY = "low priority"
"""Instead of a name: run with low priority from now on; may be sent again."""
NICENESS = 15


class CompilerProcess:
    """The process, as the serving one sees it."""

    def __init__(self) -> None:
        """Its input stays open while this process lives, however it ends."""
        self.process = subprocess.Popen(
            command("pointpred_server.compiling.process"),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env=environment(),
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
        """Stop it at any time: the cache replaces files atomically."""
        self.process.kill()

    def end(self) -> None:
        """Kill it and wait until it has ended."""
        self.process.kill()
        self.process.communicate()


def main() -> None:
    """Compile the parts that are named until the input ends."""
    names: SimpleQueue[str] = SimpleQueue()
    threading.Thread(target=_read_names, args=(names,), daemon=True).start()
    gc.disable()
    from pointpred_server.compiling.parts import parts

    by_name = {part.name: part for part in parts()}
    while True:
        name = names.get()
        if name == LOW_PRIORITY:
            if hasattr(os, "nice"):
                os.nice(max(0, NICENESS - os.nice(0)))  # only root may lower it
        elif name in by_name:
            with suppress(Exception):  # the serving process runs it as well, and logs what is wrong
                by_name[name].run()
        os.write(1, b"\n")
        gc.collect()


def _read_names(names: SimpleQueue[str]) -> None:
    """Put names into the queue, and end as soon as the parent process has ended, for whatever reason."""
    rest = b""
    while more := os.read(0, 4096):  # not sys.stdin: its lock would be held when the interpreter ends
        *lines, rest = (rest + more).split(b"\n")
        for line in lines:
            names.put(line.decode())
    os._exit(1)


if __name__ == "__main__":
    main()
