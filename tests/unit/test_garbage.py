from __future__ import annotations

import gc

from pointpred.garbage import YOUNGEST, tune_collector


def test_what_is_loaded_is_not_looked_at_again() -> None:
    threshold, frozen = gc.get_threshold(), gc.get_freeze_count()
    try:
        tune_collector()
        assert gc.get_freeze_count() > frozen + 1000
        assert gc.get_threshold()[0] == YOUNGEST
        cycle: list[object] = []
        cycle.append(cycle)
        del cycle
        assert gc.collect() >= 1  # cycles made from now on are still found
    finally:
        gc.unfreeze()
        gc.set_threshold(*threshold)
