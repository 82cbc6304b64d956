"""Compile what the service and the scorer run: a container then starts with its cache full."""

from __future__ import annotations

from pointpred.datasets import sample
from pointpred.registry import REGISTRY
from pointpred.scoring import score
from pointpred.scoring.summary.summarise import document
from pointpred_server.compiling.compiler import compile_all


def main() -> None:
    """Compile as the service does at its start, and score a recording with every predictor."""
    compile_all()
    document(score([sample()], tuple(REGISTRY), threads=1))
    print(f"{len(REGISTRY)} predictors are compiled")


if __name__ == "__main__":
    main()
