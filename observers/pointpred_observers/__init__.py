"""Observers and regulators with certificates: chapters 3 and 4 of the thesis.

The public names stand in ``public.py``. They load when one is first used: the command line loads the commands
of this package at every start.
"""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pointpred_observers.public import *  # noqa: F403
else:

    def __getattr__(name: str) -> object:
        if find_spec(f"{__name__}.{name}") is not None:  # a module, which public.py may be importing
            return import_module(f"{__name__}.{name}")
        return getattr(import_module("pointpred_observers.public"), name)

    def __dir__() -> list[str]:
        return sorted({*import_module("pointpred_observers.public").__all__, "camera", "thesis"})
