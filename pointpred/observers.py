"""The name of ``pointpred_observers`` until version 0.1; it goes with the next one."""

from typing import Any

from pointpred.extras import moved_to_observers


def __getattr__(name: str) -> Any:
    return moved_to_observers("pointpred.observers", "pointpred_observers", name)
