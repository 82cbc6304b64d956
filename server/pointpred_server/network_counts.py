"""Sessions of each address of other machines, counted over all workers of a service."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
from numpy.typing import NDArray

KEY_BYTES = 8


class NetworkCounts:
    """A table of keys, workers x most sessions: the network of each session, zero where there is none.

    Each worker writes its own row and reads the others', so that the count needs no message. A session is
    written before it is counted: where two workers admit at the same time, both see both.
    """

    def __init__(self, keys: NDArray[np.int64], worker: int = 0) -> None:
        self._keys = keys
        self._own = keys[worker]

    @contextmanager
    def place(self, network: str) -> Iterator[int]:
        """Count one session more of a network until the block ends; the sessions that it now has.

        There must be a free place: no more blocks at a time in a worker than the table has columns.
        """
        key = _key(network)
        place = int(np.argmin(self._own != 0))
        assert self._own[place] == 0
        self._own[place] = key
        try:
            yield int(np.count_nonzero(self._keys == key))
        finally:
            self._own[place] = 0


def _key(network: str) -> int:
    """A number for a network, never zero; two networks have the same with a chance of 1 in 2**64."""
    digest = hashlib.blake2b(network.encode(), digest_size=KEY_BYTES).digest()
    return int.from_bytes(digest, "little", signed=True) or 1
