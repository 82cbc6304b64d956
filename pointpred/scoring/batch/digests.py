"""What checkpoints belong to: a digest of the recording, the settings and the code."""

from __future__ import annotations

import hashlib
import pickle
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

import msgspec

import pointpred
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.scoring.batch.plan import Chunk, Source, events_of

BLOCK_BYTES = 1 << 20


def digest(
    source: Source, pipelines: Mapping[str, Pipeline], chunks: Sequence[Chunk], *settings: object
) -> str:
    """A name for the results of chunks: another recording, predictor, setting or version has another one.

    ``settings``: whatever else changes a result. The seed of the bootstrap does not: it is used at the end.
    """
    whole = hashlib.blake2b(digest_size=16)
    whole.update(_code().encode())
    whole.update(repr(settings).encode())
    for name, pipeline in pipelines.items():
        whole.update(f"{name} {type(pipeline.differentiator)} {type(pipeline.predictor)}".encode())
        whole.update(pickle.dumps(pipeline.fresh(), protocol=5))
        for shared in pipeline.predictor.shared:  # a pickle holds the path of a coefficient file only
            whole.update(shared.tobytes())
    whole.update(repr([events_of(chunk) for chunk in chunks]).encode())
    if isinstance(source, Recording):
        whole.update(msgspec.msgpack.encode((source.name, source.trials, source.provenance)))
        whole.update(source.offsets.tobytes())
        whole.update(source.events.table.tobytes())
    else:
        for path in (source.samples, source.trials):
            with Path(path).open("rb") as file:
                while block := file.read(BLOCK_BYTES):
                    whole.update(block)
    return whole.hexdigest()


@cache
def _code() -> str:
    """A digest of the package's source: a version that is being worked on has many states."""
    whole = hashlib.blake2b(pointpred.__version__.encode(), digest_size=16)
    folder = Path(pointpred.__file__).parent
    for path in sorted(folder.rglob("*.py")):
        whole.update(path.relative_to(folder).as_posix().encode())
        whole.update(path.read_bytes())
    return whole.hexdigest()
