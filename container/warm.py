"""Compile what the service and the scorer run: a container then starts with its cache full."""

from __future__ import annotations

from pointpred.datasets import sample
from pointpred.registry import REGISTRY, build
from pointpred.scoring import prepare, replay
from pointpred.server.compiling.compiler import compile_all


def main() -> None:
    """Compile as the service does at its start, and score a recording with every predictor."""
    compile_all()
    recording = sample()
    prepared = prepare(recording, threads=1)
    for name in REGISTRY:
        replay(prepared, build(name, cpi=recording.provenance.cpi, dpi=recording.provenance.dpi), threads=1)
    print(f"{len(REGISTRY)} predictors are compiled")


if __name__ == "__main__":
    main()
