"""One function over many items: on threads, on processes, or on a Dask cluster."""

from pointpred.scoring.executors.executor import Executor
from pointpred.scoring.executors.opening import open_executor

__all__ = ["Executor", "open_executor"]
