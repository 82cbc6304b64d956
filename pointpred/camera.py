"""The name of ``pointpred_observers.camera`` until version 0.1; it goes with the next one."""

from importlib import import_module
from importlib.util import find_spec
from typing import Any
from warnings import warn

from pointpred.extras import missing_extra


def __getattr__(name: str) -> Any:
    if find_spec("pointpred_observers") is None:
        raise missing_extra("", "pointpred_observers.camera has moved", of="pointpred-observers")
    warn("pointpred_observers.camera is pointpred_observers.camera now", DeprecationWarning, stacklevel=2)
    return getattr(import_module("pointpred_observers.camera"), name)
