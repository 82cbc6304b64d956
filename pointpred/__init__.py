"""pointpred predicts where a pointing movement will end while it is still going on."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pointpred.pipeline import Pipeline, run
    from pointpred.records import (
        EventColumns,
        Motion,
        MotionColumns,
        Place,
        PointerEvent,
        Prediction,
        PredictionColumns,
        RegionColumns,
    )
    from pointpred.regions import Region
    from pointpred.registry import RECOMMENDED, REGISTRY, build

__version__ = "0.2.0"

__all__ = [
    "RECOMMENDED",
    "REGISTRY",
    "EventColumns",
    "Motion",
    "MotionColumns",
    "Pipeline",
    "Place",
    "PointerEvent",
    "Prediction",
    "PredictionColumns",
    "Region",
    "RegionColumns",
    "build",
    "run",
]

MODULES = ("records", "pipeline", "regions", "registry")
"""Where the public names are; loaded when one is first used, so that the command can start before them."""


if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        if name in __all__:
            for place in MODULES:
                module = import_module(f"{__name__}.{place}")
                globals().update({one: getattr(module, one) for one in __all__ if hasattr(module, one)})
            return globals()[name]
        if not name.startswith("_") and find_spec(f"{__name__}.{name}") is not None:
            return import_module(f"{__name__}.{name}")
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

    def __dir__() -> list[str]:
        return sorted({*globals(), *__all__})
