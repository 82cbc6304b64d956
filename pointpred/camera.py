"""The name of ``pointpred_observers.camera`` until version 0.1; it goes with the next one."""

from typing import Any

from pointpred.extras import moved_to_observers


def __getattr__(name: str) -> Any:
    return moved_to_observers("pointpred.camera", "pointpred_observers.camera", name)
