"""The inputs that reached most in each parser, in one archive: ``corpus.tar.xz``, a folder a target.

The same inputs make the same bytes. The campaign writes it, the ordinary tests replay it.
"""

from __future__ import annotations

import io
import tarfile
from collections.abc import Iterable
from functools import cache
from pathlib import Path

ARCHIVE = Path(__file__).parent / "corpus.tar.xz"
KEPT_BYTES = 2**15
"""Of a target; the repository holds them all."""


@cache
def corpora(archive: Path = ARCHIVE) -> dict[str, list[bytes]]:
    """The inputs of each target that has some."""
    read: dict[str, list[bytes]] = {}
    with tarfile.open(archive) as packed:
        for member in packed:
            file = packed.extractfile(member)
            assert file is not None, f"{member.name} is no file"
            read.setdefault(member.name.partition("/")[0], []).append(file.read())
    return read


def corpus(name: str) -> list[bytes]:
    """The inputs of a target; none where it has no corpus."""
    return corpora().get(name, [])


def by_size(data: bytes) -> tuple[int, bytes]:
    """The order in which inputs are kept."""
    return len(data), data


def smallest(inputs: Iterable[bytes]) -> list[bytes]:
    """As many of the inputs as may be kept, smallest first."""
    kept, total = [], 0
    for data in sorted(inputs, key=by_size):
        total += len(data)
        if total > KEPT_BYTES:
            break
        kept.append(data)
    return kept


def write_corpora(kept: dict[str, list[bytes]], archive: Path = ARCHIVE) -> None:
    """Write the archive anew."""
    with tarfile.open(archive, "w:xz") as packed:
        for name, inputs in sorted(kept.items()):
            for number, data in enumerate(sorted(inputs, key=by_size)):
                member = tarfile.TarInfo(f"{name}/{number:04d}")
                member.size = len(data)
                packed.addfile(member, io.BytesIO(data))
    corpora.cache_clear()
