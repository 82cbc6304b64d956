"""Look for bytes that break one parser, guided by its coverage: ``python -m tests.fuzz.run NAME [OPTIONS]``.

NAME is a target of ``tests/fuzz/targets.py``, the options are libFuzzer's, as in ``-max_total_time=60``. It
begins with the seeds and the corpus of the target; what reaches new code is kept in the first folder that is
named. A breach ends it and leaves its input in a file. atheris is no dependency of the project.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from types import FunctionType
from typing import Any

import atheris

from tests.fuzz.corpus import corpus
from tests.fuzz.targets import TARGETS, Target


def instrument(target: Target) -> None:
    """Have the target's own code report its coverage; laws in C report none."""
    for name, module in list(sys.modules.items()):
        if module is not None and name.startswith(target.modules):
            for function in functions_of(vars(module), name):
                atheris.instrument_func(function)


def functions_of(members: Any, module: str) -> Iterator[FunctionType]:
    """The functions and methods that a module defines."""
    for member in list(members.values()):
        one = getattr(member, "__func__", None) or getattr(member, "fget", None) or member
        if isinstance(one, FunctionType) and one.__module__ == module:
            yield one
        elif isinstance(one, type) and one.__module__ == module:
            yield from functions_of(vars(one), module)


def one(target: Target, data: bytes) -> None:
    """One input."""
    target.check(data)


def main() -> None:
    """Fuzz until the options say to stop."""
    name, *options = sys.argv[1:]
    target = TARGETS[name]
    instrument(target)
    with tempfile.TemporaryDirectory(prefix="seeds-") as folder:
        for place, seed in enumerate(target.seeds()):
            target.check(seed)  # a first run takes longer than any input may
            (Path(folder) / f"seed{place}").write_bytes(seed)
        for place, kept in enumerate(corpus(name)):
            (Path(folder) / f"kept{place}").write_bytes(kept)
        sizes = (
            [] if any(one.startswith("-max_len") for one in options) else [f"-max_len={target.most_bytes}"]
        )
        command = (
            f"{sys.executable} -m tests.fuzz.run {name}"  # libFuzzer runs it again to make a corpus small
        )
        atheris.Setup([command, *sizes, *options, folder], partial(one, target))
        atheris.Fuzz()


if __name__ == "__main__":
    main()
