"""Whether a parser keeps memory: ``python -m tests.fuzz.memory [NAME]``, ``person`` unless named, Linux only.

It checks 20,000 inputs, made from the seeds and the corpus by changing bytes, without the fuzzer, and prints
the memory that the process has for itself.
"""

from __future__ import annotations

import os
import random

from evidence.arguments import parse
from evidence.costs.soak.verdicts import usage_of
from tests.fuzz.corpus import corpus
from tests.fuzz.targets import TARGETS

INPUTS, EACH = 20_000, 2_000


def main(name: str) -> None:
    target, chance = TARGETS[name], random.Random(1)
    known = [*target.seeds(), *corpus(name)]
    for number in range(INPUTS + 1):
        data = bytearray(chance.choice(known))
        for _ in range(min(len(data), chance.randint(0, 4))):
            data[chance.randrange(len(data))] = chance.randrange(256)
        target.check(bytes(data))
        if number % EACH == 0:
            print(f"{number} inputs: {usage_of(os.getpid(), 0.0).memory_mb:.1f} MB", flush=True)


if __name__ == "__main__":
    main((parse(__doc__, metavar="NAME", most=1) or ["person"])[0])
