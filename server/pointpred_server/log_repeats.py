"""Bounds how often the log repeats an entry: a client that causes one again and again fills no disk."""

from __future__ import annotations

import logging

from pointpred.protocol.token_bucket import TokenBucket

AT_ONCE = 300
"""Entries of one kind that are written together, ..."""
PER_S = 5.0
"""... and a second, in the long run."""
KINDS_MOST = 256
"""Kinds that are told apart: a client may cause as many sentences of a library as it likes."""


class RepeatLimit(logging.Filter):
    """Drops entries that come too often; the next that is written says how many were not.

    Entries are of one kind where they have the same logger, level and sentence, whatever is filled in.
    """

    def __init__(self) -> None:
        super().__init__()
        self._kinds: dict[object, _Kind] = {}

    def filter(self, record: logging.LogRecord) -> bool:
        """Whether an entry is written."""
        key: object = (record.name, record.levelno, str(record.msg))
        if key not in self._kinds and len(self._kinds) >= KINDS_MOST:
            key = record.levelno
        kind = self._kinds.setdefault(key, _Kind(record.created))
        if not kind.bucket.take(1.0 / AT_ONCE, PER_S / AT_ONCE * record.created):
            kind.dropped += 1
            return False
        if kind.dropped:
            record.msg = f"{record.msg} ({kind.dropped} like it were not written)"
            kind.dropped = 0
        return True


class _Kind:
    """How many entries of a kind may still be written, and how many were not."""

    def __init__(self, now: float) -> None:
        self.bucket = TokenBucket(1.0, PER_S / AT_ONCE * now)  # holds AT_ONCE entries, in units of them all
        self.dropped = 0
